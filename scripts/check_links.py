#!/usr/bin/env python3
"""Checks that links of documents, and names of documents and files in them and in comments, lead somewhere."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)
# A comment names a document, or a section of it: (docs/numerics/steps.md, "Step lengths").
SECTION = re.compile(r'(docs/[\w/-]+\.md)(?:[,:]? "([^"]+)")?')
FILE = re.compile(r"`([\w-]+(?:/[\w.-]+)*/[\w.-]+\.(?:cpp|hpp|h|py|sh|ts|md|txt|cmake|mjs|toml))`")
# What was found in old commits names files of that time.
OF_ITS_TIME = ("paper/notes/", "CHANGELOG.md")


def anchor(heading: str) -> str:
    """Return the anchor that a heading has in a rendered document."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.replace("`", ""))
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


def broken_links(document: pathlib.Path) -> list[str]:
    """Return what is wrong with a document's links to other files and to their sections."""
    broken = []
    for target in LINK.findall(document.read_text()):
        path, _, name = target.partition("#")
        file = (document.parent / path) if path else document
        if re.match(r"https?:|mailto:", target):
            continue
        if not file.exists():
            broken.append(f"{document.relative_to(ROOT)}: no file {target}")
        elif name and name not in map(anchor, HEADING.findall(file.read_text())):
            broken.append(f"{document.relative_to(ROOT)}: no section {target}")
    return broken


def missing_files(document: pathlib.Path, tracked: list[str]) -> list[str]:
    """Return which files that a document names, by a path or its end, are not there."""
    names = sorted(set(FILE.findall(document.read_text())))
    return [f"{document.relative_to(ROOT)}: no file {name}" for name in names
            if not (document.parent / name).exists() and not any(f"/{path}".endswith(f"/{name}") for path in tracked)]


def missing_sections(source: pathlib.Path) -> list[str]:
    """Return which documents, or sections of them, a source names that are not there."""
    # A comment may break within the section's name.
    text = re.sub(r"\n\s*(?://[/!]?|#|\*)?\s*", " ", source.read_text(errors="ignore"))
    missing = []
    for path, title in SECTION.findall(text):
        document = ROOT / path
        if not document.exists():
            missing.append(f"{source.relative_to(ROOT)}: no file {path}")
        elif not re.search(rf"^(#+ |(- )?\*+){re.escape(title)}", document.read_text(), re.MULTILINE):
            missing.append(f'{source.relative_to(ROOT)}: no section {path}, "{title}"')
    return missing


def main() -> int:
    """Print what leads nowhere. Exit code 1 if anything does, 77 outside of a Git checkout, whose files are checked."""
    if not (ROOT / ".git").exists():
        print("skipped: no Git checkout")
        return 77
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout
    tracked = [path for path in listed.split() if (ROOT / path).is_file()]
    wrong = []
    for path in tracked:
        if path.endswith(".md"):
            wrong += broken_links(ROOT / path)
            wrong += [] if path.startswith(OF_ITS_TIME) else missing_files(ROOT / path, tracked)
        elif path.endswith((".cpp", ".hpp", ".h", ".py", ".sh", ".txt", ".ts", ".rs")):
            wrong += missing_sections(ROOT / path)
    print("\n".join(wrong) or "all links and names of documents lead somewhere")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
