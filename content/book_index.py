"""The index of the book: where its terms, functions and errors stand, found in the pages.

Nothing in it is typed. A term is found where a page links to the glossary, a function where a cell
calls it, an error where a page has one under "Common errors" or in the table of the troubleshooting
page.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from content import ROOT
from content.toc import list_pages

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

MOST_PLACES = 3  # of a term or a function: where it is met first
#: Pages that explain or use nothing: the glossary itself, sources, how the book is made.
LEFT_OUT = ("index", "glossary", "references", "architecture", "index_of_terms")
REPEATED = "\n## Recap\n"  # from here on a page only repeats
ERRORS = "{page}-errors"  # label of the section "Common errors" of a page

PAGE_LABEL = re.compile(r"^\(([\w-]+)\)=\n+# ", re.MULTILINE)
HEADING = re.compile(r"^(?:\(([\w-]+)\)=\n+)?(##+) ", re.MULTILINE)
TITLE = re.compile(r"^# (.+)$", re.MULTILINE)
TERM = re.compile(r"\{term\}`(?:[^`<]*<)?([^`<>]+)>?`")
ENTRY = re.compile(r"^([^\s:].*)\n  \S", re.MULTILINE)
CELL = re.compile(r"^```\{code-cell\}.*?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COMMON_ERRORS = re.compile(r"^## Common errors\n(.*?)^## ", re.MULTILINE | re.DOTALL)
ERROR = re.compile(r"^(?:\*\*(.+?)\.\*\*|:+\{admonition\} Pitfall: (.+)$)", re.MULTILINE)
SYMPTOM = re.compile(r"^\| (.+?) \| (\{ref\}`[\w-]+`) \|$", re.MULTILINE)


@dataclass(frozen=True)
class Page:
    """A page of the book: its name without folder and ending, its text."""

    name: str
    text: str

    @property
    def title(self) -> str:
        """The first words of its heading: Step 4."""
        found = TITLE.search(self.text)
        return found[1].partition(":")[0] if found else self.name

    def find_label(self, place: int) -> str | None:
        """Return the label of the section that a place of the text is in."""
        for found in reversed([*HEADING.finditer(self.text, 0, place)]):
            if found[1]:
                return found[1]
            if found[2] == "##":  # a section without a label: the page is the best there is
                break
        page = PAGE_LABEL.search(self.text)
        return page[1] if page else None


def read_pages(root: Path = ROOT) -> list[Page]:
    """Read the pages of ``book/`` that explain something, in their order."""
    names = [name.removeprefix("book/") for name in list_pages(root) if name.startswith("book/")]
    return [
        Page(name, (root / "book" / f"{name}.md").read_text(encoding="utf-8"))
        for name in names
        if name not in LEFT_OUT
    ]


def make_index(functions: Iterable[str], root: Path = ROOT) -> dict[str, str]:
    """Write the index: its tables of terms, functions and errors, as MyST Markdown.

    Parameters
    ----------
    functions : iterable of str
        The public names of the library.
    root : Path
        The repository.

    Returns
    -------
    dict of str to str
        The tables; a term or a function that no page names is left out.
    """
    pages = read_pages(root)
    glossary = (root / "book" / "glossary.md").read_text(encoding="utf-8")
    sections = {
        "terms": ("Term", "Where it is met first", list_terms(pages, glossary)),
        "functions": ("Function", "Where cells call it", list_functions(pages, functions)),
        "errors": ("What you see", "Where it is explained", list_errors(pages)),
    }
    return {
        name: "\n".join([f"| {left} | {right} |", "|---|---|", *rows, ""])
        for name, (left, right, rows) in sections.items()
    }


def list_terms(pages: list[Page], glossary: str) -> list[str]:
    """List the rows of the terms of the glossary, by letter."""
    rows = []
    for term in sorted(ENTRY.findall(glossary.partition(":::{glossary}\n")[2]), key=str.lower):
        places = _find_places(pages, TERM, term)
        if places:
            rows.append(f"| {{term}}`{term}` | {places} |")
    return rows


def list_functions(pages: list[Page], functions: Iterable[str]) -> list[str]:
    """List the rows of the functions, by letter."""
    rows = []
    for name in sorted(functions, key=str.lower):
        pattern = re.compile(rf"(?<![\w.])(?:lab\.)?({re.escape(name)})\(")
        places = _find_places(pages, pattern, name, in_cells=True)
        if places:
            rows.append(f"| `{name}` | {places} |")
    return rows


def list_errors(pages: list[Page]) -> list[str]:
    """List the rows of the errors: by symptom first, then page by page."""
    rows = []
    for page in pages:
        rows += [f"| {seen} | {where} |" for seen, where in SYMPTOM.findall(page.text)]
    for page in pages:
        for section in COMMON_ERRORS.findall(page.text):
            link = f"{{ref}}`{page.title} <{ERRORS.format(page=page.name)}>`"
            for bold, pitfall in ERROR.findall(section):
                rows.append(f"| {_begin_small(bold or pitfall)} | {link} |")
    return rows


def _begin_small(words: str) -> str:
    """Begin with a small letter, unless the first word is a name such as K."""
    return words[:1].lower() + words[1:] if words[1:2].islower() else words


def _find_places(
    pages: list[Page], pattern: re.Pattern[str], name: str, *, in_cells: bool = False
) -> str:
    """Link to the first sections of the first pages in which a pattern finds a name."""
    links = []
    for page in pages:
        spans = (
            [found.span(1) for found in CELL.finditer(page.text)]
            if in_cells
            else [(0, len(page.text.partition(REPEATED)[0]))]
        )
        found = (one for span in spans for one in pattern.finditer(page.text, *span))
        place = next((one.start() for one in found if one[1] == name), None)
        label = None if place is None else page.find_label(place)
        if label is not None:
            links.append(f"{{ref}}`{page.title} <{label}>`")
    return ", ".join(links[:MOST_PLACES])
