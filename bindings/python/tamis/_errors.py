"""The exceptions of Tamis. Every message says what is wrong, where, and what to do."""

from __future__ import annotations


class Error(Exception):
    """Base of all exceptions of Tamis."""


class InvalidMesh(Error, ValueError):
    """A topology that cannot be used: an index out of range, no feature at all."""


class InvalidStep(Error, ValueError):
    """Positions that do not fit the mesh, are no rows of three numbers, or are not finite."""


class InvalidPath(Error, ValueError):
    """A path that does not fit the mesh, breaks what it promises, or lacks a vertex that it is asked about."""


class InvalidOptions(Error, ValueError):
    """An option outside its documented range, or an unknown name."""


class Cancelled(Error):
    """`is_cancelled` returned True and so ended the question. The detector may be asked again."""


class Busy(Error):
    """A question to a detector or world that is answering another one, of another thread or the one that calls this."""


class FileError(Error, OSError):
    """A file that cannot be used: which one, where in it, what is wrong, what to do."""
