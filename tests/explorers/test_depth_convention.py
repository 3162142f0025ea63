"""The depth convention explorer: raw to meters, wrong readings, and the steps of the buffers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from labutils import metric_to_raw, process_depth
from labutils.explorers import explore_depth_convention
from labutils.explorers.depth_convention import (
    DepthConventionExplorer,
    _find_float_levels,
    _find_integer_levels,
)
from tests.helpers.node import evaluate

#: Both sides compute in double precision with the same formulas in the same order.
SAME = 1e-12


def make_cases(count: int = 80) -> list[tuple[float, int, float]]:
    """Traits of random places, and of all the corners."""
    rng = np.random.default_rng(11)
    nears = explore_depth_convention().view.nears
    corners = [
        (r, n, f) for r in (0.0, 0.5, 1.0) for n in (0, len(nears) - 1) for f in (2.0, 100.0)
    ]
    crowded = 1 - 10.0 ** rng.uniform(-9, 0, count)  # where far depths crowd
    places = rng.integers(0, len(nears), count)
    fars = rng.uniform(2, 100, count)
    return corners + list(zip(crowded.tolist(), places.tolist(), fars.tolist(), strict=True))


def compute(raw: float, near_place: int, far: float) -> DepthConventionExplorer:
    explorer = explore_depth_convention()
    explorer.view.set_trait("raw", raw)
    explorer.view.set_trait("near_place", near_place)
    explorer.view.set_trait("far", far)
    return explorer


def test_depth_and_wrong_readings_follow_from_process_depth() -> None:
    for case in make_cases():
        explorer = compute(*case)
        raw, near, far = explorer.raw, explorer.near, explorer.far
        values = explorer.values
        assert explorer.depth == process_depth(np.float64(raw), near, far)
        assert metric_to_raw(explorer.depth, near, far) == pytest.approx(raw, abs=1e-12)
        linear = np.interp(raw, [0, 1], [near, far])
        assert values["linear_error"] == pytest.approx(linear - explorer.depth, abs=1e-12 * far)
        reversed_depth = process_depth(np.float64(1 - raw), near, far)
        assert values["reversed_error"] == reversed_depth - explorer.depth


def test_all_readings_agree_where_they_must() -> None:
    at_near = compute(0.0, 3, 12.0).values
    assert at_near["linear_error"] == pytest.approx(0, abs=1e-12)
    at_far = compute(1.0, 3, 12.0).values
    assert at_far["linear_error"] == pytest.approx(0, abs=1e-12)
    assert compute(0.5, 3, 12.0).values["reversed_error"] == 0


@pytest.mark.parametrize("bits", [16, 24])
def test_an_integer_step_is_the_gap_between_two_levels(bits: int) -> None:
    last = 2**bits - 1
    for raw, place, far in make_cases(50):
        explorer = compute(raw, place, far)
        low, high = _find_integer_levels(raw, bits)
        assert low <= raw <= high
        assert round(high * last) - round(low * last) == 1
        ends = process_depth(np.array([low, high]), explorer.near, far)
        # the difference of two nearly equal depths loses digits, so it is no exact reference
        noise = 1000 * 4 * np.spacing(far) * far / explorer.near
        assert explorer.values[f"step{bits}_mm"] == pytest.approx(
            1000 * (ends[1] - ends[0]), rel=1e-9, abs=noise
        )


def test_float_levels_are_neighbors_around_the_value() -> None:
    values: list[Any] = [0.0, 1e-30, 0.1, 0.5, 0.7, np.float32(0.7), 1 - 1e-9, 1.0]
    for value in values:
        low, high = _find_float_levels(float(value))
        assert low <= value <= high
        assert np.nextafter(np.float32(low), np.float32(2)) == np.float32(high)
        assert high <= 1


def test_float_steps_are_those_of_step_3() -> None:
    """The chapter measures them with np.spacing: a third of a millimeter at 10 m."""
    near, far, z = 0.02, 12.0, 10.0
    raw = float(metric_to_raw(z, near, far))
    values = compute(raw, explore_depth_convention(near).view.near_place, far).values
    mm_per_unit = 1000 * z**2 * (far - near) / (near * far)
    for key, buffer in (("step_float_mm", raw), ("step_reversed_mm", 1 - raw)):
        spacing = float(np.spacing(np.float32(buffer))) * mm_per_unit
        # the slope of the curve stands for the gap: they differ by the curvature over one step
        assert values[key] == pytest.approx(spacing, rel=1e-4)
    assert 0.2 < values["step_float_mm"] < 0.4
    assert values["step_reversed_mm"] < 0.001


def test_the_page_computes_the_same() -> None:
    cases = make_cases()
    nears = explore_depth_convention().view.nears
    given = [(raw, nears[place], far) for raw, place, far in cases]
    found = evaluate("depth_convention", "given.map((one) => m.readRaw(...one))", given=given)
    for case, values in zip(cases, found, strict=True):
        expected = compute(*case).values
        assert values.keys() == expected.keys()
        for key, value in expected.items():
            # an error is a difference of two depths, each rounded once
            assert values[key] == pytest.approx(value, rel=SAME, abs=SAME * case[2]), (case, key)


def test_the_page_inverts_process_depth() -> None:
    z = np.geomspace(0.02, 12, 200).tolist()
    back = "z.map((z) => m.processDepth(m.metricToRaw(z, 0.02, 12), 0.02, 12))"
    # near raw = 1 one rounding of the raw value is worth z / near roundings of the depth
    np.testing.assert_allclose(evaluate("_depth", back, z=z), z, rtol=1e-12)


def test_starts_where_it_is_told_and_says_it() -> None:
    explorer = explore_depth_convention(0.0234, 12, 0.25)
    assert (explorer.near, explorer.far, explorer.raw) == (0.0234, 12.0, 0.25)
    assert explorer.view.nears == sorted(explorer.view.nears)
    assert "0.0234" in explorer.controls["near_place"].widget.options
    explorer.move(near_place=0)
    assert explorer.near == 0.005
    assert "raw 0.25000 between planes at 0.005 and 12 m is 0.0067 m" in repr(explorer)


def test_starts_in_the_middle_between_the_planes_unless_it_is_told() -> None:
    explorer = explore_depth_convention(0.2, 10)
    # to the step of its slider, which is coarse where depths are large
    assert explorer.depth == pytest.approx(5.1, abs=0.1)


def test_the_goal_needs_the_near_plane_away_from_the_camera() -> None:
    reached = {}
    for near in (0.02, 0.1):
        explorer = explore_depth_convention(near, 12)
        explorer.view.set_trait("raw", float(metric_to_raw(np.float64(2.0), near, 12)))
        reached[near] = explorer.goal_is_reached
    assert reached == {0.02: False, 0.1: True}


def test_starts_on_a_step_of_its_sliders() -> None:
    explorer = explore_depth_convention(0.02, 12.034, 0.123456)
    assert (explorer.far, explorer.raw) == (12.0, 0.1235)


def test_the_poster_is_a_picture_of_the_curve() -> None:
    poster = explore_depth_convention(0.2, 3, 0.7).view.draw_poster()
    assert poster.dtype == np.uint8
    assert poster.shape == (360, 720, 3)
    blue = (poster == (0, 114, 178)).all(
        axis=2
    )  # the true curve has the first color of all figures
    assert np.count_nonzero(blue) > 200
    assert (poster[0, 0] == 255).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"near": 0.001}, "near: expected 0.005 to 1, got 0.001"),
        ({"near": 1.5}, "near: expected 0.005 to 1, got 1.5"),
        ({"far": 1.5}, "far: expected 2 to 100, got 1.5"),
        ({"far": 200}, "far: expected 2 to 100, got 200"),
        ({"raw": -0.1}, "raw: expected 0 to 1, got -0.1"),
        ({"raw": float("nan")}, "raw: expected 0 to 1, got nan"),
        ({"near": 5.0, "far": 2.0}, "expected 0 < near < far"),
    ],
)
def test_values_outside_the_sliders_are_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        explore_depth_convention(**arguments)


def test_planes_must_be_numbers() -> None:
    with pytest.raises(TypeError, match="near: expected meters as a number"):
        explore_depth_convention(near="0.02")  # type: ignore[arg-type]  # wrong on purpose
