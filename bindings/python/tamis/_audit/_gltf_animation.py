"""Animations of a glTF file, and the poses of its nodes at a time."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tamis._arrays import Doubles
from tamis._audit._gltf_buffers import Buffers
from tamis._checks import shown
from tamis._errors import InvalidOptions


class _Channel(NamedTuple):
    node: int
    path: str  # translation, rotation, scale, weights
    times: Doubles
    values: Doubles  # one row a key; for cubic splines three rows: tangent in, value, tangent out
    how: str  # LINEAR, STEP, CUBICSPLINE

    def at(self, time: float) -> Doubles:
        i = int(np.clip(np.searchsorted(self.times, time, side="right") - 1, 0, len(self.times) - 1))
        j = min(i + 1, len(self.times) - 1)
        length = self.times[j] - self.times[i]
        t = float(np.clip((time - self.times[i]) / length, 0, 1)) if length > 0 else 0.0
        if self.how == "CUBICSPLINE":
            found = _spline(self.values[3 * i : 3 * i + 3], self.values[3 * j : 3 * j + 3], t, float(length))
        elif self.how == "STEP" or i == j:
            found = self.values[i]
        elif self.path == "rotation":
            return _turned(self.values[i], self.values[j], t)
        else:
            found = (1 - t) * self.values[i] + t * self.values[j]
        return found / np.linalg.norm(found) if self.path == "rotation" else found


def _spline(first: Doubles, second: Doubles, t: float, length: float) -> Doubles:
    """Return the value at t in [0, 1] of the specification's Hermite spline between keys that are `length` s apart."""
    (_, a, out), (into, b, _) = first, second
    value: Doubles = (
        (2 * t**3 - 3 * t**2 + 1) * a
        + length * (t**3 - 2 * t**2 + t) * out
        + (3 * t**2 - 2 * t**3) * b
        + length * (t**3 - t**2) * into
    )
    return value


def _turned(a: Doubles, b: Doubles, t: float) -> Doubles:
    """Return the rotation at t in [0, 1] between two quaternions, on the shorter arc at constant speed (slerp)."""
    cosine = float(a @ b)
    if cosine < 0:
        b, cosine = -b, -cosine
    angle = np.arccos(min(cosine, 1.0))
    mixed = (1 - t) * a + t * b if angle < 1e-6 else np.sin((1 - t) * angle) * a + np.sin(t * angle) * b
    turned: Doubles = mixed / np.linalg.norm(mixed)
    return turned


class Animation:
    """The channels of one animation, by node and property."""

    def __init__(self, channels: list[_Channel]) -> None:
        self._channels = {(channel.node, channel.path): channel for channel in channels}

    def at(self, node: int, path: str, time: float) -> Doubles | None:
        """Return the value of a node's property at a time; None if the property is not animated."""
        channel = self._channels.get((node, path))
        return None if channel is None else channel.at(time)

    def frame_times(self, rate: float) -> Doubles:
        """Return times from the first key to the last key, `rate` a second, and always the last key's."""
        first = min((channel.times[0] for channel in self._channels.values()), default=0.0)
        last = max((channel.times[-1] for channel in self._channels.values()), default=0.0)
        count = int(np.floor((last - first) * rate + 1e-9))
        times = first + np.arange(count + 1) / rate
        return np.append(times, last) if last - times[-1] > 1e-9 else times


def animation_of(gltf: Any, buffers: Buffers, name: str, which: Any) -> Animation | None:
    """Return the animation of the number or name `which`, by default the first; None if the file has none."""
    animations = gltf.animations or []
    if which is None and not animations:
        return None
    names = [animation.name for animation in animations]
    wanted = 0 if which is None else names.index(which) if which in names else which
    if isinstance(wanted, bool) or not isinstance(wanted, int) or wanted not in range(len(animations)):
        raise InvalidOptions(f"{name} has no animation {shown(which)}: it has {names or 'none'}")
    return Animation(_channels(animations[wanted], buffers))


def _channels(animation: Any, buffers: Buffers) -> list[_Channel]:
    channels = []
    for channel in animation.channels:
        sampler = animation.samplers[channel.sampler]
        times = buffers.doubles(sampler.input)[:, 0]
        how = sampler.interpolation or "LINEAR"
        keys = len(times) * (3 if how == "CUBICSPLINE" else 1)
        values = buffers.doubles(sampler.output).reshape(keys, -1)  # morph weights are stored as scalars
        if channel.target.node is not None and len(times):
            channels.append(_Channel(channel.target.node, channel.target.path, times, values, how))
    return channels


class Pose:
    """The nodes of a file at one time of an animation."""

    def __init__(self, gltf: Any, animation: Animation | None, time: float) -> None:
        self._gltf, self._animation, self._time = gltf, animation, time
        self._worlds: dict[int, Doubles] = {}
        self._parents = {child: i for i, node in enumerate(gltf.nodes) for child in node.children or []}

    def world(self, node: int) -> Doubles:
        """Return the 4 x 4 matrix from the node's space to the world's; it multiplies columns."""
        above: list[int] = []
        next_above = node
        while next_above not in self._worlds:
            above.append(next_above)
            if len(above) > len(self._gltf.nodes):
                raise ValueError(f"node {node} is below itself")
            if (parent := self._parents.get(next_above)) is None:
                break
            next_above = parent
        for each in reversed(above):
            parent, local = self._parents.get(each), self._local(each)
            self._worlds[each] = local if parent is None else self._worlds[parent] @ local
        return self._worlds[node]

    def weights(self, node: int, default: Doubles) -> Doubles:
        """Return the weights of a node's morph targets."""
        found = self._value(node, "weights")
        return default if found is None else found

    def _value(self, node: int, path: str) -> Doubles | None:
        return None if self._animation is None else self._animation.at(node, path, self._time)

    def _local(self, node: int) -> Doubles:
        given = self._gltf.nodes[node]
        moved = [self._value(node, path) for path in ("translation", "rotation", "scale")]
        if given.matrix is not None and all(value is None for value in moved):
            matrix: Doubles = np.asarray(given.matrix, np.float64).reshape(4, 4).T
            return matrix
        defaults = (given.translation or [0, 0, 0], given.rotation or [0, 0, 0, 1], given.scale or [1, 1, 1])
        place, turn, scale = (np.asarray(d if m is None else m, np.float64) for m, d in zip(moved, defaults))
        local = np.eye(4)
        local[:3, :3] = _rotation(turn) * scale
        local[:3, 3] = place
        return local


def _rotation(quaternion: Doubles) -> Doubles:
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
