"""The page reads the clip as the notebook does: see ``inside/recordings.py``."""

from __future__ import annotations

from typing import Any

import pytest

from tests.helpers.scripts import load_script


def test_the_page_sees_the_same_pictures_with_the_same_noise(page_said: dict[str, Any]) -> None:
    here = load_script("tests/page/inside/recordings.py")
    assert page_said["recordings"]["describe_pairs"]["value"] == here.describe_pairs()


def test_the_page_finds_the_same_matches(page_said: dict[str, Any]) -> None:
    """OpenCV adds windows in another order there: of equal costs another one may win."""
    here = load_script("tests/page/inside/recordings.py")
    count, total = page_said["recordings"]["sum_matches"]["value"]
    assert [count, total] == pytest.approx(here.sum_matches(), rel=1e-4)
