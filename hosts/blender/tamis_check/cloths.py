# SPDX-License-Identifier: GPL-3.0-or-later
"""Cloths whose quality is set frame by frame, and whose cache on the disk can be cut off after any frame.

Blender forgets a cache when a setting of its cloth is set, and keeps it when the setting is animated. It goes on
simulating from the last frame that the cache has.
"""

from __future__ import annotations

import pathlib
from typing import Any

import bpy

from .library import Trouble

_SETTINGS = ("settings.quality", "collision_settings.collision_quality")


def cloths_of(objects: list[Any], frames: range, better: tuple[int, int]) -> list[Cloth]:
    """Return those among some objects."""
    found = [(thing, modifier) for thing in objects for modifier in thing.modifiers if modifier.type == "CLOTH"]
    return [Cloth(thing, modifier, frames, better) for thing, modifier in found]


class Cloth:
    """`better` is what the two kinds of quality are in frames that are to be improved, if they are lower."""

    def __init__(self, thing: Any, modifier: Any, frames: range, better: tuple[int, int]) -> None:
        self._cache, self._frames, self._better = modifier.point_cache, frames, better
        self._files = _files_of(thing, self._cache)
        paths = [f'modifiers["{bpy.utils.escape_identifier(modifier.name)}"].{setting}' for setting in _SETTINGS]
        self._curves = [_curve(thing, path, frames[0]) for path in paths]

    def improve(self, frames: range) -> None:
        """Have some frames simulated at the better quality."""
        for curve, better in zip(self._curves, self._better):
            values = {frame: round(curve.evaluate(frame)) for frame in range(self._frames[0], frames[-1] + 2)}
            values |= {frame: max(values[frame], better) for frame in frames}
            for frame, value in values.items():
                curve.keyframe_points.insert(frame, value, options={"FAST"}).interpolation = "CONSTANT"
            curve.update()

    def forget_after(self, last: int) -> None:
        """Take all later frames out of the cache."""
        folder, name = self._files
        for file in folder.glob(f"{name}_*_{self._cache.index:02}.bphys"):
            if int(file.stem.split("_")[-2]) > last:
                file.unlink()


def _files_of(thing: Any, cache: Any) -> tuple[pathlib.Path, str]:
    """The folder and how names begin, as Blender makes them."""
    if cache.is_baked:
        raise Trouble(f"the cache of {thing.name} is baked: free the bake, whose frames cannot be simulated anew")
    if not cache.use_disk_cache or cache.use_external or not bpy.data.filepath:
        raise Trouble(
            f"the cache of {thing.name} is in memory, where single frames cannot be simulated anew: save the file, and "
            "set Disk Cache in the panel of the cloth's cache"
        )
    name = cache.name or "".join(f"{byte:02X}" for byte in thing.name.encode())
    return pathlib.Path(bpy.path.abspath(f"//blendcache_{pathlib.Path(bpy.data.filepath).stem}")), name


def _curve(thing: Any, path: str, frame: int) -> Any:
    """The animation of a setting; one that stays as it is if there was none."""
    found = _find_curve(thing, path)
    if found is None:
        thing.keyframe_insert(path, frame=frame)
        found = _find_curve(thing, path)
    return found


def _find_curve(thing: Any, path: str) -> Any:
    animation = thing.animation_data
    if animation is None or animation.action is None:
        return None
    if hasattr(animation.action, "fcurves"):  # before Blender 5
        return animation.action.fcurves.find(path)
    bags = [strip.channelbag(animation.action_slot) for layer in animation.action.layers for strip in layer.strips]
    return next((curve for bag in bags if bag for curve in [bag.fcurves.find(path)] if curve), None)
