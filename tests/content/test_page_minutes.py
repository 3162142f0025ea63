"""Minutes are counted from the text of a page, and every card says what the formula gives."""

from __future__ import annotations

import pytest

from content import ROOT
from content.chapters import Chapter, load_chapters
from content.page_minutes import Counts, Minutes, count_page, fill_card, measure_page

PAGE = """---
kernelspec: none of these words counts
---

(page-one)=
# Three words here

| | |
|---|---|
| Reading | about 99 minutes |

```{code-cell} ipython3
---
mystnb:
  image: {alt: "Not read word by word."}
---
plot(not, read)
```

```{figure} picture.svg
:alt: Nothing of this is read.
A caption.
```

:::{admonition} Predict
:class: predict
:name: predict-one
Which one?
:::

:::{admonition} Try it
:class: tryit
Move it.
:::

<!-- begin exercises -->
Written by a tool.
<!-- end exercises -->
"""


def test_what_readers_meet_is_counted() -> None:
    # words: the heading 3, the card 4, the boxes 4
    assert count_page(PAGE) == Counts(
        words=11, cells=1, figures=2, predictions=1, questions=0, tasks=1
    )


def test_questions_are_counted_where_a_page_asks_them() -> None:
    assert count_page("```{quiz} step1_camera\n(here)\n```\n").questions == 5


@pytest.mark.parametrize(
    ("counts", "expected"),
    [
        (Counts(), Minutes(0, 0)),
        (Counts(words=10), Minutes(5, 0)),  # what takes any time takes one grain
        (Counts(words=2000), Minutes(10, 0)),  # 200 words a minute
        (Counts(cells=30), Minutes(10, 10)),  # 20 s to read, 15 s to run: 7.5 is nearer to 10
        (Counts(words=2000, figures=40), Minutes(20, 0)),  # 15 s each
        (Counts(predictions=6, questions=5), Minutes(0, 10)),  # 1 minute each
        (Counts(tasks=5), Minutes(0, 20)),  # 4 minutes each
    ],
)
def test_minutes_follow_from_the_counts(counts: Counts, expected: Minutes) -> None:
    assert counts.minutes == expected


def test_a_card_is_filled_and_its_minutes_do_not_depend_on_themselves() -> None:
    card = "| Reading | about 99 minutes; skip what you know |\n| Doing | as long again |\n"
    filled = fill_card(card + "word " * 3000)
    assert filled.startswith("| Reading | about 15 minutes; skip what you know |\n")
    assert fill_card(filled) == filled
    assert "| Doing | about 0 minutes |" in filled
    other = "| Doing | two commands and a download |\n"
    assert fill_card(other) == other


@pytest.mark.parametrize("chapter", load_chapters(), ids=lambda one: one.id)
def test_every_card_says_what_the_formula_gives(chapter: Chapter) -> None:
    page = chapter.page
    text = (ROOT / page).with_suffix(".md").read_text(encoding="utf-8")
    assert fill_card(text) == text, "run make exercises"
    assert measure_page(page).total > 0
