"""Frames as matrices (4, 4)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._paths._rigid_path import pose_of


def turned(rotation: Doubles) -> Doubles:
    """Return the matrix (3, 3) of a rotation vector."""
    angle = float(np.linalg.norm(rotation))
    if angle == 0:
        return np.eye(3)
    x, y, z = rotation / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix: Doubles = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)
    return matrix


def placed(rotation: Doubles, position: Doubles) -> Doubles:
    """Return the frame of a rotation, as a matrix or as a rotation vector, and a position."""
    frame = np.eye(4)
    frame[:3, :3] = rotation if rotation.ndim == 2 else turned(rotation)
    frame[:3, 3] = position
    return frame


def frame_of(pose: npt.ArrayLike | None) -> Doubles:
    """Return a pose, as `tamis.pose_of` makes it, or a matrix (4, 4), as a frame; None is the identity."""
    if pose is None:
        return np.eye(4)
    given = np.asarray(pose, float)
    if given.shape == (4, 4):
        given = pose_of(given[:3, :3], given[:3, 3])
    checked = pose_of(given[1], given[0]) if given.shape == (2, 3) else pose_of(given, np.zeros(3))
    return placed(checked[1], checked[0])


def pose_of_frame(frame: Doubles) -> Doubles:
    """Return a frame as position and rotation vector, shape (2, 3)."""
    return pose_of(frame[:3, :3], frame[:3, 3])


def moved(points: Doubles, frame: Doubles) -> Doubles:
    """Return points that are given in a frame."""
    result: Doubles = points @ frame[:3, :3].T + frame[:3, 3]
    return result
