"""Measure how a page reads: the length of the sentences of its running text.

A short sentence lands a point; many in a row read like a list of orders. What is counted is what
:func:`tests.helpers.claims.split_sentences` finds: no cells, tables, tasks, questions or recaps.

``python -m tests.helpers.reading book/*.md`` prints a table, also of pages that no test asks for.
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path

from tests.helpers.claims import FRONT_MATTER, split_sentences

SHORT = 6  # words; up to here a sentence is short
WORD = re.compile(r"[^\W_]")  # what has a letter or a digit is a word


@dataclass(frozen=True)
class Reading:
    """The lengths of the sentences of a page, in words."""

    lengths: tuple[int, ...]

    @property
    def short_share(self) -> float:
        """Share of the sentences with at most ``SHORT`` words."""
        return sum(length <= SHORT for length in self.lengths) / len(self.lengths)

    @property
    def mean_length(self) -> float:
        """Words per sentence."""
        return sum(self.lengths) / len(self.lengths)


def measure_reading(text: str) -> Reading:
    """Measure the running text of a page."""
    sentences = split_sentences(FRONT_MATTER.sub("", text))
    return Reading(tuple(count_words(sentence) for sentence in sentences))


def find_short_sentences(text: str) -> list[str]:
    """Return the short sentences of a page, in its order."""
    sentences = split_sentences(FRONT_MATTER.sub("", text))
    return [sentence for sentence in sentences if count_words(sentence) <= SHORT]


def count_words(sentence: str) -> int:
    """Count the words of a sentence; signs of mathematics that stand alone are none."""
    return sum(WORD.search(word) is not None for word in sentence.split())


def main(paths: list[str]) -> None:
    """Print the measures of some pages."""
    print("page                 sentences  short   mean")
    for path in paths:
        reading = measure_reading(Path(path).read_text(encoding="utf-8"))
        print(
            f"{Path(path).stem:20} {len(reading.lengths):9} {reading.short_share:6.1%}"
            f" {reading.mean_length:6.1f}"
        )


if __name__ == "__main__":
    main(sys.argv[1:])
