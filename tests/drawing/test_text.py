"""How wide texts are, where they break, and where names at the ends of curves stand."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.font_manager import findfont
from matplotlib.ft2font import FT2Font, LoadFlags
from numpy.testing import assert_allclose, assert_array_equal

from labutils._drawing.end_labels import spread_labels
from labutils._drawing.text_widths import _OTHERS, measure, wrap


def test_the_widths_are_those_of_matplotlibs_font() -> None:
    font = FT2Font(findfont("DejaVu Sans"))
    font.set_size(1000, 72)
    for character in [*map(chr, range(32, 127)), *_OTHERS]:
        glyph = font.load_char(ord(character), flags=LoadFlags.NO_HINTING)
        # the table has whole thousandths
        advance = glyph.linearHoriAdvance / 2**16
        assert measure(character, 1000) == pytest.approx(advance, abs=0.51), character


def test_a_text_is_as_wide_as_its_letters() -> None:
    assert measure("depth (m)", 10) == pytest.approx(sum(measure(c, 10) for c in "depth (m)"))
    assert measure("", 10) == 0


def test_a_text_breaks_between_words_and_never_in_one() -> None:
    width = measure("raw 0.7 between", 10)
    assert wrap("raw 0.7 between planes", 10, width) == ["raw 0.7 between", "planes"]
    assert wrap("unbreakable", 10, 1) == ["unbreakable"]
    assert wrap("", 10, 100) == []


def test_labels_that_would_overlap_move_apart_and_others_stay() -> None:
    assert_allclose(spread_labels(np.array([50.0, 10.0]), 13), [50, 10])
    assert_allclose(spread_labels(np.array([5.0, 5.0]), 13), [-1.5, 11.5])
    apart = spread_labels(np.array([3.0, 1.0, 2.0, 90.0]), 10)
    assert_array_equal(np.argsort(apart), [1, 2, 0, 3])
    # to rounding: the gap is made by adding and taking away again
    assert np.diff(np.sort(apart)).min() >= 10 - 1e-9
