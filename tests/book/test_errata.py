"""The errata page is right: one test per row, which measures what the row says."""

from __future__ import annotations

import inspect
import os
import re
import subprocess
import sys
import textwrap
import warnings
from pathlib import Path

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from typing import TypeAlias

import cv2
import mujoco
import numpy as np
import pytest

from labutils.raycast import RaycastRenderer
from labutils.scene import SCENE_PATH

# The same files and numbers are due where no OpenGL works.
pytestmark = pytest.mark.filterwarnings("ignore::labutils.NoOpenGLWarning")

PAGE = Path(__file__).resolve().parents[2] / "book" / "errata.md"
ROW = re.compile(r"^\| \[(E\d+)\]\((\w+\.md)\) \|(.*)\|(.*)\*\*(.*)\*\* \|$", re.MULTILINE)
WIDTH, HEIGHT = 640, 480
CAMERA = "head_camera"

Frame: TypeAlias = tuple[mujoco.MjModel, mujoco.MjData, np.ndarray, np.ndarray]


def read_rows() -> dict[str, list[str]]:
    """Return, per row, the page that teaches it, what the sheet says, the truth, the measure."""
    rows = ROW.findall(PAGE.read_text(encoding="utf-8"))
    return {name: [cell.strip() for cell in cells] for name, *cells in rows}


def assert_page_says(row: str, *texts: str) -> None:
    """The bold text of the row contains what was just measured."""
    measured = read_rows()[row][3]
    for text in texts:
        # a digit before it would make 1.4 mm out of 11.4 mm
        assert re.search(rf"(?<![\d.]){re.escape(text)}", measured), f"{row}: {text} / {measured}"


@pytest.fixture(scope="module")
def frame() -> Frame:
    """State, depth and intrinsics; the depth is the exact one, the same on every machine."""
    model, data = lab.make_scene()
    renderer = RaycastRenderer(model, HEIGHT, WIDTH)
    _, depth = lab.render_camera(model, data, renderer, CAMERA)
    K, _ = lab.get_camera_intrinsics(model, CAMERA, WIDTH, HEIGHT)
    return model, data, depth, K


@pytest.fixture(scope="module")
def rgb() -> np.ndarray:
    """The color picture, from OpenGL where there is one."""
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        return lab.render_camera(model, data, renderer, CAMERA)[0]


def stretch(depth: np.ndarray) -> np.ndarray:
    """Convert as the sheet does: clip to 0-1, then a straight line from 0.01 m to 10 m."""
    return 0.01 + np.clip(depth, 0, 1) * (10.0 - 0.01)


def find_visible(model: mujoco.MjModel, data: mujoco.MjData) -> set[str]:
    """Name the bodies that the head camera sees."""
    ids = lab.render_segmentation(model, data, RaycastRenderer(model, HEIGHT, WIDTH), CAMERA)
    return {model.body(i).name for i in np.unique(ids[ids >= 0])}


def test_every_row_has_a_test_and_every_test_a_row() -> None:
    tests = [re.match(r"test_(e\d+)_", name) for name in globals()]
    assert sorted(m[1].upper() for m in tests if m) == sorted(read_rows())


def test_rows_are_numbered_in_order_and_complete() -> None:
    rows = read_rows()
    assert list(rows) == [f"E{i}" for i in range(1, len(rows) + 1)]
    assert all(all(cells) for cells in rows.values())
    # A row in another form would be no row to the tests, but still one to a reader.
    assert PAGE.read_text(encoding="utf-8").count("\n| [E") == len(rows)
    assert all((PAGE.parent / page).is_file() for page, *_ in rows.values())


def test_e1_the_path_of_the_sheet_leads_nowhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    path = "textbook/assets/robot-models/mujoco/" + SCENE_PATH.name
    with pytest.raises(ValueError, match="Error opening file"):
        mujoco.MjModel.from_xml_path(path)
    assert lab.make_scene()[0].ncam > 0
    assert_page_says("E1", "`ValueError`")


