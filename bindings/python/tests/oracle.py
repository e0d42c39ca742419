"""Single pairs and whole meshes, decided in fractions: another route than the library's, slow and plain.

The times at which four points are coplanar are the roots of a cubic; each is isolated by Sturm's theorem, and the signs
of the contact weights at it are those of polynomials, told from an interval in which these have no root.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

Polynomial = list[Fraction]  # lowest power first, no zero at the end
Vector = tuple[Polynomial, Polynomial, Polynomial]
Points = Sequence[Sequence[float]]


class Degenerate(Exception):
    """A pair that this oracle cannot decide: it is always coplanar, or has no normal at the time in question."""


class Interval(NamedTuple):
    """An interval [lower, upper] that contains one root."""

    lower: Fraction
    upper: Fraction


def trimmed(p: Polynomial) -> Polynomial:
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def add(p: Polynomial, q: Polynomial, sign: int = 1) -> Polynomial:
    n = max(len(p), len(q))
    p, q = p + [Fraction(0)] * (n - len(p)), q + [Fraction(0)] * (n - len(q))
    return trimmed([a + sign * b for a, b in zip(p, q)])


def mul(p: Polynomial, q: Polynomial) -> Polynomial:
    result = [Fraction(0)] * (len(p) + len(q))
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return trimmed(result)


def at(p: Polynomial, t: Fraction) -> Fraction:
    value = Fraction(0)
    for coefficient in reversed(p):
        value = value * t + coefficient
    return value


def divided(p: Polynomial, q: Polynomial) -> tuple[Polynomial, Polynomial]:
    quotient: Polynomial = []
    while len(p) >= len(q):
        factor = p[-1] / q[-1]
        term = [Fraction(0)] * (len(p) - len(q)) + [factor]
        quotient, p = add(quotient, term), add(p, mul(term, q), -1)
    return quotient, p


def gcd(p: Polynomial, q: Polynomial) -> Polynomial:
    while q:
        p, q = q, divided(p, q)[1]
    return p


def derivative(p: Polynomial) -> Polynomial:
    return [i * c for i, c in enumerate(p)][1:]


def roots_in(p: Polynomial, lower: Fraction, upper: Fraction) -> int:
    """Return the number of distinct roots in (lower, upper]."""
    chain = [p, derivative(p)]
    while chain[-1]:
        chain.append([-c for c in divided(chain[-2], chain[-1])[1]])

    def changes(t: Fraction) -> int:
        signs = [value > 0 for value in (at(q, t) for q in chain if q) if value != 0]
        return sum(a != b for a, b in zip(signs, signs[1:]))

    return changes(lower) - changes(upper)


def isolated(p: Polynomial) -> list[Interval]:
    """Return intervals around the roots of a square-free p in [0, 1], in order; of width 0 for a root found exactly."""
    found = [Interval(Fraction(0), Fraction(0))] if at(p, Fraction(0)) == 0 else []
    todo = [Interval(Fraction(0), Fraction(1))]
    while todo:
        part = todo.pop()
        count = roots_in(p, *part)
        if count == 1:
            found.append(part)
        elif count > 1:
            middle = (part.lower + part.upper) / 2
            todo += [Interval(part.lower, middle), Interval(middle, part.upper)]
    return sorted(found)


def halved(p: Polynomial, root: Interval) -> Interval:
    middle = (root.lower + root.upper) / 2
    if root.lower == root.upper or roots_in(p, root.lower, middle) == 1:
        return Interval(root.lower, middle)
    return Interval(middle, root.upper)


def sign_at(q: Polynomial, p: Polynomial, root: Interval) -> int:
    """Return the sign of q at the only root of p in the interval."""
    if root.lower == root.upper:
        value = at(q, root.lower)
        return (value > 0) - (value < 0)
    common = gcd(p, q)
    if not q or (len(common) > 1 and roots_in(common, *root) == 1):
        return 0
    while at(q, root.upper) == 0 or roots_in(q, *root) > 0 or at(q, root.lower) == 0:
        root = halved(p, root)
    value = at(q, root.upper)
    return (value > 0) - (value < 0)


def minus(a: Vector, b: Vector) -> Vector:
    return add(a[0], b[0], -1), add(a[1], b[1], -1), add(a[2], b[2], -1)


def cross(a: Vector, b: Vector) -> Vector:
    def component(i: int, j: int) -> Polynomial:
        return add(mul(a[i], b[j]), mul(a[j], b[i]), -1)

    return component(1, 2), component(2, 0), component(0, 1)


def dot(a: Vector, b: Vector) -> Polynomial:
    return add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]))


def moving(start: Sequence[float], end: Sequence[float]) -> Vector:
    x, y, z = (trimmed([Fraction(a), Fraction(b) - Fraction(a)]) for a, b in zip(start, end))
    return x, y, z


def weights(kind: int, p: Vector, a: Vector, b: Vector, c: Vector) -> tuple[Polynomial, Polynomial, list[Polynomial]]:
    """Return the cubic, the normal's squared length, and polynomials that are all >= 0 where the features touch."""
    if kind == 0:
        n = cross(minus(b, a), minus(c, a))
        q = minus(p, a)
        first, second = dot(cross(q, minus(c, a)), n), dot(cross(minus(b, a), q), n)
        area = dot(n, n)
        return dot(q, n), area, [first, second, add(add(area, first, -1), second, -1)]
    d, e, r = minus(a, p), minus(c, b), minus(b, p)
    n = cross(d, e)
    first, second, area = dot(cross(r, e), n), dot(cross(r, d), n), dot(n, n)
    return dot(r, n), area, [first, second, add(area, first, -1), add(area, second, -1)]


def first_contact(kind: int, start: Points, end: Points) -> Interval | None:
    """Return an interval, at most 2^-60 wide, around the first time at which the pair touches; None if it does not."""
    cubic, area, conditions = weights(kind, *(moving(s, e) for s, e in zip(start, end)))
    if not cubic:
        raise Degenerate
    simple = divided(cubic, gcd(cubic, derivative(cubic)))[0] if len(cubic) > 1 else cubic
    for root in isolated(simple):
        if sign_at(area, simple, root) == 0:
            raise Degenerate
        if all(sign_at(q, simple, root) >= 0 for q in conditions):
            while root.upper - root.lower > Fraction(1, 2**60):
                root = halved(simple, root)
            return root
    return None


def contacts(faces: Sequence[Sequence[int]], start: Points, end: Points) -> dict[tuple[int, ...], Interval]:
    """Return every contact of a mesh, by kind and vertices."""
    points = sorted({v for face in faces for v in face})
    edges = sorted({tuple(sorted(pair)) for face in faces for pair in combinations(face, 2)})
    candidates = [(0, (p, *face)) for p in points for face in faces if p not in face]
    candidates += [(1, (*a, *b)) for a, b in combinations(edges, 2) if not set(a) & set(b)]
    found = {}
    for kind, vertices in candidates:
        when = first_contact(kind, [start[v] for v in vertices], [end[v] for v in vertices])
        if when is not None:
            found[(kind, *vertices)] = when
    return found
