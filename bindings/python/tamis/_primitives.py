"""Triangles around boxes, cylinders, balls, capsules and ellipsoids.

Each solid lies within its triangles, and no point of these is farther from the solid than the tolerance. So a surface
that stays outside the triangles does not touch the solid.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tamis._arrays import Doubles, Indices
from tamis._errors import InvalidOptions

_MOST_RINGS = 518  # a ball has 8 rings^2 triangles: two million


@dataclass(frozen=True)
class Shape:
    """Triangles, counter-clockwise as seen from outside."""

    points: Doubles
    faces: Indices


def box(half: Doubles) -> Shape:
    """Return the twelve triangles of a box with these half sizes, shape (3,)."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return Shape(corners, _triangles([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]))


def around_square(half: float) -> Shape:
    """Return one triangle in the plane z = 0 around a square of this half side.

    The square has no edge inside, on which a feature that rests there could lie exactly.
    """
    points = half * np.array([[-4, -2, 0], [4, -2, 0], [0, 6, 0]], float)
    return Shape(points, _triangles([(0, 1, 2)]))


def cylinder(radius: float, half_length: float, tolerance: float) -> Shape:
    """Return triangles around a cylinder along z with flat ends."""
    n = max(3, int(np.ceil(np.pi / np.arccos(radius / (radius + tolerance)))))
    angles, corner = 2 * np.pi * np.arange(n) / n, _beyond_rounding(radius / np.cos(np.pi / n))
    ring = np.column_stack([corner * np.cos(angles), corner * np.sin(angles), np.full(n, half_length)])
    points = np.vstack([ring, ring * [1, 1, -1], [[0, 0, half_length], [0, 0, -half_length]]])
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(n + i, n + j, j), (n + i, j, i), (2 * n, i, j), (2 * n + 1, n + j, n + i)]
    return Shape(points, _triangles(faces))


def ellipsoid(half: Doubles, tolerance: float) -> Shape:
    """Return triangles around an ellipsoid with these half axes, shape (3,).

    They are the triangles of the ball with the largest half axis, shrunk along each axis: no two points come farther
    apart.
    """
    ball = capsule(float(half.max()), 0.0, tolerance)
    return Shape(ball.points * (half / half.max()), ball.faces)


def capsule(radius: float, half_length: float, tolerance: float) -> Shape:
    """Return triangles around a capsule along z, or a ball if `half_length` is 0.

    The halves of the ball's triangles, moved apart, are no farther out than the ball's.
    """
    rings = 1
    while radius * (_size_around_ball(rings) - 1) > tolerance:
        rings += max(1, rings // 8)
        if rings > _MOST_RINGS:
            raise InvalidOptions(
                f"more than two million triangles would be needed to come within {tolerance} of a round surface of "
                f"radius {radius:.6g}: give a larger tolerance"
            )
    top, faces = _half_ball(rings)
    top *= radius * _size_around_ball(rings)
    n, rim = len(top), np.arange(len(top) - 4 * rings, len(top))
    below = np.arange(n) + n
    if half_length == 0:
        below[rim] = rim
    away = np.array([0, 0, half_length])
    points = np.vstack([top + away, top * [1, 1, -1] - away])
    a, b = rim, np.roll(rim, -1)
    band = np.vstack([np.column_stack([below[a], below[b], b]), np.column_stack([below[a], b, a])])
    used = np.vstack([faces, below[faces[:, ::-1]], band if half_length > 0 else band[:0]])
    kept, used = np.unique(used, return_inverse=True)
    return Shape(points[kept], _triangles(used.reshape(-1, 3)))


def _half_ball(rings: int) -> tuple[Doubles, Indices]:
    """Return half a unit ball, z >= 0: a pole, then rings of 4, 8, 12, ... vertices, equally spaced in latitude."""
    points, faces, first = [np.array([[0.0, 0, 1]])], [], [0]
    for ring in range(1, rings + 1):
        angle, around = np.pi / 2 * ring / rings, 2 * np.pi * np.arange(4 * ring) / (4 * ring)
        height = np.cos(angle) if ring < rings else 0.0
        points.append(
            np.column_stack([np.sin(angle) * np.cos(around), np.sin(angle) * np.sin(around), 0 * around + height])
        )
        first.append(first[-1] + max(1, 4 * (ring - 1)))
        faces += _between_rings(ring, first)
    return np.vstack(points), _triangles(faces)


def _between_rings(ring: int, first: list[int]) -> list[tuple[int, int, int]]:
    """Return the triangles from a ring to the ring above: in each quarter `ring` that point up, and one less down."""

    def inner(quarter: int, i: int) -> int:
        return first[ring - 1] + (quarter * (ring - 1) + i) % max(1, 4 * (ring - 1))

    def outer(quarter: int, i: int) -> int:
        return first[ring] + (quarter * ring + i) % (4 * ring)

    up = [(inner(q, i), outer(q, i), outer(q, i + 1)) for q in range(4) for i in range(ring)]
    return up + [(inner(q, i), outer(q, i + 1), inner(q, i + 1)) for q in range(4) for i in range(ring - 1)]


def _size_around_ball(rings: int) -> float:
    """Return the factor that scales the triangles until all their planes lie outside the unit ball."""
    points, faces = _half_ball(rings)
    a, b, c = points[faces].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    nearest = (np.abs((normals * a).sum(1)) / np.linalg.norm(normals, axis=1)).min()
    return _beyond_rounding(1 / float(nearest))


def _beyond_rounding(size: float) -> float:
    return size * (1 + 1e-12)


def _triangles(faces: object) -> Indices:
    return np.asarray(faces, np.int32).reshape(-1, 3)
