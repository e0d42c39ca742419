"""Loads the compiled part. If it cannot work here, the import of tamis says why, and what to do."""

from __future__ import annotations

import sys
import sysconfig


def _check_python() -> None:
    """Raise ImportError unless this Python has the stable ABI for which the compiled part was built."""
    free = " without a GIL" if sysconfig.get_config_var("Py_GIL_DISABLED") else ""
    name = sys.implementation.name
    oldest = 12 if sys.platform == "win32" else 10  # nanobind is inside, or in a package of its own
    if name != "cpython" or sys.version_info < (3, oldest) or free:
        version = ".".join(map(str, sys.version_info[:2]))
        raise ImportError(
            f"tamis needs CPython 3.{oldest} or newer with a GIL, and {sys.executable} is {name} {version}{free}: "
            "use another Python"
        )


_check_python()
try:
    import tamis._core as _core
    from tamis._version import VERSION as VERSION
except ModuleNotFoundError as error:
    if error.name not in ("tamis._core", "tamis._version"):
        raise
    raise ImportError(
        f"tamis in {__file__.rpartition('_loading')[0]} has no compiled part for this Python: "
        "pip install --force-reinstall tamis, or in the clone pip install ."
    ) from None
if _core.__version__ != VERSION:
    raise ImportError(
        f"tamis {VERSION} has found a compiled part of version {_core.__version__}, {_core.__file__}: "
        "pip install --force-reinstall tamis"
    )
