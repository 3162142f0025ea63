"""How long a page takes, counted from its text: one formula for every place that says minutes.

What is counted is what readers meet: words, code cells with their output, figures; and what they
do: cells to run, predictions, questions, tasks. How long each takes is an assumption, written
down here and told on the page `book/start`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from content import ROOT, quiz_items

if TYPE_CHECKING:
    from pathlib import Path

#: Reading: below the 238 words a minute that are usual for English non-fiction, see ref-brysbaert.
WORDS_PER_MINUTE = 200
CELL_SECONDS = 20
FIGURE_SECONDS = 15
#: Doing.
RUN_SECONDS = 15
PREDICTION_MINUTES = 1
QUESTION_MINUTES = 1
TASK_MINUTES = 4
#: A plan is told in steps of so many minutes.
GRAIN = 5

FRONT_MATTER = re.compile(r"\A---\n.*?^---\n", re.DOTALL | re.MULTILINE)
CELL = re.compile(r"^```\{code-cell\}", re.MULTILINE)
QUIZ = re.compile(r"^```\{quiz\} (\w+)$", re.MULTILINE)
BOX = r"^:class: {}$"
FIGURE = re.compile(r"^`{3,}\{figure\}|^mystnb:$", re.MULTILINE)
# code, figures and tables of contents are looked at, not read word by word
BLOCK = re.compile(r"^(`{3,})[^\n]*\n.*?^\1$", re.DOTALL | re.MULTILINE)
# options and fences of directives, labels
UNREAD = re.compile(r"^:\w+:.*$|^:{3,}.*$|^\([\w-]+\)=$", re.MULTILINE)
# what is written by a tool: minutes must not depend on themselves
MARKED = re.compile(r"<!-- begin ([\w ]+) -->\n.*?<!-- end \1 -->\n", re.DOTALL)
# folded on the page: who follows the path does not open it; "# " begins a comment in a cell
CURIOUS = re.compile(
    r"^(##+) For the curious.*?(?=^##+ |^\([\w-]+\)=$|\Z)", re.DOTALL | re.MULTILINE
)
WORD = re.compile(r"\w[\w'.,-]*")
CARD_ROW = re.compile(r"^\| (Reading|Doing) \| (?:about \d+ minutes|as long again)", re.MULTILINE)


@dataclass(frozen=True)
class Minutes:
    """How long something takes."""

    reading: int = 0
    doing: int = 0

    def __add__(self, other: Minutes) -> Minutes:
        return Minutes(self.reading + other.reading, self.doing + other.doing)

    @property
    def total(self) -> int:
        """Both together."""
        return self.reading + self.doing


@dataclass(frozen=True)
class Counts:
    """What a page holds."""

    words: int = 0
    cells: int = 0
    figures: int = 0
    predictions: int = 0
    questions: int = 0
    tasks: int = 0

    @property
    def minutes(self) -> Minutes:
        """What that takes, to the nearest five minutes."""
        reading = (
            self.words / WORDS_PER_MINUTE
            + self.cells * CELL_SECONDS / 60
            + self.figures * FIGURE_SECONDS / 60
        )
        doing = (
            self.cells * RUN_SECONDS / 60
            + self.predictions * PREDICTION_MINUTES
            + self.questions * QUESTION_MINUTES
            + self.tasks * TASK_MINUTES
        )
        return Minutes(_round(reading), _round(doing))


def count_page(text: str, root: Path = ROOT) -> Counts:
    """Count what a page holds, in the text of its file."""
    concepts = root / quiz_items.CONCEPTS.relative_to(ROOT)
    text = CURIOUS.sub("", FRONT_MATTER.sub("", text))
    return Counts(
        words=len(WORD.findall(UNREAD.sub("", BLOCK.sub("", MARKED.sub("", text))))),
        cells=len(CELL.findall(text)),
        figures=len(FIGURE.findall(text)),
        predictions=len(re.findall(BOX.format("predict"), text, re.MULTILINE)),
        questions=sum(len(quiz_items.load_page(page, concepts)) for page in QUIZ.findall(text)),
        tasks=len(re.findall(BOX.format("tryit"), text, re.MULTILINE)),
    )


def measure_page(page: str, root: Path = ROOT) -> Minutes:
    """Say how long a page of the book takes, named without ending; its exercises are not in it."""
    text = (root / page).with_suffix(".md").read_text(encoding="utf-8")
    return count_page(text, root).minutes


def fill_card(text: str) -> str:
    """Write the minutes into the card at the top of a page, where it has some."""
    minutes = count_page(text).minutes
    due = {"Reading": minutes.reading, "Doing": minutes.doing}
    return CARD_ROW.sub(lambda row: f"| {row[1]} | about {due[row[1]]} minutes", text)


def _round(minutes: float) -> int:
    """Round to the grain; what takes any time takes one grain at least."""
    return max(GRAIN * round(minutes / GRAIN), GRAIN if minutes else 0)
