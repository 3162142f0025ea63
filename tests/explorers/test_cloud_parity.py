"""The point cloud explorer's JavaScript against labutils and NumPy."""

from __future__ import annotations

import base64
import json
from typing import Any

import mujoco
import numpy as np
import pytest

from labutils import intrinsics_matrix, points_to_pixels
from labutils._splat import get_depth_colors
from labutils.camera_utils import get_camera_pose
from labutils.explorers import explore_cloud
from labutils.explorers._base import DEPTH_STEP
from labutils.explorers._cloud_poster import (
    _SIZE,
    VIEW_FOV_DEG,
    draw_cloud,
    make_view_transform,
)
from labutils.explorers._cloud_start import turn_to_view
from labutils.explorers.cloud import CloudExplorer, CloudView
from tests.helpers.node import STATIC, run_node
from tests.helpers.tolerances import EXACT

#: Lets the view's own code read the traits of `fixture_of`.
READ_CLOUD = """
import { readCloud } from "STATIC/_cloud_read.js";
const bytes = (text) => Uint8Array.from(Buffer.from(text, "base64")).buffer;
const { traits, width, height } = data;
traits.palette = new DataView(bytes(data.palette));
const depth = { width, height, data: new Uint16Array(bytes(data.steps)) };
const image = { data: new Uint8ClampedArray(bytes(data.rgba)) };
const cloud = readCloud({ get: (name) => traits[name] }, image, depth);
"""
#: What of a view the page reads, beside its pictures.
TRAITS = (
    "depth_step",
    "min_depth",
    "true_K",
    "true_fov_y_deg",
    "T_world_cam",
    "faces",
    "depth_limits",
    "height_limits",
)


def show_from(code: str, data: Any) -> list[Any]:
    """Run a module that ends in `show(value)`, with `data` given; return what it shows."""
    start = (
        'import { readFileSync } from "node:fs";\nconst data = JSON.parse(readFileSync(0, "utf8"));'
        "\nconst show = (value) => console.log(JSON.stringify(value));\n"
    )
    text = start + code.replace("STATIC", STATIC.as_uri())
    return json.loads(run_node(text, given=json.dumps(data)))


def fixture_of(view: CloudView) -> dict[str, Any]:
    """What the JavaScript gets to know of a view."""
    depth = view.depth
    steps = np.round(depth / DEPTH_STEP).astype("<u2")
    rng = np.random.default_rng(5)
    rgba = rng.integers(0, 256, (*depth.shape, 4), np.uint8)
    return {
        "width": depth.shape[1],
        "height": depth.shape[0],
        "steps": base64.b64encode(steps.tobytes()).decode(),
        "rgba": base64.b64encode(rgba.tobytes()).decode(),
        # red is the place in the table
        "palette": base64.b64encode(bytes(b for i in range(256) for b in (i, 7, 9))).decode(),
        "traits": {name: getattr(view, name) for name in TRAITS},
    }


@pytest.fixture
def explorer(asymmetric: tuple[mujoco.MjModel, mujoco.MjData]) -> CloudExplorer:
    """A cloud of an uneven camera, with holes, in a world it is turned in."""
    model, data = asymmetric
    rng = np.random.default_rng(11)
    depth = rng.uniform(0.5, 3.0, (31, 47))
    depth[rng.random(depth.shape) < 0.1] = np.nan
    depth[[0, 0, 30, 30], [0, 46, 0, 46]] = [1.0, 1.3, 0.9, 2.0]
    rgb = rng.integers(0, 256, (31, 47, 3), np.uint8)
    K = np.array([[52.0, 0, 21.5], [0, 44.0, 16.25], [0, 0, 1]])
    faces = {"one": [(0, 0), (46, 0), (0, 30)], "other": [(46, 30), (46, 0), (0, 30)]}
    camera = model.camera(0).name
    return explore_cloud(rgb, depth, K, get_camera_pose(model, data, camera), faces=faces)


