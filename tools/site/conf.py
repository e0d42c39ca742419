"""The configuration of Sphinx for the site (scripts/site.sh)."""
from __future__ import annotations

import inspect
import os
import pathlib
import re
import sys
from collections import _tuplegetter
from collections.abc import Iterator

HERE = pathlib.Path(__file__).resolve().parent
BUILT = pathlib.Path(os.environ["TAMIS_SITE"])
sys.path.insert(0, str(HERE))
from python_module import public_module  # noqa: E402

from sphinx.application import Sphinx  # noqa: E402
from sphinx.domains.c import CDomain  # noqa: E402
from sphinx.domains.cpp import CPPDomain  # noqa: E402
from sphinx.util import logging  # noqa: E402

project = html_title = "Tamis"
html_theme = "furo"
html_extra_path = [str(BUILT / "html")]
html_show_copyright = html_show_sphinx = html_show_sourcelink = html_copy_source = False
html_permalinks_icon = "#"
html_show_search_summary = False  # a page that is read from a file cannot fetch the summaries
pygments_style, pygments_dark_style = "friendly", "native"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 6
default_role = "code"
smartquotes = False
add_module_names = False
autodoc_typehints = "none"
autodoc_default_options = {"members": True, "undoc-members": True, "inherited-members": "tuple,BaseException,Exception,OSError,ValueError,int,Generic"}
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_custom_sections = [("Attributes", "params_style")]  # not a link for each name

public_module("tamis")


def require_docstring(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Warn about a public name without a docstring, and a field that its class does not list; a warning fails."""
    if not any(lines):
        logging.getLogger(__name__).warning("%s %s has no docstring", what, name)
    fields = obj._fields if isinstance(obj, type) and issubclass(obj, tuple) else getattr(obj, "__dataclass_fields__", ())
    for field in fields:
        if not re.search(rf"^(?:\w+, )*{field}(?:, \w+)*(?: : |$)", inspect.getdoc(obj) or "", re.MULTILINE):
            logging.getLogger(__name__).warning("the docstring of %s has no attribute %s", name, field)


def skip_field(app: Sphinx, what: str, name: str, obj: object, skip: bool, options: object) -> bool | None:
    """Skip what a named tuple has of each field: its class lists them, with their types."""
    return True if isinstance(obj, _tuplegetter) or getattr(tuple, name, None) is not None else None


class Cpp(CPPDomain):
    """C++ without the parameters of functions, which the search would list one by one."""

    def get_objects(self) -> Iterator[tuple[str, str, str, str, str, int]]:
        return (each for each in super().get_objects() if each[2] not in ("functionParam", "templateParam"))


class C(CDomain):
    """C without the parameters of functions."""

    def get_objects(self) -> Iterator[tuple[str, str, str, str, str, int]]:
        return (each for each in super().get_objects() if each[2] != "functionParam")


def setup(app: Sphinx) -> None:
    app.add_domain(Cpp, override=True)
    app.add_domain(C, override=True)
    app.connect("autodoc-skip-member", skip_field)
    app.connect("autodoc-process-docstring", require_docstring)