def test_e2_code_cut_by_fences_or_without_indentation_does_not_compile() -> None:
    lines = inspect.getsource(lab.find_object_centroid).splitlines()
    middle = len(lines) - 3
    cut = [*lines[:middle], "```python", *lines[middle:]]
    with pytest.raises(SyntaxError):
        compile("\n".join(cut), "sheet", "exec")
    flat = [textwrap.dedent(line) for line in lines]
    with pytest.raises(IndentationError):
        compile("\n".join(flat), "sheet", "exec")
    assert_page_says("E2", "`SyntaxError`", "`IndentationError`")


def test_e3_depth_rendering_takes_no_argument() -> None:
    # Called on a stand-in: the signature is the same where no OpenGL can make a renderer.
    switch = mujoco.Renderer.enable_depth_rendering
    with pytest.raises(TypeError, match="takes 1 positional argument but 2 were given"):
        switch(None, True)  # noqa: FBT003 - the mistake itself
    assert_page_says("E3", "`TypeError`")


def test_e4_a_step_leaves_the_camera_one_step_behind(frame: Frame) -> None:
    _, _, _, K = frame
    model, data = lab.make_scene()
    data.qvel[model.joint("neck_pan").dofadr[0]] = 3.0
    before = data.time
    mujoco.mj_step(model, data)
    assert_page_says("E4", f"{1000 * (data.time - before):.0f} ms")
    # What the stale camera has in its middle is elsewhere for the camera that qpos describes.
    stale = lab.get_camera_pose(model, data, CAMERA)
    point_world = (stale @ [0, 0, 100.0, 1])[:3]  # far off, so that only the turn counts
    mujoco.mj_forward(model, data)
    camera = data.camera(CAMERA)
    point = lab.world_to_camera(point_world[None], camera.xpos, camera.xmat)
    shift_px = np.linalg.norm(lab.points_to_pixels(point, K) - K[:2, 2])
    assert_page_says("E4", f"{shift_px:.1f} px")


def test_e5_a_fresh_state_looks_past_the_objects() -> None:
    model, home = lab.make_scene()
    objects = {
        "red_box", "red_ball", "orange_cylinder", "green_can",
        "yellow_block", "blue_bottle", "purple_capsule", "cyan_mug",
    }  # fmt: skip
    fresh = mujoco.MjData(model)
    mujoco.mj_forward(model, fresh)
    assert_page_says("E5", f"{len(find_visible(model, fresh) & objects)} of {len(objects)}")
    assert objects <= find_visible(model, home)


@pytest.mark.skipif(not lab.is_gl_available(), reason="the ray caster always paints a sky")
def test_e6_without_forward_there_is_nothing_and_only_no_sky_is_black() -> None:
    spec = mujoco.MjSpec.from_file(str(SCENE_PATH))
    with_sky = spec.compile()
    spec.delete(spec.texture("sky"))
    brightest = []
    for model in (with_sky, spec.compile()):
        with mujoco.Renderer(model, 48, 64) as renderer:
            renderer.update_scene(mujoco.MjData(model), camera=CAMERA)
            brightest.append(renderer.render().max())
            renderer.enable_depth_rendering()
            at_far = np.isclose(renderer.render(), lab.get_clip_planes(model)[1], atol=1e-3)
        assert_page_says("E6", f"{100 * at_far.mean():.0f} %")
    assert brightest[0] > 200
    assert brightest[1] == 0


def test_e7_half_a_pixel_moves_every_point(frame: Frame) -> None:
    *_, depth, K = frame
    sheet = K.copy()
    sheet[:2, 2] = WIDTH / 2, HEIGHT / 2
    ours, theirs = (lab.depth_to_pointcloud(depth, k)[0] for k in (K, sheet))
    off_mm = 1000 * np.linalg.norm(ours - theirs, axis=1)
    assert_page_says("E7", f"{np.median(off_mm):.1f} mm", f"{off_mm.max():.1f} mm")


