#!/usr/bin/env python3
"""pages.py FOLDER: copies the documents of this checkout into FOLDER, as the source of a site that Sphinx builds.

The pages are Markdown as a forge shows it. What only Sphinx needs is added to the copies: the tree of pages, which
follows docs/README.md, and the pages of the reference, one for each header and each part of the Python module.
"""
from __future__ import annotations

import inspect
import os
import pathlib
import re
import shutil
import subprocess
import sys

from headers import Header
from python_module import public_module

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCUMENTS = "docs/README.md"  # its parts and links, in their order, are the navigation
LINK = re.compile(r"(!?\[[^\]]*\])\(([^)\s]+)\)|(src=\")([^\"]+)(\")")
PROGRAM = '\n\n<p><a href="index.html">Try Tamis in this browser</a></p>\n'
# Part of the Python reference: its title, and the modules whose public names stand there.
PYTHON = {
    "detector": ("Detector", ["_detector", "_mesh", "_weld"]),
    "answers": ("Answers", ["_tables", "_answers", "_kinds", "_statistics", "_pages"]),
    "paths": ("Paths", ["_paths"]),
    "world": ("Worlds", ["_world"]),
    "pairs": ("Single pairs", ["_pairs", "_pair_distance"]),
    "files": ("Files and scenes", ["_files", "_scenes"]),
    "audit": ("Audits", ["_audit"]),
    "errors": ("Errors", ["_errors"]),
}
PYTHON_MODULES = ["tamis.bridge.ipctk", "tamis.compat.ipctk", "tamis.distributed", "tamis.mujoco", "tamis.newton",
                  "tamis.robots", "tamis.robots.ompl"]


def tree(entries: list[str], options: str = "") -> str:
    """Return a hidden table of contents, whose entries appear in the site's navigation."""
    return "\n\n```{toctree}\n:hidden:\n" + options + "\n" + "\n".join(entries) + "\n```\n"


def place(path: str) -> str:
    """Return where a document of the checkout stands in the site: the README of a folder is its first page.

    The site's own first page is the program (tools/program), so the README of the checkout is `overview`.
    """
    return "overview.md" if path == "README.md" else re.sub(r"(^|/)README\.md$", r"\1index.md", path)


def is_page(path: str) -> bool:
    return re.fullmatch(r"(?:(?:docs|paper)/.*|[^/]*)\.md", path) is not None


def copied(path: str, folder: pathlib.Path) -> str:
    """Return a document's text with the links of the site. Files that it links to, other than documents, are copied."""

    def mended(found: re.Match[str]) -> str:
        text, target = found[1] or found[3], found[2] or found[4]
        name, mark, section = target.partition("#")
        if not name or re.match(r"https?:|mailto:", target):
            return found[0]
        linked = os.path.normpath(pathlib.Path(path).parent / name)
        if is_page(linked):
            return f"{text}({os.path.relpath(place(linked), pathlib.Path(path).parent)}{mark}{section})"
        is_beside = name.endswith((".html", ".md"))  # Sphinx would take a document for one of its pages
        copy = folder / ("html" if is_beside else "source") / linked
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / linked, copy)
        # A page is opened, where Sphinx would offer it as a download.
        return f'<a href="{target}">{text[1:-1]}</a>' if is_beside else found[0]

    return LINK.sub(mended, (ROOT / path).read_text())


def navigation(pages: dict[str, str]) -> str:
    """Return the trees of the first page: a part for each bold heading of docs/README.md, and the reference."""
    trees, seen = [], {"overview.md"}
    for part in re.split(r"^(?=\*\*)", pages[place(DOCUMENTS)], flags=re.MULTILINE)[1:]:
        caption = re.match(r"\*\*(.*?)\*\*", part)[1].rstrip(":?")
        targets = [place(os.path.normpath(f"docs/{target.partition('#')[0]}")) for _, target, *_ in LINK.findall(part)]
        entries = [target for target in dict.fromkeys(targets) if target in pages and target not in seen]
        seen.update(entries)
        trees.append(tree(entries, f":caption: {caption}\n:maxdepth: 1\n"))
    trees.append(tree(["reference/cpp/index", "reference/c/index", "reference/python/index"], ":caption: Reference\n"))
    # A page that docs/README.md does not name stands under the first page of its folder.
    for name in sorted(set(pages) - seen - {place(DOCUMENTS)}):
        parent = f"{pathlib.Path(name).parent}/index.md"
        parent = parent if parent in seen else "paper/index.md" if name.startswith("paper/") else None
        if parent is None:
            sys.exit(f"pages: {name} is not in docs/README.md, nor has its folder a README.md there")
        pages[parent] += tree([os.path.relpath(name, pathlib.Path(parent).parent)])
    return "".join(trees)


