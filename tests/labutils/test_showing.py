"""`show` looks at what came: pictures are drawn, numbers are printed, the rest is refused."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import cv2
import IPython.display
import numpy as np
import pytest
from numpy.testing import assert_array_equal

import labutils
from labutils import show
from labutils.figures import Picture, plot_cloud, plot_depth, plot_images

RNG_SEED = 11


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What a notebook displays."""
    views: list[Any] = []
    monkeypatch.setattr(IPython.display, "display", views.append)
    return views


def make_rgb() -> np.ndarray:
    return np.random.default_rng(RNG_SEED).integers(0, 256, (12, 16, 3), np.uint8)


def make_depth() -> np.ndarray:
    return np.random.default_rng(RNG_SEED).uniform(1, 3, (12, 16)).astype(np.float32)


def make_points(count: int = 40) -> np.ndarray:
    return np.random.default_rng(RNG_SEED).uniform(0.5, 1, (count, 3))


def get_one(shown: list[Any]) -> Picture:
    (picture,) = shown
    assert isinstance(picture, Picture)
    return picture


def test_it_is_on_the_front_page_and_returns_nothing(shown: list[Any]) -> None:
    assert labutils.show is show
    assert show(make_rgb()) is None  # type: ignore[func-returns-value]
    assert len(shown) == 1


def test_a_picture_is_drawn_under_its_title(shown: list[Any]) -> None:
    show(make_rgb(), "the table")
    assert get_one(shown).png == plot_images({"the table": make_rgb()}).png
    assert get_one(shown).summary == "the table"


def test_a_picture_without_a_title_says_its_size_in_words(shown: list[Any]) -> None:
    show(make_rgb())
    assert get_one(shown).summary == "a picture of 16 x 12 pixels"


@pytest.mark.parametrize("value", [255, 1, True])
def test_a_mask_is_black_and_white_even_where_all_of_it_is_one(
    value: int, shown: list[Any]
) -> None:
    show(np.full((12, 16), value, np.uint8 if value is not True else np.bool_))
    white = np.full((12, 16, 3), 255, np.uint8)
    assert get_one(shown).png == plot_images({"": white}).png


def test_one_channel_of_many_values_is_gray_and_not_cut_to_two(shown: list[Any]) -> None:
    gray = make_rgb()[..., 0]
    show(gray)
    assert get_one(shown).png == plot_images({"": np.repeat(gray[..., None], 3, axis=2)}).png


def test_floats_in_rows_are_a_depth_image_with_its_color_bar(shown: list[Any]) -> None:
    depth = make_depth()
    depth[0, 0] = np.nan
    show(depth, "ours")
    assert get_one(shown).png == plot_depth(depth, title="ours").png


@pytest.mark.parametrize("frame", ["camera", "world"])
def test_rows_of_three_floats_are_points_of_a_frame(frame: str, shown: list[Any]) -> None:
    show(make_points(), frame=frame)
    assert get_one(shown).png == plot_cloud(make_points(), frame=frame).png


def test_points_with_their_colors_are_one_cloud(shown: list[Any]) -> None:
    colors = make_points()[::-1]
    show((make_points(), colors))
    assert get_one(shown).png == plot_cloud(make_points(), colors).png


def test_points_without_colors_are_one_cloud(shown: list[Any]) -> None:
    show((make_points(), None))
    assert get_one(shown).png == plot_cloud(make_points()).png


def test_two_clouds_are_not_taken_for_points_and_colors(shown: list[Any]) -> None:
    show((make_points(), 2 * make_points()))
    assert len(shown) == 2


