"""Worlds of bodies: against a detector of one mesh, and what is refused."""

from __future__ import annotations

import pickle
import threading
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import END, FACES, START

import tamis

Array = npt.NDArray[np.float64]

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) - 0.5
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
CUBE_FACES = np.array([corners for a, b, c, d in QUADS for corners in ((a, b, c), (a, c, d))])


@pytest.fixture(scope="module")
def cube() -> tamis.Shape:
    return tamis.Shape(tamis.Mesh(CUBE_FACES), CUBE)


def _at(*places: Any) -> Array:
    """Poses that do not turn."""
    return tamis.pose_of(np.zeros((len(places), 3)), np.array(places, float))


def _one_mesh(starts: Array, ends: Array) -> tuple[tamis.Detector, Array, Array]:
    """Return a detector of all cubes as one mesh, and where its vertices are; cubes do not touch themselves."""
    count = len(starts)
    faces = np.concatenate([CUBE_FACES + 8 * i for i in range(count)])
    groups = np.repeat(np.arange(count), 8)
    detector = tamis.Detector(tamis.Mesh(faces), groups=groups, may_touch=~np.eye(count, dtype=bool))
    return detector, *((CUBE + poses[:, :1]).reshape(-1, 3) for poses in (starts, ends))  # type: ignore[return-value]


def _named(contacts: tamis.BodyContacts) -> set[tuple[Any, ...]]:
    """Contacts with the vertices of the mesh of all cubes."""
    first = np.where(contacts.kind == tamis.PairKind.EDGE_EDGE, 2, 1)[:, np.newaxis] > np.arange(4)
    of_vertex = np.where(first, contacts.bodies[:, :1], contacts.bodies[:, 1:])
    vertices = contacts.vertices + 8 * of_vertex
    return {*zip(contacts.kind.tolist(), map(tuple, vertices.tolist()), contacts.toi_lower.tolist())}


def test_the_contacts_of_a_detector(cube: tamis.Shape) -> None:
    """Bugs: another body's vertices, a body left out, positions rounded in another way."""
    random = np.random.default_rng(5)
    starts, ends = (_at(*random.uniform(-2, 2, (12, 3))) for _ in range(2))
    world = tamis.World(threads=1)
    bodies = world.add_many(cube, tamis.between(starts, ends))
    assert bodies.tolist() == [*range(12)]
    found = world.contacts()
    detector, start, end = _one_mesh(starts, ends)
    expected = detector.contacts(start, end)
    assert len(expected) > 100
    alone = tamis.narrow_phase(expected.kind, expected.vertices, start, end)  # as the world decides: bit for bit
    rows = zip(expected.kind.tolist(), map(tuple, expected.vertices.tolist()), alone.toi_lower.tolist())
    assert _named(found) == {*rows} and len(found) == len(expected)
    assert found.certified.all()
    first, theirs = world.earliest(), detector.earliest(start, end)
    assert first.toi_lower == pytest.approx(theirs.toi_lower, abs=1e-12)
    assert first.contact is not None and not world.is_free()
    near, near_theirs = world.pairs_within(0.5), detector.pairs_within(start, 0.5)
    assert np.array_equal(np.sort(near.distance), np.sort(near_theirs.distance)) and len(near)
    assert len(world.intersections()) == len(detector.intersections(start)) > 0
    assert world.statistics.threads == 1 and world.statistics.memory_bytes > 0


def test_tables_have_the_bodies(cube: tamis.Shape) -> None:
    world = tamis.World()
    world.add(cube)
    world.add(cube, tamis.between(_at((3, 0, 0)), _at((0.5, 0, 0)))[0])
    contacts = world.contacts()
    assert contacts.bodies.base is not None and contacts.bodies.shape == (len(contacts), 2)
    one = contacts[0]
    assert isinstance(one, tamis.BodyContact) and {*one.bodies} == {0, 1} and one.toi_lower == contacts.toi_lower[0]
    frame = contacts.to_pandas()
    assert [*frame.columns[:3]] == ["b0", "b1", "kind"] and len(frame) == len(contacts)
    assert (np.abs(contacts.weights.sum(1)) < 1e-12).all() and "first at 0.8" in repr(contacts)
    assert pickle.loads(pickle.dumps(contacts)) == contacts and contacts[contacts.kind == 0][:1][0].kind == 0
    near = world.pairs_within(2)
    assert near[0].bodies == (0, 1) and near.distance.min() == 2 and [*near.to_pandas().columns[:2]] == ["b0", "b1"]
    world.move(1, _at((0.5, 0.5, 0.5))[0])
    world.move(0, tamis.between(_at((0, 0, 0)), _at((0, 0, 1)))[0])
    crossing = world.intersections()
    assert len(crossing) and crossing[0].bodies in ((0, 1), (1, 0))
    assert crossing.to_pandas()["b0"].tolist() == crossing.bodies[:, 0].tolist()


