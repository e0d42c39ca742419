"""Reads the structs and prototypes of the C interface from its headers."""
import ctypes
import pathlib
import re
from dataclasses import dataclass

NUMBERS = {"int": ctypes.c_int, "int32_t": ctypes.c_int32, "uint8_t": ctypes.c_uint8, "uint64_t": ctypes.c_uint64,
           "size_t": ctypes.c_size_t, "ptrdiff_t": ctypes.c_ssize_t, "double": ctypes.c_double,
           "tamis_status": ctypes.c_int}


@dataclass(frozen=True)
class Parameter:
    """A parameter of a function, or a field of a struct; `speaks_of_null`: the field's comment mentions NULL."""
    name: str
    type: str
    speaks_of_null: bool

    @property
    def is_pointer(self) -> bool:
        return self.type.endswith("*") or self.type == "function"


@dataclass(frozen=True)
class Function:
    name: str
    returns: str
    parameters: "tuple[Parameter, ...]"


@dataclass
class Interface:
    functions: "list[Function]"
    structs: "dict[str, list[Parameter]]"
    types: "dict[str, type]"  # the structs for ctypes


def _parameter(text: str, comment: str) -> Parameter:
    if "(*" in text:
        return Parameter(re.search(r"\(\*(\w+)\)", text)[1], "function", "NULL" in comment)
    kind, pointer, name = re.fullmatch(r"(.*?)\s*(\**)\s*(\w+)(?:\[\w+\])?", text.strip()).groups()
    return Parameter(name, kind + pointer, "NULL" in comment)


def _fields(body: str) -> "list[Parameter]":
    """Return the fields of a struct. A comment belongs to the field below it, or before it on the line."""
    found, above = [], ""
    for comment, field, behind in re.findall(r"(/\*\*.*?\*/)|([^;/]+);[ \t]*(/\*\*<.*?\*/)?", body, re.DOTALL):
        if comment:
            above = comment
            continue
        first, *others = [field] if "(*" in field else field.split(",")
        parameter = _parameter(" ".join(first.split()), above + behind)
        found += [parameter, *(_parameter(f"{parameter.type} {name}", behind) for name in others)]
        above = ""
    return found


def _ctype(parameter: Parameter, declared: str, types: "dict[str, type]") -> type:
    if parameter.is_pointer:
        return ctypes.c_void_p
    kind = NUMBERS.get(parameter.type) or types[parameter.type]
    length = re.search(rf"\b{parameter.name}\[(\w+)\]", declared)
    most = {"TAMIS_MOST_STAGES": 16, "TAMIS_MOST_KINDS": 8}
    return kind * (most.get(length[1]) or int(length[1])) if length else kind


def read(folder: pathlib.Path) -> Interface:
    text = "".join((folder / f"{name}.h").read_text() for name in ("status", "answers", "mesh", "detector", "pairs", "path", "world", "linkage"))
    assert len(list(folder.glob("*.h"))) == 8, f"a header in {folder} is not read here"
    structs, types = {}, {}
    for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\n\} \1;", text, re.DOTALL):
        structs[name] = _fields(body)
        types[name] = type(name, (ctypes.Structure,), {"_fields_": [(f.name, _ctype(f, body, types)) for f in structs[name]]})
    functions = []
    for returns, name, listed in re.findall(r"^TAMIS_API ([^(;]*?)\s*(tamis_\w+)\(([^)]*)\);", text, re.MULTILINE):
        parameters = [_parameter(" ".join(part.split()), "") for part in listed.split(",") if part.strip() != "void"]
        functions.append(Function(name, returns.strip(), tuple(parameters)))
    assert len(functions) == len(re.findall("^TAMIS_API ", text, re.MULTILINE)), "a prototype is not understood"
    return Interface(functions, structs, types)
