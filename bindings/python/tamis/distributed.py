"""The questions of `tamis.Detector` for the ranks of an MPI communicator. Each rank has a part of the mesh.

>>> from mpi4py import MPI
>>> from tamis import distributed
>>> detector = distributed.Detector(MPI.COMM_WORLD, faces, vertices)
>>> contacts = detector.contacts(start, end)

Needs mpi4py, and a build with MPI: ``pip install . -C cmake.define.TAMIS_PYTHON_MPI=ON`` in a clone. Run scripts as
``mpirun -n 4 python -m mpi4py script.py``: then an exception that ends one rank ends all of them.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import numpy.typing as npt
from mpi4py import MPI

from tamis._arrays import indices, indices_or_none
from tamis._errors import InvalidMesh
from tamis._options import Filter, Isa, group_count_of, make_options
from tamis._ranks._questions import Questions
from tamis._ranks._statistics import Balance, Statistics
from tamis._ranks._together import Ranks

try:
    from tamis import _distributed
except ImportError as reason:
    raise ImportError(
        f"this build of tamis knows no MPI ({reason}): pip install . -C cmake.define.TAMIS_PYTHON_MPI=ON in a clone"
    ) from reason

__all__ = ["Balance", "Detector", "Statistics"]


def _require_one_mpi() -> None:
    """Raise if mpi4py uses another MPI library than `_distributed`: neither knows the communicators of the other."""
    ours, theirs = (said.rstrip("\0 \n") for said in (_distributed.library_version(), MPI.Get_library_version()))
    if ours != theirs:
        raise ImportError(f"tamis was built for '{ours}', mpi4py uses '{theirs}': let both use the same MPI")


_require_one_mpi()


class Detector(Questions):
    """A `tamis.Detector` over all ranks of a communicator. Each rank has a part of the mesh.

    Construction and every question are collective: all ranks call them, in the same order and with the same options;
    only `threads`, `isa`, `filter` and `is_cancelled` may differ. Vertices have the numbers of the whole mesh
    everywhere: in faces, filters and answers. The answers are bit for bit the answers of one `tamis.Detector` with the
    whole mesh, however the mesh is divided among the ranks.

    An error on one rank is raised on all ranks, as the same `tamis.Error`, with a sentence that begins with the rank.
    The next question works as usual. There is one exception: Ctrl-C, or an exception of `is_cancelled`, is raised as it
    is on its rank, and the other ranks raise `Cancelled`.

    Parameters
    ----------
    comm : mpi4py.MPI.Intracomm
        The communicator. It is duplicated: messages never mix with other messages. The duplicate is freed after the
        detector is gone on all of its ranks, when these ranks make another detector.
    faces : array_like of int, shape (f, 3)
        This rank's triangles, each given by one rank; may be empty.
    vertices : array_like of int, shape (n,)
        The number of the vertex of each row of this rank's positions. Several ranks may give a vertex on a border,
        always with the same position. Features of this rank may use vertices that only other ranks give.
    edges : array_like of int, shape (e, 2), optional
        This rank's loose edges: rods.
    points : array_like of int, shape (p,), optional
        This rank's loose points.
    threads : int
        The number of threads of this rank, >= 0; 0: all cores. Take 1 if each core has a rank.
    groups : array_like of int, shape (n,), optional
        The group of the vertex of each row, >= 0.
    filter : callable, optional
        As in `tamis.Detector`. Any rank may call it, so its answer about a pair may not depend on the rank.
    min_separation, isa, may_touch, radii, is_cancelled
        As in `tamis.Detector`.

    Raises
    ------
    InvalidMesh
        A negative number, a vertex that one rank gives twice, or a vertex that is used and that no rank gives.
    InvalidOptions
        As in `tamis.Detector`, or the options of ranks differ.
    """

    __slots__ = ("__weakref__", "_description", "_detector", "_lock", "_ranks")

    def __init__(
        self,
        comm: MPI.Intracomm,
        faces: npt.ArrayLike,
        vertices: npt.ArrayLike,
        *,
        edges: npt.ArrayLike | None = None,
        points: npt.ArrayLike | None = None,
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        groups: npt.ArrayLike | None = None,
        may_touch: npt.ArrayLike | None = None,
        radii: npt.ArrayLike | None = None,
        filter: Filter | None = None,
        is_cancelled: Callable[[], bool] | None = None,
    ) -> None:
        self._lock = threading.Lock()
        self._ranks = Ranks(comm)
        part = self._ranks.together(
            lambda: _distributed.Part(
                indices(vertices, 0, "vertices", InvalidMesh),
                indices(faces, 3, "faces", InvalidMesh),
                indices_or_none(edges, 2, "edges", InvalidMesh),
                indices_or_none(points, 0, "points", InvalidMesh),
            )
        )
        # No rank need have a vertex of each group.
        group_count = self._ranks.comm.allreduce(self._ranks.together(lambda: group_count_of(groups)), op=MPI.MAX)
        options = self._ranks.together(
            lambda: make_options(
                threads=threads,
                min_separation=min_separation,
                isa=isa,
                groups=groups,
                may_touch=may_touch,
                radii=radii,
                filter=filter,
                is_cancelled=is_cancelled,
                group_count=group_count,
            )
        )
        self._detector = _distributed.Detector(self._ranks.comm.py2f(), part, options)
        self._description = f"min_separation={float(min_separation):g}"

    @property
    def vertex_count(self) -> int:
        """The largest number of a vertex that any rank gives or uses, plus 1."""
        return self._detector.vertex_count()

    @property
    def statistics(self) -> Statistics:
        """The cost of the last question on this rank."""
        return Statistics(**self._detector.statistics())

    @property
    def balance(self) -> Balance:
        """How evenly the ranks shared the work of the last question; the same on every rank."""
        return Balance(*self._detector.balance())

    def __repr__(self) -> str:
        return f"Detector(rank {self._ranks.comm.rank} of {self._ranks.comm.size}, {self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a Detector cannot be pickled: every rank makes its own, all together")