def test_turning_bodies_and_their_paths(cube: tamis.Shape) -> None:
    """A cube turns in place beside a wall of another: only its corners reach that, as on a RigidPath."""
    chain = tamis.turned(_at((0, 0, 0))[0], [0, 0, np.pi / 2], [0, 0, 0])
    world = tamis.World(min_separation=0.01)
    world.add(cube, chain)
    still = world.add(cube, _at((1.15, 0, 0))[0])
    faces = np.concatenate([CUBE_FACES, CUBE_FACES + 8])
    path = tamis.RigidPath(
        np.concatenate([CUBE, CUBE + np.array([1.15, 0, 0])]), np.repeat([0, 1], 8), [chain, np.empty((0, 4, 3))]
    )
    detector = tamis.Detector(
        tamis.Mesh(faces), min_separation=0.01, groups=np.repeat([0, 1], 8), may_touch=~np.eye(2, dtype=bool)
    )
    ours, theirs = world.earliest(tolerance=1e-6), detector.earliest(path, tolerance=1e-6)
    assert 0 < ours.toi_lower < 0.5 and abs(ours.toi_lower - theirs.toi_lower) <= 2e-6
    assert ours.toi_upper - ours.toi_lower <= 1e-6
    step = world.safe_step()
    assert step.pair is not None and 0 < step.lower < ours.toi_lower and step.upper - step.lower < 1e-6
    world.move(still, _at((5, 0, 0))[0])
    assert world.is_free() and world.safe_step().pair is None


def test_a_cloth_between_bodies() -> None:
    """A deforming body falls on a static one: both ways of saying so agree; then it may touch itself."""
    sheet = tamis.Shape(tamis.Mesh(FACES), START)
    world = tamis.World()
    falling = world.add(sheet, tamis.Deforming(START, END))
    assert [c.bodies for c in world.contacts()] == [(falling, falling)]
    step = world.safe_step(0.5)
    assert step == tamis.BodyStep(*tamis.Detector(sheet.mesh).safe_step(START, END, 0.5)[:2], step.pair)
    assert step.pair is not None and step.pair.bodies == (0, 0) and step.pair.kind == tamis.PairKind.VERTEX_FACE
    world.set_may_touch([falling, falling], False)
    assert world.is_free()
    world.add(sheet, _at((0, 0, -0.5))[0])
    assert {*world.contacts().bodies.ravel().tolist()} == {0, 1}
    world.move(falling, tamis.Deforming(END, START))
    assert world.is_free(at_start="ignore") is False
    with pytest.raises(tamis.InvalidStep, match="body 0 has 5 points"):
        world.move(falling, tamis.Deforming(START[:5], END))


def test_removed_switched_off_and_kept_apart(cube: tamis.Shape) -> None:
    world = tamis.World()
    bodies = world.add_many(cube, _at((0, 0, 0), (10, 0, 0), (20, 0, 0)))
    flying = world.add(cube, tamis.between(_at((-5, 0, 0)), _at((25, 0, 0)))[0])

    def met() -> set[int]:
        return {*world.contacts().bodies.ravel().tolist()} - {flying}

    assert met() == {0, 1, 2}
    world.set_enabled(bodies[:2], False)
    assert met() == {2}
    world.set_enabled(0, True)
    world.set_may_touch([[0, flying], [2, flying]], False)
    assert met() == set()
    world.set_may_touch([2, flying], True)
    assert met() == {2}
    world.remove(bodies[1:])
    assert met() == set()
    for ask in (world.remove, lambda body: world.move(body, _at((0, 0, 0))[0]), lambda b: world.set_enabled(b, True)):
        with pytest.raises(tamis.InvalidOptions, match="body 1"):
            ask(1)
    assert world.add(cube) == 4


