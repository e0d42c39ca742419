"""Answers of a world: the tables and named tuples of a detector, with the two bodies of each row."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._checks import file_name
from tamis._errors import Error
from tamis._kinds import PairKind, both_features
from tamis._renamed import renamed
from tamis._tables._columns import Columns, FeaturePairs, numbered
from tamis._tables._contacts import TouchingPairs
from tamis._tables._near import ClosePairs, CrossingPairs
from tamis._tables._table import Column, Row, Table
from tamis._world._features import Meshes, places_of

if TYPE_CHECKING:
    BodyPair = tuple[int, int]


class BodyContact(NamedTuple):
    """A `Contact` of two bodies, or of a deforming body with itself.

    Attributes
    ----------
    bodies : tuple of two int
        The body of the first feature, then of the second. Of two edges the edge of the body with the smaller number is
        first.
    kind, vertices, toi_lower, toi_upper, u, v, normal, certified
        As in `Contact`; vertices are numbered in the bodies' own meshes.
    """

    bodies: BodyPair
    kind: PairKind
    vertices: tuple[int, int, int, int]
    toi_lower: float
    toi_upper: float
    u: float
    v: float
    normal: tuple[float, float, float]
    certified: bool


class BodyNearPair(NamedTuple):
    """A `NearPair` of two bodies, or of a deforming body with itself.

    Attributes
    ----------
    bodies : tuple of two int
        As in `BodyContact`.
    kind, vertices, distance, u, v, direction
        As in `NearPair`; vertices are numbered in the bodies' own meshes.
    """

    bodies: BodyPair
    kind: PairKind
    vertices: tuple[int, int, int, int]
    distance: float
    u: float
    v: float
    direction: tuple[float, float, float]


class BodyIntersection(NamedTuple):
    """An `Intersection` of two bodies, or of a deforming body with itself.

    Attributes
    ----------
    bodies : tuple of two int
        The body of the edge, then of the face.
    edge, face, s_lower, s_upper, u, v
        As in `Intersection`; vertices are numbered in the bodies' own meshes.
    """

    bodies: BodyPair
    edge: tuple[int, int]
    face: tuple[int, int, int]
    s_lower: float
    s_upper: float
    u: float
    v: float


class EarliestBodyContact(NamedTuple):
    """The first contact of a step: how far all bodies may go, as `EarliestContact`.

    Attributes
    ----------
    toi_lower, toi_upper : float
        As in `EarliestContact`.
    contact : BodyContact or None
        The contact that ends the step; None if the step is free.
    """

    toi_lower: float
    toi_upper: float
    contact: BodyContact | None


@renamed(lower="toi_lower", upper="toi_upper")
class BodyStep(NamedTuple):
    """How far all bodies may go while every pair keeps a fraction of its distance: as `SafeStep`.

    Attributes
    ----------
    toi_lower, toi_upper : float
        As in `SafeStep`.
    pair : BodyNearPair or None
        The pair that ends the step, as it is at the start; None if the whole step may go.
    """

    toi_lower: float
    toi_upper: float
    pair: BodyNearPair | None


class EarliestMany(NamedTuple):
    """The first contact of each of n motions.

    Attributes
    ----------
    toi_lower, toi_upper : array of float64, shape (n,)
        For each motion as in `EarliestContact`.
    touching : array of int32, shape (m,)
        The motions that are not free, ascending.
    contacts : BodyContacts
        The first contact of each motion in `touching`: m rows.
    """

    toi_lower: Doubles
    toi_upper: Doubles
    touching: Indices
    contacts: BodyContacts

    @property
    def is_free(self) -> npt.NDArray[np.bool_]:
        """Whether each motion is free, shape (n,). True is a proof."""
        free = np.ones(len(self.toi_lower), bool)
        free[self.touching] = False
        return free

    def __repr__(self) -> str:
        return f"EarliestMany({len(self.toi_lower)} motions, {len(self.touching)} of them not free)"


class OfBodies(Table[Row]):
    """Tables whose rows are about two bodies each."""

    __slots__ = ()

    bodies = Column[Indices](
        "The bodies of the first and of the second feature, shape (n, 2); twice the same for a body with itself."
    )

    def _fields(self, values: Sequence[Any]) -> tuple[Any, ...]:
        *pair, bodies = values
        return tuple(bodies.tolist()), *super()._fields(pair)

    def _columns(self) -> Columns:
        return {**numbered("b", self.bodies), **super()._columns()}


class FeaturesOfBodies(OfBodies[Row], FeaturePairs[Row]):
    """Pairs of features, each of two bodies."""

    __slots__ = ()

    def features(self, meshes: Meshes) -> Indices:
        """Find both features of each pair in the meshes of their bodies.

        Parameters
        ----------
        meshes : mapping or sequence of Mesh
            The mesh of each body in the table, by the body's number: ``{body: shape.mesh}``.

        Returns
        -------
        array of int32, shape (n, 2)
            For each pair its first and its second feature: for a face its row in `Mesh.faces`, for an edge its row in
            `Mesh.edges`, for a vertex its index; in the mesh of the body that `bodies` has in the same column.

        Raises
        ------
        InvalidMesh
            A body has no mesh in `meshes`, or its mesh has no such vertex, edge or face.
        """
        features = both_features(self._kinds(), self.vertices)
        return np.stack([places_of(features[i], self.bodies[:, i], meshes) for i in (0, 1)], axis=1)


class BodyContacts(FeaturesOfBodies[BodyContact], TouchingPairs[BodyContact]):
    """Contacts of a step, sorted by kind, then bodies and vertices. They own their memory.

    `len()` counts the contacts; an integer index gives a `BodyContact`, any other index of an array `BodyContacts`. The
    columns of `table` are those of `Contacts`, and bodies.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.body_contact_layout())
    _record = BodyContact

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the contacts to a table. If that fails, no file is left. Numbers read back to the same doubles.

        Parameters
        ----------
        path : path_like
            A name that ends in ``.csv``, or that has no extension. The columns are b0 and b1, the bodies, then those of
            `Contacts.save`.

        Raises
        ------
        FileError
            The file cannot be written, or its name has another extension.
        Error
            The extension is that of a file to look at. Only the command writes these for bodies: ``tamis bodies
            SCENE.json --out``.
        """
        name = file_name(path, "path")
        if _core.is_file_to_look_at(name):
            raise Error(f"{name}: of bodies a table alone is written: save .csv, or let tamis bodies --out make a page")
        _core.write_body_contacts(name, np.ascontiguousarray(self._table).view(np.uint8))


class BodyNearPairs(FeaturesOfBodies[BodyNearPair], ClosePairs[BodyNearPair]):
    """Pairs of features that are near each other at the start, sorted by kind, then bodies and vertices.

    `len()` counts the pairs; an integer index gives a `BodyNearPair`, any other index of an array `BodyNearPairs`. The
    columns of `table` are those of `NearPairs`, and bodies.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.body_near_layout())
    _record = BodyNearPair


class BodyIntersections(OfBodies[BodyIntersection], CrossingPairs[BodyIntersection]):
    """Edges that pass through triangles or touch them at the start, sorted by bodies, edge and face.

    `len()` counts the rows; an integer index gives a `BodyIntersection`, any other index of an array
    `BodyIntersections`. The columns of `table` are those of `Intersections`, and bodies.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.body_intersection_layout())
    _record = BodyIntersection
