"""Questions to a detector about curved motion."""

from __future__ import annotations

import gc
import math
import weakref

import numpy as np
import numpy.typing as npt
import pytest

import tamis

STILL = np.zeros((2, 3))
FACES = np.array([[0, 1, 2], [3, 4, 5]])
# A wall at x = 0, and a blade that turns about z from one side to the other: free at the start and at the end.
WALL = [[0, 1, -1], [0, 3, -1], [0, 2, 2]]
BLADE = [[1.9, -0.1, -2], [2.1, 0.1, -2], [2, 0, 0.5]]
HALF_TURN = [0.0, 0.0, math.pi]


def turning_blade() -> tamis.RigidPath:
    """Return the path of the blade. Straight motion between its ends goes through the axis, where there is no wall."""
    chains = [np.empty((0, 4, 3)), tamis.turned_chain(STILL, HALF_TURN, [0, 0, 0])]
    return tamis.RigidPath(WALL + BLADE, [0, 0, 0, 1, 1, 1], chains)


def positions_of_blade(time: float, vertices: npt.NDArray[np.int32]) -> tuple[npt.NDArray[np.float64], float]:
    """Compute the same motion with NumPy; its rounding is far below the error that it returns."""
    angle = math.pi * time
    turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    points = np.array(WALL + BLADE)[vertices]
    moves = vertices >= 3
    points[moves] = points[moves] @ turn.T
    return points, 1e-14


def deviations_of_blade(start: float, end: float, vertices: npt.NDArray[np.int32]) -> npt.NDArray[np.float64]:
    """Bound deviations: the acceleration is pi^2 times the distance from the axis, which is below 2.2."""
    return np.where(vertices >= 3, 2.2 * math.pi**2 * (end - start) ** 2 / 8, 0.0)


def test_a_blade_meets_the_wall_that_a_straight_step_misses() -> None:
    path, detector = turning_blade(), tamis.Detector(tamis.Mesh(FACES))
    contacts = detector.contacts(path)
    assert len(contacts) > 0 and contacts.certified.all()
    assert (contacts.toi_upper - contacts.toi_lower <= 1e-9).all()
    first = detector.earliest(path)
    assert first.contact is not None and first.toi_lower == contacts.toi_lower.min()
    assert 0.4 < first.toi_lower <= first.toi_upper < 0.5
    assert not detector.is_free(path)
    assert detector.is_free(path.points_at(0), path.points_at(1))


def test_single_pairs_agree_with_the_detector() -> None:
    path = turning_blade()
    contacts = tamis.Detector(tamis.Mesh(FACES)).contacts(path)
    of_edges = contacts[contacts.kind == tamis.PairKind.EDGE_EDGE]
    pairs = tamis.narrow_phase(of_edges.kind, of_edges.vertices, path)
    assert len(pairs) > 0 and pairs.touches.all()
    assert (np.maximum(pairs.toi_lower, of_edges.toi_lower) <= np.minimum(pairs.toi_upper, of_edges.toi_upper)).all()


def test_options_of_a_question() -> None:
    path, detector = turning_blade(), tamis.Detector(tamis.Mesh(FACES))
    narrow, wide = detector.contacts(path), detector.contacts(path, tolerance=1e-3)
    assert np.array_equal(narrow.vertices, wide.vertices)
    assert (wide.toi_lower <= narrow.toi_upper).all() and (narrow.toi_lower <= wide.toi_upper).all()
    near = detector.earliest(path, min_separation=0.25)
    assert near.toi_lower < detector.earliest(path).toi_lower
    thick = tamis.Detector(tamis.Mesh(FACES), groups=[0, 0, 0, 1, 1, 1], radii=[0.0, 0.25])
    assert thick.earliest(path).toi_lower == pytest.approx(near.toi_lower, abs=1e-8)


def test_a_function_is_a_path() -> None:
    """Would catch vertices or times that are passed on in another order."""
    detector = tamis.Detector(tamis.Mesh(FACES))
    path = tamis.FunctionPath(6, positions_of_blade, deviations_of_blade)
    assert repr(path) == "FunctionPath(6 vertices)"
    assert np.allclose(path.points_at(0.3), turning_blade().points_at(0.3), atol=1e-12)
    expected, found = detector.contacts(turning_blade()), detector.contacts(path, tolerance=1e-6)
    assert np.array_equal(found.vertices, expected.vertices)
    assert np.allclose(found.toi_lower, expected.toi_lower, atol=1e-5)
    assert not detector.is_free(path)


def test_an_exception_of_a_function_arrives() -> None:
    detector = tamis.Detector(tamis.Mesh(FACES))

    def points_at(time: float, vertices: npt.NDArray[np.int32]) -> tuple[npt.NDArray[np.float64], float]:
        raise ZeroDivisionError("in the middle")

    with pytest.raises(ZeroDivisionError, match="in the middle"):
        detector.is_free(tamis.FunctionPath(6, points_at, deviations_of_blade))
    with pytest.raises(ZeroDivisionError, match="in the middle"):
        tamis.narrow_phase(
            tamis.PairKind.EDGE_EDGE, [0, 1, 3, 4], tamis.FunctionPath(6, points_at, deviations_of_blade)
        )
    assert not detector.is_free(turning_blade())


