"""Every argument of every public function, as signatures name them, is tried with wrong types, sizes and meanings.

What is refused is refused by a documented exception, whose sentence names the argument and says what to give. What no
one can mean is refused; nothing else may happen to it.
"""

from __future__ import annotations

import pathlib
from typing import Any

import pytest
from misuse.public import Argument, Callee, callees
from misuse.right import PATH, receiver_of, right_calls, use
from misuse.sentences import complaint
from misuse.wrong import wrong_values

CALLEES = callees()


def _call(callee: Callee, receiver: Any, given: dict[str, Any]) -> None:
    many = [name for name in given if any(a.name == name and a.is_many for a in callee.arguments)]
    by_name = {name: value for name, value in given.items() if name not in many}
    answer = callee.function(*([receiver] if callee.of else []), *(given[name] for name in many), **by_name)
    use(receiver if answer is None else answer)


def _complaints(callee: Callee, receiver: Any, argument: Argument, right: dict[str, Any]) -> list[str]:
    found = []
    for name, value, must_refuse in wrong_values(argument, right.get(argument.name)):
        try:
            _call(callee, receiver, {**right, argument.name: value})
            wrong = "was taken" if must_refuse else ""
        except Exception as error:
            wrong = complaint(error, argument.name, must_refuse)
        found += [f"{argument.name} = {name}: {wrong}"] if wrong else []
    return found


@pytest.mark.parametrize("callee", CALLEES, ids=lambda callee: callee.name)
def test_wrong_arguments_are_refused(callee: Callee, tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bugs: errors in the binding's own words; an attribute of None; a filter that cannot be called, but was taken."""
    monkeypatch.setattr("webbrowser.open", lambda url: True)
    monkeypatch.chdir(tmp_path)
    found = []
    receiver = receiver_of(callee)
    for right in right_calls(callee, tmp_path):
        _call(callee, receiver, right)
        for argument in (a for a in callee.arguments if right.get(a.name) is not PATH):
            found += _complaints(callee, receiver, argument, right)
    assert not found, "\n".join(found)
