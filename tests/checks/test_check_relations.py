"""How an answer differs is told only where it was seen in every value of every case."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import cv2
import numpy as np
import pytest

from labutils.checks import judge_answers
from labutils.checks.explain import FAMILIES, Differences
from labutils.checks.kinds import KINDS
from labutils.checks.table import Case, CheckTable, Outcome, Part, load_table, read_words

MOVE = np.array([0.1, 0.2, 0.4])

Change = Callable[[np.ndarray], Any]


def make_table(
    part: Part, dues: list[np.ndarray], parameters: tuple[str, ...] = (), args: Any = ()
) -> CheckTable:
    """Make the table of an exercise with one part; `args` has the arguments of every case."""
    given = args or [()] * len(dues)
    return CheckTable(
        name="made_up",
        title="a made-up exercise",
        chapter="step0",
        kind="required",
        points=1,
        parameters=parameters,
        section="",
        parts=(part,),
        hints=("", "", ""),
        misconceptions={},
        cases=tuple(Case(f"case {n}", tuple(some)) for n, some in enumerate(given)),
        expected=tuple((due,) for due in dues),
        wrong={},
    )


def relate(part: Part, dues: list[np.ndarray], change: Change, **known: Any) -> Any:
    """Return what is told of answers that are all changed in one way."""
    answers: tuple[Outcome, ...] = tuple((np.asarray(change(due)),) for due in dues)
    return Differences(make_table(part, dues, **known), answers).find_relation()


def draw(kind: str, seed: int = 1) -> tuple[Part, list[np.ndarray]]:
    """Draw three right answers of a kind."""
    rng = np.random.default_rng(seed)
    make: dict[str, tuple[Part, Callable[[], np.ndarray]]] = {
        "number": (Part("angle", kind, "float", atol=1e-4), lambda: rng.uniform(0.2, 0.9, ())),
        "matrix": (Part("K", kind, "float", atol=1e-3), lambda: rng.uniform(20, 90, (3, 3))),
        "pixel": (Part("place", kind, "float", atol=1e-3), lambda: rng.uniform(20, 90, 2)),
        "vector": (Part("plane", kind, "float", atol=1e-4), lambda: rng.uniform(0.2, 0.9, 4)),
        "rows": (Part("points", kind, "float", atol=1e-4), lambda: rng.normal(size=(30, 3))),
        "cloud": (Part("points", kind, "float", atol=1e-4), lambda: rng.normal(size=(30, 3))),
        "depth": (Part("depth", kind, "float", atol=1e-3), lambda: rng.uniform(1, 6, (9, 14))),
        "list": (Part("areas", kind, "float", atol=1e-3), lambda: rng.uniform(1, 6, 7)),
        "flags": (Part("stale", kind, "bool"), lambda: rng.random(15) < 0.3),
        "mask": (
            Part("mask", kind, "uint8"),
            lambda: cv2.circle(
                np.zeros((30, 40), np.uint8), (int(rng.integers(12, 28)), 14), 7, 255, -1
            ),
        ),
        "rgb": (
            Part("rgb", kind, "uint8", atol=1),
            lambda: rng.integers(0, 256, (9, 14, 3), dtype=np.uint8),
        ),
    }
    part, one = make[kind]
    return part, [np.asarray(one()) for _ in range(3)]


@pytest.mark.parametrize(
    ("kind", "change", "name"),
    [
        ("number", lambda a: a * 180 / np.pi, "scaled:180/pi"),
        ("number", lambda a: a * 1.7, "scaled:1.7"),
        ("number", lambda a: a + 0.5, "shifted:0.5"),
        ("number", lambda a: 0 * a, "zero"),
        ("number", np.square, "square"),
        ("matrix", lambda a: a.T, "transposed"),
        ("matrix", np.linalg.inv, "inverted"),
        ("matrix", lambda a: put(a, (0, 2), a[0, 2] + 0.5), "shifted:0.5:K[0, 2]"),
        ("matrix", lambda a: put(a, (1, 1), a[0, 0]), "other:K[0, 0]:K[1, 1]"),
        ("pixel", lambda a: a[::-1], "axes:y,x"),
        ("pixel", lambda a: put(a, 0, -a[0]), "axes:-x,y"),
        ("rows", lambda a: a * [1, -1, -1], "axes:x,-y,-z"),
        ("rows", lambda a: a[:, [2, 0, 1]] * [1, -1, 1], "axes:z,-x,y"),
        ("rows", lambda a: a * 1000, "scaled:1000"),
        ("rows", lambda a: put(a, np.s_[:, 1], 2 * a[:, 1]), "scaled:2:y"),
        ("cloud", lambda a: a[np.abs(a[:, 0]).argsort()[:-4]], "rows:missing"),
        ("cloud", lambda a: np.concatenate([a, np.full((3, 3), np.nan)]), "rows:too-many:NaN"),
        ("cloud", lambda a: np.concatenate([a, np.zeros((3, 3))]), "rows:too-many:zeros only"),
        ("rows", lambda a: a @ turn("z", 0.3).T, "rigid:turned-about-z"),
        (
            "rows",
            lambda a: a @ turn("x", 0.3).T + MOVE,
            "rigid:turned-about-x-and-moved",
        ),
        ("rows", lambda a: a + MOVE, "rigid:moved"),
        ("rows", lambda a: a @ turn("z", 0.3).T * [1, 1, -1], "rigid:mirrored"),
        ("rows", lambda a: a[a[:, 0].argsort()], "reordered"),
        ("depth", np.flipud, "mirrored:up-down"),
        ("depth", lambda a: np.minimum(a, 4), "clipped:above:4"),
        ("depth", lambda a: a / 1000, "scaled:1/1000"),
        ("depth", np.round, "rounded"),
        ("depth", lambda a: np.round(a, 2), "decimals:2"),
        ("depth", lambda a: (a - a.min()) / np.ptp(a), "stretched:1"),
        ("vector", lambda a: a / a[0], "length"),
        ("list", lambda a: a[::-1], "reversed"),
        ("list", np.sort, "sorted"),
        ("flags", lambda a: ~a, "complement"),
        ("flags", lambda a: np.roll(a, 1), "late"),
        ("mask", lambda a: 255 - a, "complement"),
        ("mask", lambda a: cv2.dilate(a, np.ones((3, 3), np.uint8)), "grown:1"),
        ("mask", lambda a: cv2.erode(a, np.ones((5, 5), np.uint8)), "shrunk:2"),
        ("rgb", lambda a: a[..., ::-1], "channels:BGR"),
        ("rgb", lambda a: 255 - a, "negative"),
        ("rgb", lambda a: np.rot90(a, 2), "turned:180"),
    ],
)
def test_a_relation_is_named_as_itself(kind: str, change: Change, name: str) -> None:
    part, dues = draw(kind)
    found = relate(part, dues, change)
    assert found is not None
    assert found.name == name
    assert found.text.startswith("In all 3 cases: ")


def put(array: np.ndarray, place: Any, value: Any) -> np.ndarray:
    """Return a copy with another value at one place."""
    changed = array.copy()
    changed[place] = value
    return changed


def turn(axis: str, angle: float) -> np.ndarray:
    """Make the rotation about an axis."""
    vector = np.zeros(3)
    vector["xyz".index(axis)] = angle
    rotation: np.ndarray = cv2.Rodrigues(vector)[0]
    return rotation


@pytest.mark.parametrize("kind", ["number", "matrix", "pixel", "rows", "depth", "list", "mask"])
@pytest.mark.parametrize("seed", range(5))
def test_of_noise_nothing_is_told(kind: str, seed: int) -> None:
    part, dues = draw(kind, seed)
    rng = np.random.default_rng(100 + seed)

    def disturb(due: np.ndarray) -> np.ndarray:
        if due.dtype == np.uint8:
            return np.where(rng.random(due.shape) < 0.2, 255 - due, due)
        return due + rng.normal(size=due.shape)

    assert relate(part, dues, disturb) is None


def test_a_relation_that_fails_in_one_case_is_not_told() -> None:
    part, dues = draw("rows")
    answers = tuple((2 * due if number else 3 * due,) for number, due in enumerate(dues))
    assert Differences(make_table(part, dues), answers).find_relation() is None


def test_one_number_in_one_case_fits_anything_and_tells_nothing() -> None:
    part, dues = draw("number")
    assert relate(part, dues[:1], lambda due: 2 * due) is None


def test_two_relations_of_one_size_cannot_be_told_apart() -> None:
    part, dues = draw("depth")
    turned = [due + due[::-1, ::-1] for due in dues]  # mirrored either way they look the same
    assert relate(part, turned, np.fliplr) is None
    assert relate(part, dues, np.fliplr).name == "mirrored:left-right"


def test_an_argument_that_came_back_is_named() -> None:
    part, dues = draw("depth")
    raw = [(due / 10,) for due in dues]
    answers = tuple((one[0],) for one in raw)
    found = Differences(make_table(part, dues, ("depth_raw",), raw), answers).find_relation()
    assert found is not None
    assert found.name == "returned:depth_raw"
    assert found.text == "In all 3 cases: depth: depth_raw, unchanged."


def test_a_number_among_the_arguments_is_named() -> None:
    part, dues = draw("number")
    args = [(width, 17 * width - 3) for width in (64, 80, 36)]
    answers = tuple((due * w / h,) for due, (w, h) in zip(dues, args, strict=True))
    found = Differences(make_table(part, dues, ("width", "height"), args), answers).find_relation()
    assert found is not None
    assert found.name == "argument:*(width / height)"


def test_where_it_is_wrong_and_what_stands_there_is_told() -> None:
    part, dues = draw("depth")
    rng = np.random.default_rng(3)
    holes = [rng.random(due.shape) < 0.2 for due in dues]
    raw = [(np.where(hole, np.nan, due / 7),) for hole, due in zip(holes, dues, strict=True)]
    answers = tuple((np.where(hole, 0.0, due),) for hole, due in zip(holes, dues, strict=True))
    found = Differences(make_table(part, dues, ("depth_raw",), raw), answers).find_relation()
    assert found is not None
    assert found.name == "where:depth_raw is NaN"
    assert found.text.endswith("it is wrong exactly where depth_raw is NaN; there it is 0.")


def test_a_region_that_holds_all_that_is_wrong_is_told_as_only() -> None:
    part, dues = draw("depth")
    rng = np.random.default_rng(4)
    holes = [rng.random(due.shape) < 0.3 for due in dues]
    raw = [(np.where(hole, np.nan, due),) for hole, due in zip(holes, dues, strict=True)]
    answers = tuple(
        (np.where(hole & (rng.random(due.shape) < 0.7), due + rng.normal(size=due.shape), due),)
        for hole, due in zip(holes, dues, strict=True)
    )
    found = Differences(make_table(part, dues, ("depth_metric",), raw), answers).find_relation()
    assert found is not None
    assert found.name == "within:depth_metric is NaN"
    assert "it is wrong only where depth_metric is NaN; elsewhere it agrees." in found.text


def test_a_relation_of_one_part_says_that_the_others_agree() -> None:
    table = load_table("get_camera_intrinsics")
    answers: list[Outcome] = []
    for due in table.expected:
        if isinstance(due, tuple):
            K, fov_y = due
            assert K is not None
            assert fov_y is not None
            answers.append((K, fov_y * 3))
        else:
            answers.append(due)
    verdict = judge_answers(table, tuple(answers))
    assert verdict.relation == "scaled:3:fov_y"
    count = sum(isinstance(due, tuple) for due in table.expected)
    said = f"Seen: In all {count} cases: fov_y: 3 times what is due. K agrees."
    assert said in verdict.message
    assert verdict.misconception is None


def test_a_listed_mistake_is_named_and_nothing_else_is_said() -> None:
    for name in read_words():
        table = load_table(name)
        for made, answers in table.wrong.items():
            verdict = judge_answers(table, answers)
            assert verdict.misconception == " + ".join(made)
            assert verdict.relation is None


def test_a_right_answer_has_no_relation() -> None:
    table = load_table("intrinsics_matrix")
    assert judge_answers(table, table.expected).relation is None


def test_every_family_that_a_kind_names_exists() -> None:
    assert {family for kind in KINDS.values() for family in kind.relations} == set(FAMILIES)


def test_a_relation_never_holds_a_number_that_is_due() -> None:
    """Of few numbers a message could give the right one away."""
    part, dues = draw("matrix")
    for change in (lambda a: a + 12.34, lambda a: a * 1.2345, lambda a: put(a, (0, 0), 7.0)):
        found = relate(part, dues, change)
        text = found.text if found else ""
        for due in dues:
            assert not any(f"{value:.4g}" in text for value in due.ravel())


ODD = [
    np.array(3.0),
    np.zeros(0),
    np.zeros((0, 3)),
    np.zeros((0, 0, 3), np.uint8),
    np.full((2, 3), np.nan),
    np.full((1, 2), np.inf),
    np.array([1e300, -1e300, 0.0]),
    np.array(["a", "b"]),
    np.array([True, False, True]),
    np.arange(24).reshape(2, 3, 4),
    np.ones((1, 1, 1, 1)),
]


@pytest.mark.parametrize("name", read_words())
def test_odd_answers_are_compared_without_an_error(name: str) -> None:
    table = load_table(name)
    with_texts = any(part.dtype == "str" for part in table.parts)
    for odd in ODD:
        if odd.dtype.kind == "U" and not with_texts:
            continue  # calls.split_answer has refused texts before
        answers: list[Outcome] = [(odd,) * len(table.parts)] * len(table.cases)
        Differences(table, tuple(answers)).find_relation()
        mixed = [
            (odd, *due[1:]) if isinstance(due, tuple) and number else due
            for number, due in enumerate(table.expected)
        ]
        Differences(table, tuple(mixed)).find_relation()


def test_a_relation_of_the_wrong_cases_says_that_the_others_agree() -> None:
    part, dues = draw("rows")
    answers = ((dues[0],), (dues[1] * 1000,), (dues[2] * 1000,))
    found = Differences(make_table(part, dues), answers).find_relation()
    assert found is not None
    assert found.text == "Only in cases 2 and 3, the other agrees: points: 1000 times what is due."


def test_the_only_wrong_case_and_the_only_right_one_are_named() -> None:
    part, dues = draw("depth")
    noise = np.random.default_rng(9).normal(size=(3, *dues[0].shape))
    table = make_table(part, dues)
    one_wrong = ((dues[0],), (dues[1] + noise[1],), (dues[2],))
    found = Differences(table, one_wrong).find_odd_case()
    assert found is not None
    assert (found.name, found.text) == (
        "only-wrong:2",
        "Of 3 cases only this one is wrong: case 1.",
    )
    one_right = ((dues[0],), (dues[1] + noise[1],), (dues[2] + noise[2],))
    found = Differences(table, one_right).find_odd_case()
    assert found is not None
    assert found.name == "only-right:1"
    assert Differences(table, table.expected).find_odd_case() is None


def test_two_wrong_cases_of_five_are_named() -> None:
    part, dues = draw("depth")
    dues = [*dues, dues[0] + 1, dues[1] + 1]
    noise = np.random.default_rng(9).normal(size=dues[0].shape)
    answers = tuple((due + noise if n in (1, 4) else due,) for n, due in enumerate(dues))
    found = Differences(make_table(part, dues), answers).find_odd_case()
    assert found is not None
    assert found.name == "only-wrong:2+5"
    assert found.text == "Of 5 cases only 2 are wrong: case 1; case 4."


def make_two_parts() -> tuple[CheckTable, list[tuple[np.ndarray, np.ndarray]]]:
    """Make a table of an answer with two parts, and its right answers."""
    (matrix, ones), (points, others) = draw("matrix"), draw("rows")
    table = make_table(matrix, ones)
    dues = list(zip(ones, others, strict=True))
    return replace(table, parts=(matrix, points), expected=tuple(dues)), dues


def test_what_is_known_of_one_part_is_told_and_that_the_other_is_wrong() -> None:
    table, dues = make_two_parts()
    noise = np.random.default_rng(9).normal(size=(30, 3))
    answers = tuple((K.T, points + noise) for K, points in dues)
    assert Differences(table, answers).find_relation() is None
    found = Differences(table, answers).find_partial()
    assert found is not None
    assert found.name == "transposed:K"
    assert found.text.endswith("K: the transpose of what is due. points is wrong in another way.")


def test_of_a_part_that_is_wrong_in_no_known_way_the_others_are_told_to_agree() -> None:
    table, dues = make_two_parts()
    noise = np.random.default_rng(9).normal(size=(30, 3))
    found = Differences(table, tuple((K, points + noise) for K, points in dues)).find_partial()
    assert found is not None
    assert found.name == "only-part:points"
    assert found.text == "K agrees in every case: only points is wrong."
    assert Differences(table, table.expected).find_partial() is None


def test_points_whose_distances_change_were_not_turned() -> None:
    part, dues = draw("rows")
    points = [(due - MOVE) @ turn("x", 0.7) for due in dues]
    table = make_table(part, dues, ("points",), [(one,) for one in points])
    noise = np.random.default_rng(9).normal(size=(30, 3))
    found = Differences(table, tuple((due + noise,) for due in dues)).find_relation()
    assert found is not None
    assert found.name == "not-rigid"
    assert "the distances between the points have changed" in found.text


def test_black_is_a_word_and_not_a_level() -> None:
    table = load_table("visualize_depth")
    answers = tuple((np.zeros_like(due[0]),) for due in table.expected if isinstance(due, tuple))
    verdict = judge_answers(table, answers)
    assert verdict.relation is not None
    assert "black everywhere" in verdict.message
    assert "-64" not in verdict.message
