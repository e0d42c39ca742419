"""Checks of single arguments of users: numbers, words, functions, names of files. Each error names the argument."""

from __future__ import annotations

import operator
import os
import reprlib
import sys
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from tamis._errors import Error, FileError, InvalidOptions

_Kind = TypeVar("_Kind")

LARGEST_INDEX = 2**31 - 1


def shown(given: object) -> str:
    """Return an object as error messages show it: short, and in one line."""
    text = " ".join(reprlib.repr(given).split())
    return f"of the type {type(given).__name__}" if text.startswith("<") or len(text) > 80 else text


def number(given: Any, name: str, error: type[Error] = InvalidOptions) -> float:
    """Return one real number as a float; raise for anything else, also for text and truth values."""
    is_single = not isinstance(given, (str, bytes, bytearray, bool, np.bool_)) and getattr(given, "ndim", 0) == 0
    try:
        if is_single and (hasattr(given, "__float__") or hasattr(given, "__index__")) and not np.iscomplexobj(given):
            value = float(given)
        else:
            raise TypeError
    except (TypeError, ValueError, OverflowError):
        raise error(f"{name} is {shown(given)}: give one number") from None
    if _is_rounded(given, value):
        raise error(f"{name} is {given!s}, which a double would round: give a double")
    return value


def _is_rounded(given: Any, value: float) -> bool:
    """Whether a double cannot hold an integer, or a number of NumPy's with more digits."""
    exact = given[()] if isinstance(given, np.ndarray) else given
    if isinstance(exact, (int, np.integer)):
        return int(exact) != value
    return isinstance(exact, np.longdouble) and exact == exact and np.longdouble(value) != exact


def number_from_zero(given: Any, name: str) -> float:
    """Return a finite number >= 0, for arguments that the library itself does not check."""
    value = number(given, name)
    if not 0 <= value < float("inf"):
        raise InvalidOptions(f"{name} is {value}: give a finite number >= 0")
    return value


def number_or_none(given: Any, name: str) -> float | None:
    """Return one number, or None for None."""
    return None if given is None else number(given, name)


def whole(given: Any, name: str, least: int = 0, error: type[Error] = InvalidOptions, advice: str = "") -> int:
    """Return a whole number in [least, 2^31); `advice` ends the sentence of the error."""
    try:
        value = None if isinstance(given, (bool, np.bool_)) else operator.index(given)
    except TypeError:
        value = None
    if value is None or not least <= value <= LARGEST_INDEX:
        raise error(f"{name} is {shown(given)}: give a whole number >= {least} and < 2^31{advice}")
    return value


def word(given: Any, name: str) -> str:
    """Return a text: not empty, no zero byte, no lone surrogate. The library checks whether it knows the word."""
    try:
        if isinstance(given, str) and "\0" not in given and given.encode():
            return given
    except UnicodeEncodeError:
        pass
    raise InvalidOptions(f"{name} is {shown(given)}: give a name, as text")


def truth(given: Any, name: str) -> bool:
    """Return True or False, NumPy's too; raise for anything else, such as 1 or None."""
    if not isinstance(given, (bool, np.bool_)):
        raise InvalidOptions(f"{name} is {shown(given)}: give True or False")
    return bool(given)


def function(given: Any, name: str, call: str, error: type[Error] = InvalidOptions) -> Callable[..., Any]:
    """Return a callable; `call` shows in the error how it will be called."""
    if not callable(given):
        raise error(f"{name} is {shown(given)}, which cannot be called: give a function, {call}")
    return given  # type: ignore[no-any-return]


def instance(given: Any, kind: type[_Kind], name: str, advice: str, error: type[Error] = InvalidOptions) -> _Kind:
    """Return an object of the class `kind`; `advice` says in the error what to give."""
    if not isinstance(given, kind):
        raise error(f"{name} is {shown(given)}: give {advice}")
    return given


def file_name(given: Any, name: str) -> str:
    """Return the name of a file as text: not empty, no zero byte, encodable by the system."""
    broken = "strict" if os.name == "nt" else "surrogateescape"  # on Windows names are text
    try:
        result = os.fsdecode(given)
        if "\0" not in result and result.encode(sys.getfilesystemencoding(), broken):
            return result
    except (TypeError, ValueError):
        pass
    raise FileError(f"{name} is {shown(given)}: give the name of a file")
