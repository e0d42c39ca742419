"""The exceptions of Tamis. Every message names the fault, the place and the remedy."""

from __future__ import annotations


class Error(Exception):
    """Base of all exceptions of Tamis."""


class InvalidMesh(Error, ValueError):
    """A topology that cannot be used: an index out of range, no feature at all."""


class InvalidStep(Error, ValueError):
    """Positions that do not fit the mesh, are not rows of three numbers, or are not finite."""


class InvalidPath(Error, ValueError):
    """A path that does not fit the mesh, breaks its promises, or lacks a vertex of a question."""


class InvalidOptions(Error, ValueError):
    """An option outside its documented range, or an unknown name."""


class Cancelled(Error):
    """`is_cancelled` returned True and so ended the question. The detector may be queried again."""


class Busy(Error):
    """A question to a detector or world that is still answering another one, of this or another thread."""


class FileError(Error, OSError):
    """A file that cannot be used. The message names the file, the place, the fault and the remedy."""
