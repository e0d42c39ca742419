"""Names that were used before the first release: each is refused with the name that it has now."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NoReturn, TypeVar

_T = TypeVar("_T")
_IN_MODULE = {"between": "chain_between", "interpolated": "interpolated_chain", "turned": "turned_chain"}


def missing(owner: str, name: str, names: dict[str, str] = _IN_MODULE) -> AttributeError:
    """Return the error for an attribute that `owner` does not have."""
    if name in names:
        return AttributeError(f"{owner} has no attribute {name!r}: use {names[name]!r}, its name since version 0.1.0")
    return AttributeError(f"{owner} has no attribute {name!r}")


def renamed(**names: str) -> Callable[[type[_T]], type[_T]]:
    """Make a class refuse the old names of its attributes with the new ones."""

    def refuse(self: Any, name: str) -> NoReturn:
        raise missing(f"{type(self).__name__!r} object", name, names)

    def with_refusal(owner: type[_T]) -> type[_T]:
        owner.__getattr__ = refuse  # type: ignore[attr-defined]
        return owner

    return with_refusal
