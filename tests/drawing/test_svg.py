"""SVG figures: names for everybody, no ids, no more pixels than are seen, always the same text."""

from __future__ import annotations

import base64
import re
from typing import Any, cast
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils._drawing import get_backend, use_backend
from labutils._drawing.as_svg import shrink
from labutils._drawing.legend import _count_hidden
from labutils._drawing.shapes import Box
from labutils._picture import Picture, SvgPicture
from labutils.figures import plot_cloud, plot_depth, plot_histogram, plot_images, plot_lines
from tests.helpers.drawn import NAMESPACE, decode_rgba


def draw_lines(**lines: np.ndarray) -> SvgPicture:
    """Draw curves over 0 to 1 as SVG."""
    x = np.linspace(0, 1, len(next(iter(lines.values()))))
    with use_backend("svg"):
        return cast("SvgPicture", plot_lines(x, lines, x_label="x & y", y_label="<mm>"))


def draw_images(**images: np.ndarray) -> tuple[SvgPicture, list[ET.Element]]:
    """Draw pictures as SVG; return the figure and its pictures."""
    with use_backend("svg"):
        picture = cast("SvgPicture", plot_images(images))
    root = ET.fromstring(picture.svg)  # noqa: S314 - our own text
    return picture, list(root.iter(f"{NAMESPACE}image"))


def test_a_figure_has_a_name_and_texts_that_may_hold_any_letter() -> None:
    root = ET.fromstring(draw_lines(**{'a "b" <c>': np.arange(3.0)}).svg)  # noqa: S314
    assert root.get("role") == "img"
    assert root.get("aria-label") == '<mm> over x & y: a "b" <c>'
    texts = [node.text for node in root.iter(f"{NAMESPACE}text")]
    assert {"x & y", "<mm>", 'a "b" <c>'} <= set(texts)


def test_two_figures_on_a_page_have_no_ids_to_mix_up_and_load_nothing() -> None:
    svg = draw_lines(a=np.arange(3.0)).svg + draw_images(a=np.zeros((2, 2, 3), np.uint8))[0].svg
    assert not re.search(r"\bid=|url\(|<style|<script", svg)
    assert set(re.findall(r'href="(.{22})', svg)) == {"data:image/png;base64,"}


def test_the_same_figure_is_the_same_text_with_two_decimals_at_most() -> None:
    svg = draw_lines(a=np.random.default_rng(0).normal(size=50)).svg
    assert svg == draw_lines(a=np.random.default_rng(0).normal(size=50)).svg
    assert not re.search(r"\.\d{3}|e-\d|nan|inf", re.sub(r"<text.*?</text>", "", svg))


def test_a_figure_grows_no_wider_than_its_page_and_has_no_ground() -> None:
    svg = draw_lines(a=np.arange(3.0)).svg
    assert 'viewBox="0 0 720 280"' in svg
    assert "max-width:100%" in svg
    assert "<rect" not in svg


def test_a_gap_in_a_curve_stays_a_gap() -> None:
    root = ET.fromstring(draw_lines(a=np.array([0, 1, np.nan, 3, 4.0])).svg)  # noqa: S314
    curve = next(n for n in root.iter(f"{NAMESPACE}path") if n.get("data-part") == "curve")
    assert re.sub(r"[^ML]", "", curve.attrib["d"]) == "MLML"


def test_pixels_are_kept_and_squares_where_they_are_enlarged() -> None:
    small = np.random.default_rng(1).integers(0, 256, (30, 40, 3), np.uint8)
    _, (image,) = draw_images(small=small)
    assert_array_equal(read(image)[..., :3], small)
    assert image.get("style") == "image-rendering:pixelated"


