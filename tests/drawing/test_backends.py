"""Figures as SVG show what they show with Matplotlib: texts, limits, colors, curves, pixels."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import (
    find_valid_depth,
    get_clip_planes,
    make_scene,
    metric_to_raw,
    render_camera,
    visualize_depth,
)
from labutils._drawing.parts import Plot, Sheet
from labutils.figures import (
    plot_comparison,
    plot_depth,
    plot_histogram,
    plot_images,
    plot_lines,
)
from labutils.raycast import RaycastRenderer
from tests.helpers.drawn import Drawn, read_matplotlib, read_svg

#: Curves stand at the same share of the axes: a hundredth of a page pixel is rounded away.
SHARE_ATOL = 1e-3
#: Labels of ticks are centered on letters by Matplotlib, by the height of a digit here.
TICK_ATOL = 0.02
#: Room for texts is made from widths in a table: pictures and axes may move by so much.
PLACE_ATOL = 0.02
#: Matplotlib cuts colors where we round, and counts pixels of colors in single precision.
COLOR_ATOL = 2
#: Of all pixels: those whose value lies on the border of two colors of a map.
SHARE_ON_BORDERS = 0.01

Made = Callable[[Mapping[str, np.ndarray]], object]


def make_cases() -> dict[str, Made]:
    """Name the figures of the book, and harder ones, with what draws them."""
    z = np.linspace(0.2, 1.2, 200)
    return {
        "one picture": lambda s: plot_images({"overview": s["rgb"]}),
        "half a column": lambda s: plot_images({"inside the box": s["rgb"]}, width="half"),
        "two pictures": lambda s: plot_images({"read as RGB": s["rgb"], "BGR": s["bgr"]}),
        "picture and channel": lambda s: plot_images(
            {"rgb": s["rgb"], "depth, up to 2.5 m": np.minimum(s["depth"], 2.5)}
        ),
        "three in a row": lambda s: plot_images(
            {f"pan {pan:+.1f} rad": np.roll(s["rgb"], int(50 * pan), 1) for pan in (-0.3, 0, 0.3)}
        ),
        "masks in two rows": lambda s: plot_images(
            {name: s["depth"] > limit for name, limit in zip("abcdef", range(6), strict=True)},
            columns=3,
        ),
        "files read back": lambda s: plot_images(
            {"rgb_view.png": s["rgb"], "depth_view.png": visualize_depth(s["depth"])[..., ::-1]}
        ),
        "other sizes": lambda s: plot_images({"wide": s["rgb"], "tall": s["rgb"][:, 40:100]}),
        "depth with holes": lambda s: plot_depth(s["surface"], limits=(0.6, 2.2)),
        "depth with a title": lambda s: plot_depth(s["sheet"], title="the sheet's metric depth"),
        "half a depth": lambda s: plot_depth(s["depth"], limits=(0, 2.2), width="half"),
        "depth in millimeters": lambda s: plot_depth(1000 * s["surface"], unit="mm"),
        "one depth": lambda _: plot_depth(np.full((24, 32), 2.0)),
        "comparison": lambda s: plot_comparison(
            s["surface"], s["surface"] + s["noise"], error_limit_mm=0.3
        ),
        "comparison without limits": lambda s: plot_comparison(s["depth"], s["depth"] + s["noise"]),
        "histogram": lambda s: plot_histogram(
            {"window depth": s["raw"]}, label="window depth", limits=(0, 1)
        ),
        "histograms": lambda s: plot_histogram(
            {"red_box": s["depth"] * 2 - 3, "red_ball": s["depth"], "orange": s["depth"] + 8},
            label="hue, 0 at the seam", bins=32, limits=(-12, 20),
        ),
        "logarithmic histograms": lambda s: plot_histogram(
            {"(W-1)/2": s["depth"], "W/2": s["depth"] + 0.5}, label="height (mm)", log=True
        ),
        "curves": lambda _: plot_lines(
            z,
            {"linear": z / 12} | {f"near {n} m": metric_to_raw(z, n, 12.0) for n in (0.02, 0.2)},
            x_label="depth (m)", y_label="window",
        ),
        "curves that end together": lambda _: plot_lines(
            z, {"joint": np.tanh(9 * z), "gyroscope": np.tanh(8 * z)},
            x_label="time (s)", y_label="angle (rad)",
        ),
        "logarithmic curves": lambda _: plot_lines(
            z, {"0 near, 1 far": z**2 / 4, "reversed": np.spacing(z.astype(np.float32)) * 1e3},
            x_label="depth (m)", y_label="mm per level", log_y=True,
        ),
        "a curve with gaps and zeros": lambda _: plot_lines(
            z, {"a & b": np.where((z > 0.4) & (z < 0.6), np.nan, z), "<c>": np.maximum(z - 1, 0)},
            x_label="x", y_label="y", log_y=True,
        ),
        "large numbers": lambda _: plot_lines(
            1e6 * z, {"mm": 1e-7 * z}, x_label="x", y_label="y"
        ),
        "numbers far from zero": lambda _: plot_lines(
            z, {"m": 1e5 + z}, x_label="x", y_label="y"
        ),
    }  # fmt: skip


CASES = make_cases()


@pytest.fixture(scope="module")
def data() -> Mapping[str, np.ndarray]:
    """What the book's figures are made of: the scene, seen by its camera without OpenGL."""
    model, state = make_scene()
    rgb, depth = render_camera(model, state, RaycastRenderer(model, 120, 160), "head_camera")
    near, far = get_clip_planes(model)
    surface = np.where(find_valid_depth(depth), depth, np.nan)
    return {
        "rgb": rgb,
        "bgr": rgb[..., ::-1],
        "depth": depth,
        "surface": surface,
        "raw": metric_to_raw(depth, near, far),
        "sheet": 0.01 + np.clip(depth, 0, 1) * (10 - 0.01),
        "noise": np.random.default_rng(4).normal(0, 1e-4, depth.shape),
    }


