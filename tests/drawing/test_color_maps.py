"""The color maps without Matplotlib are Matplotlib's."""

from __future__ import annotations

from typing import Literal

import matplotlib as mpl
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils._drawing.color_maps import get_table, paint, to_bytes
from labutils._splat import get_depth_colors


@pytest.mark.parametrize("name", ["gray", "turbo", "RdBu_r"])
def test_the_tables_are_those_of_matplotlib(name: Literal["gray", "turbo", "RdBu_r"]) -> None:
    theirs = 255 * mpl.colormaps[name](np.arange(256))[:, :3]
    # to rounding: a color is a whole number here
    assert_allclose(get_table(name), theirs, rtol=0, atol=0.5 + 1e-9)


def test_a_cloud_has_the_bytes_of_matplotlibs_colors() -> None:
    points = np.random.default_rng(2).uniform(-1, 3, (500, 3))
    z = points[:, 2]
    theirs = mpl.colormaps["turbo"]((z - z.min()) / np.ptp(z))[:, :3]
    assert_array_equal(np.round(255 * get_depth_colors(points)), np.round(255 * theirs))


def test_the_limits_have_the_first_and_the_last_color_and_beyond_is_the_same() -> None:
    painted = paint(np.array([[-9.0, 1, 2, 99]]), "turbo", (1, 2))
    table = get_table("turbo")
    assert_array_equal(painted[0], table[[0, 0, 255, 255]])


def test_what_is_not_finite_is_transparent() -> None:
    painted = paint(np.array([[np.nan, 1, np.inf, 3]]), "gray")
    assert_array_equal(painted[0, :, 3], [0, 255, 0, 255])
    assert_array_equal(painted[0, [1, 3], 0], [0, 255])
    assert (paint(np.full((2, 2), np.nan), "gray")[..., 3] == 0).all()


def test_a_channel_of_one_value_is_black() -> None:
    assert not paint(np.full((2, 2), 255, np.uint8), "gray").any()
    assert not paint(np.zeros((2, 2), bool), "gray").any()


def test_colors_of_any_number_type_become_bytes() -> None:
    assert_array_equal(to_bytes(np.array([0.0, 0.5, 1, 7, np.nan])), [0, 127, 255, 255, 0])
    assert_array_equal(to_bytes(np.array([-3, 20, 999])), [0, 20, 255])
