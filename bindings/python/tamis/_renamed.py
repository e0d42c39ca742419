"""Names that were used before the first release: each is refused with the name that it has now."""

_IN_MODULE = {"between": "chain_between", "interpolated": "interpolated_chain", "turned": "turned_chain"}


def missing(owner: str, name: str, renamed: dict[str, str] = _IN_MODULE) -> AttributeError:
    """Return the error for an attribute that `owner` does not have."""
    if name in renamed:
        return AttributeError(f"{owner} has no attribute {name!r}: use {renamed[name]!r}, its name since version 0.1.0")
    return AttributeError(f"{owner} has no attribute {name!r}")
