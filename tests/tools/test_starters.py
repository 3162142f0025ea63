"""A starter asks for what the exercise asks for, even where the library's function does more."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from solutions import load_exercises
from tools.derive.starters import make_starter, narrow

DOC = """Do it.

Parameters
----------
model, data : object
    The scene.
name : str, int or object
    Any of three.
low, high : float
    Limits.

Returns
-------
str
    The name.
"""


def enlarge(model: Any, name: str | int, *, low: float = 0.0, high: float = 1.0) -> str:
    """Answer.

    Parameters
    ----------
    model : object
        The scene.
    name : str or int
        Name or number.
    low, high : float
        Limits.

    Returns
    -------
    str
        The name.
    """
    return f"{model}{name}{low}{high}"


def test_what_goes_by_keyword_only_is_no_part_of_a_starter() -> None:
    card: Any = SimpleNamespace(
        name="enlarge", reference=enlarge, imports=(), asks={"name": "str\nA name."}
    )
    text = make_starter(card)
    assert "def enlarge(model, name):" in text
    assert "low" not in text
    assert "name : str\n        A name." in text
    assert "number" not in text
    assert "Returns\n    -------\n    str\n        The name." in text


def test_a_shared_entry_loses_only_the_names_that_are_left_out() -> None:
    text = narrow(DOC, ["high"], {})
    assert "low : float\n    Limits.\n\nReturns" in text


def test_without_extras_a_docstring_stays_as_it_is() -> None:
    assert narrow(DOC, [], {}) == DOC


@pytest.mark.parametrize(
    ("extras", "asks", "words"),
    [
        (["depth"], {}, "depth: expected an entry in the section Parameters"),
        ([], {"depth": "float\nOne."}, "depth: expected an entry"),
        ([], {"data": "object\nState."}, "data: expected an entry of its own, got model, data"),
    ],
)
def test_an_entry_that_is_not_there_is_refused(
    extras: list[str], asks: dict[str, str], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        narrow(DOC, extras, asks)


def test_a_camera_of_an_exercise_goes_by_name() -> None:
    for name in ("render_camera", "get_camera_intrinsics"):
        text = make_starter(load_exercises()[name])
        assert "camera_name : str\n        Name of a camera of the model." in text
        assert "scene_option" not in text