def test_the_page_computes_the_values_that_python_computes(explorer: CloudExplorer) -> None:
    view = explorer.view
    depth = view.depth
    hole = np.argwhere(depth == 0)[0][::-1].tolist()
    far_at_a_point = float(np.float32(depth[12, 9]))  # not below its own depth
    settings = [
        {"fov_y_deg": fov, "far": far, "pixel": pixel}
        for fov in (view.fov_y_deg, 25.0, 61.5)
        for far in (0.5, 1.7, far_at_a_point, 2.999)
        for pixel in ([], [9, 12], [46, 30], hole)
    ]
    code = (
        READ_CLOUD
        + """
    import {
      assumeIntrinsics, findPoint, makeCounter, measureAngle,
    } from "STATIC/_cloud_points.js";
    const count = makeCounter(cloud);
    show(data.settings.map(({ fov_y_deg, far, pixel }) => {
      const { K, stretch } = assumeIntrinsics(cloud.trueK, cloud.trueFov, fov_y_deg);
      return { points: count(far), f: K[1][1], stretch, angle_deg: measureAngle(cloud, K),
               ...findPoint(cloud, pixel, K, far) };
    }));
    """
    )
    found = show_from(code, {**fixture_of(view), "settings": settings})
    for setting, values in zip(settings, found, strict=True):
        explorer.move(**setting)
        expected = explorer.values
        assert values.keys() == expected.keys()
        assert values["points"] == expected["points"]
        for name in expected.keys() - {"points"}:
            if expected[name] is None:
                assert values[name] is None, (name, setting)
            else:
                np.testing.assert_allclose(values[name], expected[name], rtol=1e-9, err_msg=name)
    with_a_point = [values for values in found if values["point_camera"]]
    assert 0 < len(with_a_point) < len(found)


def test_the_page_looks_from_where_the_poster_looks() -> None:
    rng = np.random.default_rng(3)
    orbits = [
        {
            "azimuth_deg": rng.uniform(-360, 360),
            "elevation_deg": elevation_deg,
            "distance": rng.uniform(0.1, 5),
            "target": rng.normal(size=3).tolist(),
        }
        for elevation_deg in (-90.0, 90.0, 0.0, *rng.uniform(-90, 90, 20))
    ]
    code = """
    import { makeEyeTransform } from "STATIC/_orbit.js";
    show(data.map(makeEyeTransform));
    """
    for orbit, flat in zip(orbits, show_from(code, orbits), strict=True):
        transform = np.array(flat).reshape(3, 4)
        np.testing.assert_allclose(transform, make_view_transform(orbit)[:3], rtol=0, atol=EXACT)
        rotation = transform[:, :3]
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), rtol=0, atol=EXACT)
        assert np.linalg.det(rotation) == pytest.approx(1, abs=EXACT)


def test_transforms_join_as_matrices_do() -> None:
    rng = np.random.default_rng(4)
    first, second = rng.normal(size=(2, 4, 4))
    first[3] = second[3] = [0, 0, 0, 1]
    point = rng.normal(size=3)
    code = """
    import { joinTransforms, movePoint } from "STATIC/_orbit.js";
    import { FROM_WORLD } from "STATIC/_shared.js";
    show([joinTransforms(data.first, data.second), movePoint(data.first, data.point), FROM_WORLD]);
    """
    data = {
        "first": first[:3].ravel().tolist(),
        "second": second[:3].ravel().tolist(),
        "point": point.tolist(),
    }
    joined, moved, from_world = show_from(code, data)
    np.testing.assert_allclose(joined, (first @ second)[:3].ravel(), rtol=0, atol=EXACT)
    np.testing.assert_allclose(moved, (first @ [*point, 1])[:3], rtol=0, atol=EXACT)
    assert from_world == turn_to_view(np.eye(4))[:3].ravel().tolist()


