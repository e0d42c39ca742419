"""A planner's questions to a world, about edges between configurations of a linkage."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, indices
from tamis._checks import truth
from tamis._errors import InvalidOptions, InvalidPath
from tamis._options import path_options
from tamis._world._linkage import Linkage, configurations_of, edges_of, known_linkage
from tamis._world._tables import BodyContact, BodyContacts

Flags = npt.NDArray[np.bool_]


class EdgeAnswers(NamedTuple):
    """How far a linkage may go along each of n edges.

    Attributes
    ----------
    fraction : array of float64, shape (n,)
        Edge i is free on [0, fraction[i]), proven. 1 if it is free, 0 if its start overlaps.
    fraction_upper : array of float64, shape (n,)
        A certified contact happens at or before this fraction, as `EarliestContact.toi_upper`.
    overlaps_at_start : array of bool, shape (n,)
        Whether two bodies pass through each other at the start, or one is inside another.
    bodies : array of int32, shape (n, 2)
        The bodies that touch first, or overlap at the start, by their numbers in the world; -1 where the edge is free.
    points : array of float64, shape (n, 3)
        Where the contact is, in the world's frame; NaN where there is none.
    touching : array of int32, shape (m,)
        The edges that have a contact, ascending.
    contacts : BodyContacts
        The first contact of each edge in `touching`: m rows.
    """

    fraction: Doubles
    fraction_upper: Doubles
    overlaps_at_start: Flags
    bodies: Indices
    points: Doubles
    touching: Indices
    contacts: BodyContacts

    @property
    def is_free(self) -> Flags:
        """Whether each edge is free, shape (n,). True is a proof."""
        return self.bodies[:, 0] < 0

    def __repr__(self) -> str:
        return f"EdgeAnswers({len(self.fraction)} edges, {int((~self.is_free).sum())} of them not free)"


class FirstBadEdge(NamedTuple):
    """The first edge of a trajectory that is not free.

    Attributes
    ----------
    edge : int or None
        Its number: from waypoint `edge` to the next; None if all edges are free, which is a proof.
    fraction : float
        This edge is free on [0, fraction), proven; 1 if all edges are free.
    fraction_upper : float
        As in `EdgeAnswers`.
    overlaps_at_start : bool
        Whether the trajectory's first configuration overlaps.
    bodies : tuple of two int, or None
        The bodies that touch first, or overlap.
    point : array of float64, shape (3,), or None
        Where the contact is, in the world's frame.
    contact : BodyContact or None
        The contact.
    """

    edge: int | None
    fraction: float
    fraction_upper: float
    overlaps_at_start: bool
    bodies: tuple[int, int] | None
    point: Doubles | None
    contact: BodyContact | None

    @property
    def is_free(self) -> bool:
        """Whether all edges are free."""
        return self.edge is None


class FreeRoadmap(NamedTuple):
    """The free part of a roadmap. True is a proof.

    Attributes
    ----------
    configurations_are_free : array of bool, shape (n,)
        For each configuration.
    edges_are_free : array of bool, shape (e,)
        For each edge.
    """

    configurations_are_free: Flags
    edges_are_free: Flags


class EdgeQuestions:
    """A planner's questions to a `World` (this is a base of it)."""

    __slots__ = ()
    _world: _core.World

    def configurations_are_free(
        self,
        linkage: Linkage,
        configurations: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> Flags:
        """Tell which configurations of a linkage are free: nothing overlaps (`has_overlap`), and nothing touches.

        Only pairs with a body of the linkage count. All other bodies are where their motions begin, and move as they
        were told: give obstacles that stay a pose.

        Parameters
        ----------
        linkage : Linkage
            The joints, and the bodies that they carry.
        configurations : array_like, shape (n, d)
            A row a configuration; d is `Linkage.dimension`.
        min_separation, tolerance
            As in `contacts`.

        Returns
        -------
        array of bool, shape (n,)
            True is a proof.

        Raises
        ------
        InvalidOptions
            The world has not a body of the linkage; or an option outside its range.
        InvalidPath
            Configurations of another shape, or numbers that are not finite.
        """
        given = configurations_of(linkage, configurations, "configurations")
        asked = path_options(min_separation, "report", tolerance)
        return self._world.configurations_are_free(linkage._linkage, given, asked).view(np.bool_)

    def edges_are_free(
        self,
        linkage: Linkage,
        starts: npt.ArrayLike,
        ends: npt.ArrayLike,
        starts_are_free: bool = False,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> Flags:
        """Tell which edges between configurations are free, as planners need it.

        An edge is free if nothing overlaps at its start (`has_overlap`), and nothing touches along it. Then nothing
        overlaps at its end. Only pairs with a body of the linkage count; all other bodies take part in each edge with
        their own motions. Threads share the edges.

        Parameters
        ----------
        linkage : Linkage
            The joints, and the bodies that they carry. Their own motions do not matter, and stay.
        starts, ends : array_like, shape (n, d)
            A row a configuration; d is `Linkage.dimension`. Each number goes linearly.
        starts_are_free : bool
            The starts are known not to overlap, as from earlier answers: they are not tested. If one does, True proves
            nothing.
        min_separation, tolerance
            As in `contacts`. With a separation, free means farther apart all along the edge.

        Returns
        -------
        array of bool, shape (n,)
            True is a proof.

        Raises
        ------
        InvalidOptions
            The world has not a body of the linkage; or an option outside its range.
        InvalidPath
            Configurations of another shape, or numbers that are not finite.
        InvalidStep
            A body turns too far, as in `add`.
        """
        first, last = _edges(linkage, starts, ends)
        asked = path_options(min_separation, "report", tolerance)
        known = truth(starts_are_free, "starts_are_free")
        return self._world.edges_are_free(linkage._linkage, first, last, known, asked).view(np.bool_)

    def last_valid(
        self,
        linkage: Linkage,
        starts: npt.ArrayLike,
        ends: npt.ArrayLike,
        starts_are_free: bool = False,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> EdgeAnswers:
        """Find how far each edge is free, and the contact that ends it.

        Parameters
        ----------
        linkage, starts, ends, starts_are_free, min_separation, tolerance
            As in `edges_are_free`.

        Returns
        -------
        EdgeAnswers
            Edge i is free before `fraction[i]`, proven.

        Raises
        ------
        InvalidOptions, InvalidPath, InvalidStep
            As `edges_are_free`.
        """
        first, last = _edges(linkage, starts, ends)
        asked = path_options(min_separation, "report", tolerance)
        known = truth(starts_are_free, "starts_are_free")
        return _answers(self._world.last_valid(linkage._linkage, first, last, known, asked))

    def first_bad_edge(
        self,
        linkage: Linkage,
        waypoints: npt.ArrayLike,
        start_is_free: bool = False,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> FirstBadEdge:
        """Find the first edge of a trajectory that is not free.

        Only the first waypoint is tested for an overlap: those that free edges reach have none. If other bodies move,
        all are tested, as obstacles begin each edge where they are at t = 0.

        Parameters
        ----------
        linkage : Linkage
            As in `edges_are_free`.
        waypoints : array_like, shape (n, d)
            Two configurations or more.
        start_is_free : bool
            The first waypoint is known not to overlap.
        min_separation, tolerance
            As in `edges_are_free`.

        Returns
        -------
        FirstBadEdge
            No edge if the whole trajectory is free, which is a proof.

        Raises
        ------
        InvalidOptions, InvalidPath, InvalidStep
            As `edges_are_free`; InvalidOptions for fewer than two waypoints.
        """
        given = configurations_of(linkage, waypoints, "waypoints")
        asked = path_options(min_separation, "report", tolerance)
        known = truth(start_is_free, "start_is_free")
        edge, columns = self._world.first_bad_edge(linkage._linkage, given, known, asked)
        answer = _answers(columns)
        if edge < 0:
            return FirstBadEdge(None, 1.0, 1.0, False, None, None, None)
        first, second = answer.bodies[0].tolist()
        has_contact = len(answer.contacts) > 0
        return FirstBadEdge(
            edge,
            float(answer.fraction[0]),
            float(answer.fraction_upper[0]),
            bool(answer.overlaps_at_start[0]),
            (first, second),
            answer.points[0] if has_contact else None,
            answer.contacts[0] if has_contact else None,
        )

    def roadmap(
        self,
        linkage: Linkage,
        configurations: npt.ArrayLike,
        edges: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> FreeRoadmap:
        """Decide which part of a whole roadmap is free.

        Parameters
        ----------
        linkage : Linkage
            As in `edges_are_free`.
        configurations : array_like, shape (n, d)
            The roadmap's configurations.
        edges : array_like of int, shape (e, 2)
            The numbers of two configurations each. An edge is free if both are, and nothing touches along it.
        min_separation, tolerance
            As in `edges_are_free`.

        Returns
        -------
        FreeRoadmap
            An answer for each configuration and each edge.

        Raises
        ------
        InvalidOptions, InvalidPath, InvalidStep
            As `edges_are_free`; InvalidOptions for an edge that names a configuration that is not there.
        """
        given = configurations_of(linkage, configurations, "configurations")
        pairs = indices(edges, 2, "edges", InvalidOptions)
        asked = path_options(min_separation, "report", tolerance)
        free, free_edges = self._world.roadmap(linkage._linkage, given, pairs, asked)
        return FreeRoadmap(free.view(np.bool_), free_edges.view(np.bool_))


def _edges(linkage: Linkage, starts: npt.ArrayLike, ends: npt.ArrayLike) -> tuple[Doubles, Doubles]:
    first, last, alone = edges_of(known_linkage(linkage), starts, ends)
    if alone:
        raise InvalidPath("starts and ends are one configuration each: give rows, (1, d), for one edge")
    return first, last


def _answers(columns: Any) -> EdgeAnswers:
    lower, upper, overlaps, bodies, points, touching, contacts = columns
    has_none = np.ones(len(lower), bool)
    has_none[touching] = False
    points[has_none] = np.nan
    return EdgeAnswers(lower, upper, overlaps.view(np.bool_), bodies, points, touching, BodyContacts(contacts))
