"""Pages read as running text: few sentences are so short that many in a row sound like orders."""

from __future__ import annotations

import pytest

from tests.helpers.reading import find_short_sentences, measure_reading
from tools import ROOT

# The densest pages: what they say hangs together, so nearly all of it is joined.
DENSE = ("background", "conventions", "step3_depth")
STEPS = sorted(path.stem for path in (ROOT / "book").glob("step*.md"))
# Between predictions a step answers in a word and asks the next thing, so it may have some more.
MOST = {page: 0.10 if page in DENSE else 0.15 for page in {*DENSE, *STEPS}}


def read(page: str) -> str:
    return (ROOT / "book" / f"{page}.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("page", sorted(MOST))
def test_few_sentences_of_a_page_are_short(page: str) -> None:
    text = read(page)
    assert measure_reading(text).short_share < MOST[page], (
        f"expected less than {MOST[page]:.0%} of sentences of six words or fewer, "
        f"got {find_short_sentences(text)}"
    )


@pytest.mark.parametrize("page", sorted(MOST))
def test_sentences_are_joined_without_becoming_long(page: str) -> None:
    mean = measure_reading(read(page)).mean_length
    assert 10 < mean < 18, f"expected 10 to 18 words in a sentence on average, got {mean:.1f}"


def test_sentences_of_running_text_are_measured_and_nothing_else() -> None:
    text = "---\na: b\n---\n# A title\nOne two. One two three four five six = seven.\n\n- Is it?\n"
    reading = measure_reading(text)
    assert reading.lengths == (2, 7), "a sign of mathematics is no word, a question no sentence"
    assert reading.short_share == 0.5
    assert reading.mean_length == 4.5
    assert find_short_sentences(text) == ["One two."]
