"""The predictions: every box is answered by data, and covers its answer wherever it stands."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

import labutils as lab
from content.predictions import Prediction, PredictionError, load_all, load_page
from tests.helpers.chapters import ROOT

PAGES = load_all()
ITEMS = [item for items in PAGES.values() for item in items.values()]
BOX = re.compile(
    r"^:::\{admonition\} Predict\n:class: predict\n(?::name: (?P<name>\S+)\n)?(?P<text>.*?)^:::$",
    re.MULTILINE | re.DOTALL,
)
CHOICE = re.compile(r"^\d\. (.+)$", re.MULTILINE)

CHOICES: dict[str, Any] = {
    "id": "more",
    "right": 2,
    "said": [f"An explanation of choice {n} that is long enough to help." for n in "ABC"],
}
NUMBER: dict[str, Any] = {
    "id": "half",
    "number": 0.5,
    "tolerance": 0.1,
    "unit": "m",
    "said": {
        side: f"What is said to a number that is {side}, in one sentence."
        for side in ("right", "low", "high")
    },
}


def find_boxes() -> list[tuple[str, str | None, str]]:
    """List all boxes of the book: page, name, text."""
    return [
        (path.stem, box["name"], box["text"])
        for path in sorted((ROOT / "book").glob("*.md"))
        for box in BOX.finditer(path.read_text(encoding="utf-8"))
    ]


def get_choices(item: Prediction) -> list[str]:
    """List what a reader may choose in the box of a prediction."""
    (text,) = (text for page, name, text in find_boxes() if (page, name) == (item.page, item.name))
    return CHOICE.findall(text)


# ---- What is asked


def test_every_box_of_the_book_is_answered_and_every_answer_has_its_box() -> None:
    boxes = find_boxes()
    pages = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "book").glob("*.md"))
    assert len(boxes) == pages.count("\n:class: predict\n") > 20
    asked = sorted((page, str(name)) for page, name, _ in boxes)
    assert asked == sorted((item.page, item.name) for item in ITEMS)


@pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.id)
def test_a_box_offers_as_many_choices_as_there_are_answers(item: Prediction) -> None:
    assert len(get_choices(item)) == (0 if item.number else len(item.said))


@pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.id)
def test_what_is_said_explains_and_does_not_only_judge(item: Prediction) -> None:
    for text in item.said.values():
        judges = re.match(r"(wrong|right|no|yes|correct|incorrect)\b", text.lower())
        assert not judges, f"expected an explanation, got {text!r}"
        assert text.endswith((".", "?", "!")), f"expected sentences, got {text!r}"


def test_the_place_of_the_right_choice_tells_nothing() -> None:
    asked = [item for item in ITEMS if item.right]
    places = Counter(item.right for item in asked)
    assert max(places.values()) <= 0.4 * len(asked), f"expected no place above 40 %: {places}"
    hits = 0
    for item in asked:
        lengths = [len(text) for text in get_choices(item)]
        hits += lengths[(item.right or 0) - 1] == max(lengths)
    assert hits <= 0.45 * len(asked), f"the longest choice is right in {hits} of {len(asked)}"


def test_the_numbers_are_those_of_the_book() -> None:
    model, _ = lab.make_scene()
    K, _ = lab.get_camera_intrinsics(model, "head_camera", 640, 480)
    (corner,) = lab.pixels_to_points([[0, 0]], np.ones(1), K)
    K_six, _ = lab.get_camera_intrinsics(model, "head_camera", 6, 6)
    near, far = lab.get_clip_planes(model)
    mm_per_unit = 1000 * 10**2 * (far - near) / (near * far)  # at 10 m
    computed = {
        "whole-numbers": mm_per_unit / (2**24 - 1),
        "focal": K[0, 0],
        "corner-ray": np.linalg.norm(corner),
        "middle": K_six[0, 2],
        "horizon-row": K[1, 2] - K[1, 1] * np.tan(np.deg2rad(10)),
    }
    numbers = {item.id: item.number for item in ITEMS if item.number}
    assert set(numbers) == set(computed)
    for name, number in numbers.items():
        assert abs(number.value - computed[name]) < 0.1 * number.tolerance, name


# ---- What is refused


def write(folder: Path, *entries: dict[str, Any] | str) -> None:
    """Write a file of predictions for a page that is called page."""
    (folder / "page.yml").write_text(yaml.safe_dump(list(entries)), encoding="utf-8")


def test_good_predictions_are_read(tmp_path: Path) -> None:
    write(tmp_path, CHOICES | {"until": "After"}, NUMBER | {"number": 1})
    more, half = load_page("page", tmp_path).values()
    assert (more.name, more.right, list(more.said), more.until) == (
        "predict-more",
        2,
        ["1", "2", "3"],
        "After",
    )
    assert half.number is not None
    assert (half.number.value, half.number.unit, half.right, half.until) == (1.0, "m", None, None)


def test_a_page_without_a_file_has_no_predictions(tmp_path: Path) -> None:
    assert load_page("nowhere", tmp_path) == {}


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("text", "prediction 1: expected fields with names, got 'text'"),
        (CHOICES | {"id": "Too Long"}, "id: expected small letters and dashes such as stale"),
        (CHOICES | {"hint": "?"}, "unknown field hint; known are id, right, said, until"),
        ({k: v for k, v in CHOICES.items() if k != "right"}, "the field right is missing"),
        (CHOICES | {"right": 4}, "more: right: expected 1 to 3, got 4"),
        (CHOICES | {"said": CHOICES["said"][:1]}, "more: said: expected 2 to 4 texts, got 1"),
        (CHOICES | {"said": [1, 2]}, "more: said: expected texts; write them in quotes"),
        (CHOICES | {"said": ["No."] * 2}, "more, said to 1: expected at least 40 characters"),
        (CHOICES | {"said": CHOICES["said"][:1] * 2}, "more: two answers are told the same"),
        (NUMBER | {"tolerance": 0}, "half: tolerance: expected above 0, got 0.0"),
        (NUMBER | {"said": {"right": "x"}}, "half: said: the field low is missing"),
        (NUMBER | {"right": 1}, "unknown field right; known are id, number, tolerance, said"),
    ],
)
def test_a_bad_prediction_is_refused_with_the_place(
    entry: str | dict[str, Any], message: str, tmp_path: Path
) -> None:
    write(tmp_path, entry)
    with pytest.raises(PredictionError, match=re.escape(message)) as refusal:
        load_page("page", tmp_path)
    assert str(refusal.value).startswith("page.yml, ")


def test_a_file_that_is_no_list_is_refused(tmp_path: Path) -> None:
    for text, message in (("{}", "expected a list of predictions"), ("- [", "not YAML")):
        (tmp_path / "page.yml").write_text(text, encoding="utf-8")
        with pytest.raises(PredictionError, match=rf"page\.yml: {message}"):
            load_page("page", tmp_path)


def test_an_id_is_given_once(tmp_path: Path) -> None:
    write(tmp_path, CHOICES)
    (tmp_path / "q.yml").write_text(yaml.safe_dump([CHOICES]), encoding="utf-8")
    with pytest.raises(PredictionError, match=r"q\.yml, more: this id is taken in page\.yml"):
        load_all(tmp_path)


# ---- What the reader gets

ONE_BOX = """# Page

