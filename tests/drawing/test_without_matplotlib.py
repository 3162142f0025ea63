"""Everything that draws also works where Matplotlib does not exist, as in the browser."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
from numpy.testing import assert_allclose

from labutils._drawing import use_backend
from labutils.explorers import explore_depth_convention

LINES = """
import sys
for name in ("matplotlib", "cycler", "PIL", "open3d"):
    sys.modules[name] = None
import numpy as np
import labutils, labutils.figures, labutils.explorers
from labutils import figures, visualize_pointcloud
from labutils.explorers import explore_depth_convention
x, depth = np.linspace(0, 1, 20), np.random.default_rng(0).uniform(1, 3, (24, 32))
made = [
    figures.plot_images({"mask": depth > 2, "rgb": np.zeros((24, 32, 3), np.uint8)}),
    figures.plot_depth(depth, title="depth"),
    figures.plot_comparison(depth, depth + 0.001),
    figures.plot_histogram({"a": depth, "b": depth + 1}, label="m", log=True),
    figures.plot_lines(x, {"a": x, "b": x**2}, x_label="m", y_label="mm"),
    figures.plot_cloud(np.random.default_rng(0).uniform(1, 2, (50, 3))),
    visualize_pointcloud(np.random.default_rng(0).uniform(1, 2, (50, 3))),
]
for picture in made:
    print(*picture._repr_mimebundle_()[0])
print(*explore_depth_convention(0.2, 3, 0.7).view.draw_poster().shape)
"""


def run(code: str) -> list[str]:
    """Run code in a Python of its own; return what it printed, line by line."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_every_figure_is_drawn_without_matplotlib() -> None:
    svg, png = "image/svg+xml text/plain", "image/png text/plain"
    assert run(LINES) == [*[svg] * 5, *[png] * 2, "360 720 3"]


def test_importing_figures_loads_no_matplotlib() -> None:
    code = "import sys, labutils.figures, labutils.explorers; print('matplotlib' in sys.modules)"
    assert run(code) == ["False"]


def test_a_poster_without_matplotlib_shows_the_same_curves() -> None:
    explorer = explore_depth_convention(0.2, 3, 0.7)
    built = explorer.view.draw_poster()
    with use_backend("svg"):
        written = explorer.view.draw_poster()
    assert written.shape == built.shape
    assert written.dtype == np.uint8
    for color in ((0, 114, 178), (230, 159, 0), (0, 158, 115), (213, 94, 0)):
        places = [np.argwhere((image == color).all(axis=2)) for image in (built, written)]
        assert min(map(len, places)) > 20
        # titles break at other words, and lines are thicker: by a few pixels
        ends = [np.concatenate([place.min(axis=0), place.max(axis=0)]) for place in places]
        assert_allclose(ends[1], ends[0], rtol=0, atol=8)
