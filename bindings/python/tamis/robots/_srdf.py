"""Reads the pairs of links that an SRDF file disables."""

from __future__ import annotations

import os
import pathlib
import xml.etree.ElementTree as ElementTree
from collections.abc import Container

from tamis._errors import FileError


def disabled_pairs(file: str | os.PathLike[str], links: Container[str]) -> list[tuple[str, str]]:
    """Return the pairs of <disable_collisions>; raise FileError if one names a link that the robot lacks."""
    name = os.fspath(file)
    try:
        root = ElementTree.fromstring(pathlib.Path(name).read_bytes())
    except OSError as error:
        raise FileError(f"{name}: {error.strerror}: give an SRDF file that can be read") from None
    except ElementTree.ParseError as error:
        raise FileError(f"{name}: is no XML ({error}): give an SRDF file") from None
    for element in root:
        if element.tag in ("disable_default_collisions", "enable_collisions"):
            raise FileError(f"{name}: has <{element.tag}>, which is not read here: list pairs by <disable_collisions>")
    pairs = [(e.get("link1", ""), e.get("link2", "")) for e in root.iter("disable_collisions")]
    for pair in pairs:
        for link in pair:
            if link not in links:
                raise FileError(
                    f"{name}: disables the link {link!r}, which the robot has not: give the robot's own SRDF"
                )
    return pairs
