#!/usr/bin/env python3
"""check_prose.py [FILE...]: checks that documents, comments, help texts and messages stay short and plain.

Per group of files it measures words, words a sentence, sentences over 30 words, and stumbling phrases per 1000 words,
and compares them with the group's limits. With files it prints their long sentences and phrases instead.
"""
from __future__ import annotations

import pathlib
import re
import subprocess
import sys
from collections.abc import Callable
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent
LONG = 30
# Phrases that readers stumble over, and plain words for them.
PHRASES = {
    r"(?<!there )\b(?:is|are|was|were) no\b(?! (?:longer|more|less|later|earlier|wider|farther|larger|smaller|greater))":
        "is not, there is no, does not",
    r"\b(?:is|are|was|were|be|been) asked\b|\basks?\b(?! for (?:help|confirmation))|\basked (?:about|of|for|with)\b":
        "query, call, request, test",
    r"\bleaves? out\b|\bleft out\b|\bleaving out\b": "skip, cull, omit",
    r"\bin vain\b|\bdearest\b|\bas ever\b|\bfor want of\b|\bbe it\b|\bsa(?:ys|id) so\b|\bgo(?:es)? on\b|\bcame\b":
        "a plain verb",
    r"\b(?:of|in|from|to|by|with) which\b": "two sentences",
    r"\b(?:that|those) of\b": "repeat the noun",
    r"\bwhat (?:is|are|was|may|can|must|it|they|a|an|the) ": "name the thing",
    r"\bin place of\b": "instead of",
    r"\bso that\b": "so",
}
FOR_CONTRIBUTORS = ("CONTRIBUTING.md", "docs/architecture.md", "docs/recipes.md", "docs/numerics/", "paper/")


class Limits(NamedTuple):
    """The most that a group of files may have; None: no limit."""

    words: int | None  # of the whole text, tables and programs included
    per_sentence: float
    long_percent: float
    phrases: float  # per 1000 words


def is_page(path: str) -> bool:
    return re.fullmatch(r"README\.md|docs/.*\.md", path) is not None and not path.startswith(FOR_CONTRIBUTORS)