def test_points_that_are_not_finite_are_left_out_and_counted(
    shown: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    points = make_points()
    points[3, 1] = np.nan
    show(points)
    assert get_one(shown).png == plot_cloud(np.delete(points, 3, axis=0)).png
    assert capsys.readouterr().out == "Of 40 points, 1 are not finite: they are left out.\n"


def test_a_pair_of_color_and_depth_shows_both(shown: list[Any]) -> None:
    show((make_rgb(), make_depth()))
    assert [one.png for one in shown] == [
        plot_images({"": make_rgb()}).png,
        plot_depth(make_depth()).png,
    ]


def test_a_mapping_shows_its_pictures_in_one(shown: list[Any]) -> None:
    rgb = make_rgb()
    show({"picture": rgb, "mask": rgb[..., 0] > 99})
    assert get_one(shown).summary == "picture; mask"


def test_a_mapping_with_a_depth_image_shows_one_after_another(shown: list[Any]) -> None:
    show({"picture": make_rgb(), "depth": make_depth()})
    assert [one.summary for one in shown] == ["picture", "depth"]


def test_what_draws_itself_is_displayed_as_it_is(
    shown: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    picture = Picture.from_rgb(make_rgb(), "a picture")
    show(picture, "title")
    assert get_one(shown) is picture
    assert capsys.readouterr().out == "title\n"


@pytest.mark.parametrize(
    ("thing", "title", "text"),
    [
        (None, "", "None"),
        ("two words", "", "two words"),
        (0.123456, "height", "height: 0.1235"),
        (0.0000123456, "", "1.235e-05"),
        (np.float32(2), "", "2.0000"),
        (np.int64(3), "", "3"),
        (np.True_, "", "True"),
        ((320, 241.5), "", "(320, 241.5000)"),
        (["red", 2, None], "", "['red', 2, None]"),
        (np.array([False, True]), "stale", "stale: [False  True]"),
        (np.array([0.8193, -0.19, 12]), "", "[ 0.8193 -0.1900 12.0000]"),
        ([[2, 0], [0, 2.5]], "K", "K\n[[2.0000 0.0000]\n [0.0000 2.5000]]"),
        ([[1, 2], [3]], "", "[[1, 2], [3]]"),
        (np.empty((0, 3)), "", "an empty array of shape (0, 3)"),
        (np.zeros((2, 4), np.int32), "boxes", "boxes\n[[0 0 0 0]\n [0 0 0 0]]"),
    ],
)
def test_numbers_and_text_are_printed_readably(
    thing: Any, title: str, text: str, shown: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    show(thing, title)
    assert capsys.readouterr().out == f"{text}\n"
    assert shown == []


def test_a_matrix_in_a_tuple_is_printed_by_itself(capsys: pytest.CaptureFixture[str]) -> None:
    show((2 * np.eye(3), 0.785398))
    assert capsys.readouterr().out == (
        "[[2.0000 0.0000 0.0000]\n [0.0000 2.0000 0.0000]\n [0.0000 0.0000 2.0000]]\n0.7854\n"
    )


def test_of_a_long_table_the_ends_are_printed_and_its_shape(
    capsys: pytest.CaptureFixture[str],
) -> None:
    show(np.arange(2000.0).reshape(-1, 2))
    first, *rows = capsys.readouterr().out.splitlines()
    assert first == "an array of shape (1000, 2)"
    assert len(rows) < 10
    assert rows[0].endswith("1.0000]")


def make_labels() -> np.ndarray:
    return np.zeros((12, 16), np.int32)


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: make_rgb() / 255, TypeError, r"float64: colors from 0 to 1 become a picture by"),
        (lambda: make_rgb() / 1.0, TypeError, r"shape \(12, 16, 3\) and dtype float64: the colors"),
        (lambda: make_rgb().astype(np.int64), TypeError, "the colors of a picture are uint8"),
        (make_labels, TypeError, "dtype int32: of numbers of objects, show one as a mask"),
        (lambda: np.zeros((3, 12, 16), np.uint8), TypeError, r"\(3, 12, 16\) and dtype uint8$"),
        (object, TypeError, "points .*, numbers or text, got object"),
        (lambda: 1j, TypeError, "numbers or text, got complex"),
        (lambda: make_depth() * np.nan, ValueError, "one finite depth at least, got an array"),
        (lambda: make_points() * np.nan, ValueError, "one finite point at least, got none of 40"),
        (dict, ValueError, "one picture at least in the mapping, got none"),
    ],
)
def test_what_cannot_be_shown_is_refused_with_what_was_expected(
    make: Callable[[], Any], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=f"^thing: expected .*{words}"):
        show(make())


def test_outside_of_a_notebook_a_line_stands_for_a_picture(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "IPython", None)
    monkeypatch.setitem(sys.modules, "IPython.display", None)
    show(make_rgb(), "the table")
    assert capsys.readouterr().out.endswith(": the table>\n")


def test_what_is_shown_stays_as_it_was() -> None:
    rgb, mask = make_rgb(), make_rgb()[..., 0] > 99
    before = cv2.hconcat([rgb, rgb])
    show({"picture": rgb, "mask": mask})
    assert_array_equal(cv2.hconcat([rgb, rgb]), before)