def test_no_more_pixels_are_written_than_a_page_shows() -> None:
    large = np.random.default_rng(1).integers(0, 256, (480, 640, 3), np.uint8)
    _, images = draw_images(a=large, b=large, c=large)
    written = read(images[0])
    width = float(images[0].attrib["width"])
    assert written.shape[1] == round(2 * width) < 640
    assert images[0].get("style") is None
    # nearest pixels, as Matplotlib takes them: no color is made up
    have = {tuple(color) for color in large.reshape(-1, 3).tolist()}
    assert {tuple(color) for color in written[..., :3].reshape(-1, 3).tolist()} <= have


def read(image: ET.Element) -> np.ndarray:
    return decode_rgba(base64.b64decode(image.attrib["href"].partition(",")[2]))


def test_rows_and_columns_that_are_left_out_are_evenly_spaced() -> None:
    pixels = np.arange(6 * 9).reshape(6, 9)
    assert_array_equal(shrink(pixels, 3, 2), pixels[[1, 4]][:, [1, 4, 7]])
    assert_array_equal(shrink(pixels, 99, 99), pixels)
    assert shrink(pixels, 0.2, 0.2).shape == (1, 1)


def test_a_notebook_gets_svg_and_words() -> None:
    picture = draw_lines(a=np.arange(3.0))
    data, metadata = picture._repr_mimebundle_()
    assert data["image/svg+xml"].startswith("<svg ")
    assert data["text/plain"] == "<Picture 1440x560: <mm> over x & y: a>"
    assert metadata == {}


def test_a_figure_in_svg_has_no_png_and_says_why() -> None:
    picture = draw_lines(a=np.arange(3.0))
    assert not hasattr(picture, "png")
    with pytest.raises(AttributeError, match="png: expected a figure drawn with Matplotlib, got"):
        _ = picture.png


def test_the_same_figure_has_the_same_size_by_both_backends() -> None:
    def draw(name: Any) -> Picture:
        with use_backend(name):
            return plot_depth(np.random.default_rng(0).uniform(1, 2, (30, 41)), width="half")

    assert draw("svg").size == draw("matplotlib").size


def test_a_cloud_is_the_same_png_by_both_backends() -> None:
    points = np.random.default_rng(0).uniform(1, 2, (50, 3))
    with use_backend("svg"):
        written = plot_cloud(points)
    assert written.png == plot_cloud(points).png


def test_a_histogram_on_a_logarithmic_axis_draws_no_line_where_nothing_is() -> None:
    with use_backend("svg"):
        picture = plot_histogram({"a": np.repeat([0.0, 9], 50)}, label="x", bins=9, log=True)
    root = ET.fromstring(cast("SvgPicture", picture).svg)  # noqa: S314
    inner = next(node for node in root if node.tag == f"{NAMESPACE}svg")
    path = next(iter(inner)).attrib["d"]
    bottom = float(inner.attrib["y"]) + float(inner.attrib["height"])
    heights = np.array(re.findall(r" ([\d.]+)", path), float)
    assert heights.max() > bottom + 10  # cut off by the inner drawing


def test_matplotlib_draws_where_it_is_installed_unless_asked() -> None:
    assert get_backend() == "matplotlib"
    with use_backend("svg"):
        assert get_backend() == "svg"
        with use_backend("matplotlib"):
            assert get_backend() == "matplotlib"
        assert get_backend() == "svg"


@pytest.mark.parametrize(
    ("path", "hidden"),
    [
        ([(0, 0), (9, 9)], 1),  # across
        ([(0, 0), (5, 5)], 2),  # ends inside
        ([(4.5, 4.5), (5, 5)], 3),  # stays inside
        ([(0, 5), (9, 5)], 1),  # along x
        ([(0, 3), (9, 3)], 0),  # passes below
        ([(0, 0), (3, 9)], 0),  # passes beside
        ([(np.nan, 5), (5, np.nan)], 0),
    ],
)
def test_a_legend_counts_what_it_would_hide(path: list[tuple[float, float]], hidden: int) -> None:
    assert _count_hidden(np.array(path), Box(4, 4, 2, 2)) == hidden
