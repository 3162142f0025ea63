"""The page of the rubric: its example of good code is right, and its points add up."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

import labutils as lab
from solutions import QUALITY_POINTS
from tests.helpers.chapters import ROOT

SECTION = (
    (ROOT / "book" / "rubric.md")
    .read_text(encoding="utf-8")
    .partition("(rubric-quality)=")[2]
    .partition("\n(")[0]
)


@pytest.fixture
def functions() -> dict[str, Any]:
    """The functions before and after, by their names."""
    names: dict[str, Any] = {"np": np, "find_valid_depth": lab.find_valid_depth}
    for code in re.findall(r"^```python\n(.*?)^```$", SECTION, re.DOTALL | re.MULTILINE):
        exec(code, names)  # noqa: S102 - code of our own page
    return names


def test_both_functions_count_the_same_pixels(
    functions: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    depth = np.random.default_rng(1).uniform(0.2, 3.0, (480, 640))
    depth[:, :64] = 12.0  # no surface: a tenth of the picture
    functions["f"](depth, 1.0)
    percent_of_all = float(capsys.readouterr().out)
    share_of_valid = functions["get_near_share"](depth, 1.0)
    assert percent_of_all / 100 == pytest.approx(0.9 * share_of_valid)


def test_the_good_one_names_what_it_cannot_do(functions: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="expected a valid pixel, got none"):
        functions["get_near_share"](np.full((4, 6), np.nan), 1.0)


def test_the_points_of_the_table_are_those_of_the_rubric() -> None:
    points = [int(n) for n in re.findall(r"^\| (\d+) \|", SECTION, re.MULTILINE)]
    assert sum(points) == QUALITY_POINTS