def test_the_cameras_view_is_the_cameras_own(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    pose = turn_to_view(get_camera_pose(*scene, "head_camera"))
    start = {"azimuth_deg": 1, "elevation_deg": 2, "distance": 3, "target": [0.1, -0.9, 1.2]}
    code = """
    import { makeEyeTransform, joinTransforms, makeNamedView } from "STATIC/_orbit.js";
    const views = ["camera", "above", "side"].map((n) => makeNamedView(n, data.start, data.pose));
    show([views, joinTransforms(makeEyeTransform(views[0]), data.pose)]);
    """
    data = {"start": start, "pose": pose[:3].ravel().tolist()}
    (_, above, side), seen = show_from(code, data)
    # this camera does not tilt sideways, so nothing is left between it and the reader
    np.testing.assert_allclose(seen, np.eye(4)[:3].ravel(), rtol=0, atol=1e-9)
    assert (above["elevation_deg"], side["elevation_deg"]) == (90, 0)
    assert above["target"] == side["target"] == start["target"]
    forward = make_view_transform(side)[:3, :3] @ pose[:3, 2]
    assert forward[0] > 0  # from the camera's right, it looks to the right
    assert make_view_transform(above)[1, :3] @ pose[:3, 2] < 0  # away from it is up


def test_nobody_walks_over_the_pole_or_through_the_target() -> None:
    code = """
    import { turnOrbit, zoomOrbit } from "STATIC/_orbit.js";
    const up = turnOrbit(data, 10, 500), down = turnOrbit(data, -10, -500);
    show([up, down, zoomOrbit(data, 0.5), zoomOrbit(data, 1e-9), zoomOrbit(data, 1e9)]);
    """
    orbit = {"azimuth_deg": 355, "elevation_deg": 20, "distance": 2, "target": [0, 0, 1]}
    up, down, closer, near, far = show_from(code, orbit)
    assert (up["elevation_deg"], down["elevation_deg"]) == (90, -90)
    assert (up["azimuth_deg"], down["azimuth_deg"]) == (5, 345)
    assert closer == {**orbit, "distance": 1}
    assert 0 < near["distance"] < 0.5
    assert 5 < far["distance"] < 100


def test_the_poster_has_its_middle_where_the_page_has_it() -> None:
    # Two counts of the same place: the page's from the corner of the first pixel, the library's
    # from its center, half a pixel farther in. With W/2 in the library both would read the same.
    rng = np.random.default_rng(12)
    points = rng.uniform([-0.4, -0.3, 1], [0.4, 0.3, 3], (20, 3))
    width, height = _SIZE
    code = """
    import { projectLine } from "STATIC/_orbit.js";
    import { focalFromFov } from "STATIC/_camera.js";
    const focal = focalFromFov(data.fov, data.height);
    show(data.points.map((p) => projectLine(p, p, focal, data.width, data.height)[0]));
    """
    given = {"points": points.tolist(), "fov": VIEW_FOV_DEG, "width": width, "height": height}
    on_page = np.array(show_from(code, given))
    K = intrinsics_matrix(np.radians(VIEW_FOV_DEG), width, height)
    np.testing.assert_allclose(points_to_pixels(points, K) + 0.5, on_page, rtol=0, atol=1e-9)
    # ... and the poster draws with that: one point, a square of 2 x 2 pixels around its place
    orbit = {"azimuth_deg": 0, "elevation_deg": 0, "distance": 0, "target": np.zeros(3)}
    for point, (x, y) in zip(points, on_page, strict=True):
        black = np.zeros((1, 3))
        rows, columns = np.nonzero(draw_cloud(point[None], black, None, orbit).max(axis=2) == 0)
        middle = [columns.mean() + 0.5, rows.mean() + 0.5]
        assert len(rows) == 4
        np.testing.assert_allclose(middle, [x, y], rtol=0, atol=0.5 + 1e-9)


def test_a_line_is_cut_where_it_passes_the_eye() -> None:
    code = """
    import { projectLine } from "STATIC/_orbit.js";
    const line = (a, b) => projectLine(a, b, 100, 60, 40);
    show([line([0, 0, 1], [1, 2, 2]), line([0, 0, -1], [1, 0, -2]), line([0, 0, 1], [3, 0, -1])]);
    """
    front, behind, through = show_from(code, None)
    np.testing.assert_allclose(front, [[30, 20], [80, 120]])
    assert behind == []
    # cut at a depth of 0.02: 49 hundredths of the way, x = 1.47
    np.testing.assert_allclose(through, np.array([[30, 20], [30 + 100 * 1.47 / 0.02, 20]]))


def test_colors_follow_depth_and_height(explorer: CloudExplorer) -> None:
    view = explorer.view
    explorer.move(fov_y_deg=50.0)
    K = explorer.K
    code = (
        READ_CLOUD
        + """
    import { colorPoints } from "STATIC/_cloud_points.js";
    show([0, 1, 2].map((mode) => {
      const out = new Uint32Array(cloud.steps.length);
      colorPoints(cloud, data.K, mode, out);
      return [...out].map((color) => (mode ? color & 255 : color));
    }));
    """
    )
    fixture = {**fixture_of(view), "K": K.tolist()}
    own, by_depth, by_height = show_from(code, fixture)
    assert own == np.frombuffer(base64.b64decode(fixture["rgba"]), "<u4").tolist()
    depth = view.depth.astype(np.float64)
    v, u = np.mgrid[: depth.shape[0], : depth.shape[1]]
    in_camera = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], u**0.0]) * depth
    T_world_cam = np.array(view.T_world_cam)
    heights = np.tensordot(T_world_cam[2, :3], in_camera, 1) + T_world_cam[2, 3]
    valid = depth > 0
    for found, values, (low, high) in (
        (by_depth, depth, view.depth_limits),
        (by_height, heights, view.height_limits),
    ):
        expected = np.clip((values - low) / (high - low) * 256, 0, 255.999)
        # a value at the border of two colors may fall to either: at most one color apart
        off = np.abs(np.array(found).reshape(depth.shape) + 0.5 - expected)[valid]
        assert off.max() <= 0.5 + 1e-3
        assert len(set(found)) > 50