def first_comment(text: str) -> str:
    """Return the comment that a header begins with."""
    found = re.match(r"(?://[^\n]*\n)+|/\*.*?\*/", text, re.DOTALL)[0]
    return re.sub(r"^ ?(?://|/?\*+/?) ?| \*/$", "", found, flags=re.MULTILINE)


def headers(language: str, title: str, folder: str, read: pathlib.Path, about: str) -> dict[str, str]:
    """Return the pages of the headers of one language, from what Doxygen has read."""
    found, names = {}, []
    for file in sorted((ROOT / folder).glob("*.h*")):
        if file.name in ("tamis.hpp", "tamis.h"):  # include the others
            continue
        names.append(file.stem)
        header = Header(language, read / "xml", file.relative_to(ROOT / "include").as_posix())
        found[f"reference/{language}/{file.stem}.rst"] = header.page(first_comment(file.read_text()))
    found[f"reference/{language}/index.md"] = f"# {title}\n\n{about}\n" + tree(names).replace(":hidden:", ":maxdepth: 2")
    return found


def described(module: str, name: str) -> str:
    """Return the directive that writes a public name's docstring into a page."""
    what = "autoclass" if inspect.isclass(getattr(public_module(module), name)) else "autofunction"
    return f"```{{eval-rst}}\n.. {what}:: {module}.{name}\n```\n"


def python_page(title: str, about: str, module: str, names: list[str]) -> str:
    return f"# {title}\n\n{about}\n\n" + "\n".join(described(module, name) for name in names)


def python_reference() -> dict[str, str]:
    """Return the pages of the Python module: each public name stands on the page of the module that defines it."""
    tamis, found, left = public_module("tamis"), {}, set(public_module("tamis").__all__)
    for page, (title, modules) in PYTHON.items():
        names = [name for module in modules for name in tamis.__all__ if getattr(tamis, name).__module__.split(".")[1] == module]
        left -= set(names)
        found[f"reference/python/{page}.md"] = python_page(title, "", "tamis", names)
    if left:
        sys.exit(f"pages: {', '.join(sorted(left))} stand on no page of the reference: add their modules to PYTHON")
    for module in PYTHON_MODULES:
        about = f"```{{eval-rst}}\n.. py:module:: {module}\n\n{inspect.getdoc(public_module(module))}\n```"
        found[f"reference/python/{module}.md"] = python_page(module, about, module, public_module(module).__all__)
    about = ("The public names of the module `tamis`, and the modules that are imported by themselves. "
             "[From Python](../../docs/python.md) leads through them.\n")
    pages = [*PYTHON, *PYTHON_MODULES]
    return found | {"reference/python/index.md": f"# Python\n\n{about}" + tree(pages).replace(":hidden:", ":maxdepth: 2")}


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout.split()
    pages = {place(path): copied(path, folder) for path in listed if is_page(path) and (ROOT / path).is_file()}
    pages["overview.md"] += PROGRAM + tree(["docs/index"]) + navigation(pages)
    pages |= headers("cpp", "C++", "include/tamis", folder / "cpp", "The public headers, all included by `tamis/tamis.hpp`. "
                     "[From C++](../../docs/cpp.md) leads through them.")
    pages |= headers("c", "C", "include/tamis/c", folder / "c", first_comment((ROOT / "include/tamis/tamis.h").read_text())
                     + "\n\n[From C](../../docs/c.md) leads through it.")
    pages |= python_reference()
    for name, text in pages.items():
        file = folder / "source" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


if __name__ == "__main__":
    main()