@pytest.mark.parametrize("bad", [-1, 4, 9])
def test_one_that_is_not_there_leaves_all_as_they_were(cube: tamis.Shape, bad: int) -> None:
    """Bug: those before it were removed, switched off or moved, and nobody could tell which."""
    world = tamis.World()
    world.add_many(cube, _at((0, 0, 0), (0, 10, 0)))
    world.add_many(cube, tamis.between(_at((0, 0, 5), (0, 10, 5)), _at((0, 0, 0), (0, 10, 0))))
    world.remove(world.add(cube))  # 4
    before = world.contacts()
    assert {*before.bodies.ravel().tolist()} == {0, 1, 2, 3}
    changes: list[Callable[[], object]] = [
        lambda: world.move_many([2, 3, bad], _at((50, 0, 0), (60, 0, 0), (70, 0, 0))),
        lambda: world.remove([0, bad]),
        lambda: world.set_enabled([0, 1, bad], False),
        lambda: world.set_may_touch([[0, 2], [1, bad]], False),
        lambda: world.set_may_touch([[0, 2], [bad, 1]], False),
    ]
    for change in changes:
        with pytest.raises(tamis.InvalidOptions, match=f"body {bad}"):
            change()
        assert world.contacts() == before
    with pytest.raises(tamis.InvalidOptions, match="bodies holds 0 twice"):
        world.remove([0, 1, 0])
    assert world.contacts() == before


def test_radii_and_steps_of_bodies_that_turn(cube: tamis.Shape) -> None:
    world = tamis.World()
    low, high = world.add_many(cube, _at((0, 0, 0), (0, 0, 3)))
    world.move(high, tamis.interpolated(_at((0, 0, 3))[0], np.array([[0, 0, 2], [0, 0, 0.5]])))
    assert world.is_free()
    step = world.safe_step(0.6, tolerance=1e-6)
    assert step.pair is not None
    assert 0.79 < step.lower < 0.81  # from the distance 2 down to 1.2
    world.set_radius([low, high], 0.75)
    assert abs(world.earliest().toi_lower - 0.5) < 1e-6
    for bad in (-1.0, float("nan")):
        with pytest.raises(tamis.InvalidOptions, match="radius"):
            world.set_radius([low, high], bad)
    with pytest.raises(tamis.InvalidOptions, match="no body 5"):
        world.set_radius([low, 5], 0)
    assert abs(world.earliest().toi_lower - 0.5) < 1e-6


def test_many_motions_have_the_answers_that_they_have_alone(cube: tamis.Shape) -> None:
    """Bug: bodies that another motion has moved, or an answer that goes with the wrong motion."""
    world = tamis.World(threads=2)
    world.add_many(cube, _at((0, 0, 0), (4, 0, 0)))
    arm = world.add_many(cube, _at((0, 5, 0), (4, 5, 0)))
    rng = np.random.default_rng(5)
    start = _at((0, 5, 0), (4, 5, 0)) + rng.uniform(-1, 1, (40, 2, 2, 3))
    end = start + rng.uniform(-1, 1, (40, 2, 2, 3)) + [[0, -2.5, 0], [0, 0, 0]]
    motions = tamis.interpolated(start.reshape(-1, 2, 3), end.reshape(-1, 2, 3)).reshape(40, 2, 1, 4, 3)
    found = world.earliest_many(arm, motions)
    assert world.is_free()  # they stay as they were told
    assert found.toi_lower.shape == found.toi_upper.shape == found.is_free.shape == (40,)
    assert 0 < found.is_free.sum() < 40
    assert len(found.contacts) == len(found.touching)
    contacts = dict(zip(found.touching.tolist(), found.contacts, strict=True))
    for i, motion in enumerate(motions):
        world.move_many(arm, motion)
        alone = world.earliest()
        assert (alone.toi_lower, alone.toi_upper) == (found.toi_lower[i], found.toi_upper[i])
        assert alone.contact == contacts.get(i)
        assert bool(found.is_free[i]) == world.is_free()


def test_many_motions_that_do_not_fit(cube: tamis.Shape) -> None:
    world = tamis.World()
    places = _at((0, 0, 0), (4, 0, 0))
    bodies = world.add_many(cube, places)
    motions = np.broadcast_to(tamis.between(places, places), (3, 2, 2, 4, 3))
    assert world.earliest_many(bodies, motions).is_free.all()
    assert len(world.earliest_many(bodies, motions[:0]).toi_lower) == 0
    with pytest.raises(tamis.InvalidPath, match=r"give \(n, 1, links, 4, 3\)"):
        world.earliest_many(bodies[:1], motions)
    with pytest.raises(tamis.InvalidOptions, match="bodies holds 1 twice"):
        world.earliest_many([1, 1], motions)
    with pytest.raises(tamis.InvalidOptions, match="bodies is empty"):
        world.earliest_many([], motions[:, :0])
    with pytest.raises(tamis.InvalidOptions, match="no body 7"):
        world.earliest_many([0, 7], motions)
    with pytest.raises(tamis.InvalidPath, match="motions"):
        world.earliest_many(bodies, np.where(motions == 0, np.nan, motions))


