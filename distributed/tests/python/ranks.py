"""The ranks, and what their tests share."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
import pytest
from mpi4py import MPI

import tamis
from tamis import distributed

COMM = MPI.COMM_WORLD
RANK, SIZE = COMM.rank, COMM.size
IS_LAST = RANK == SIZE - 1
NEEDS_OTHERS = pytest.mark.skipif(SIZE == 1, reason="one rank agrees with itself")


class Part:
    """The part of a scene that this rank gives: triangles in turns, so that ranks share nearly all vertices."""

    def __init__(self, scene: tamis.Scene) -> None:
        self.faces = scene.mesh.faces[RANK::SIZE]
        self.edges = scene.mesh.loose_edges[RANK::SIZE]
        self.points = scene.mesh.loose_points[RANK::SIZE]
        used = np.concatenate([self.faces.ravel(), self.edges.ravel(), self.points])
        self.vertices = np.unique(used)[::-1]  # descending: the order of rows is the caller's
        self.start, self.end = scene.start[self.vertices], scene.end[self.vertices]
        self.groups = scene.groups[self.vertices]

    def detector(self, **options: Any) -> distributed.Detector:
        return distributed.Detector(
            COMM, self.faces, self.vertices, edges=self.edges, points=self.points, threads=1, **options
        )


def raised_on_all(kind: type[Exception], ask: Callable[[], object]) -> str:
    """Expect an error on all ranks; return its sentence, which must be the same on every rank."""
    with pytest.raises(tamis.Error) as caught:
        ask()
    assert type(caught.value) is kind
    sentences: list[str] = COMM.allgather(str(caught.value))
    assert len(set(sentences)) == 1
    return sentences[0]
