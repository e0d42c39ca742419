"""The examples in docstrings run, and print what the docstrings say."""

from __future__ import annotations

import doctest
import inspect

import numpy as np
import pytest

import tamis

HEADING = "\nExamples\n--------\n"
DOCUMENTED = {name: inspect.getdoc(getattr(tamis, name)) or "" for name in tamis.__all__}
WITH_EXAMPLES = [name for name, text in DOCUMENTED.items() if HEADING in text]


@pytest.mark.parametrize("name", WITH_EXAMPLES)
def test_examples_of(name: str) -> None:
    """Would catch a call or an answer that the library has no more."""
    names = {**{public: getattr(tamis, public) for public in tamis.__all__}, "np": np}
    examples = doctest.DocTestParser().get_doctest(DOCUMENTED[name].partition(HEADING)[2], names, name, None, None)
    printed: list[str] = []
    assert examples.examples
    doctest.DocTestRunner(verbose=False).run(examples, out=printed.append)
    assert not printed, "".join(printed)


def test_some_docstrings_have_examples() -> None:
    assert len(WITH_EXAMPLES) > 5
