"""The compiled part's options of an audit, made from Python's keywords."""

from __future__ import annotations

from typing import Callable

from tamis import _core
from tamis._checks import number, truth, whole


def make_audit_options(
    *,
    min_separation: float,
    threads: int,
    intersections: bool,
    contacts: bool,
    ring_limit: int,
    listed_pairs: int,
    page_bytes: int,
    progress: Callable[[int], object] | None = None,
) -> _core.AuditOptions:
    """Check the keywords; return the options."""
    return _core.AuditOptions(
        number(min_separation, "min_separation"),
        whole(threads, "threads", advice=", 0 being all"),
        truth(intersections, "intersections"),
        truth(contacts, "contacts"),
        whole(ring_limit, "ring_limit", 1),
        whole(listed_pairs, "listed_pairs"),
        whole(page_bytes, "page_bytes"),
        progress,
    )
