"""The kinds of answers: what each says of a wrong one, and that a new one is one entry."""

from dataclasses import dataclass, replace

import cv2
import numpy as np
import pytest

from labutils.checks import judge_answers
from labutils.checks.calls import split_answer
from labutils.checks.compare import to_canonical
from labutils.checks.gates import find_failure
from labutils.checks.kinds import _FAMILIES, KINDS, Kind, get_kind
from labutils.checks.kinds.panels import draw_pictures, paint_signs
from labutils.checks.table import Case, CheckTable, Part, load_table
from labutils.checks.verdict import PanelPicture
from labutils.checks.writing import part_to_words
from tools.editions.mistakes import describe_residual


def make_table(
    part: Part, *expected: np.ndarray, wrong: list[np.ndarray] | None = None
) -> CheckTable:
    """Make a table of one part, with a case per answer due."""
    return replace(
        load_table("camera_to_world"),
        parts=(part,),
        cases=tuple(Case(f"case {number}", ()) for number in range(len(expected))),
        expected=tuple((value,) for value in expected),
        misconceptions={"upside-down": "the other way round."},
        wrong={} if wrong is None else {("upside-down",): tuple((value,) for value in wrong)},
    )


@dataclass(frozen=True, kw_only=True)
class Bearing(Kind):
    """A direction in degrees: 350 and -10 are the same."""

    def to_canonical(self, value: np.ndarray) -> np.ndarray:
        return value % 360

    def get_differences(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
        del part
        return (yours - expected + 180) % 360 - 180

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        turn = self.get_differences(part, expected, yours)[wrong]
        return f"{part.name} is turned too far to the {'left' if turn[0] > 0 else 'right'}."

    def describe_worst(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        worst = np.argmax(np.abs(self.get_differences(part, expected, yours)))
        return f"Worst bearing: number {worst}."

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        if expected.shape != yours.shape:
            return None
        gaps = np.abs(self.get_differences(part, expected, yours))[None]
        gray = np.zeros((*gaps.shape, 3), np.uint8)
        return draw_pictures(part.name, gray, gray, gaps, gaps > part.atol)


@pytest.fixture
def bearing(monkeypatch: pytest.MonkeyPatch) -> Part:
    """Register a kind that the library does not have; nothing else is told of it."""
    kind = Bearing(name="bearing", ndim=1, shape="one bearing per camera", counts_rows=True)
    monkeypatch.setitem(KINDS, "bearing", kind)
    return Part("pan", "bearing", "float", atol=0.5, unit="deg")


def test_new_kind_is_judged_told_and_drawn_by_its_entry_alone(bearing: Part) -> None:
    due = np.array([10.0, 350.0, 180.0])
    table = make_table(bearing, due, wrong=[(due + 180) % 360])
    assert judge_answers(table, ((np.array([370.0, -10.2, -180.0]),),)).passed
    verdict = judge_answers(table, ((due + np.array([0, 359, -9]),),))
    assert verdict.property == "value"
    assert verdict.paragraphs == (
        "pan is turned too far to the right.",
        "Case 1 of 1: case 0. Worst bearing: number 2.",
    )
    assert verdict.picture is not None
    assert verdict.picture.summary.startswith("pan: expected, yours, difference; worst pixel")
    verdict = judge_answers(table, ((due - 180,),))
    assert verdict.misconception == "upside-down"
    assert verdict.paragraphs[-1] == "Recognized: the other way round."
    verdict = judge_answers(table, ((due[:2],),))
    assert verdict.paragraphs[0] == "pan has too few entries (2): what is kept is not right."
    verdict = judge_answers(table, ((np.eye(3),),))
    assert verdict.paragraphs[0] == "pan has shape (3, 3); due is one bearing per camera."


def test_new_kind_is_frozen_measured_and_tried_without_being_known(bearing: Part) -> None:
    assert part_to_words(bearing)["kind"] == "bearing"
    canonical = to_canonical((bearing,), (np.array([-10.0]),))
    assert isinstance(canonical, tuple)
    (frozen,) = canonical
    assert frozen == 350
    due = np.array([10.0, 350.0])
    size, words = describe_residual((bearing,), (due,), (due + np.array([0, 365]),))
    assert size == 10
    assert words == "pan: 1 of 2 values off, typically by 5 deg, 10 times the tolerance"
    table = make_table(bearing, due)
    for amount, passes in ((5, False), (0.05, True)):
        moved = get_kind(bearing).make_shifted(bearing, due, amount)
        assert (find_failure(table, ((moved,),)) is None) is passes


def test_every_name_stands_for_one_kind() -> None:
    names = [kind.name for family in _FAMILIES for kind in family.KINDS]
    assert sorted(names) == sorted(set(names)) == sorted(KINDS)


def test_unknown_kind_is_refused_with_the_known_ones() -> None:
    with pytest.raises(ValueError, match=r"pose: expected a kind of number, .*, got 'psoe'"):
        get_kind(Part("pose", "psoe", "float"))


RAMP = np.arange(6.0).reshape(2, 3)
GRID = np.arange(12.0).reshape(4, 3)


@pytest.mark.parametrize(
    ("kind", "due", "yours", "words"),
    [
        ("number", np.array(2.0), np.array(2.1), "x is too large by 1 to 10 %."),
        ("matrix", RAMP, RAMP * [1, 0, 1], "x[0, 1] is zero; x[1, 1] is zero."),
        ("pixel", np.array([4, 5]), np.array([4, 9]), "y is too large by more than 10 %."),
        ("vector", RAMP[1], -RAMP[1], "x[0] is of the wrong sign; x[1] is of the wrong sign; x[2]"),
        ("vector", np.ones(5), np.ones(5) * np.nan, "x[2] is no finite number; and 2 more."),
        ("choice", np.array(2), np.array(1), "x is not the right one."),
        ("flag", np.array(1, bool), np.array(0, bool), "what the card says"),
        (
            "flags",
            np.array([True, False, False]),
            np.array([False, True, True]),
            "x: 3 of 3 are wrong: 2 True that should be False, 1 False that should be True.",
        ),
        ("names", np.array(["a", "b"]), np.array(["a", "c"]), "1 of 2 x are not the right ones."),
        ("list", RAMP[0], RAMP[0] + 2, "3 of 3 values of x are off, typically by 2 px."),
        (
            "rows",
            GRID,
            GRID + np.array([0, 0, 2]),
            "x: off are z in 4 of 4 rows, typically by 2 px.",
        ),
        ("cloud", GRID, GRID + np.array([3, 0, 0]), "x: off are x in 4 of 4 rows"),
        (
            "attached",
            GRID,
            GRID + np.array([3, 0, 0]),
            "x: off are R in 4 of 4 rows, typically by 3 px.",
        ),
        ("pixels", GRID[:, :2], GRID[:, :2] + np.array([0, 3]), "x: off are v in 4 of 4 rows"),
        (
            "boxes",
            GRID.reshape(3, 4),
            GRID.reshape(3, 4) + np.array([0, 0, 3, 0]),
            "x: off are width in 3",
        ),
        ("depth", RAMP, RAMP - 1, "6 of 6 pixels of x are off: too small, typically by 1 px."),
        (
            "depth",
            RAMP,
            np.full_like(RAMP, np.inf),
            "6 of them are NaN or infinite on one side only.",
        ),
        (
            "rgb",
            np.full((2, 2, 3), 9, np.uint8),
            np.array([[[9, 9, 9]] * 2, [[9, 7, 11]] * 2], np.uint8),
            "2 of 4 pixels of x are off: to both sides, typically by 2 px.",
        ),
        (
            "mapped",
            np.array([[[255, 0, 0], [0, 0, 255]]], np.uint8),
            np.array([[[0, 0, 255], [255, 0, 0]]], np.uint8),
            "2 of 2 pixels of x are off: to both sides, typically by 200 px.",
        ),
        (
            "mapped",
            np.array([[[255, 0, 0]]], np.uint8),
            np.array([[[9, 200, 9]]], np.uint8),
            "x: its colors do not follow the depth along one map",
        ),
        (
            "mapped",
            np.array([[[255, 0, 0], [0, 0, 255], [0, 0, 0]]], np.uint8),
            np.array([[[0, 0, 0], [0, 0, 255], [0, 0, 255]]], np.uint8),
            "2 of 3 pixels of x are off: 1 of them should be black; 1 of them should not be black.",
        ),
        (
            "mask",
            np.array([[255, 255, 0]], np.uint8),
            np.array([[0, 0, 255]], np.uint8),
            "3 of 3 pixels of x are off: 1 marked that should not be, 2 missing.",
        ),
        (
            "disparity",
            np.full((4, 5), 7.0),
            np.full((4, 5), 9.0),
            "100 % of the pixels of x are off by more than 0 px, all over the picture: 100 % too l",
        ),
    ],
)
def test_difference_is_told_in_the_words_of_the_kind(
    kind: str, due: np.ndarray, yours: np.ndarray, words: str
) -> None:
    names = {"f": "float", "b": "bool", "U": "str", "u": "uint8", "i": "int"}
    part = Part("x", kind, names[due.dtype.kind], atol=0, unit="px", note="what the card says")
    if kind == "cloud":
        part = replace(part, atol=1e-3)
    table = make_table(part, due)
    assert judge_answers(table, ((due,),)).passed
    verdict = judge_answers(table, ((yours,),))
    assert verdict.property == "value"
    assert words in verdict.paragraphs[0]
    sized = kind in ("depth", "rgb", "mapped", "disparity")
    assert ("Worst pixel: (u, v) = (" in verdict.paragraphs[1]) is sized
    drawn = sized or kind in ("mask", "rows", "cloud", "pixels")
    assert (verdict.picture is not None) is drawn


@pytest.mark.parametrize("kind", ["rgb", "mapped"])
def test_picture_of_255_levels_differs_by_no_more(kind: str) -> None:
    ends = np.array([[0, 255]], np.uint8)
    due = cv2.applyColorMap(ends, cv2.COLORMAP_TURBO) if kind == "mapped" else np.dstack([ends] * 3)
    part = Part("x", kind, "uint8", atol=1, unit="levels of 255")
    verdict = judge_answers(make_table(part, due), ((due[:, ::-1],),))
    assert "to both sides, typically by 255 levels of 255." in verdict.paragraphs[0]
    assert "typically by 255 levels" in describe_residual((part,), (due,), (due[:, ::-1],))[1]


def test_every_kind_is_tried_above() -> None:
    (mark,) = test_difference_is_told_in_the_words_of_the_kind.pytestmark
    # What acts in loops has no value to differ from: its words are in test_check_loops.py.
    assert {row[0] for row in mark.args[1]} == set(KINDS) - {"closed-loop"}


@pytest.mark.parametrize(
    "empty",
    [[], (), np.array([]), np.zeros((0, 4)), np.zeros((0, 4), np.int32)],
)
def test_a_list_of_no_things_has_neither_dtype_nor_columns(empty: object) -> None:
    parts = load_table("find_all_objects").parts
    assert [part.kind for part in parts] == ["names", "list", "boxes"]
    boxes = [np.zeros((0, 4), np.int64)]
    for part, due in zip(parts, [np.zeros(0, "U1"), np.zeros(0, np.int64), *boxes], strict=True):
        if np.array(empty).shape not in ((0,), due.shape):
            continue
        outcome = split_answer((part,), empty, ())
        assert isinstance(outcome, tuple)
        table = make_table(part, due)
        assert judge_answers(table, (outcome,)).passed
        assert isinstance(outcome[0], np.ndarray)
        assert outcome[0].dtype.kind == due.dtype.kind


@pytest.mark.parametrize("wrong", [[[]], np.zeros((0, 3)), [[1, 2, 3, 4]], None])
def test_what_is_no_list_of_no_things_is_refused(wrong: object) -> None:
    part = load_table("find_all_objects").parts[2]
    outcome = split_answer((part,), wrong, ())
    assert not judge_answers(make_table(part, np.zeros((0, 4), np.int64)), (outcome,)).passed


def test_points_keep_their_columns_where_there_are_none() -> None:
    part = Part("points", "cloud", "float", atol=1e-3)
    for came, passes in ((np.zeros((0, 3)), True), ([], False)):
        outcome = split_answer((part,), came, ())
        assert judge_answers(make_table(part, np.zeros((0, 3))), (outcome,)).passed is passes


def make_steps() -> np.ndarray:
    """Make disparities of a wall, a near box in its middle, and a rim without a match."""
    due = np.full((40, 60), 4.0)
    due[16:24, 24:36] = 12
    due[:2] = due[-2:] = due[:, :2] = due[:, -2:] = np.nan
    return due


@pytest.mark.parametrize(
    ("place", "value", "words"),
    [
        (np.s_[:, 2:14], np.nan, "most of them in the columns at the left: 18 % missing (NaN)."),
        (np.s_[16:24, 24:36], 4.5, "most of them where something is near: 4 % too small, typical"),
        (np.s_[:2, 2:-2], 1.0, "along the edge of the picture: 5 % given where none is due."),
        (np.s_[16:24, 21:24], 12.0, "most of them beside jumps of the disparity: 1 % too large"),
        (
            np.s_[20, 2:9],
            5.0,
            "less than 1 % of the pixels of x are off by more than 0.25 px, most of them in",
        ),
        (np.s_[2:-2, 46:-2], 4.5, "most of them in the columns at the right: 18 % too large"),
        (np.s_[3:38:2, 2:], np.nan, "more than 0.25 px, all over the picture: 4"),
    ],
)
def test_wrong_disparities_are_told_by_share_and_place(
    place: tuple[slice, slice], value: float, words: str
) -> None:
    due = make_steps()
    yours = due.copy()
    yours[place] = value
    verdict = judge_answers(
        make_table(Part("x", "disparity", "float", atol=0.25), due), ((yours,),)
    )
    assert words in verdict.paragraphs[0]
    # The worst pixel is one that is off by something; where all are missing, one of them.
    worst = "(2, 0)" if np.isnan(due[place]).all() else "(u, v) = ("
    assert worst in verdict.paragraphs[1]


def test_difference_of_disparities_shows_side_and_absence() -> None:
    differences = np.array([[-2.0, 0.0, 2.0, np.nan, -1.0]])
    wrong = np.array([[True, False, True, True, True]])
    blue, white, red, gray, pale = paint_signs(differences, wrong)[0].astype(int)
    assert blue[0] > blue[2]
    assert red[2] > red[0]
    assert white.tolist() == [255] * 3
    assert gray.tolist() == [150] * 3
    assert pale.sum() > blue.sum()