def test_the_palette_is_the_librarys_turbo(explorer: CloudExplorer) -> None:
    palette = np.frombuffer(explorer.view.palette, np.uint8).reshape(256, 3)
    ramp = np.stack([np.zeros(256), np.zeros(256), np.arange(256.0)], axis=1)
    # two tables of one color map: OpenCV's and Matplotlib's, rounded differently
    assert np.abs(palette / 255 - get_depth_colors(ramp)).max() < 0.03


SPLAT = (
    READ_CLOUD
    + """
import { makeSplatBuffer, pickDrawn, splatPoints } from "STATIC/_splat.js";
const look = { eyeFromCamera: data.eye, focal: data.focal, K: cloud.trueK, far: data.far };
const buffer = makeSplatBuffer(...data.size);
splatPoints(cloud, look, buffer, data.stride);
"""
)


def draw_slowly(
    points: np.ndarray,
    kept: np.ndarray,
    fy: float,
    eye: np.ndarray,
    focal: float,
    size: tuple[int, int],
    stride: int,
) -> np.ndarray:
    """Draw squares one by one, far to near: the nearest id at each pixel, -1 where none is."""
    width, height = size
    ids = np.full((height, width), -1)
    seen = points @ eye[:, :3].T + eye[:, 3]
    order = [i for i in np.argsort(-seen[:, 2], kind="stable") if kept[i] and seen[i, 2] >= 0.02]
    for i in order:
        x, y = focal * seen[i, :2] / seen[i, 2] + [width / 2, height / 2]
        side = 1.6 * stride * focal * points[i, 2] / (fy * seen[i, 2])
        half = np.clip(side, 1, 12 * stride) / 2
        inside = [
            (np.abs(np.arange(count) + 0.5 - at) <= half) | (np.arange(count) == np.floor(at))
            for at, count in ((y, height), (x, width))
        ]
        ids[np.ix_(*inside)] = i
    return ids


@pytest.mark.parametrize("stride", [1, 3])
def test_the_nearest_point_is_drawn_on_top(explorer: CloudExplorer, stride: int) -> None:
    view = explorer.view
    depth = view.depth.astype(np.float64)
    v, u = np.mgrid[: depth.shape[0], : depth.shape[1]]
    K = np.array(view.true_K)
    points = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], u**0.0], -1)
    points = (points * depth[..., None]).reshape(-1, 3)
    far = 2.2
    kept = ((depth > 0.01) & (depth < far) & (u % stride == 0) & (v % stride == 0)).ravel()
    orbit = {"azimuth_deg": 35, "elevation_deg": 25, "distance": 1.6, "target": [0.1, 0, 1.4]}
    eye = make_view_transform(orbit)[:3]
    size, focal = (83, 61), 60.0
    data = {
        **fixture_of(view), "eye": eye.ravel().tolist(), "focal": focal, "far": far,
        "size": size, "stride": stride,
    }  # fmt: skip
    ids = np.array(show_from(SPLAT + "show([...buffer.ids]);", data)).reshape(size[::-1])
    expected = draw_slowly(points, kept, K[1, 1], eye, focal, size, stride)
    # a square may end exactly on a pixel's center: allow one pixel in a thousand
    assert (ids != expected).mean() < 1e-3
    assert 0.2 < (ids >= 0).mean() < 1


def test_picking_finds_the_front_point_or_the_closest_drawn() -> None:
    # two pixels on one line of sight from the side; only the nearer one is drawn
    depth = np.zeros((3, 5))
    depth[1, 2], depth[1, 3] = 1.0, 2.0
    K = np.array([[10.0, 0, 2], [0, 10.0, 1], [0, 0, 1]])
    view = explore_cloud(np.zeros((3, 5, 3), np.uint8), depth, K).view
    target = [0.0, 0.0, 1.0]  # the first point; the second lies at (0.2, 0, 2)
    azimuth_deg = -float(np.degrees(np.arctan2(0.2, 1.0)))
    orbit = {"azimuth_deg": azimuth_deg, "elevation_deg": 0, "distance": 1, "target": target}
    data = {
        **fixture_of(view), "eye": make_view_transform(orbit)[:3].ravel().tolist(),
        "focal": 40.0, "far": 5.0, "size": (100, 80), "stride": 1,
    }  # fmt: skip
    code = (
        SPLAT
        + """
    const pick = (x, y, slack) => pickDrawn(buffer, x, y, slack);
    show([new Set(buffer.ids).size, pick(50, 40, 0), pick(58.5, 40, 5), pick(58.5, 40, 9),
          pick(0, 0, 4), pick(-3, 200, 4)]);
    """
    )
    kinds, on_it, beside, within, corner, outside = show_from(code, data)
    front = 1 * 5 + 2
    assert kinds == 2  # nothing, and the front point
    assert (on_it, beside, within) == (front, -1, front)
    assert (corner, outside) == (-1, -1)
