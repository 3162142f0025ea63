"""The names that the editor of the pages offers: public ones, and not too many."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from tools.vendor.library_names import list_names

NAMES = {module: found.split(" ") for module, found in list_names().items()}


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("python", {"def", "return", "print", "range", "ValueError", "None"}),
        ("np", {"array", "clip", "float32", "linalg", "nan"}),
        ("np.linalg", {"inv", "norm"}),
        ("np.random", {"default_rng"}),
        ("cv2", {"inRange", "cvtColor", "COLOR_RGB2HSV", "MORPH_OPEN", "connectedComponents"}),
    ],
)
def test_what_exercises_need_is_offered(module: str, names: set[str]) -> None:
    assert names <= set(NAMES[module])


def test_only_public_names_that_exist_are_offered() -> None:
    owners = {"np": np, "np.linalg": np.linalg, "np.random": np.random, "cv2": cv2}
    for module, owner in owners.items():
        assert all(hasattr(owner, name) for name in NAMES[module]), module
    assert not [name for found in NAMES.values() for name in found if name.startswith("_")]


def test_what_no_page_has_is_not_offered() -> None:
    left_out = ("CAP_", "WINDOW_", "QT_", "IMWRITE_")
    assert not [name for name in NAMES["cv2"] if name.startswith(left_out)]
    assert "gapi" not in NAMES["cv2"]


def test_names_come_in_order_and_once() -> None:
    for found in NAMES.values():
        assert found == sorted(set(found))
