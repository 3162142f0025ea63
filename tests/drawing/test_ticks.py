"""Ticks without Matplotlib stand where Matplotlib's stand, and say the same."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, ScalarFormatter
from numpy.testing import assert_allclose, assert_array_equal

from labutils._drawing.scales import Axis, get_color_limits, get_limits, widen
from labutils._drawing.ticks import Label, make_ticks
from tests.helpers.drawn import strip_math

#: Both add and multiply a few numbers; Matplotlib in another order.
RTOL = 1e-12


def make_limits(rng: np.random.Generator) -> tuple[float, float]:
    """Choose limits of any size, around zero or far from it, round or not."""
    span = 10 ** rng.uniform(-8, 8)
    middle = rng.choice([0, 1]) * rng.choice([-1, 1]) * 10 ** rng.uniform(-6, 6)
    low, high = middle - span * rng.uniform(), middle + span * rng.uniform()
    if rng.random() < 0.5:
        low, high = float(f"{low:.2g}"), float(f"{high:.2g}")
    # below that, the ticks are as fine as numbers are
    return (low, high) if high - low > 1e-9 * abs(middle) else (low, low + span + abs(middle))


def test_even_ticks_are_those_of_matplotlib() -> None:
    rng = np.random.default_rng(3)
    for _ in range(1000):
        limits, most = make_limits(rng), int(rng.integers(1, 12))
        locator = MaxNLocator(min(most, 9), steps=[1, 2, 2.5, 5, 10])
        locator.create_dummy_axis()
        formatter = ScalarFormatter()
        formatter.axis = locator.axis
        locator.axis.set_view_interval(*limits)  # type: ignore[union-attr]
        values = np.asarray(locator.tick_values(*limits))
        texts = formatter.format_ticks(values)  # type: ignore[arg-type]  # stubs want a list
        seen = (values >= limits[0]) & (values <= limits[1])
        ticks = make_ticks(Axis("", limits), most)
        assert_allclose(ticks.values, values[seen], rtol=RTOL, atol=RTOL * (limits[1] - limits[0]))
        assert [label.text for label in ticks.labels] == list(np.array(texts)[seen]), limits
        assert ticks.note == formatter.get_offset(), limits


@pytest.fixture(scope="module")
def log_axes() -> Axes:
    """Axes of Matplotlib whose y is logarithmic."""
    axes = Figure().subplots()
    axes.set_yscale("log")
    return axes


def test_logarithmic_ticks_are_those_of_matplotlib(log_axes: Axes) -> None:
    rng = np.random.default_rng(5)
    most = log_axes.yaxis.get_tick_space()
    for _ in range(200):
        low = rng.uniform(-12, 8)
        limits = (10**low, 10 ** (low + rng.choice([1.0, 9.0, 30.0]) * rng.uniform(0.4, 1)))
        log_axes.set_ylim(*limits)
        expected: dict[float, str] = {}
        for is_minor in (False, True):
            values = log_axes.yaxis.get_ticklocs(minor=is_minor)
            labels = log_axes.yaxis.get_ticklabels(minor=is_minor)
            texts = [strip_math(label.get_text()) for label in labels]
            expected |= {v: text for v, text in zip(values, texts, strict=True) if is_in(v, limits)}
        ticks = make_ticks(Axis("", limits, log=True), most)
        ours = np.sort(np.concatenate([ticks.values, ticks.minor]))
        assert_allclose(ours, sorted(expected), rtol=RTOL)
        written = [f"{label.text}^{label.exponent}" for label in ticks.labels]
        assert sorted(written) == sorted(text for text in expected.values() if text)


def is_in(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]


def test_a_logarithmic_axis_without_two_marks_has_plain_numbers() -> None:
    ticks = make_ticks(Axis("", (2.1, 2.4), log=True), 5)
    assert [label.text for label in ticks.labels][:2] == ["2.10", "2.15"]


def test_minus_signs_are_no_hyphens() -> None:
    ticks = make_ticks(Axis("", (-1, 1)), 2)
    assert ticks.labels[0] == Label("\N{MINUS SIGN}1")
    assert "-" not in make_ticks(Axis("", (0, 1e-9)), 2).note


def test_limits_leave_a_margin_and_widen_what_is_one_value() -> None:
    assert_allclose(get_limits(np.array([0.0, 10, np.nan, np.inf])), (-0.5, 10.5))
    assert_allclose(get_limits(np.array([0.0, 1, 100]), log=True), (10**-0.1, 10**2.1))
    assert_allclose(get_limits(np.array([2.0]), margin=0), (1.9, 2.1))
    assert_allclose(get_limits(np.array([2.0]), log=True, margin=0), (1, 10))
    assert_array_equal(get_limits(np.array([np.nan])), (0, 1))
    assert_array_equal(get_limits(np.array([-1.0]), log=True), (1, 10))
    assert_allclose(get_color_limits(np.array([2.0, np.nan])), (1.8, 2.2))
    assert_array_equal(get_color_limits(np.array([np.nan])), (0, 1))
    assert_allclose(widen(0, 0), (-0.05, 0.05))


@pytest.mark.parametrize("limits", [(2.0, 1.0), (np.nan, 1.0)])
def test_limits_in_the_wrong_order_are_refused(limits: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="limits: expected low <= high, got"):
        get_color_limits(np.ones(2), limits)