Before.

```{admonition} Predict
:class: predict
:name: predict-more
How many?

1. One.
2. Two.
3. Three.
```

The answer is two.

```{figure} picture.svg
The picture of it.
```

```{admonition} Check
A box.
```

The end.
"""


def build(folder: Path, text: str, *entries: dict[str, Any]) -> subprocess.CompletedProcess[str]:
    """Build a page with predictions of its own."""
    (folder / "book").mkdir(exist_ok=True)
    (folder / "book" / "page.md").write_text(text, encoding="utf-8")
    (folder / "book" / "picture.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
    (folder / "index.md").write_text("# All\n\n```{toctree}\nbook/page\n```\n")
    write(folder, *entries)
    (folder / "conf.py").write_text(
        "import content.predictions, pathlib\n"
        "load = content.predictions.load_page\n"
        "content.predictions.load_page = lambda page: load(page, pathlib.Path(__file__).parent)\n"
        'extensions = ["myst_parser", "predictions"]\n'
    )
    paths = (str(ROOT / "book" / "_ext"), *filter(None, [os.environ.get("PYTHONPATH")]))
    return subprocess.run(
        [sys.executable, "-m", "sphinx", "-W", "-q", "-b", "html", ".", "out"],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        check=False,
    )


def read_covered(folder: Path) -> str:
    """What the page covers."""
    html = (folder / "out" / "book" / "page.html").read_text(encoding="utf-8")
    start = '<div class="predict-answer predict-answer-more">'
    return "".join(re.findall(rf"{start}(.*?)\n</div>", html, re.DOTALL))


def test_the_answer_is_covered_up_to_the_next_box(tmp_path: Path) -> None:
    done = build(tmp_path, ONE_BOX, CHOICES)
    assert done.returncode == 0, done.stderr
    covered = read_covered(tmp_path)
    assert "The answer is two." in covered
    assert "The picture of it." in covered
    assert "A box." not in covered
    html = (tmp_path / "out" / "book" / "page.html").read_text(encoding="utf-8")
    assert '<div class="predict-said" hidden data-right="2"><p data-answer="1">' in html
    assert "predict.js" in html
    assert "predict.js" not in (tmp_path / "out" / "index.html").read_text(encoding="utf-8")


def test_an_author_says_where_the_answer_ends(tmp_path: Path) -> None:
    build(tmp_path, ONE_BOX, CHOICES | {"until": "The end"})
    assert "A box." in read_covered(tmp_path)


def test_a_number_comes_with_its_unit_and_tolerance(tmp_path: Path) -> None:
    text = re.sub(r"\n\d\. \w+\.", "", ONE_BOX).replace("-more", "-half")
    done = build(tmp_path, text, NUMBER)
    assert done.returncode == 0, done.stderr
    html = (tmp_path / "out" / "book" / "page.html").read_text(encoding="utf-8")
    assert 'data-number="0.5" data-unit="m" data-tolerance="0.1"' in html


@pytest.mark.parametrize(
    ("text", "entry", "message"),
    [
        (ONE_BOX.replace("3. Three.\n", ""), {}, "expected 3 choices in the box, got lists of [2]"),
        (ONE_BOX.replace("-more", "-less"), {}, "expected an item for this box, by its"),
        (ONE_BOX.replace(":name: predict-more\n", ""), {}, "got none"),
        ("# Page\n\nNo box.\n", {}, "expected a box for each of more, got none"),
        (ONE_BOX, {"until": "Nowhere"}, "expected a part that begins with 'Nowhere' before"),
        (ONE_BOX, {"until": "The answer"}, "expected an output or a text to cover"),
    ],
)
def test_a_box_that_cannot_be_answered_fails_the_build(
    text: str, entry: dict[str, Any], message: str, tmp_path: Path
) -> None:
    done = build(tmp_path, text, CHOICES | entry)
    assert done.returncode != 0
    assert message in done.stderr
