"""Curved motion of single pairs: a rod that turns meets a post that a straight step would miss."""

from __future__ import annotations

import copy
import math
import pickle

import numpy as np
import pytest

import tamis

VF, EE, VE, VV = tamis.PairKind

STILL = np.zeros((2, 3))


def turning_rod() -> tamis.RigidPath:
    """Return the path of a rod along x that turns by 90 degrees about z, through a post at 45 degrees at t = 0.5."""
    rest = [[0, 0, 0], [2, 0, 0], [1, 1, -1], [1, 1, 1]]
    chain = tamis.turned_chain(STILL, [0, 0, math.pi / 2], [0, 0, 0])
    return tamis.RigidPath(rest, [0, 0, 1, 1], [chain, np.empty((0, 4, 3))])


def test_a_rod_that_turns_meets_a_post() -> None:
    path = turning_rod()
    found = tamis.narrow_phase(EE, [0, 1, 2, 3], path)
    assert found.touches[0] and found.toi_lower[0] <= 0.5 <= found.toi_upper[0]
    assert found.toi_upper[0] - found.toi_lower[0] <= 1e-9
    assert found.u[0] == pytest.approx(math.sqrt(0.5), abs=1e-6)
    straight = tamis.narrow_phase(EE, [0, 1, 2, 3], path.points_at(0), path.points_at(1))
    assert straight.touches[0] and straight.toi_lower[0] > 0.4


def test_points_on_the_way() -> None:
    path = turning_rod()
    assert np.allclose(path.points_at(1)[1], [0, 2, 0], atol=1e-12)
    assert np.allclose(path.points_at(0.5)[1], [math.sqrt(2), math.sqrt(2), 0], atol=1e-12)
    assert repr(path) == "RigidPath(4 vertices)"


def test_a_full_turn_that_no_straight_step_sees() -> None:
    rest = [[2, 0, 0], [-1, 2, -1], [-1, -2, -1], [-1, 0, 3]]
    rest[1:] = [[0, 2 + dy, dz] for dy, dz in ((-1, -1), (1, -1), (0, 2))]
    path = tamis.RigidPath(
        rest, [0, 1, 1, 1], [tamis.turned_chain(STILL, [0, 0, 2 * math.pi], [0, 0, 0]), np.empty((0, 4, 3))]
    )
    found = tamis.narrow_phase(VF, [0, 1, 2, 3], path)
    assert found.touches[0] and found.toi_lower[0] <= 0.25 <= found.toi_upper[0]
    assert not tamis.narrow_phase(VF, [0, 1, 2, 3], path.points_at(0), path.points_at(1)).touches[0]
    assert not tamis.narrow_phase(VV, [0, 1, -1, -1], path, min_separation=0.5).touches[0]
    assert tamis.narrow_phase(VE, [0, 1, 2, -1], path, min_separation=1.5).touches[0]


def test_chains() -> None:
    end = [[1, 2, 3], [0, 0, 1]]
    assert tamis.interpolated_chain(STILL, end).shape == (1, 4, 3)
    path = tamis.RigidPath([[1, 0, 0]], [0], [tamis.chain_between(STILL, end)])
    assert np.allclose(path.points_at(1), [[1 + math.cos(1), 2 + math.sin(1), 3]], atol=1e-12)


def test_a_body_that_deforms_while_it_turns() -> None:
    turn = tamis.turned_chain(STILL, [0, 0, math.pi], [0, 0, 0])
    path = tamis.RigidPath([[1, 0, 0], [0, 0, 0]], [0, 1], [turn, np.empty((0, 4, 3))], [[3, 0, 0], [0, 4, 0]])
    assert np.allclose(path.points_at(0.5), [[0, 2, 0], [0, 2, 0]], atol=1e-12)
    met = tamis.narrow_phase(tamis.PairKind.VERTEX_VERTEX, [[0, 1, -1, -1]], path, min_separation=1e-9)
    assert met.touches[0] and met.toi_lower[0] == pytest.approx(0.5, abs=1e-6)


def test_bad_paths() -> None:
    with pytest.raises(tamis.InvalidPath, match="rest_end has 1 rows, rest 2"):
        tamis.RigidPath(np.zeros((2, 3)), [0, 0], [np.empty((0, 4, 3))], [[0, 0, 0]])
    with pytest.raises(tamis.InvalidPath):
        tamis.RigidPath([[0, 0, 0]], [1], [np.empty((0, 4, 3))])
    with pytest.raises(tamis.InvalidPath):
        tamis.RigidPath([[0, math.nan, 0]], [0], [np.empty((0, 4, 3))])
    with pytest.raises(tamis.InvalidPath):
        tamis.narrow_phase(EE, [0, 1, 2, 9], turning_rod())
    with pytest.raises(tamis.InvalidPath):
        turning_rod().points_at(1.5)
    with pytest.raises(tamis.InvalidPath):
        tamis.chain_between(STILL, [[0, 0, 0]])
    with pytest.raises(tamis.InvalidOptions):
        tamis.narrow_phase(EE, [0, 1, 2, 3], turning_rod(), tolerance=0.0)


def test_paths_say_that_they_cannot_be_pickled() -> None:
    frames = np.zeros((2, 3, 3))
    function = tamis.FunctionPath(1, lambda t, v: (frames[0][v], 0.0), lambda a, b, v: 0.0)
    for path in (turning_rod(), tamis.BezierPath(frames), tamis.CatmullRomPath(frames), function):
        for make in (pickle.dumps, copy.copy):
            with pytest.raises(TypeError, match=f"a {type(path).__name__} cannot be pickled or copied: pickle what"):
                make(path)
