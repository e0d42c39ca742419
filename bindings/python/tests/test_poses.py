"""Poses made from rotations, and chains from one pose to another."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import tamis


def test_poses_of_rotations() -> None:
    """Would catch a quaternion's parts in another order, or a transposed matrix."""
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
    """Many poses at once are the same as one by one."""
    random = np.random.default_rng(1)
    start, end = random.normal(size=(2, 5, 2, 3))
    for make in (tamis.chain_between, tamis.interpolated_chain):
        assert np.array_equal(make(start, end), [make(*poses) for poses in zip(start, end)])
    turns = tamis.turned_chain(start, end[:, 1], end[:, 0])
    assert np.array_equal(turns, [tamis.turned_chain(s, e[1], e[0]) for s, e in zip(start, end)])
    about = tamis.chain_between(start, end, center=end[:, 1])
    assert np.array_equal(about, [tamis.chain_between(s, e, center=e[1]) for s, e in zip(start, end)])
    assert np.array_equal(tamis.nlerp_deviation(start, end), [tamis.nlerp_deviation(*p)[0] for p in zip(start, end)])
    with pytest.raises(tamis.InvalidPath, match="start has 5, end has 4"):
        tamis.chain_between(start, end[:4])
    with pytest.raises(tamis.InvalidPath, match="center has 4, start has 5: give one, or as many"):
        tamis.chain_between(start, end, center=end[:4, 1])


def test_pose_on_a_chain() -> None:
    """Many chains at once are the same as one by one; `chain_between` has the given poses at its ends."""
    start, end = np.random.default_rng(3).uniform(-1, 1, size=(2, 5, 2, 3))  # turned by less than pi
    chains = tamis.chain_between(start, end, center=end[:, 1])
    halfway = tamis.pose_at(chains, 0.5)
    assert halfway.shape == (5, 2, 3)
    assert np.array_equal(halfway, [tamis.pose_at(chain, 0.5) for chain in chains])
    assert np.allclose(tamis.pose_at(chains, 0), start, atol=1e-14)
    assert np.array_equal(tamis.pose_at(tamis.interpolated_chain(start, end), 1), end)
    assert tamis.pose_at(chains[:0], 0.5).shape == (0, 2, 3)
    with pytest.raises(tamis.InvalidPath, match=r"chain has the shape \(5, 2, 3\)"):
        tamis.pose_at(start, 0.5)
    with pytest.raises(tamis.InvalidPath, match="time is 2: give a number"):
        tamis.pose_at(chains, 2)
    with pytest.raises(tamis.InvalidPath, match="chain"):
        tamis.pose_at(np.full((1, 4, 3), np.nan), 0.5)


def test_chains_begin_and_end_at_their_poses() -> None:
    """Bug: the rotation at the start was dropped, so that a turned body had another place."""
    random = np.random.default_rng(2)
    corners, center = random.normal(size=(4, 3)), random.normal(size=3)
    poses = random.normal(size=(2, 6, 2, 3))

    def at(pose: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        return tamis.RigidPath(corners, [0] * 4, [tamis.interpolated_chain(pose, pose)]).points_at(0)

    for start, end, chain in zip(*poses, tamis.chain_between(*poses, center=center)):
        path = tamis.RigidPath(corners, [0] * 4, [chain])
        assert np.allclose(path.points_at(0), at(start), atol=1e-14)
        assert np.allclose(path.points_at(1), at(end), atol=1e-14)
        middle = tamis.RigidPath([center], [0], [chain]).points_at(0.25)
        ends = [tamis.RigidPath([center], [0], [tamis.interpolated_chain(p, p)]).points_at(0) for p in (start, end)]
        assert np.allclose(middle, 0.75 * ends[0] + 0.25 * ends[1], atol=1e-14)
    turn = tamis.turned_chain(poses[0, 0], [0, 0, 2.5], poses[1, 0, 0])
    assert np.allclose(tamis.RigidPath(corners, [0] * 4, [turn]).points_at(0), at(poses[0, 0]), atol=1e-14)