def test_thousands_in_one_call(cube: tamis.Shape) -> None:
    """Bodies of a grid go up by less than is between them; then one row goes too far."""
    places = np.stack(np.meshgrid(*[np.arange(20) * 2.0] * 3), -1).reshape(-1, 3)
    still = tamis.pose_of(np.tile([1.0, 0, 0, 0], (8000, 1)), places)
    world = tamis.World()
    bodies = world.add_many(cube, still)
    assert world.is_free()
    up = tamis.pose_of(np.tile([1, 0, 0, 0], (8000, 1)).astype(np.float32), places + np.array([0, 0, 0.9]))
    world.move_many(bodies, tamis.between(still, up))
    assert world.is_free()
    one = bodies[places[:, 2] == 0][:1]
    world.move_many(one, tamis.between(still[one], _at(places[one[0]] + np.array([0, 0, 2.5]))))
    assert {*world.contacts().bodies.ravel().tolist()} == {int(one[0]), int(one[0]) + 1}


def test_poses_of_rotations() -> None:
    """Bug: the order of a quaternion's parts, rows of a matrix for its columns."""
    half = np.sqrt(0.5)
    quarter = np.array([[half, 0, 0, half]])  # about z
    matrix = np.array([[[0, -1, 0], [1, 0, 0], [0, 0, 1]]])
    rotations: list[npt.NDArray[Any]] = [quarter, quarter.astype(np.float32), matrix, np.array([[0, 0, np.pi / 2]])]
    for rotation in rotations:
        pose = tamis.pose_of(rotation, [[1, 2, 3]])
        assert pose.shape == (1, 2, 3) and np.allclose(pose.ravel(), [1, 2, 3, 0, 0, np.pi / 2], atol=1e-7)
        assert np.array_equal(tamis.pose_of(rotation[0], [1, 2, 3]), pose[0])
    with pytest.raises(tamis.InvalidPath, match=r"rotation 1: .*quaternion"):
        tamis.pose_of(np.array([[1, 0, 0, 0], [1, 0.1, 0, 0]]), np.zeros((2, 3)))
    with pytest.raises(tamis.InvalidPath, match="reflection"):
        tamis.pose_of(-np.eye(3), np.zeros(3))
    with pytest.raises(tamis.InvalidPath, match=r"rotation has the shape \(2, 4\), position \(3, 3\)"):
        tamis.pose_of(np.ones((2, 4)), np.zeros((3, 3)))


def test_chains_of_many_poses() -> None:
    """As many at once as one by one."""
    random = np.random.default_rng(1)
    start, end = random.normal(size=(2, 5, 2, 3))
    for make in (tamis.between, tamis.interpolated):
        assert np.array_equal(make(start, end), [make(*poses) for poses in zip(start, end)])
    turns = tamis.turned(start, end[:, 1], end[:, 0])
    assert np.array_equal(turns, [tamis.turned(s, e[1], e[0]) for s, e in zip(start, end)])
    about = tamis.between(start, end, center=end[:, 1])
    assert np.array_equal(about, [tamis.between(s, e, center=e[1]) for s, e in zip(start, end)])
    assert np.array_equal(tamis.nlerp_deviation(start, end), [tamis.nlerp_deviation(*p)[0] for p in zip(start, end)])
    with pytest.raises(tamis.InvalidPath, match="start has 5, end has 4"):
        tamis.between(start, end[:4])
    with pytest.raises(tamis.InvalidPath, match="center has 4, start has 5: give one, or as many"):
        tamis.between(start, end, center=end[:4, 1])