def test_e8_one_focal_length_does_not_fit_a_sensor_camera(frame: Frame) -> None:
    model, data, *_ = frame
    camera = "sensor_camera"
    K, _ = lab.get_camera_intrinsics(model, camera, WIDTH, HEIGHT)
    focal = HEIGHT / 2 / np.tan(np.deg2rad(model.camera(camera).fovy[0]) / 2)
    sheet = np.array([[focal, 0, WIDTH / 2], [0, focal, HEIGHT / 2], [0, 0, 1]])
    depth = lab.raycast_depth(model, data, camera, WIDTH, HEIGHT)
    ours, theirs = (lab.depth_to_pointcloud(depth, k)[0] for k in (K, sheet))
    off_mm = 1000 * np.linalg.norm(ours - theirs, axis=1)
    assert_page_says("E8", f"{focal:.0f} px", f"{K[0, 0]:.0f} px", f"{np.median(off_mm):.0f} mm")


def test_e9_clipping_meters_destroys_them(frame: Frame) -> None:
    *_, depth, K = frame
    sheet = stretch(depth)
    points, _ = lab.depth_to_pointcloud(sheet, K)
    assert_page_says(
        "E9",
        f"{100 * (depth > 1).mean():.0f} %",
        f"{depth.min():.2f} m to {points[:, 2].min():.2f} m",
    )
    assert len(points) == np.count_nonzero(depth < 1)


def test_e10_window_depth_is_no_straight_line(frame: Frame) -> None:
    model, _, depth, _ = frame
    near, far = lab.get_clip_planes(model)
    surface = lab.find_valid_depth(depth)
    raw = lab.metric_to_raw(depth, near, far)
    off = np.abs(near + raw * (far - near) - depth)[surface]
    assert_page_says("E10", f"{np.median(off):.1f} m")
    ndc = 2 * raw - 1
    comment = 2 * near * far / (far + near - ndc * (far - near))
    np.testing.assert_allclose(comment, lab.process_depth(raw, near, far), rtol=1e-9, atol=0)


def test_e11_default_planes_are_not_those_of_the_scene(frame: Frame) -> None:
    model, _, depth, _ = frame
    near, far = lab.get_clip_planes(model)
    assert (near, far) != (0.01, 10.0)
    raw = lab.metric_to_raw(depth, near, far)
    wrong = lab.process_depth(raw, 0.01, 10.0)
    surface = lab.find_valid_depth(depth)
    share = np.median((1 - wrong / depth)[surface])
    assert_page_says("E11", f"{10 * round(10 * share):.0f} %")


def test_e12_the_depth_picture_has_a_single_color(frame: Frame) -> None:
    *_, depth, _ = frame
    levels = (np.clip(stretch(depth) / 5.0, 0, 1) * 255).astype(np.uint8)
    colors = np.unique(cv2.applyColorMap(levels, cv2.COLORMAP_JET).reshape(-1, 3), axis=0)
    assert_page_says("E12", f"{len(colors)} color")


def test_e13_a_healthy_buffer_is_near_one(frame: Frame) -> None:
    model, _, depth, _ = frame
    raw = lab.metric_to_raw(depth, *lab.get_clip_planes(model))
    assert_page_says("E13", f"{raw.min():.2f}")


def test_e14_the_ray_is_longer_than_the_depth(frame: Frame) -> None:
    *_, K = frame
    (corner,) = lab.pixels_to_points(np.zeros((1, 2)), np.ones(1), K)
    assert_page_says("E14", f"{100 * (np.linalg.norm(corner) - 1):.0f} %")


def test_e15_the_largest_depth_is_no_surface(frame: Frame) -> None:
    model, data, depth, _ = frame
    truth = lab.raycast_depth(model, data, CAMERA, WIDTH, HEIGHT)
    assert_page_says("E15", f"{depth.max():.1f} m", f"{np.nanmax(truth):.1f} m")


def test_e16_a_pixel_without_depth_looks_like_the_nearest() -> None:
    depth = np.array([[np.nan, 0.0]], dtype=np.float32)
    with pytest.warns(RuntimeWarning, match="invalid value encountered in cast"):
        levels = (np.clip(depth / 5.0, 0, 1) * 255).astype(np.uint8)
    hole, nearest = cv2.applyColorMap(levels, cv2.COLORMAP_JET)[0]
    np.testing.assert_array_equal(hole, nearest)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ours = lab.visualize_depth(np.array([[np.nan, 0.01]]))[0]
    assert not ours[0].any()
    assert ours[1].any()
    assert_page_says("E16", "The same color", "`RuntimeWarning`")