@pytest.fixture(params=CASES)
def both(
    request: pytest.FixtureRequest,
    data: Mapping[str, np.ndarray],
    monkeypatch: pytest.MonkeyPatch,
) -> tuple[Drawn, Drawn]:
    """One figure, drawn with Matplotlib and as SVG."""
    parts: list[Plot | Sheet] = []
    monkeypatch.setattr("labutils.figures.draw", parts.append)
    CASES[request.param](data)
    return read_matplotlib(parts[0]), read_svg(parts[0])


def test_all_backends_show_the_same(both: tuple[Drawn, Drawn]) -> None:
    built, written = both
    assert_allclose(written.size, built.size, rtol=0, atol=0.01)
    for words in ("titles", "labels", "names", "notes", "ticks"):
        assert getattr(written, words) == getattr(built, words), words
    compare_axes(built, written)
    assert len(written.pictures) == len(built.pictures)
    for ours, theirs in zip(written.pictures, built.pictures, strict=True):
        assert_allclose(ours.box, theirs.box, rtol=0, atol=PLACE_ATOL)
        colors = ours.sample(*ours.rgba.shape[:2]).astype(int)
        differences = np.abs(colors - theirs.sample(*colors.shape[:2])).max(axis=2)
        # what is transparent has no color
        differences[(colors[..., 3] == 0) & (differences < 256)] = 0
        assert (differences > COLOR_ATOL).mean() < SHARE_ON_BORDERS


def compare_axes(built: Drawn, written: Drawn) -> None:
    """Compare where axes, ticks and curves are, and their colors."""
    if written.axes is None or built.axes is None:
        assert written.axes is built.axes
        return
    assert_allclose(written.axes, built.axes, rtol=0, atol=PLACE_ATOL)
    for name in ("x_ticks", "y_ticks"):
        shares, expected_shares = (dict(getattr(one, name)) for one in (written, built))
        assert shares.keys() == expected_shares.keys()
        places = [expected_shares[text] for text in shares]
        assert_allclose(list(shares.values()), places, rtol=0, atol=TICK_ATOL)
    assert [one.color for one in written.curves] == [one.color for one in built.curves]
    for ours, theirs in zip(written.curves, built.curves, strict=True):
        expected = theirs.shares[np.isfinite(theirs.shares).all(axis=1)]
        assert len(ours.shares) == len(expected)
        # below the axes nothing is seen
        seen = expected[:, 1] > -SHARE_ATOL
        assert_allclose(ours.shares[seen], expected[seen], rtol=0, atol=SHARE_ATOL)
        assert (ours.shares[~seen, 1] < 0).all()
