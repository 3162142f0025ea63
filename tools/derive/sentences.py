"""Take the texts of an exercise apart into sentences: its statement and its starter's docstring."""

from __future__ import annotations

import ast
import inspect
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tools import ROOT
from tools.derive.starters import make_starter

if TYPE_CHECKING:
    from collections.abc import Iterator

    from solutions import Exercise

#: Where a sentence ends: a full stop, then a space and what begins another one.
_END = re.compile(r"(?:(?<=[.?!:])|(?<=[.?!:]\*)|(?<=[.?!:]\*\*))\s+(?=[A-Z*`\[(])")

#: What stands after these is no new sentence.
_NO_END = re.compile(r"(?:\be\.g|\bi\.e|section)\.$|:\*{0,2}$")

#: The example on a page, which is the card's.
_EXAMPLE = re.compile(r"<!-- begin example .*?<!-- end example \w+ -->\n", re.DOTALL)

#: Where a code block of a statement stands.
CODE = "example"

#: A section that says where a formula stands asks for nothing.
_SOURCES = "References"


@dataclass(frozen=True)
class Sentence:
    """One sentence, or one line that counts as one: a code block, a parameter with its type."""

    place: str
    text: str

    def __str__(self) -> str:
        return f"{self.place}: {self.text}"


def list_sentences(exercise: Exercise) -> tuple[Sentence, ...]:
    """List what a learner reads of an exercise, in the order of the page."""
    page = (ROOT / exercise.home.exercises).with_suffix(".md").read_text(encoding="utf-8")
    statement = take_statement(page, exercise.name)
    tree = ast.parse(make_starter(exercise))
    function = next(node for node in tree.body if isinstance(node, ast.FunctionDef))
    docstring = inspect.cleandoc(ast.get_docstring(function) or "")
    lines = exercise.example.splitlines()
    called = re.compile(rf"\b{exercise.name}\b")  # or handed to what calls it
    call = next(line.strip() for line in lines if called.search(line))
    return (*split_statement(statement), Sentence(CODE, call), *split_docstring(docstring))


def take_statement(page: str, name: str) -> str:
    """Return what stands on a page between the heading of an exercise and its example.

    Raises
    ------
    ValueError
        If the page has no such exercise.
    """
    label = f"(exercise-{name.replace('_', '-')})=\n"
    _, found, rest = page.partition(label)
    statement, ends, _ = rest.partition(f"<!-- begin exercise {name} -->")
    if not found or not ends:
        raise ValueError(f"{name}: expected its heading and its starter on a page, got none")
    return _EXAMPLE.sub("", statement.partition("\n")[2]).strip()


def split_statement(statement: str) -> Iterator[Sentence]:
    """Split the text of a page; a code block is one sentence."""
    for block in re.split(r"\n\s*\n", statement):
        if block.startswith("```"):
            yield Sentence(CODE, _join(block.splitlines()[1:-1]))
        else:
            for sentence in split_sentences(_join(block.splitlines())):
                yield Sentence("statement", sentence)


def split_docstring(docstring: str) -> Iterator[Sentence]:
    """Split a docstring; a parameter with its type is one sentence, an example another."""
    section, entry = "summary", ""
    block: list[str] = []
    lines = docstring.splitlines()
    for number, line in enumerate([*lines, ""]):
        following = lines[number + 1] if number + 1 < len(lines) else ""
        is_title = bool(line) and not line.startswith(" ") and set(following) == {"-"}
        is_entry = section in ("Parameters", "Returns", "Raises") and not line.startswith(" ")
        if (not line or is_title or is_entry) and block:
            yield from _close(section, entry, block)
            block = []
        if is_title:
            section, entry = line, ""
        elif not line or set(line) == {"-"}:
            continue
        elif is_entry and section == "Parameters" and " : " not in line:
            section, entry, block = "summary", "", [line]  # a line of its own after the parameters
        elif is_entry:
            entry = line
            yield Sentence(section, line)
        else:
            block.append(line.strip())


def _close(section: str, entry: str, block: list[str]) -> Iterator[Sentence]:
    if section == _SOURCES:
        return
    place = f"{section}, {entry.partition(' :')[0]}" if entry else section
    if section == "Examples":
        yield Sentence(place, _join(block))
        return
    for sentence in split_sentences(_join(block)):
        yield Sentence(place, sentence)


def split_sentences(text: str) -> list[str]:
    """Split a paragraph where a sentence ends."""
    found: list[str] = []
    for piece in _END.split(text):
        if found and _NO_END.search(found[-1]):
            found[-1] += f" {piece}"
        else:
            found.append(piece)
    return found


def _join(lines: list[str]) -> str:
    return " ".join(line.strip() for line in lines if line.strip())
