"""From the welcome page to the first action and the first solved exercise: how far is it?"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

ANSWER = """\
import numpy as np


def intrinsics_matrix(fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
"""


@pytest.fixture(scope="module")
def path(
    chromium: Callable[..., Any],
    file_site: str,
    page_python: dict[str, Any],  # noqa: ARG001 - needed to run
) -> dict[str, Any]:
    return chromium("first_path.mjs", file_site, ANSWER)


def test_the_first_action_takes_one_gesture(path: dict[str, Any]) -> None:
    seen = path["action"]
    assert seen["complaints"] == []
    assert (seen["pages"], seen["drags"]) == (1, 1)
    assert seen["clicks"] == seen["typed"] == seen["windows"] == 0


def test_the_first_exercise_is_solved_within_three_pages(path: dict[str, Any]) -> None:
    seen = path["exercise"]
    assert seen["complaints"] == []
    assert seen["result"] == "passed"
    assert seen["pages"] <= 3
    assert seen["clicks"] <= 3
    assert seen["windows"] <= 2  # the link leads to the exercise, not to the top of its page
