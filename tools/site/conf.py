"""The configuration of Sphinx for the site (scripts/site.sh)."""
from __future__ import annotations

import inspect
import os
import pathlib
import re
import sys
from collections import _tuplegetter

HERE = pathlib.Path(__file__).resolve().parent
BUILT = pathlib.Path(os.environ["TAMIS_SITE"])
sys.path.insert(0, str(HERE))
from python_module import public_module  # noqa: E402

from sphinx.application import Sphinx  # noqa: E402
from sphinx.util import logging  # noqa: E402

project = html_title = "Tamis"
html_theme = "furo"
html_static_path = [str(HERE / "static")]
html_css_files = ["site.css"]
html_extra_path = [str(BUILT / "html")]
html_show_copyright = html_show_sphinx = html_show_sourcelink = html_copy_source = False
html_permalinks_icon = "#"
html_show_search_summary = False  # a page that is read from a file cannot fetch the summaries
pygments_style, pygments_dark_style = "friendly", "native"

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 6
breathe_projects = {"cpp": str(BUILT / "cpp/xml"), "c": str(BUILT / "c/xml")}
breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False
default_role = "code"
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


def setup(app: Sphinx) -> None:
    app.connect("autodoc-skip-member", skip_field)
    app.connect("autodoc-process-docstring", require_docstring)
