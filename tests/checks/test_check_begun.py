"""A starter that nobody has touched is told from a body that somebody has written."""

from __future__ import annotations

import linecache
from collections.abc import Callable
from functools import partial

import pytest

from labutils.checks import judge
from labutils.checks.begun import count_open_lines, is_begun
from labutils.checks.exceptions import explain
from labutils.checks.table import load_table
from labutils.checks.verdict import Verdict

NAME = "process_depth"


def make_function(body: str) -> Callable[..., object]:
    names: dict[str, Callable[..., object]] = {}
    exec(f"def {NAME}(depth_raw, near, far):\n    {body}\n", names)  # noqa: S102 - its purpose
    return names[NAME]


def judge_body(body: str) -> Verdict:
    return judge(load_table(NAME), make_function(body))


@pytest.mark.parametrize(
    "body",
    [
        "raise NotImplementedError",
        '"""Text."""\n    raise NotImplementedError',
        'raise NotImplementedError("later")',
        "pass",
        "...",
        "return None",
        '"""Text."""',
    ],
)
def test_body_of_a_starter_is_not_begun(body: str) -> None:
    assert not is_begun(make_function(body))
    verdict = judge_body(body)
    assert verdict.paragraphs[0] == "Not started yet."
    assert not verdict.counted
    assert verdict.line is None


@pytest.mark.parametrize(
    "body",
    [
        "depth = depth_raw",
        "depth_raw * near",
        "print('here')",
        "2 + near",
        "del far",
        "if near > far: pass",
        "def inner(): return far",
        "near",
        "[1 for _ in ()]",
    ],
)
@pytest.mark.parametrize("end", ["", "raise NotImplementedError"])
def test_written_body_is_never_called_not_started(body: str, end: str) -> None:
    verdict = judge_body(f"{body}\n    {end}")
    assert verdict.property == "runs"
    assert verdict.counted
    assert "Not started" not in verdict.message
    assert "empty" not in verdict.message


def test_written_body_that_still_raises_is_told_the_line() -> None:
    verdict = judge_body("depth = depth_raw\n    raise NotImplementedError")
    assert "still ends with NotImplementedError in your line 3" in verdict.paragraphs[0]
    assert verdict.line == 3


def test_written_body_without_return_is_told_so() -> None:
    verdict = judge_body("depth = depth_raw * far")
    assert verdict.paragraphs[0].startswith("It returns nothing: `return` is missing")
    assert verdict.line is None


def test_code_that_stops_gives_its_line() -> None:
    verdict = judge_body("depth = depth_raw\n    return depth[9999]")
    assert verdict.line == 3


def test_callable_object_is_begun() -> None:
    assert is_begun(partial(print, 1))
    assert not is_begun(None)


def test_parameters_in_another_order_are_told_before_any_value() -> None:
    def swapped(depth_raw: object, far: object, near: object) -> object:
        return (depth_raw, far, near)

    verdict = judge(load_table(NAME), swapped)
    assert verdict.property == "defined"
    words = "called as process_depth(depth_raw, near, far), and yours is process_depth(depth_raw,"
    assert words in " ".join(verdict.message.split())


def test_parameters_with_new_names_are_allowed() -> None:
    verdict = judge(load_table(NAME), lambda raw, low, high: raw * 0 + low + high * 0)
    assert verdict.property != "defined"


@pytest.mark.parametrize(
    "code",
    [
        "def f(x):\n    y = 1\n    \tz = 2\n",
        "def f(x):\n\ty = 1\n            z = 2\n",
        "def f(x):\n        y = 1\n\t  z = 2\n",
    ],
)
def test_mixed_tabs_are_named_whatever_python_calls_them(code: str) -> None:
    name = "a cell with tabs"
    linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)
    with pytest.raises(IndentationError) as caught:
        compile(code, name, "exec")
    assert explain(caught.value, name).startswith("Tabs and spaces are mixed")


@pytest.mark.parametrize(
    ("body", "count"),
    [
        ("a = ...", 1),
        ("a, b = ...\n    c = ...\n    return a", 2),
        ("for one in depth_raw:\n        near = ...\n    return lambda: near", 1),
        ("a = depth_raw[..., near]\n    return a[..., 0]", 0),
        ("return ...", 0),
        ("...", 0),
        ("return depth_raw", 0),
    ],
)
def test_values_that_are_still_open_are_counted(body: str, count: int) -> None:
    assert count_open_lines(make_function(body)) == count


def test_what_has_no_code_of_its_own_has_no_open_line() -> None:
    assert count_open_lines(abs) == 0
    assert count_open_lines(None) == 0
