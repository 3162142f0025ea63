"""Read a built page section by section, as its reader sees it: for what searches the book."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from typing import Any

#: What is told apart in a section: its heading, the words it explains, its text, its code.
PARTS = ("heading", "terms", "text", "code")
TERM = "term-"  # with this begins the anchor of a term of the glossary
TEX_LAYOUT = re.compile(
    r"\\(?:frac|mathrm|mathbf|mathsf|operatorname|text|left|right|[dt]frac|q?quad|begin|end)\b"
)
TEX_SIGNS = re.compile(r"\\[()\[\],;:! ]|[{}\\]")
VOID = {"area", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
INLINE = {"a", "abbr", "b", "code", "em", "i", "kbd", "span", "strong", "sub", "sup"}
HEADINGS = {"h1", "h2", "h3", "h4", "h5", "h6"}
SKIPPED_TAGS = {"script", "style", "nav", "button", "svg", "noscript", "textarea"}
# answers of the quiz: a result must not give away what its page asks
SKIPPED_CLASSES = {
    "admonition-title",  # "Predict" is no part of a sentence
    "caption-number",
    "cell_output",
    "exercise-hint",  # says how to ask for one, on every exercise alike
    "headerlink",
    "page-stamp",
    "quiz-answers",
}


class SectionReader(HTMLParser):
    """Read the article of a page section by section; every glossary term is a section.

    `sections` holds one record each: its `anchor`, its `trail` (the headings above it) and its
    PARTS, as lists of pieces until `close` joins them.
    """

    def __init__(self) -> None:
        super().__init__()
        self.sections: list[dict[str, Any]] = []
        self._open: list[dict[str, Any]] = []
        # of every element that is open: its tag, and where its text goes
        self._elements: list[tuple[str, tuple[str, ...]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Open a section, or decide where the text of an element goes."""
        given = {key: value or "" for key, value in attrs}
        if tag == "article" and "bd-article" in given.get("class", ""):
            self._elements = [(tag, ("text",))]
        if not self._elements:
            return
        if tag not in INLINE:
            self._write(" ")
        if tag in VOID:
            return
        name = given.get("id", "")
        is_term = tag == "dt" and name.startswith(TERM)
        if (tag == "section" and name) or is_term:
            self._begin(name)
        elif tag == "span" and name and self._open:
            self._open[-1]["terms"].append(f" {name} ")  # a label, like exercise-depth-to-meters
        if tag == "span" and "data-tex" in given:
            self._write(_drop_tex(given["data-tex"]))
        goes = self._elements[-1][1]
        if tag != "article":
            goes = _choose_fields(tag, set(given.get("class", "").split()), goes, is_term=is_term)
        if tag == "table" and len(self._open) == 1:
            goes = ()  # the card at the top of a page: minutes, points, files
        self._elements.append((tag, goes))

    def handle_endtag(self, tag: str) -> None:
        """Close what the tag closes, and the section with it."""
        if not self._elements or tag in VOID:
            return
        while self._elements:
            closed, goes = self._elements.pop()
            if "terms" in goes and self._open:
                self._open[-1]["terms"].append(" ")  # two terms are two words
            if closed == tag:
                break
        if tag not in INLINE:
            self._write(" ")
        if self._open and (tag == "section" or (tag == "dd" and self._is_in_term())):
            self._open.pop()
        if tag == "article":
            self._elements = []

    def handle_data(self, data: str) -> None:
        """Keep a piece of text."""
        self._write(data)

    def close(self) -> None:
        """Join the pieces."""
        super().close()
        for section in self.sections:
            for field in PARTS:
                section[field] = " ".join("".join(section[field]).split())
        for section in self.sections:
            section["trail"] = [above["heading"] for above in section["trail"]]

    def _is_in_term(self) -> bool:
        return bool(self._open) and self._open[-1]["anchor"].startswith(TERM)

    def _begin(self, anchor: str) -> None:
        fields: dict[str, Any] = {field: [] for field in PARTS}
        section = {"anchor": anchor, "trail": list(self._open), **fields}
        self.sections.append(section)
        self._open.append(section)

    def _write(self, text: str) -> None:
        if self._open and self._elements:
            for field in self._elements[-1][1]:
                self._open[-1][field].append(text)


def _choose_fields(
    tag: str, classes: set[str], goes: tuple[str, ...], *, is_term: bool
) -> tuple[str, ...]:
    """Say which fields the text of an element belongs to; `goes` is where it went so far."""
    if tag == "figcaption":
        return ("text",)  # also below an output
    is_formula = "math" in classes  # a drawing; of one in a line of text the TeX is read
    if not goes or is_formula or tag in SKIPPED_TAGS or classes & SKIPPED_CLASSES:
        return ()
    if tag in HEADINGS or is_term:
        return ("heading",)
    if tag == "pre":
        return ("code",)
    if "text" in goes and (tag == "strong" or "std-term" in classes):
        return ("text", "terms")  # what is bold is defined there
    return goes


def _drop_tex(text: str) -> str:
    r"""Write inline formulas as plain text: `\(f_y\)` becomes f_y."""
    return TEX_SIGNS.sub("", TEX_LAYOUT.sub(" ", text))


def read_sections(html: str) -> list[dict[str, Any]]:
    """Return the sections of a page; see `SectionReader`."""
    reader = SectionReader()
    reader.feed(html)
    reader.close()
    return [one for one in reader.sections if one["heading"]]
