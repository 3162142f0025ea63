"""Find the sentences of a page that claim something, and what ties each of them to evidence.

A claim is a sentence of the running text that holds a number with a unit, or says what a library
does. Questions, tasks, objectives and recaps claim nothing. What a claim rests on is seen in the
sentence itself (a reference), or in an output of its page (every number of it, whole ones with
their unit), or it is said in ``tests/book/claims.yml``:

.. code-block:: yaml

    step3_depth:                                # a page
      - says: spends half of its range on       # a part of one sentence, once on the page
        cell: lab.metric_to_raw(z, n, far)      # a part of one line of a cell of the page, or
        test: tests/labutils/test_x.py::test_y  # a test of this repository, or
        measured: "| route | tuned |"           # a part of a table that a bench has written, or
        reference: ref-mujoco-docs              # a label of the page References, or
        follows: from 30 digits of the formula  # why it needs no evidence of its own
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import yaml
from bs4 import BeautifulSoup

from tools import ROOT

REGISTER = ROOT / "tests" / "book" / "claims.yml"
TIES = ("cell", "test", "measured", "reference", "follows")

UNITS = r"mm|cm|m|px|pixels?|%|°|degrees?|rad|rad/s|ms|s|seconds?|minutes?|MB|kB|GB|levels?|times"
MEASURE = re.compile(rf"(?<![\w.])(\d[\d,.]*\d|\d)\s?(?:{UNITS})(?!\w)")
LIBRARY = re.compile(
    r"MuJoCo|OpenCV|Open3D|NumPy|\bROS\b|OpenGL|\bEGL\b|`Renderer`|`mujoco\.|`mj[r_]\w+|`cv2\."
)
REFERENCE = re.compile(r"\{ref\}`[^`]*<?ref-|\]\(https?://")

FRONT_MATTER = re.compile(r"\A---\n.*?\n---\n", re.DOTALL)
CELL = re.compile(r"^```\{code-cell\}.*?\n(.*?)^```$", re.DOTALL | re.MULTILINE)
INCLUDED = re.compile(r"^```\{include\} (\S+)", re.MULTILINE)
FENCE = re.compile(r"^\s*(`{3,}|\$\$)")
ASKS = re.compile(r":class: (predict|tryit)")
ITEM = re.compile(r"\s*([-*]|\d+\.) ")
QUIET = {"Question and objectives", "Where we are", "Recap", "New words", "Further reading"}
LAYOUT = re.compile(r"^\s*(:\w|\||<|\(|%)")
END = re.compile(r"(?<=[.?!])[*_)\"”]*\s+(?=[A-Z`*{\[(\"“])")


@dataclass(frozen=True)
class Page:
    """What a page says, what its cells hold, and what they print."""

    name: str
    sentences: tuple[str, ...]
    code: str
    outputs: str
    tables: str = ""

    @property
    def claims(self) -> tuple[str, ...]:
        """The sentences that need evidence."""
        return tuple(s for s in self.sentences if MEASURE.search(s) or LIBRARY.search(s))


def read_page(source: Path, built: Path) -> Page:
    """Read a page, the code of its cells, and what the built page shows below them."""
    text = FRONT_MATTER.sub("", source.read_text(encoding="utf-8"))
    code = "\n".join(part[1] for part in CELL.finditer(text))
    soup = BeautifulSoup(built.read_text(encoding="utf-8"), "html.parser")
    outputs = "\n".join(part.get_text() for part in soup.select(".cell_output pre"))
    included = [source.parent / name for name in INCLUDED.findall(text)]
    tables = "\n".join(path.read_text(encoding="utf-8") for path in included)
    return Page(source.stem, tuple(split_sentences(text)), code, outputs, tables)


def split_sentences(text: str) -> list[str]:
    """Split the running text that claims; cells, tables, headings and what asks is left out."""
    paragraphs: list[list[str]] = [[]]
    fence, is_quiet, is_asking = "", False, False
    for line in text.splitlines():
        mark = FENCE.match(line)
        if fence:
            fence = "" if line.strip().startswith(fence) else fence
        elif mark:
            fence = mark[1] if line.strip().count(mark[1]) == 1 else ""
            paragraphs.append([])
        elif line.startswith("#"):
            is_quiet = line.strip("# ") in QUIET
        elif line.startswith(":::"):
            is_asking = False
            paragraphs.append([])
        elif ASKS.match(line):
            is_asking = True
        elif not line.strip() or LAYOUT.match(line) or is_quiet or is_asking:
            paragraphs.append([])
        else:
            if ITEM.match(line):
                paragraphs.append([])
            paragraphs[-1].append(line.strip())
    sentences = [part for lines in paragraphs for part in END.split(" ".join(lines))]
    return [part.strip() for part in sentences if part.strip() and not part.strip().endswith("?")]


def is_tied_by_itself(claim: str, page: Page) -> bool:
    """Tell whether a claim names its source, or all its numbers were printed on its page."""
    if REFERENCE.search(claim):
        return True
    numbers = MEASURE.findall(claim)
    printed = set(re.findall(r"\d+\.\d+", page.outputs)) | set(MEASURE.findall(page.outputs))
    return bool(numbers) and all(number in printed for number in numbers)


def read_register() -> dict[str, list[dict[str, str]]]:
    """Read what ties claims to evidence, by page."""
    return yaml.safe_load(REGISTER.read_text(encoding="utf-8")) or {}


def find_fault(entry: dict[str, str], page: Page) -> str:
    """Say what is wrong with an entry; empty where it is right."""
    found = [sentence for sentence in page.sentences if entry.get("says", "") in sentence]
    ties = [tie for tie in TIES if tie in entry]
    if "says" not in entry or len(ties) != 1 or len(entry) != 2:
        return f"expected says and one of {', '.join(TIES)}, got {sorted(entry)}"
    if len(found) != 1:
        return f"expected one sentence with {entry['says']!r}, got {len(found)}"
    return _find_missing_evidence(ties[0], entry[ties[0]], page)


def _find_missing_evidence(tie: str, evidence: str, page: Page) -> str:
    if tie == "cell" and evidence not in page.code:
        return f"expected a cell of {page.name} with {evidence!r}, got none"
    if tie == "measured" and evidence not in page.tables:
        return f"expected a table of {page.name} with {evidence!r}, got none"
    if tie == "reference":
        references = (ROOT / "book" / "references.md").read_text(encoding="utf-8")
        return "" if f"({evidence})=" in references else f"no reference {evidence!r}"
    if tie == "test":
        file, _, name = evidence.partition("::")
        path = ROOT / file
        if not path.is_file() or f"def {name}(" not in path.read_text(encoding="utf-8"):
            return f"no test {evidence!r}"
    return ""
