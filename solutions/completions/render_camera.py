"""Step 1: a third kind of picture, with the renderer in another mode."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco

from solutions._completion import Case, Completion, Part, Slip

if TYPE_CHECKING:
    import numpy as np


def render_labels(model: Any, data: Any, renderer: Any, camera_name: str) -> np.ndarray:
    """Render which geom every pixel shows.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene and its state.
    renderer : mujoco.Renderer
        In color mode, before and after.
    camera_name : str
        Name of a camera of the model.

    Returns
    -------
    ndarray, int, shape (H, W)
        Numbers of geoms; -1 where a pixel sees none.
    """
    mujoco.mj_forward(model, data)  # open: bring positions up to date
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_segmentation_rendering()
    pairs = renderer.render()  # two numbers per pixel: (H, W, 2)
    renderer.disable_segmentation_rendering()
    numbers = pairs[..., 0]  # open: of every pixel, the first of the two
    return numbers


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    return cases[:2]


COMPLETION = Completion(
    title="label every pixel",
    statement="A renderer has a third mode beside color and depth: segmentation, in which every "
    "pixel gets two numbers, the geom it shows and a kind. The pattern is the one of color and "
    "depth: bring the state up to date, switch on, draw, switch off.",
    section="step1-worked",
    twin=render_labels,
    parts=(
        Part("numbers", "depth", "int"),
        Part(
            "renderer in color mode",
            "flag",
            "bool",
            note="After your call the renderer still draws labels: leave it in color mode.",
        ),
    ),
    cases=_choose,
    slips=(
        Slip(
            "stale-labels",
            "the labels show where things were before the joints moved. Positions follow from "
            "data.qpos only when mj_forward computes them.",
            line="pass",
        ),
        Slip(
            "kind-of-thing",
            "these are the second numbers, which tell the kind: the same for every geom. The "
            "number of the geom comes first.",
            line="numbers = pairs[..., 1]",
        ),
    ),
    example="""\
numbers = render_labels(model, data, renderer, "head_camera")
print(len(np.unique(numbers)), "geoms in the picture")
show(numbers == model.geom("table_top").id, "the table top")""",
    imports=("import mujoco", "import numpy as np"),
)