def test_e17_one_range_misses_the_red_box(frame: Frame, rgb: np.ndarray) -> None:
    model, data, *_ = frame
    labels = lab.render_segmentation(model, data, RaycastRenderer(model, HEIGHT, WIDTH), CAMERA)
    box = labels == model.body("red_box").id
    sheet = lab.segment_by_color(rgb, ((0, 100, 100), (10, 255, 255)))
    ours = lab.segment_by_color(rgb, lab.HSV_RANGES["red"])
    found = [100 * (mask[box] > 0).mean() for mask in (sheet, ours)]
    assert_page_says("E17", f"{found[0]:.0f} %")
    assert found[1] > 98  # rounding at the outline depends on the driver
    centroid = lab.find_object_centroid(sheet)
    assert centroid is not None
    x, y = centroid
    assert model.body(labels[y, x]).name == "red_ball"
    centroid = lab.find_object_centroid(ours)
    assert centroid is not None
    x, y = centroid
    assert model.body(labels[y, x]).name == "red_box"


def test_e18_a_centroid_cut_off_to_whole_pixels_misses_the_center(
    frame: Frame, rgb: np.ndarray
) -> None:
    model, data, depth, K = frame
    camera, origin = data.camera(CAMERA), data.body("orange_cylinder").xpos
    mask = lab.segment_by_color(rgb, lab.HSV_RANGES["orange"])
    exact = np.argwhere(mask).mean(axis=0)[::-1]
    cut = lab.find_object_centroid(mask)
    assert cut == tuple(np.floor(exact))

    def get_error_mm(pixel: np.ndarray) -> float:
        u, v = pixel.astype(int)
        point = lab.pixels_to_points([pixel], depth[v, u][None], K)
        found = lab.camera_to_world(point, camera.xpos, camera.xmat)[0]
        ray = (found - camera.xpos) / np.linalg.norm(found - camera.xpos)
        thickness = mujoco.mj_ray(model, data, origin, -ray, None, 1, -1, None)
        return float(1000 * np.linalg.norm(found + thickness * ray - origin))

    errors = [get_error_mm(pixel) for pixel in (np.floor(exact), np.round(exact))]
    assert_page_says("E18", *(f"{error:.1f} mm" for error in errors))


def test_e19_the_cloud_is_in_the_camera_frame(frame: Frame) -> None:
    model, data, depth, K = frame
    points, _ = lab.depth_to_pointcloud(depth, K)
    truth = lab.raycast_points(model, data, CAMERA, WIDTH, HEIGHT)[lab.find_valid_depth(depth)]
    off = np.median(np.linalg.norm(points - truth, axis=1))
    camera = data.camera(CAMERA)
    moved = lab.camera_to_world(points, camera.xpos, camera.xmat)
    rest_mm = 1000 * np.median(np.linalg.norm(moved - truth, axis=1))
    assert_page_says("E19", f"{off:.1f} m", f"{rest_mm:.1f} mm")


def test_e20_a_ply_file_needs_no_open3d(tmp_path: Path) -> None:
    code = (
        "import sys; sys.modules['open3d'] = None\n"
        "from labutils.__main__ import main\n"
        "sys.exit(main(['--out', sys.argv[1], '--width', '64', '--height', '48']))"
    )
    hidden = {"DISPLAY", "WAYLAND_DISPLAY"}
    environment = {k: v for k, v in os.environ.items() if k not in hidden}
    command = [sys.executable, "-c", code, str(tmp_path)]
    subprocess.run(command, check=True, capture_output=True, env=environment)
    assert (tmp_path / "scene_pointcloud.ply").read_bytes().startswith(b"ply\n")
    assert_page_says("E20", "`scene_pointcloud.ply` written")


def test_e21_the_lab_makes_five_files(tmp_path: Path) -> None:
    names = [path.name for path in lab.save_outputs(tmp_path, width=64, height=48)]
    assert "pointcloud.xyz" in names
    assert_page_says("E21", f"{len(names)} files")
