"""The five files of the lab hold what went in, with and without OpenGL."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from collections.abc import Callable

import cv2
import numpy as np
import pytest

from labutils.raycast import RaycastRenderer

# The same files and numbers are due where no OpenGL works.
pytestmark = pytest.mark.filterwarnings("ignore::labutils.NoOpenGLWarning")

FIVE_FILES = [
    "rgb_view.png",
    "depth_view.png",
    "detection_result.png",
    "scene_pointcloud.ply",
    "pointcloud.xyz",
]
WIDTH, HEIGHT = 64, 48
SIZE = ["--width", str(WIDTH), "--height", str(HEIGHT)]


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(51)


@pytest.fixture
def rgb(rng: np.random.Generator) -> np.ndarray:
    """Noise, so that no channel and no axis equals another; odd sizes."""
    return rng.integers(0, 256, (9, 13, 3), dtype=np.uint8)


@pytest.fixture
def cloud(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    return rng.normal(size=(17, 3)).astype(np.float32), rng.random((17, 3)).astype(np.float32)


def read_rgb(path: Path) -> np.ndarray:
    bgr = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert bgr is not None
    return cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB)


def read_vertices(path: Path) -> np.ndarray:
    header, _, body = path.read_bytes().partition(b"end_header\n")
    names = [line.split()[2].decode() for line in header.splitlines() if b"property" in line]
    kinds = ["u1" if name in {"red", "green", "blue"} else "<f4" for name in names]
    return np.frombuffer(body, dtype=list(zip(names, kinds, strict=True)))


def run_lab(folder: Path, *arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "labutils", "--out", str(folder), *arguments]
    return subprocess.run(
        command, env=os.environ | variables, capture_output=True, text=True, check=False
    )


# --- one function per file ---


def test_rgb_view_shows_the_same_colors(tmp_path: Path, rgb: np.ndarray) -> None:
    path = lab.save_rgb_view(tmp_path, rgb)
    assert path == tmp_path / "rgb_view.png"
    np.testing.assert_array_equal(read_rgb(path), rgb)


def test_depth_view_is_the_colored_depth(tmp_path: Path, rng: np.random.Generator) -> None:
    depth = rng.uniform(0.5, 6.0, (9, 13)).astype(np.float32)
    depth[0, 0] = np.nan
    path = lab.save_depth_view(tmp_path, depth, max_depth=4.0)
    assert path == tmp_path / "depth_view.png"
    picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert picture is not None
    np.testing.assert_array_equal(picture, lab.visualize_depth(depth, max_depth=4.0))
    assert not picture[0, 0].any()


def test_depth_view_is_blue_close_and_red_far(tmp_path: Path) -> None:
    depth = np.full((2, 2), 0.6)
    depth[:, 1] = 4.5
    near, far = read_rgb(lab.save_depth_view(tmp_path, depth))[0].astype(int)
    assert near[2] > near[0]
    assert far[0] > far[2]


def test_detection_result_is_the_drawn_detection(tmp_path: Path, rgb: np.ndarray) -> None:
    mask = np.zeros(rgb.shape[:2], np.uint8)
    mask[2:6, 3:9] = 255
    path = lab.save_detection_result(tmp_path, rgb, (5, 4), mask)
    assert path == tmp_path / "detection_result.png"
    np.testing.assert_array_equal(read_rgb(path), lab.visualize_detection(rgb, (5, 4), mask))


def test_detection_result_without_a_detection_is_the_picture(
    tmp_path: Path, rgb: np.ndarray
) -> None:
    np.testing.assert_array_equal(read_rgb(lab.save_detection_result(tmp_path, rgb, None)), rgb)


def test_scene_pointcloud_keeps_points_and_colors(
    tmp_path: Path, cloud: tuple[np.ndarray, np.ndarray]
) -> None:
    points, colors = cloud
    path = lab.save_scene_pointcloud(tmp_path, points, colors)
    assert path == tmp_path / "scene_pointcloud.ply"
    vertices = read_vertices(path)
    np.testing.assert_array_equal(np.stack([vertices[n] for n in "xyz"], axis=1), points)
    stored = np.stack([vertices[n] for n in ("red", "green", "blue")], axis=1)
    np.testing.assert_array_equal(stored, np.round(colors * 255))


@pytest.mark.parametrize(
    ("frame", "told"),
    [
        ("world", "frame: world (z up)"),
        ("gripper camera", "frame: gripper camera"),
        (None, "frame: unknown"),
    ],
)
def test_scene_pointcloud_says_the_frame_it_was_told(
    tmp_path: Path, frame: str | None, told: str
) -> None:
    path = lab.save_scene_pointcloud(tmp_path, np.zeros((2, 3)), frame=frame)
    assert lab.read_ply_comments(path) == (told, "unit: meter")


def test_pointcloud_xyz_is_what_savetxt_writes(
    tmp_path: Path, cloud: tuple[np.ndarray, np.ndarray]
) -> None:
    points, _ = cloud
    path = lab.save_pointcloud_xyz(tmp_path, points)
    assert path == tmp_path / "pointcloud.xyz"
    np.savetxt(tmp_path / "theirs", points, fmt="%.4f")
    assert path.read_bytes() == (tmp_path / "theirs").read_bytes()
    # four decimals: half of the last one is 0.05 mm
    np.testing.assert_allclose(np.loadtxt(path), points, rtol=0, atol=0.5001e-4)


def test_an_empty_cloud_makes_readable_files(tmp_path: Path) -> None:
    nothing = np.empty((0, 3), np.float32)
    assert len(read_vertices(lab.save_scene_pointcloud(tmp_path, nothing, nothing))) == 0
    assert lab.save_pointcloud_xyz(tmp_path, nothing).read_bytes() == b""


@pytest.mark.parametrize(
    ("save", "message"),
    [
        (lambda at: lab.save_rgb_view(at, np.zeros((4, 4, 3))), "rgb_image: expected a uint8"),
        (lambda at: lab.save_rgb_view(at, np.zeros((4, 4), np.uint8)), "rgb_image: expected a col"),
        (lambda at: lab.save_depth_view(at, np.zeros((4, 4, 1))), "depth_metric: expected a depth"),
        (lambda at: lab.save_depth_view(at, np.ones((4, 4)), 0.0), "max_depth: expected meters"),
        (
            lambda at: lab.save_detection_result(
                at, np.zeros((4, 4, 3), np.uint8), None, np.zeros((5, 4), np.uint8)
            ),
            "mask: expected the picture's size",
        ),
        (lambda at: lab.save_scene_pointcloud(at, np.zeros((4, 2))), r"points: expected shape \(N"),
        (
            lambda at: lab.save_scene_pointcloud(at, np.zeros((4, 3)), np.full((4, 3), 255)),
            "colors: expected 0 to 1",
        ),
        (
            lambda at: lab.save_scene_pointcloud(at, np.full((2, 3), np.nan)),
            r"points\[0\]: expected finite numbers, got \[nan, nan, nan\]",
        ),
        (
            lambda at: lab.save_scene_pointcloud(at, np.zeros((1, 3)), frame="two\nlines"),
            "frame: expected 'camera', 'world' or one line",
        ),
        (lambda at: lab.save_pointcloud_xyz(at, np.zeros(3)), r"points: expected shape \(N"),
        (
            lambda at: lab.save_pointcloud_xyz(at, [[0.0, 0.0, 0.0], [1.0, np.inf, 2.0]]),
            r"points\[1\]: expected finite numbers, got \[1.0, inf, 2.0\]",
        ),
    ],
)
def test_bad_input_leaves_no_file_behind(
    tmp_path: Path, save: Callable[[Path], Path], message: str
) -> None:
    with pytest.raises((TypeError, ValueError), match=message):
        save(tmp_path)
    assert list(tmp_path.iterdir()) == []


# --- all at once ---


def test_save_outputs_writes_the_five_files_in_order(tmp_path: Path) -> None:
    paths = lab.save_outputs(tmp_path / "new" / "folder", width=WIDTH, height=HEIGHT)
    assert [path.name for path in paths] == FIVE_FILES
    assert sorted(p.name for p in (tmp_path / "new" / "folder").iterdir()) == sorted(FIVE_FILES)


def test_save_outputs_saves_what_the_camera_sees(tmp_path: Path) -> None:
    rgb_path, depth_path, _, ply_path, xyz_path = lab.save_outputs(tmp_path, width=64, height=48)
    model, data = lab.make_scene()
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        rgb, depth = lab.render_camera(model, data, renderer, "head_camera")
    K, _ = lab.get_camera_intrinsics(model, "head_camera", WIDTH, HEIGHT)
    points, _ = lab.depth_to_pointcloud(depth, K)
    np.testing.assert_array_equal(read_rgb(rgb_path), rgb)
    np.testing.assert_array_equal(cv2.imread(str(depth_path)), lab.visualize_depth(depth))
    vertices = read_vertices(ply_path)
    np.testing.assert_array_equal(np.stack([vertices[n] for n in "xyz"], axis=1), points)
    told = ("frame: OpenCV camera (x right, y down, z forward)", "unit: meter")
    assert lab.read_ply_comments(ply_path) == told
    np.testing.assert_allclose(np.loadtxt(xyz_path), points, rtol=0, atol=0.5001e-4)


def test_save_outputs_names_the_cameras_there_are(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"camera_name: expected one of .*head_camera.*'nose'"):
        lab.save_outputs(tmp_path, "nose", width=WIDTH, height=HEIGHT)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.filterwarnings("default")  # Open3D's own imports warn
def test_open3d_reads_the_point_cloud_back(
    tmp_path: Path, cloud: tuple[np.ndarray, np.ndarray]
) -> None:
    o3d = pytest.importorskip("open3d")

    points, colors = cloud
    read = o3d.io.read_point_cloud(str(lab.save_scene_pointcloud(tmp_path, points, colors)))
    np.testing.assert_allclose(np.asarray(read.points), points, rtol=0, atol=1e-7)
    # a color is stored as one of 256 levels
    np.testing.assert_allclose(np.asarray(read.colors), colors, rtol=0, atol=0.5001 / 255)


# --- from a shell ---


def test_the_command_writes_the_files_and_says_where(tmp_path: Path) -> None:
    run = run_lab(tmp_path / "out", *SIZE)
    assert run.returncode == 0, run.stderr
    assert [Path(line.split("  ")[0]).name for line in run.stdout.splitlines()] == FIVE_FILES
    assert all((tmp_path / "out" / name).stat().st_size for name in FIVE_FILES)


def test_the_command_reports_a_wrong_camera_in_one_line(tmp_path: Path) -> None:
    run = run_lab(tmp_path, "--camera", "nose", *SIZE)
    assert run.returncode == 1
    complaints = [line for line in run.stderr.splitlines() if line.startswith("labutils: ")]
    assert len(complaints) == 1
    assert "nose" in complaints[0]
    assert "Traceback" not in run.stderr
    assert list(tmp_path.iterdir()) == []


def test_without_opengl_all_files_come_with_one_notice_and_exact_depth(tmp_path: Path) -> None:
    run = run_lab(tmp_path, *SIZE, MUJOCO_GL="disable")
    assert run.returncode == 0, run.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(FIVE_FILES)
    # The progress bar returns to the start of its line; only what ends up in a line counts.
    lines = [line.rpartition("\r")[2].strip() for line in run.stderr.split("\n")]
    notices = [line for line in lines if "OpenGL cannot draw here" in line]
    assert len(notices) == 1, run.stderr
    assert notices[0].startswith("Note: ")
    assert "Warning" not in run.stderr
    rest = [line for line in lines if line and line not in notices and "step" not in line]
    assert rest == []

    # The points are the ray caster's own, and those are the truth.
    model, data = lab.make_scene()
    renderer = RaycastRenderer(model, HEIGHT, WIDTH)
    _, depth = lab.render_camera(model, data, renderer, "head_camera")
    truth = lab.raycast_depth(model, data, "head_camera", WIDTH, HEIGHT)
    np.testing.assert_array_equal(
        read_vertices(tmp_path / "scene_pointcloud.ply")["z"], truth[lab.find_valid_depth(depth)]
    )