def messages(_path: str, text: str) -> str:
    """Return the strings of a C++ source that have a few words, one a paragraph: help texts and messages."""
    text = re.sub(r"^\s*(?://|#include).*$", "", text, flags=re.MULTILINE)
    whole = re.findall(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', text)
    strings = ("".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', each)) for each in whole)
    return "\n\n".join(each.replace("\\n", "\n") for each in strings if len(re.findall(r"[a-z]{2,}", each)) > 3)


GROUPS = {
    "README.md": (lambda path: path == "README.md", Limits(900, 11.5, 2, 1)),
    "docs/performance.md": (lambda path: path == "docs/performance.md", Limits(2400, 12.5, 2, 1)),
    "pages for users": (is_page, Limits(44_000, 12.5, 2, 1)),
    "pages for contributors": (lambda path: path.startswith(FOR_CONTRIBUTORS) and path.endswith(".md"),
                               Limits(None, 14, 1.5, 0.5)),
    "all documents": (lambda path: path.endswith(".md"), Limits(None, 13, 1.5, 1)),
    "comments of the public headers": (lambda path: re.match(r"include/.*\.hp?p?$", path), Limits(None, 11, 1.5, 1)),
    "comments of the library": (lambda path: re.match(r"src/.*\.[hc]pp$", path), Limits(None, 12.3, 1.5, 1)),
    "docstrings and comments of the Python module": (lambda path: re.match(r"bindings/python/tamis/.*\.py$", path),
                                                     Limits(None, 12.5, 1.5, 0.8)),
}
# Sources whose strings users read.
SPEAKING = re.compile(r"(?:src|bindings/c|distributed/src|tools/(?:command|files|audit|scenes))/(?!.*tests/).*\.[hc]pp$")


def docstring(text: str) -> str:
    """Return a docstring's sentences, without headings, names with types, and examples."""
    text = re.sub(r"^ *(?:>>>|\.\.\.|-{3,}|.*\n *-{3,}$).*$", "\n", text, flags=re.MULTILINE)
    return re.sub(r"^ *[\w*, ]+ : .*$|^ *(?:[\w.]+Error|Error|Invalid\w+|Busy|Cancelled)(?:, \w+)*$", "\n", text, flags=re.MULTILINE)


def prose(path: str, text: str) -> str:
    """Return the sentences of a document or of a source's comments, without code, tables and headings."""
    if path.endswith(".md"):
        text = re.sub(r"```.*?```|<!--.*?-->|<[^>\n]+>|!\[[^\]]*\]\([^)]*\)", " ", text, flags=re.DOTALL)
        text = re.sub(r"^(?:\s*[|#]|    ).*$", "", text, flags=re.MULTILINE)
        return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    if path.endswith((".py", ".sh")):
        return "\n\n".join(map(docstring, re.findall(r'"""(.*?)"""', text, re.DOTALL))) + "\n\n" + "\n\n".join(re.findall(r"^\s*#(?!!) ?(.*)$", text, re.MULTILINE))
    lines = [re.search(r"^\s*//[/!<]* ?(.*)$|\s//[/!<]+ ?(.*)$", line) for line in text.split("\n")]
    blocks = re.findall(r"/\*(.*?)\*/", text, re.DOTALL)
    return "\n".join((found[1] or found[2] or "") if found else "" for found in lines) + "\n\n" + "\n\n".join(blocks)


def sentences(text: str) -> list[str]:
    found = []
    for block in re.split(r"\n\s*\n|\n\s*[-*] |\n\s*\d+\. ", re.sub(r"`[^`]*`", "CODE", text)):
        found += re.split(r"(?<=[.!?])\s+(?=[A-Z\"'(*_C])|(?<=:)\s+(?=[A-Z])", " ".join(block.split()))
    return [sentence for sentence in found if len(re.findall(r"[A-Za-z]+", sentence)) >= 3]


def phrases(sentence: str) -> list[str]:
    return [plain for pattern, plain in PHRASES.items() for _ in re.findall(pattern, sentence, re.IGNORECASE)]


def faults(texts: dict[str, str], limits: Limits, read: Callable[[str, str], str] = prose) -> list[str]:
    """Return which limits a group of files exceeds; `read` returns the sentences of one."""
    found = [sentence for path, text in texts.items() for sentence in sentences(read(path, text))]
    words = max(sum(len(sentence.split()) for sentence in found), 1)
    measured = Limits(sum(len(text.split()) for text in texts.values()), words / max(len(found), 1),
                      100 * sum(len(sentence.split()) > LONG for sentence in found) / max(len(found), 1),
                      1000 * sum(len(phrases(sentence)) for sentence in found) / words)
    names = ("words", "words a sentence", f"% of sentences over {LONG} words", "stumbling phrases per 1000 words")
    return [f"{value:.1f} {name}, at most {limit}" for value, limit, name in zip(measured, limits, names)
            if limit is not None and value > limit]


def show(path: str) -> None:
    text = pathlib.Path(path).read_text()
    strings = messages(path, text) if SPEAKING.match(path) else ""
    for sentence in sentences(prose(path, text)) + sentences(strings):
        advice = [f"{len(sentence.split())} words"] * (len(sentence.split()) > LONG) + phrases(sentence)
        if advice:
            print(f"{path}: {sentence[:160]}  [{'; '.join(advice)}]")


def main() -> int:
    """Print the groups that exceed a limit. Exit code 1 if one does, 77 outside of a Git checkout."""
    if sys.argv[1:]:
        for path in sys.argv[1:]:
            show(path)
        return 0
    if not (ROOT / ".git").exists():
        print("skipped: no Git checkout")
        return 77
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split()
    wrong = []
    groups = [(name, belongs, limits, prose) for name, (belongs, limits) in GROUPS.items()]
    for name, belongs, limits, read in [*groups, ("help texts and messages", SPEAKING.match, Limits(None, 10.8, 1.5, 1), messages)]:
        texts = {path: (ROOT / path).read_text() for path in listed if belongs(path) and (ROOT / path).is_file()}
        wrong += [f"{name}: {fault}: 'scripts/check_prose.py FILE' lists sentences" for fault in faults(texts, limits, read)]
    lines = len((ROOT / "README.md").read_text().splitlines())
    wrong += [f"README.md: {lines} lines, at most 120"] if lines > 120 else []
    print("\n".join(wrong) or "documents and comments are within their limits")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
