# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports the module `tamis` from the wheel in this add-on's folder into Blender's own Python."""

from __future__ import annotations

import pathlib
import sys
from typing import Any

_WHEEL = pathlib.Path(__file__).parent / "wheel"


class Trouble(Exception):
    """An error with a sentence for the user."""


def tamis() -> Any:
    """Return the module.

    Raises
    ------
    Trouble
        The wheel was built for another Python or another system.
    """
    if str(_WHEEL) not in sys.path:
        sys.path.append(str(_WHEEL))
    try:
        import tamis as module
    except ImportError as error:
        lines = [line for path in _WHEEL.glob("tamis-*.dist-info/WHEEL") for line in path.read_text().splitlines()]
        tags = [line[5:] for line in lines if line.startswith("Tag: ")]
        here = f"Python {sys.version_info[0]}.{sys.version_info[1]} on {sys.platform}"
        built = f"for {', '.join(tags)}" if tags else "without the wheel of Tamis"
        raise Trouble(
            f"this add-on was built {built}, and Blender runs {here}: install a zip that was built for it ({error})"
        ) from None
    return module
