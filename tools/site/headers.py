"""Writes the pages of public headers, in reStructuredText, from what Doxygen has read of them (XML)."""
from __future__ import annotations

import pathlib
import re
import textwrap
import xml.etree.ElementTree as ET
from collections.abc import Iterator

Node = ET.Element


def plain(node: Node | None) -> str:
    """Return the text of a declaration's part."""
    return "" if node is None else " ".join("".join(node.itertext()).split())


def escaped(text: str | None) -> str:
    return re.sub(r"([*`|_\\])", r"\\\1", text or "")


def part_of(node: Node, language: str) -> str:
    """Return a part of a paragraph: code stands in double backticks, a name that Doxygen has linked is linked."""
    text = plain(node)
    if node.tag == "ref" and re.fullmatch(r"[\w:]+(?:\(\))?", text):
        role = "cpp:any" if language == "cpp" else "c:func" if text.endswith(")") else "c:type"
        return f":{role}:`{text}`"
    return f"``{text}``" if node.tag in ("computeroutput", "ref") and text else text


def inline(node: Node, language: str) -> str:
    """Return a paragraph's text, without its lists."""
    parts = (part_of(part, language) + escaped(part.tail) for part in node if part.tag != "itemizedlist")
    return " ".join((escaped(node.text) + "".join(parts)).split())


def paragraphs(node: Node, language: str) -> Iterator[str]:
    """Yield the paragraphs of a comment. What it returns, throws and writes begins with a strong word."""
    for comment in ("briefdescription", "detaileddescription"):
        for para in node.iterfind(f"{comment}/para"):
            yield re.sub(r"^(Returns?|Throws?|Writes?)\b", r"**\1**", inline(para, language))
            for item in para.iterfind("itemizedlist/listitem"):
                yield "- " + " ".join(inline(each, language) for each in item.iterfind("para"))


def line_of(node: Node) -> int:
    return int(node.find("location").get("line"))


def template_of(node: Node) -> str:
    parameters = [f"{plain(each.find('type'))} {plain(each.find('declname'))}".strip()
                  for each in node.iterfind("templateparamlist/param")]
    return f"template<{', '.join(parameters)}> " if parameters else ""


class Header:
    """One header of a language, `cpp` or `c`, and what Doxygen has written about it into a folder."""

    def __init__(self, language: str, folder: pathlib.Path, path: str) -> None:
        self.language, self.folder, self.path = language, folder, path

    def read(self, name: str) -> Node:
        return ET.parse(self.folder / f"{name}.xml").getroot().find("compounddef")

    def entities(self) -> list[Node]:
        """Return what the header declares, in its order."""
        found = [self.read(file.stem) for pattern in ("class*", "struct*", "concept*") for file in self.folder.glob(pattern)]
        file = "namespacetamis" if self.language == "cpp" else re.sub(r"\.", "_8", self.path.rpartition("/")[2])
        found += self.read(file).iterfind("sectiondef/memberdef") if (self.folder / f"{file}.xml").exists() else []
        return sorted((each for each in found if each.find("location").get("file") == self.path), key=line_of)

    def directive(self, kind: str, declaration: str, node: Node, inside: str = "") -> str:
        body = "\n\n".join([*paragraphs(node, self.language), inside])
        return f".. {self.language}:{kind}:: {declaration}\n\n{textwrap.indent(body, '   ')}\n\n"

    def function(self, node: Node) -> str:
        words = ["explicit"] * (node.get("explicit") == "yes") + ["static"] * (node.get("static") == "yes")
        words += ["virtual"] * (node.get("virt") == "virtual") + [plain(node.find("type")), plain(node.find("name"))]
        requires = node.find("requiresclause")
        template = template_of(node) + (f"requires {plain(requires)} " if requires is not None else "")
        arguments = re.sub(r"=(default|0)$", "", plain(node.find("argsstring")))
        return self.directive("function", template + " ".join(filter(None, words)) + arguments, node)

    def variable(self, node: Node) -> str:
        kind, arguments = plain(node.find("type")), plain(node.find("argsstring"))
        start = plain(node.find("initializer")) if self.language == "cpp" else ""
        start = f" = {start}" if start.startswith("{") else f" {start}" if start else ""
        return self.directive("member", f"{kind} {plain(node.find('name'))}{arguments}{start}", node)

    def enum(self, node: Node) -> str:
        values = "".join(self.directive("enumerator", plain(each.find("name")), each) for each in node.iterfind("enumvalue"))
        kind = "enum-class" if node.get("strong") == "yes" else "enum"
        name = plain(node.find("name"))
        if not name or name.startswith("@"):  # an enum without a name
            name = f"@{plain(node.find('enumvalue/name'))}"
        return self.directive(kind, name, node, values)

    def alias(self, node: Node) -> str:
        aliased = plain(node.find("type"))
        if self.language == "c":  # a handle
            return self.directive("type", plain(node.find("name")), node)
        aliased = "" if "decltype" in aliased else f" = {aliased}"  # Sphinx does not read such types
        return self.directive("type", f"{template_of(node)}{plain(node.find('name'))}{aliased}", node)

    def record(self, node: Node) -> str:
        members = [each for each in node.iterfind("sectiondef/memberdef") if each.get("prot") == "public"]
        inside = "".join(map(self.entity, sorted(members, key=line_of)))
        name = plain(node.find("compoundname")).rpartition("::")[2]
        bases = [plain(each) for each in node.iterfind("basecompoundref")]
        kind = "struct" if node.get("kind") == "struct" else "class"
        return self.directive(kind, name + (f" : public {', '.join(bases)}" if bases else ""), node, inside)

    def concept(self, node: Node) -> str:
        return self.directive("concept", template_of(node) + plain(node.find("compoundname")).rpartition("::")[2], node)

    def entity(self, node: Node) -> str:
        kind = node.get("kind")
        # A function without a comment is a destructor, a default constructor or an override of one with a comment.
        if kind in ("friend", "define") or (kind == "function" and not any(paragraphs(node, self.language))):
            return ""
        write = {"function": self.function, "variable": self.variable, "enum": self.enum, "typedef": self.alias,
                 "concept": self.concept, "class": self.record, "struct": self.record}
        return write[kind](node)

    def page(self, about: str) -> str:
        """Return the header's page; `about` is its first comment."""
        scope = ".. cpp:namespace:: tamis\n\n" if self.language == "cpp" else ""
        title = f"{self.path}\n{'=' * len(self.path)}\n\n{about}\n\n{scope}"
        return title + "".join(map(self.entity, self.entities()))
