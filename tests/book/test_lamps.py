"""Step 4 relights a picture by three numbers: the simulator's lamps do the same to objects."""

from __future__ import annotations

import numpy as np
import pytest

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from tests.helpers.quiz import HEAD, SIZE

OBJECTS = (
    "red_box",
    "red_ball",
    "orange_cylinder",
    "green_can",
    "yellow_block",
    "blue_bottle",
    "purple_capsule",
    "cyan_mug",
    "table",
)


@pytest.mark.parametrize("lamp", [(0.25, 0.25, 0.25), (1.0, 0.75, 0.45)], ids=["weak", "warm"])
def test_another_lamp_multiplies_the_channels_of_objects(lamp: tuple[float, ...]) -> None:
    if not lab.is_gl_available():
        pytest.skip("rays draw flat colors, whatever the lamps")
    pictures = []
    for factor in ((1.0, 1.0, 1.0), lamp):
        model, data = lab.make_scene()
        headlight = model.vis.headlight
        for part in (
            model.light_ambient,
            model.light_diffuse,
            model.light_specular,
            headlight.ambient,
            headlight.diffuse,
        ):
            part[:] *= np.array(factor)
        with lab.make_renderer(model, *SIZE) as renderer:
            pictures.append(lab.render_camera(model, data, renderer, HEAD)[0].astype(float))
            bodies = lab.render_segmentation(model, data, renderer, HEAD)
    before, after = pictures
    seen = np.isin(bodies, [model.body(name).id for name in OBJECTS])
    off = np.abs(after - before * lamp)[seen]
    # Two roundings to whole numbers make 1; at outlines a pixel mixes in the sky or a glowing eye.
    assert np.percentile(off, 99) <= 1.5
