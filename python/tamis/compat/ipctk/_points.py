"""Single points as ipctk takes them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, finite, numbers
from tamis._errors import InvalidStep


def stacked(**points: npt.ArrayLike) -> Doubles:
    """Return points, by the names that the caller knows them by, as rows."""
    return np.stack([_point(point, name) for name, point in points.items()])


def _point(given: npt.ArrayLike, name: str) -> Doubles:
    """One point, as a row or as a column."""
    array = numbers(given, name, InvalidStep)
    if array.shape not in ((3,), (1, 3), (3, 1)):
        advice = "give three numbers in a row; points in the plane have a z of 0"
        raise InvalidStep(f"{name} has {array.size} numbers in {array.ndim} dimensions: {advice}")
    return finite(array.ravel().astype(np.float64), name, InvalidStep)
