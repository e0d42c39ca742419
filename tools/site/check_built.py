#!/usr/bin/env python3
"""check_built.py FOLDER: checks a built site. Links lead to files and sections, and nothing is loaded from elsewhere."""
from __future__ import annotations

import pathlib
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


class Page(HTMLParser):
    """What one page names: the sections it has, the links to others, and the files that a browser loads for it."""

    def __init__(self, file: pathlib.Path) -> None:
        super().__init__()
        self.sections: set[str] = set()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.feed(file.read_text())

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name == "id" and value:
                self.sections.add(value)
            if name in ("href", "src") and value:
                self.links.append(value)
                self.loaded += [value] * ((tag, name) in LOADED)


def broken(site: pathlib.Path, file: pathlib.Path, pages: dict[pathlib.Path, Page]) -> list[str]:
    """Return which links of a page lead nowhere, and what it would load from another server."""
    found = [f"loads {url}" for url in pages[file].loaded if urlsplit(url).netloc]
    for link in pages[file].links:
        url = urlsplit(link)
        if url.scheme or url.netloc:
            continue
        target = (file.parent / unquote(url.path)).resolve() if url.path else file
        if not target.is_file():
            found.append(f"no file {link}")
        elif url.fragment and target in pages and unquote(url.fragment) not in pages[target].sections:
            found.append(f"no section {link}")
    return [f"{file.relative_to(site)}: {each}" for each in found]


def main() -> int:
    """Print what is wrong. Exit code 1 if anything is."""
    site = pathlib.Path(sys.argv[1]).resolve()
    # Pages of the viewer are whole programs in one file, with links of their own making.
    pages = {file: Page(file) for file in sorted(site.rglob("*.html")) if "data-content_root" in file.read_text()[:200]}
    wrong = [each for file in pages for each in broken(site, file, pages)]
    for style in sorted(site.rglob("*.css")):
        urls = re.findall(r"url\(['\"]?((?:https?:)?//[^)'\"]+)", style.read_text())
        wrong += [f"{style.relative_to(site)}: loads {url}" for url in urls]
    print("\n".join(wrong) or f"{len(pages)} pages: every link leads somewhere, nothing comes from elsewhere")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
