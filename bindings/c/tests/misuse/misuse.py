#!/usr/bin/env python3
"""misuse.py LIBRARY HEADERS: tries wrong values for every argument and field that the headers declare.

Each call must return a code and, if a handle can hold it, a sentence of Tamis that says what to give. Values that can
have no meaning must be refused. The calls are made in a process of their own, so that a crash can be reported.
"""
import ctypes
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import headers
import right
import wrong

_RAW = re.compile(r"std::|vector(?!s\b)|max_size|bad_alloc|basic_string|optional|bad function|[Uu]nknown (?:error|exception)")
LAST = "TAMIS_LAST_CALL"  # the variable with the name of the file that describes the present call
OPTIONAL = ("options", "fractions", "center", "error")


class Session:
    def __init__(self, library: pathlib.Path, folder: pathlib.Path):
        self.library, self.interface = ctypes.CDLL(str(library)), headers.read(folder)
        self.calls, self.complaints = 0, []
        self.last = open(os.environ[LAST], "w")

    def call(self, function: headers.Function, arguments: dict):
        """Return the status, and the message of the handle; None if there is no handle."""
        native, given = getattr(self.library, function.name), []
        for parameter in function.parameters:
            value = arguments[parameter.name]
            if isinstance(value, (ctypes.Structure, ctypes.Array, ctypes.c_void_p)) and (
                    parameter.type.endswith("**") or not isinstance(value, ctypes.c_void_p)):
                value = ctypes.byref(value)
            given.append(value if parameter.is_pointer else headers.NUMBERS[parameter.type](value))
        self.calls += 1
        status = native(*given)
        return status, self.message(function, arguments)

    def message(self, function: headers.Function, arguments: dict):
        for parameter in function.parameters:
            kind = parameter.type.replace("const ", "").rstrip("*")
            say = getattr(self.library, f"{kind}_message", None) if kind.startswith("tamis_") else None
            made = parameter.type.endswith("**") or parameter == function.parameters[0]
            if say and made and not (parameter.type.startswith("const") and "create" in function.name):
                handle = arguments[parameter.name]
                say.restype = ctypes.c_char_p
                return say(handle).decode(errors="replace") if handle else None
        return None

    def handles(self) -> dict:
        """Return new handles, made from right arguments."""
        made = {}
        for kind, function in (("tamis_mesh", "tamis_mesh_create"), ("tamis_detector", "tamis_detector_create"),
                               ("tamis_pairs", "tamis_pairs_create"), ("tamis_path", "tamis_bezier_path_create"),
                               ("tamis_shape", "tamis_shape_create"), ("tamis_world", "tamis_world_create"),
                               ("tamis_linkage", "tamis_linkage_create")):
            made[kind] = self._made(self._function(function), made)
        for _ in range(2):  # bodies 0 and 1, which arguments name
            self._made(self._function("tamis_world_add"), made)
        return made

    def _function(self, name: str) -> headers.Function:
        return next(f for f in self.interface.functions if f.name == name)

    def _made(self, function: headers.Function, made: dict) -> ctypes.c_void_p:
        arguments = self.right(function, made)
        status, message = self.call(function, arguments)
        assert status == 0, f"{function.name}: {message}"
        return arguments[function.parameters[-1].name]

    def right(self, function: headers.Function, handles: dict) -> dict:
        return {p.name: right.argument(self.interface, function, p, handles) for p in function.parameters}

    def free(self, function: headers.Function, arguments: dict) -> None:
        for parameter in function.parameters:
            if parameter.type.endswith("**") and arguments[parameter.name]:
                getattr(self.library, parameter.type.rstrip("*") + "_free")(arguments[parameter.name])

    def attempt(self, what: str, function: headers.Function, arguments: dict, must_refuse: bool) -> None:
        self.last.seek(0)
        self.last.truncate()
        self.last.write(what)
        self.last.flush()
        status, message = self.call(function, arguments)
        wrong = "taken" if must_refuse and status == 0 else ""
        if status and message is not None and (_RAW.search(message) or ": " not in message):
            wrong = f"no sentence: {message!r}"
        if status == 0 and message:
            wrong = f"OK, and yet {message!r}"
        if not 0 <= status <= 9:
            wrong = f"the status {status}"
        self.complaints += [f"{what}: {wrong}"] if wrong else []
        self.free(function, arguments)

    def fields(self, function: headers.Function, parameter: headers.Parameter, handles: dict) -> None:
        kind = parameter.type.replace("const ", "").rstrip("*")
        for field in self.interface.structs[kind]:
            needs = field.speaks_of_null or "options" in kind
            asked = headers.Parameter(field.name, field.type, needs or field.name == "links")
            is_read = not (wrong.AT_REST.search(function.name) and field.name in wrong.NOT_AT_REST)
            for name, value, must in wrong.wrong_values(asked, right.FIELDS.get(field.name)):
                arguments = self.right(function, handles)
                arguments[parameter.name] = right.struct(self.interface, kind, **{field.name: value})
                self.attempt(f"{function.name}({parameter.name}.{field.name} = {name})", function, arguments, must and is_read)

    def function(self, function: headers.Function) -> None:
        handles = self.handles()
        arguments = self.right(function, handles)
        status, message = self.call(function, arguments)
        assert status == 0, f"{function.name}: {message}"
        self.free(function, arguments)
        for parameter in function.parameters:
            optional = headers.Parameter(parameter.name, parameter.type, parameter.name in OPTIONAL or "_copy_" in function.name)
            for name, value, must in wrong.wrong_values(optional, self.right(function, handles)[parameter.name]):
                changed = {**self.right(function, handles), parameter.name: value}
                self.attempt(f"{function.name}({parameter.name} = {name})", function, changed, must)
            if parameter.type.replace("const ", "").rstrip("*") in right.INPUTS:
                self.fields(function, parameter, handles)
        for kind, handle in handles.items():
            getattr(self.library, kind + "_free")(handle)


def main() -> int:
    if LAST in os.environ:
        return make_calls()
    with tempfile.NamedTemporaryFile("r") as last:
        status = subprocess.run([sys.executable, *sys.argv], env={**os.environ, LAST: last.name}).returncode
        if status < 0:
            print(f"signal {-status} in {last.read()}")
    return 1 if status else 0


def make_calls() -> int:
    session = Session(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:]))
    for function in session.interface.functions:
        if function.returns == "tamis_status":
            session.function(function)
        else:  # functions that make, describe or free must accept NULL
            getattr(session.library, function.name)(*(None for _ in function.parameters))
    print("\n".join(session.complaints))
    print(f"{session.calls} calls, {len(session.complaints)} complaints")
    return 1 if session.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