def test_chains_begin_and_end_at_their_poses() -> None:
    """Bug: the rotation of the start was dropped, so that a turned body was asked about where it is not."""
    random = np.random.default_rng(2)
    corners, center = random.normal(size=(4, 3)), random.normal(size=3)
    poses = random.normal(size=(2, 6, 2, 3))

    def at(pose: Array) -> Array:
        return tamis.RigidPath(corners, [0] * 4, [tamis.interpolated(pose, pose)]).points_at(0)

    for start, end, chain in zip(*poses, tamis.between(*poses, center=center)):
        path = tamis.RigidPath(corners, [0] * 4, [chain])
        assert np.allclose(path.points_at(0), at(start), atol=1e-14)
        assert np.allclose(path.points_at(1), at(end), atol=1e-14)
        middle = tamis.RigidPath([center], [0], [chain]).points_at(0.25)
        ends = [tamis.RigidPath([center], [0], [tamis.interpolated(p, p)]).points_at(0) for p in (start, end)]
        assert np.allclose(middle, 0.75 * ends[0] + 0.25 * ends[1], atol=1e-14)
    turn = tamis.turned(poses[0, 0], [0, 0, 2.5], poses[1, 0, 0])
    assert np.allclose(tamis.RigidPath(corners, [0] * 4, [turn]).points_at(0), at(poses[0, 0]), atol=1e-14)


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda w, s: w.add(s, np.zeros((4, 3))), r"motion has the shape \(4, 3\)"),
        (lambda w, s: w.add_many(s, np.zeros((2, 3))), r"motions has the shape \(2, 3\)"),
        (lambda w, s: w.add_many(s, np.full((1, 2, 3), np.nan)), "not finite"),
        (lambda w, s: w.move_many([0, 1], _at((0, 0, 0))), "motions has 1 entries, bodies 2"),
        (lambda w, s: w.move_many([0, 0], _at((0, 0, 0), (1, 1, 1))), "bodies holds 0 twice"),
        (lambda w, s: w.move_many([0, 7], _at((0, 0, 0), (1, 1, 1))), "body 7"),
        (lambda w, s: w.set_may_touch([0, 1], True), "both stay"),
        (lambda w, s: w.set_may_touch([0, 1, 2], True), r"give \(n, 2\)"),
        (lambda w, s: w.contacts(at_start="fail"), "start"),
        (lambda w, s: w.contacts(tolerance=0), "tolerance"),
        (lambda w, s: w.contacts(min_separation=-1), "minimum separation"),
        (lambda w, s: w.add(CUBE, CUBE), "shape"),
    ],
)
def test_misuse_is_refused(cube: tamis.Shape, ask: Any, sentence: str) -> None:
    world = tamis.World()
    world.add(cube)
    world.add(cube)
    world.add(cube, tamis.between(_at((0, 0, 0)), _at((1, 0, 0)))[0])
    before = world.contacts()
    with pytest.raises(tamis.Error, match=sentence):
        ask(world, cube)
    assert world.contacts() == before


def test_one_question_at_a_time_and_an_end_to_it(cube: tamis.Shape) -> None:
    """A change during a question is refused; a question that is cancelled is as if it had not been."""
    random = np.random.default_rng(2)
    stopping = threading.Event()
    refused: list[Exception] = []

    def is_cancelled() -> bool:
        try:
            world.add(cube)
        except tamis.Busy as error:
            refused.append(error)
        return stopping.is_set() or bool(refused)

    world = tamis.World(threads=1, is_cancelled=is_cancelled)
    world.add_many(
        cube,
        tamis.between(*(tamis.pose_of(random.normal(size=(300, 3)), random.normal(size=(300, 3))) for _ in range(2))),
    )
    with pytest.raises(tamis.Cancelled):
        world.contacts()
    assert refused and world.add(cube) == 300


def test_a_world_and_its_callback_are_collected(cube: tamis.Shape) -> None:
    import gc

    class Owner:
        def __init__(self) -> None:
            self.world = tamis.World(is_cancelled=self.stop)

        def stop(self) -> bool:
            return False

    owner = Owner()
    owner.world.add(cube)
    gone = weakref.ref(owner)
    del owner
    gc.collect()
    assert gone() is None


def test_shapes(cube: tamis.Shape) -> None:
    assert np.array_equal(cube.points, CUBE) and cube.memory_bytes > 0 and cube.mesh.vertex_count == 8
    copied = pickle.loads(pickle.dumps(cube))
    assert np.array_equal(copied.points, CUBE) and repr(copied) == repr(cube)
    with pytest.raises(tamis.InvalidMesh, match="7 points"):
        tamis.Shape(tamis.Mesh(CUBE_FACES), CUBE[:7])
    with pytest.raises(TypeError, match="make a World"):
        pickle.dumps(tamis.World())
