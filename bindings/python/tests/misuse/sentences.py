"""Checks that an error has a sentence of Tamis, which says which argument is wrong, and what to give."""

from __future__ import annotations

import re

import tamis

_RAW = re.compile(
    r"incompatible function|nanobind|_core|std::|max_size|bad_alloc|has no attribute|truth value|not subscriptable|"
    r"unhashable|object is not (?!an? )|unsupported operand|could not be broadcast|cannot reshape|<[\w.]+ object at"
)
# The words of the library's sentences for Python's arguments, whose names it does not know.
_WORDS = {
    "min_separation": ["minimum separation"],
    "min_distance": ["minimum separation"],
    "latest": ["latest time of interest"],
    "tmax": ["latest time of interest"],
    "bodies": ["body -?[0-9]+"],
    "chains": ["chain [0-9]+", "bodies"],
    "control_points": ["frame [0-9]+"],
    "frames": ["frame [0-9]+"],
    "vertices": ["pose"],
    "vertices_t0": ["start of the step"],
    "vertices_t1": ["end of the step"],
}
_ADVICE = re.compile(r"[:;,] \w")


def complaint(error: Exception, argument: str, is_type_wrong: bool) -> str:
    """Return what is wrong with the error of a call; "" if nothing is."""
    text = str(error)
    if isinstance(error, RuntimeError) and text.endswith("today"):  # raised by the argument itself: passed on as it is
        return ""
    if not isinstance(error, tamis.Error) and not (type(error) is IndexError and argument == "index"):
        return f"{type(error).__name__} instead of a documented one: {text[:200]}"
    if _RAW.search(text):
        return f"says what is inside: {text[:200]}"
    if "\n" in text or not 20 < len(text) < 400 or not _ADVICE.search(text):
        return f"is no sentence that says what to give: {text[:400]!r}"
    names = "|".join([argument, *_WORDS.get(argument, ())])
    if is_type_wrong and not re.search(rf"\b({names})\b", text):
        return f"does not name {argument}: {text[:200]}"
    return ""
