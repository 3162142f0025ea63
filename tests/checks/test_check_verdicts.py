"""What a learner reads: every gate, every message, in a terminal and in Jupyter."""

import html
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import EllipsisType
from typing import Any, NoReturn

import cv2
import numpy as np
import pytest

import labutils
from labutils.checks import check, hint, judge_answers
from labutils.checks.links import name_link
from labutils.checks.table import Outcome, load_table
from labutils.checks.verdict import Verdict

LAST_WORDS = "These are the visible cases: hidden cases decide the grade."


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def right_depth(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    return near * far / (far - np.clip(depth_raw, 0, 1) * (far - near))


def linear_depth(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    return near + np.clip(depth_raw, 0, 1) * (far - near)


def starter(depth_raw: np.ndarray, near: float = 0.01, far: float = 10.0) -> np.ndarray:
    raise NotImplementedError


def begin_to_write(depth_raw: np.ndarray, *_: float) -> np.ndarray:
    depth_raw = depth_raw * 1.0
    return depth_raw[10000000]


def test_right_answer_passes_and_says_that_hidden_cases_decide() -> None:
    verdict = check("process_depth", right_depth)
    assert verdict.passed is True
    assert verdict.misconception is None
    assert verdict.property is None
    assert verdict.message.splitlines()[-1] == LAST_WORDS


def test_known_mistake_is_named_with_its_hint_and_a_picture() -> None:
    verdict = check("process_depth", linear_depth)
    assert verdict.passed is False
    assert verdict.misconception == "linear"
    assert verdict.property == "value"
    assert "hyperbolic" in verdict.message
    assert "Worst pixel: (u, v) =" in verdict.message
    assert "Read again: ../book/step3_depth.html#step3-raw" in verdict.message
    assert verdict.picture is not None
    picture = cv2.imdecode(np.frombuffer(verdict.picture.png, np.uint8), cv2.IMREAD_COLOR)
    assert picture is not None
    assert picture.shape[1] > 3 * 150


def test_unknown_mistake_gets_statistics_and_no_name() -> None:
    verdict = check("process_depth", lambda *args: right_depth(*args) * 1.0 + 0.05)
    assert (verdict.property, verdict.misconception) == ("range", None)
    verdict = check("process_depth", lambda d, n, f: np.clip(right_depth(d, n, f) + 0.05, n, f))
    assert (verdict.property, verdict.misconception) == ("value", None)
    assert "pixels of depth are off: too large, typically by 0.05 m" in verdict.message
    assert "Recognized" not in verdict.message


@pytest.mark.parametrize(
    ("function", "gate", "words"),
    [
        (None, "defined", "Pass your function as well: check('process_depth', process_depth)"),
        (3.5, "defined", "the function itself, without parentheses; it got a float"),
        (np.zeros((2, 3)), "defined", "it got an array of shape (2, 3)"),
        (..., "defined", "it got ..."),
        (lambda raw: raw, "defined", "It will be called as process_depth(depth_raw, near, far)"),
        (starter, "runs", "still `raise NotImplementedError`"),
        (lambda *_: None, "runs", "It returns nothing"),
        (lambda *_: ..., "runs", "It returns nothing"),
        (begin_to_write, "runs", "IndexError: index 10000000 is out of bounds"),
        (
            begin_to_write,
            "runs",
            f"in your line {begin_to_write.__code__.co_firstlineno + 2}: return depth_raw[",
        ),
        (lambda *_: sys.exit("bye"), "runs", "It stops with SystemExit: bye"),
        (lambda *_: 1 / 0, "runs", "It stops with ZeroDivisionError: division by zero"),
        (lambda *_: "far", "type", "Expected numbers, yours is a str."),
        (lambda *_: [[1, 2], [3]], "type", "yours is a list of 2"),
        (lambda raw, *_: raw[0], "shape", "depth has shape (32,); due is (H, W)"),
        (lambda raw, *_: (raw * 0).astype(int), "dtype", "depth is int64; due are floating-point"),
        (lambda raw, *_: raw * 0, "range", "lie below near (0.1 m); the furthest is 0 m"),
        (lambda raw, _, far: raw * 0 + 2 * far, "range", "lie above far (4 m)"),
        (lambda raw, *_: raw * np.nan, "value", "of them are NaN or infinite on one side only"),
    ],
)
def test_first_property_that_fails_is_told(function: object, gate: str, words: str) -> None:
    verdict = check("process_depth", function)
    assert not verdict.passed
    assert verdict.property == gate
    assert words in " ".join(verdict.message.split("\n"))
    assert len(verdict.message.splitlines()) < 12


def test_function_that_returns_two_times_nothing_has_been_begun() -> None:
    for answer in ((None, None), (..., ...), [None, None]):
        verdict = check("depth_to_pointcloud", lambda *_, answer=answer: answer)
        assert verdict.counted
        assert "Not started yet" not in verdict.message


@pytest.mark.parametrize("value", [None, ...])
def test_empty_function_of_two_results_counts_as_not_started(value: EllipsisType | None) -> None:
    verdict = check("depth_to_pointcloud", lambda *_: value)
    assert verdict.property == "runs"
    assert "Not started yet" in verdict.message


@pytest.mark.parametrize(
    ("name", "function", "gate", "words"),
    [
        ("depth_to_pointcloud", lambda d, *_: d, "type", "Expected 2 things (points, colors)"),
        (
            "depth_to_pointcloud",
            lambda d, *_: (d.reshape(-1, 1) * [1, 1, 1], d),
            "type",
            "colors has to be None here (None exactly where rgb_image is None)",
        ),
        ("depth_to_pointcloud", lambda *_: (None, None), "type", "points must not be None here"),
        ("depth_to_pointcloud", lambda *_: (..., ...), "type", "Expected numbers, yours is ..."),
        (
            "depth_to_pointcloud",
            lambda _, K, rgb: (K, None if rgb is None else K),
            "shape",
            "points has too few rows (3)",
        ),
        ("find_object_centroid", lambda _: (2, 3), "type", "centroid has to be None here"),
        ("find_object_centroid", lambda m: (2, 3) if m.any() else None, "type", "to be None here"),
        ("find_object_centroid", lambda _: (2.0, 3.0), "type", "to be None here"),
        (
            "segment_by_color",
            lambda rgb, _: rgb[..., 0] > 9,
            "dtype",
            "mask is bool; due are uint8",
        ),
        (
            "segment_by_color",
            lambda rgb, _: (rgb[..., 0] > 9) * np.uint8(1),
            "range",
            "mask holds 1",
        ),
        ("segment_by_color", lambda rgb, _: rgb[..., 0] & 0, "value", "pixels of mask are off"),
        ("intrinsics_matrix", lambda *_: np.eye(3), "value", "K[0, 0] is too small by more than"),
        ("intrinsics_matrix", lambda *_: -np.eye(3), "value", "K[0, 0] is of the wrong sign"),
        (
            "intrinsics_matrix",
            lambda *_: np.eye(3) * np.nan,
            "value",
            "K[0, 0] is no finite number",
        ),
        ("intrinsics_matrix", lambda *_: np.zeros((3, 3)), "value", "K[0, 0] is zero"),
        ("intrinsics_matrix", lambda *_: np.eye(3).astype(int), "dtype", "K is int64"),
        ("visualize_depth", lambda d, _: np.dstack([d * 0] * 3), "dtype", "picture is float32"),
        (
            "visualize_depth",
            lambda d, _: np.full((*d.shape, 3), (9, 200, 9), np.uint8),
            "value",
            "do not follow the depth along one map",
        ),
        ("camera_to_world", lambda p, *_: p[:, :2], "shape", "points has shape (5, 2)"),
        ("camera_to_world", lambda p, *_: p + np.array([0.5, 0, 0]), "value", "x in 5 of 5 rows"),
    ],
)
def test_other_kinds_of_answers_are_told_as_well(
    name: str, function: Callable[..., Any], gate: str, words: str
) -> None:
    verdict = check(name, function)
    assert verdict.property == gate, verdict.message
    assert words in " ".join(verdict.message.split("\n"))


def test_missing_exception_is_told() -> None:
    table = load_table("get_camera_intrinsics")
    answers = (*table.expected[:-1], table.expected[0])
    verdict = judge_answers(table, answers)
    assert verdict.property == "value"
    assert "has to raise ValueError" in verdict.message


def test_other_exception_than_the_one_due_is_told() -> None:
    def by_key(model: Any, camera_name: str, width: int, height: int) -> Any:
        camera = model.camera(camera_name).id  # MuJoCo raises KeyError
        return labutils.get_camera_intrinsics(model, model.camera(camera).name, width, height)

    verdict = check("get_camera_intrinsics", by_key)
    assert verdict.property == "runs"
    assert "KeyError" in verdict.message
    assert "Here a ValueError is due." in " ".join(verdict.message.split("\n"))


def test_long_exception_text_is_cut() -> None:
    def shout(*_: object) -> NoReturn:
        raise ValueError(text)

    text = "very " * 400 + "\nsecond line"
    message = check("process_depth", shout).message
    assert "..." in message
    assert "second line" not in message
    assert len(message.splitlines()) < 12


def test_function_that_spoils_its_input_changes_no_other_case() -> None:
    def spoil(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
        depth = right_depth(depth_raw, near, far)
        depth_raw[:] = -1
        return depth

    assert check("process_depth", spoil).property == "input"  # all values agree
    assert check("process_depth", right_depth).passed


def test_misspelled_exercise_lists_the_known_ones() -> None:
    with pytest.raises(ValueError, match=r"expected one of render_camera, .*'process_depth'\?"):
        check("proces_depth", right_depth)
    with pytest.raises(ValueError, match="expected one of"):
        hint("nothing_like_it")


def test_function_of_the_library_passes_without_being_counted(tmp_path: Path) -> None:
    verdict = check("process_depth", labutils.process_depth)
    assert verdict.passed
    assert "write your own" in verdict.message
    assert not list(tmp_path.iterdir())


def test_jupyter_shows_the_same_words_and_the_picture() -> None:
    for function in (linear_depth, right_depth, starter, begin_to_write):
        verdict = check("process_depth", function)
        page = verdict._repr_html_()
        words = html.unescape(re.sub(r"<[^>]+>", " ", page)).split()
        # a page names the section that it links to, a terminal says its address
        name = name_link(verdict.link) if verdict.link else ""
        assert words == verdict.message.replace(verdict.link or "\0", name).split()
        assert ("<img" in page) == (verdict.picture is not None)
    assert (
        'alt="depth: expected, yours, difference'
        in check("process_depth", linear_depth)._repr_html_()
    )


def test_words_of_a_learner_cannot_become_html() -> None:
    def attack(*_: object) -> NoReturn:
        raise ValueError("<script>alert(1)</script>")

    assert "<script>" not in check("process_depth", attack)._repr_html_()


def test_terminal_shows_the_message() -> None:
    verdict = check("process_depth", linear_depth)
    assert repr(verdict) == str(verdict) == verdict.message


def test_builtin_function_without_signature_can_be_checked() -> None:
    assert check("find_object_centroid", cv2.countNonZero).property == "type"


def get_cloud(due: Outcome) -> tuple[np.ndarray, np.ndarray | None]:
    """The points and colors of an answer."""
    assert isinstance(due, tuple)
    points, colors = due
    assert points is not None
    return points, colors


def test_cloud_in_any_order_is_the_same_cloud() -> None:
    table = load_table("depth_to_pointcloud")
    rng = np.random.default_rng(5)

    def shuffled(due: Outcome) -> Outcome:
        points, colors = get_cloud(due)
        order = rng.permutation(len(points))
        noise = rng.uniform(-0.9e-4, 0.9e-4, size=points.shape)
        return points[order] + noise, None if colors is None else colors[order]

    assert judge_answers(table, tuple(map(shuffled, table.expected))).passed
    # The same points with the colors of others are not.
    points, colors = get_cloud(table.expected[1])
    wrong = (table.expected[0], (points[::-1], colors), *table.expected[2:])
    assert judge_answers(table, wrong).property == "value"


def test_one_point_twice_and_another_never_is_another_cloud() -> None:
    table = load_table("depth_to_pointcloud")
    points, colors = get_cloud(table.expected[1])
    assert colors is not None
    points = points.copy()
    points[0] = points[1]
    answers = (table.expected[0], (points[::-1], colors[::-1]), *table.expected[2:])
    assert not judge_answers(table, answers).passed


def test_equal_points_are_matched_one_by_one() -> None:
    table = load_table("crop_region")
    (number,) = (n for n, case in enumerate(table.cases) if "twice" in case.label)
    due = table.expected[number]
    assert isinstance(due, tuple)
    (points,) = due
    assert points is not None
    rows, counts = np.unique(points, axis=0, return_counts=True)
    assert set(counts) == {1, 2}

    def passes(wanted: np.ndarray) -> bool:
        yours = (np.repeat(rows, wanted, axis=0),)
        return judge_answers(
            table, (*table.expected[:number], yours, *table.expected[number + 1 :])
        ).passed

    assert passes(counts)
    # As many points, but others are twice.
    once, twice = np.flatnonzero(counts == 1)[0], np.flatnonzero(counts == 2)[0]
    others = counts.copy()
    others[[once, twice]] = (2, 1)
    assert not passes(others)


def test_picture_of_a_cloud_with_other_points_is_drawn() -> None:
    table = load_table("depth_to_pointcloud")
    points, _ = get_cloud(table.expected[0])
    half = (points[::2], None)
    verdict = judge_answers(table, (half, *table.expected[1:]))
    assert verdict.property == "shape"
    assert verdict.picture is not None
    empty = (points[:0], None)
    assert judge_answers(table, (empty, *table.expected[1:])).picture is None


def test_library_exports_what_pages_use() -> None:
    assert {"check", "hint", "report"} <= set(labutils.__all__)
    assert replace(check("process_depth", right_depth), result="failed").passed is False


def test_a_starter_that_nobody_has_touched_has_the_color_of_no_mistake() -> None:
    missed = Verdict("process_depth", "failed", paragraphs=("Not right.",))
    untouched = replace(missed, counted=False)
    assert "#D55E00" in missed._repr_html_()
    assert "#D55E00" not in untouched._repr_html_()
    assert 'data-begun="false"' in untouched._repr_html_()
    assert "data-begun" not in missed._repr_html_()
    assert untouched.headline == missed.headline
