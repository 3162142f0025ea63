"""Rays to compare: pictures of the book's scene, and many rays at things of every shape."""

from __future__ import annotations

import sys
from typing import Any

import mujoco
import numpy as np

import labutils as lab
from labutils.raycast import RaycastRenderer, get_pixel_rays

SHAPES = ("box", "sphere", "capsule", "cylinder", "ellipsoid", "mesh", "hfield")
GROUPS = np.array([1, 1, 1, 0, 0, 0], np.uint8)
_MESH = '<mesh name="t" vertex="0 0 0  .3 0 0  0 .3 0  0 0 .3  .2 .2 .2"/>'
_HFIELD = (
    '<hfield name="h" nrow="3" ncol="3" size=".2 .2 .2 .05" elevation="0 .2 0 .4 1 .3 0 .1 0"/>'
)


def collect(width: int, height: int) -> dict[str, Any]:
    """Return depth, labels and colors of pictures, and the answers of rays."""
    found = _draw(width, height)
    for shape in SHAPES:
        found |= _shoot(shape)
    return found


def _draw(width: int, height: int) -> dict[str, Any]:
    model, data = lab.make_scene()
    renderer = RaycastRenderer(model, height, width)
    found: dict[str, Any] = {}
    for camera in ("head_camera", "overview"):
        rgb, depth = lab.render_camera(model, data, renderer, camera)
        found[f"{camera}.rgb"], found[f"{camera}.depth"] = rgb, depth
        renderer.enable_segmentation_rendering()
        found[f"{camera}.geoms"] = renderer.render()[..., 0]
        renderer.disable_segmentation_rendering()
        rays = get_pixel_rays(model, data, camera, width, height).reshape(-1, 3)
        origin = data.camera(camera).xpos
        found[f"{camera}.multi"] = cast_all(model, data, origin, rays)[1]
    return found


def _shoot(shape: str) -> dict[str, Any]:
    """Cast rays from one point at a heap of things, all at once and one by one."""
    rng = np.random.default_rng(3)
    model = mujoco.MjModel.from_xml_string(_make_heap(shape, rng))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    origin = np.array([1.9, 0.3, 0.4])
    rays = rng.normal([-1, -0.15, -0.2], 0.25, (4000, 3))
    distances, ids, normals = cast_all(model, data, origin, rays)
    few = [cast_one(model, data, origin, ray) for ray in rays[:300]]
    return {
        f"{shape}.distances": distances,
        f"{shape}.ids": ids,
        f"{shape}.normals": normals,
        f"{shape}.one_distances": np.array([one[0] for one in few]),
        f"{shape}.one_ids": np.array([one[1] for one in few]),
    }


def _make_heap(shape: str, rng: np.random.Generator) -> str:
    asset = {"mesh": _MESH, "hfield": _HFIELD}.get(shape, "")
    bodies = []
    for _ in range(12):
        place = " ".join(map(str, rng.uniform(-0.6, 0.6, 3)))
        turn = " ".join(map(str, rng.uniform(-180, 180, 3)))
        size = " ".join(map(str, rng.uniform(0.05, 0.2, 3)))
        form = {"mesh": 'mesh="t"', "hfield": 'hfield="h"'}.get(shape, f'size="{size}"')
        parent = f'<body pos="{place}" euler="{turn}"><geom type="{shape}" {form}/></body>'
        bodies.append(parent)
    text = "".join(bodies)
    return f"<mujoco><asset>{asset}</asset><worldbody>{text}</worldbody></mujoco>"


def cast_all(model: Any, data: Any, origin: Any, rays: Any) -> tuple[Any, Any, Any]:
    """Cast rays by one call of `mj_multiRay`."""
    count = len(rays)
    ids, distances, normals = np.full(count, -9, np.int32), np.zeros(count), np.zeros(3 * count)
    mujoco.mj_multiRay(
        model, data, origin, rays.ravel(), GROUPS, True, -1, ids, distances, normals, count, 1e10
    )
    return distances, ids, normals.reshape(count, 3)


def cast_one(model: Any, data: Any, origin: Any, ray: Any) -> tuple[float, int]:
    """Cast a ray by `mj_ray`."""
    number = np.zeros(1, np.int32)
    distance = mujoco.mj_ray(model, data, origin, ray, GROUPS, True, -1, number)
    return distance, int(number[0])


def many_rays_hit_what_single_rays_hit() -> None:
    """Also where the boxes of a scene bulge out between their corners, as seen from a camera."""
    model, data = lab.make_scene()
    origin = data.camera("overview").xpos.copy()
    rays = get_pixel_rays(model, data, "overview", 64, 48).reshape(-1, 3)
    _, ids, _ = cast_all(model, data, origin, rays)
    single = [cast_one(model, data, origin, ray)[1] for ray in rays]
    assert ids.tolist() == single
    assert (model.body_bvhadr >= 0).any()  # put back as it was


if sys.platform == "emscripten":

    def save_rays() -> int:
        """Write all answers to the folder of the tests."""
        found = collect(640, 480)
        np.savez("/out/rays.npz", **found)
        return len(found)
