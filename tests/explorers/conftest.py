"""What the tests of the explorers share: the picture of the head camera."""

from __future__ import annotations

import numpy as np
import pytest

from labutils import make_renderer, make_scene, render_camera


@pytest.fixture(scope="module")
def rgb() -> np.ndarray:
    """Color of the head camera at home, uint8 (480, 640, 3)."""
    model, data = make_scene()
    with make_renderer(model, 480, 640) as renderer:
        return render_camera(model, data, renderer, "head_camera")[0]