@pytest.mark.parametrize(
    ("points", "errors", "deviation", "said"),
    [
        (np.zeros((2, 3)), 0.0, 0.0, "give one each"),
        (np.zeros((6, 2)), 0.0, 0.0, "three numbers a vertex"),
        (np.full((6, 3), math.nan), 0.0, 0.0, "not finite"),
        (None, -1.0, 0.0, "bound >= 0"),
        (None, [0.0], 0.0, "give one each"),
        (None, 0.0, -1.0, "bound >= 0"),
        (None, 0.0, math.nan, "bound >= 0"),
        (None, 0.0, [0.0, 0.0], "give one each"),
        (None, 0.0, "far", "floating-point numbers"),
    ],
)
def test_a_function_that_breaks_its_promise(points: object, errors: object, deviation: object, said: str) -> None:
    def points_at(time: float, vertices: npt.NDArray[np.int32]) -> tuple[object, object]:
        return positions_of_blade(time, vertices)[0] if points is None else points, errors

    path = tamis.FunctionPath(6, points_at, lambda start, end, vertices: deviation)  # type: ignore[arg-type, return-value]
    with pytest.raises(tamis.InvalidPath, match=said):
        tamis.Detector(tamis.Mesh(FACES)).contacts(path)


def test_a_function_that_gives_no_pair() -> None:
    path = tamis.FunctionPath(6, lambda time, vertices: np.zeros((6, 3)), deviations_of_blade)  # type: ignore[arg-type, return-value]
    with pytest.raises(tamis.InvalidPath, match="no pair"):
        path.points_at(0.5)
    with pytest.raises(tamis.InvalidPath, match="vertex_count is -1"):
        tamis.FunctionPath(-1, positions_of_blade, deviations_of_blade)


def test_functions_that_refer_to_their_path_are_collected() -> None:
    """Would catch a cycle that Python's garbage collector does not see."""

    class Motion:
        def __init__(self) -> None:
            self.path = tamis.FunctionPath(6, self.points_at, deviations_of_blade)

        def points_at(self, time: float, vertices: npt.NDArray[np.int32]) -> tuple[npt.NDArray[np.float64], float]:
            return positions_of_blade(time, vertices)

    motion = Motion()
    assert not tamis.Detector(tamis.Mesh(FACES)).is_free(motion.path, tolerance=1e-3)
    gone = weakref.ref(motion)
    del motion
    gc.collect()
    assert gone() is None


def test_a_line_as_a_bezier_curve(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    line = tamis.BezierPath([falling.start, falling.end])
    assert repr(line) == "BezierPath(6 vertices)" and line.vertex_count == 6
    assert np.array_equal(line.points_at(0.5), (falling.start + falling.end) / 2)
    first = detector.earliest(line)
    assert first.contact is not None and first.contact.vertices == (3, 0, 1, 2)
    assert first.toi_lower <= 0.5 <= first.toi_upper
    # Down and up again. The control point is twice as deep as the curve, which touches where 1 - 4 t (1 - t) = 0.
    low = falling.start.copy()
    low[3, 2] = -3
    bounce = tamis.BezierPath(np.stack([falling.start, low, falling.start]))
    assert bounce.points_at(0.5)[3, 2] == -1
    assert detector.is_free(bounce.points_at(0), bounce.points_at(1)) and not detector.is_free(bounce)
    assert detector.earliest(bounce).toi_lower == pytest.approx((1 - math.sqrt(0.5)) / 2, abs=1e-8)


def test_frames_joined_smoothly(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    path = tamis.CatmullRomPath([falling.start, falling.end, falling.start, falling.start])
    assert np.array_equal(path.points_at(1 / 3), falling.end) and np.array_equal(path.points_at(1), falling.start)
    times = detector.earliest(path)
    assert 0 < times.toi_lower < 1 / 3
    assert path.points_at(times.toi_lower)[3, 2] == pytest.approx(0, abs=1e-8)


def test_bad_motion(falling: tamis.Scene) -> None:
    detector, path = tamis.Detector(falling.mesh), tamis.BezierPath([falling.start, falling.end])
    for ask in (detector.contacts, detector.earliest, detector.is_free):
        with pytest.raises(tamis.InvalidPath, match="give no end"):
            ask(path, falling.end)  # type: ignore[call-overload]
        with pytest.raises(tamis.InvalidStep, match="end is missing"):
            ask(falling.start)  # type: ignore[call-overload]
        with pytest.raises(tamis.InvalidOptions, match="option of paths"):
            ask(falling.start, falling.end, tolerance=0.1)  # type: ignore[call-overload]
        with pytest.raises(tamis.InvalidOptions):
            ask(path, tolerance=0.0)
        with pytest.raises(tamis.InvalidOptions):
            ask(path, min_separation=-1.0)
        with pytest.raises(tamis.InvalidPath):
            ask(tamis.BezierPath([falling.start[:5]]))


def test_bad_frames(falling: tamis.Scene) -> None:
    for make, least in ((tamis.BezierPath, 1), (tamis.CatmullRomPath, 2)):
        with pytest.raises(tamis.InvalidPath, match="three numbers a vertex"):
            make(falling.start)
        with pytest.raises(tamis.InvalidPath, match="at least"):
            make(np.zeros((least - 1, 6, 3)))
        with pytest.raises(tamis.InvalidPath, match="not finite"):
            make(np.full((2, 6, 3), math.inf))
        with pytest.raises(tamis.InvalidPath, match="dtype"):
            make(np.zeros((2, 6, 3), object))
    with pytest.raises(tamis.InvalidPath, match="links of 3 rows"):
        tamis.RigidPath(WALL, [0, 0, 0], [np.zeros((1, 3, 3))])
