"""Finds the public functions of the module, and the kinds of their arguments, in the module itself."""

from __future__ import annotations

import enum
import importlib
import importlib.util
import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import tamis
import tamis.compat.ipctk


@dataclass(frozen=True)
class Argument:
    """A parameter, and the kinds of values that its annotation allows."""

    name: str
    takes: tuple[str, ...]
    is_many: bool


@dataclass(frozen=True)
class Callee:
    """A function, a class, a method or the setter of a property; `of` is the class of the last two."""

    name: str
    function: Callable[..., Any]
    of: type | None
    arguments: tuple[Argument, ...]


_KINDS = {
    "int": "whole",
    "float": "number",
    "str": "word",
    "bool": "truth",
    "None": "nothing",
    "npt.ArrayLike": "array",
    "Isa": "word",
    "AtStart": "word",
    "Filter": "function",
    "PointsAt": "function",
    "Deviations": "function",
    "os.PathLike[str]": "file",
    "Objects": "objects",
    "Usd.Stage": "stage",
    "Sequence[str]": "words",
    "Sequence[npt.ArrayLike]": "arrays",
    "Any": "index",
}


def _kind(annotation: str) -> str:
    if annotation in _KINDS:
        return _KINDS[annotation]
    if annotation.startswith("npt.NDArray"):
        return "table"
    return "function" if annotation.startswith("Callable[") else annotation  # else the name of a class


def _takes(annotation: str) -> tuple[str, ...]:
    kinds = tuple(_kind(part) for part in re.split(r" \| (?![^\[]*\])", annotation))
    return tuple(kind for kind in kinds if kind != "word") if "file" in kinds else kinds


def _arguments(function: Callable[..., Any]) -> tuple[Argument, ...]:
    found = []
    for name, parameter in inspect.signature(function).parameters.items():
        if name != "self" and parameter.kind != parameter.VAR_KEYWORD:
            assert isinstance(parameter.annotation, str), f"{function.__qualname__}: {name} has no annotation"
            takes, is_many = _takes(parameter.annotation), parameter.kind == parameter.VAR_POSITIONAL
            found.append(Argument(name, takes, is_many))
    return tuple(found)


def _is_record(thing: type) -> bool:
    """Return whether a class is an answer that is only read, or an exception: their arguments are not checked."""
    return issubclass(thing, (tuple, BaseException)) or thing in (tamis.Statistics, tamis.AuditReport, tamis.Motion)


def _methods(thing: type) -> Iterator[Callee]:
    for name in dir(thing):
        value = inspect.getattr_static(thing, name)
        setter = value.fset if isinstance(value, property) else None
        function = setter or value
        is_ours = inspect.isfunction(function) and function.__module__.startswith("tamis")
        if is_ours and (not name.startswith("_") or name == "__getitem__"):
            yield Callee(f"{thing.__name__}.{name}", function, thing, _arguments(function))


def _of_module(module: ModuleType, prefix: str) -> Iterator[Callee]:
    for name in module.__all__:
        thing = getattr(module, name)
        if not isinstance(thing, type):
            yield Callee(prefix + name, thing, None, _arguments(thing) if inspect.isfunction(thing) else ())
            continue
        makes = not _is_record(thing) and not inspect.isabstract(thing) and not issubclass(thing, enum.Enum)
        constructor = inspect.getattr_static(thing, "__init__")
        if makes and inspect.isfunction(constructor):
            yield Callee(prefix + name, thing, None, _arguments(constructor))
        if not inspect.isabstract(thing):
            yield from (Callee(prefix + m.name, m.function, m.of, m.arguments) for m in _methods(thing))


def callees() -> list[Callee]:
    """Return everything that users may call with arguments."""
    found = [*_of_module(tamis, ""), *_of_module(tamis.compat.ipctk, "ipctk.")]
    if importlib.util.find_spec("ipctk"):  # which has no wheel for some Pythons
        found += _of_module(importlib.import_module("tamis.bridge.ipctk"), "bridge.")
    return [callee for callee in found if callee.arguments]
