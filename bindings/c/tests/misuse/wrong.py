"""Wrong values for arguments and fields, by type: NULL, counts that no array has, numbers out of range."""
import ctypes
import math
import re

import headers
import right

_HUGE = 2**64 - 1
_NUMBERS = {
    "int32_t": (-1, 7, -2**31, 2**31 - 1),
    "size_t": (_HUGE, _HUGE // 2, 2**60, 2**55),
    "ptrdiff_t": (-1, 1, 2, -2**63, 2**63 - 1),
    "double": (math.nan, math.inf, -math.inf, -1.0, 1.5, 1e308, 5e-324),
    "const char*": (b"", b"nonsense", b"x" * 10000, b"\xff\xfe"),
}
# Questions about a pose read only the start of a step.
AT_REST, NOT_AT_REST = re.compile("_(pairs_within|intersections?|distances_of)$"), ("end", "end_stride", "min_separation", "at_start")
# The library reads as many rows as the caller says: it cannot refuse a count that an array may have.
_TAKEN_AT_ITS_WORD = ("vertex_count", "group_count")
_NEVER_RIGHT = (math.nan, math.inf, -math.inf, -1.0, -1, -2**31)


def _spoilt(value):
    """Yield a name, the array with one number changed, and whether it must be refused."""
    is_double = value._type_ is ctypes.c_double
    for number in (math.nan, math.inf, -math.inf) if is_double else (-1, 2**31 - 1, 10**6, -2**31):
        changed = type(value)(*value)
        changed[0] = number
        yield f"one of them {number}", changed, is_double


def wrong_values(parameter: headers.Parameter, value):
    """Yield a name, a value, and whether it must be refused."""
    if parameter.is_pointer:
        yield "NULL", None, not parameter.speaks_of_null and parameter.name != "user"
    if isinstance(value, ctypes.Array) and value._type_ in (ctypes.c_double, ctypes.c_int32):
        yield from _spoilt(value)
    if isinstance(value, tuple):
        yield from ((f"one of them {number}", (number, *value[1:]), False) for number in _NUMBERS[parameter.type])
        return
    if parameter.type == "const double*" and isinstance(value, float):
        yield from ((f"to {number}", number, True) for number in _NEVER_RIGHT if isinstance(number, float))
    if parameter.name == "size" or parameter.name.endswith("_size"):
        yield from ((str(size), size, True) for size in (0, 3, _HUGE, 2**40))
        return
    for number in _NUMBERS.get(parameter.type, ()):
        if not (parameter.name in _TAKEN_AT_ITS_WORD and number == 2**31 - 1):
            must = number in _NEVER_RIGHT or number != number or parameter.type in ("size_t", "ptrdiff_t", "const char*")
            yield str(number)[:40], number, must and parameter.name not in ("u", "v")
