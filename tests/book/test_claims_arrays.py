"""Sentences of the book about NumPy and OpenCV on arrays that no cell of a page can show."""

from __future__ import annotations

import subprocess
import sys

import cv2
import numpy as np
import pytest

from labutils import camera_to_world

COUNT_THREADS = """
import os, cv2, numpy as np
def count(): return len(os.listdir("/proc/self/task"))
cv2.setNumThreads(2)
points = np.ones((300_000, 1, 3), np.float32)
before = count()
cv2.transform(points, np.eye(3, 4))
print(count() - before)
cv2.GaussianBlur(np.zeros((2000, 2000), np.float32), (9, 9), 2)
print(count() - before)
"""


def test_a_byte_of_hue_runs_from_0_to_179() -> None:
    levels = np.arange(0, 256, 3, dtype=np.uint8)
    colors = np.stack(np.meshgrid(levels, levels, levels), axis=-1).reshape(1, -1, 3)
    hue = cv2.cvtColor(colors, cv2.COLOR_RGB2HSV)[..., 0]
    assert (hue.min(), hue.max()) == (0, 179)


def test_in_range_of_opencv_does_not_wrap() -> None:
    hues = np.arange(180, dtype=np.uint8)[None]
    assert cv2.inRange(hues, 170, 6).max() == 0
    assert np.count_nonzero(cv2.inRange(hues, 6, 170)) == 165


def test_numpy_adds_a_vector_to_points_three_numbers_at_a_time() -> None:
    # The loop that a sum runs in is that of its iterator.
    pair = [np.zeros((9, 3)), np.zeros(3)]
    steps = [points.size for points, _ in np.nditer(pair, flags=["external_loop"])]
    assert steps == [3] * 9


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="threads are counted in /proc")
def test_transform_of_opencv_starts_no_thread() -> None:
    # In a process of its own: threads of OpenCV stay once they are there.
    done = subprocess.run(
        [sys.executable, "-c", COUNT_THREADS], capture_output=True, text=True, check=True
    )
    by_transform, by_blur = map(int, done.stdout.split())
    assert by_transform == 0
    assert by_blur > 0  # which works with threads


def test_single_precision_is_off_by_thousandths_of_a_millimeter_at_10_m() -> None:
    rng = np.random.default_rng(0)
    points = rng.uniform(-1, 1, (5000, 3))
    points *= 10 / np.linalg.norm(points, axis=1, keepdims=True)
    rotation, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    rotation *= np.sign(np.linalg.det(rotation))
    exact = camera_to_world(points, [0.3, 0.1, 1.5], rotation)
    single = camera_to_world(points.astype(np.float32), [0.3, 0.1, 1.5], rotation)
    off_mm = 1000 * np.linalg.norm(single - exact, axis=1)
    assert single.dtype == np.float32
    assert 0.0005 < off_mm.max() < 0.005


def test_the_first_interface_of_open3d_holds_double_precision() -> None:
    o3d = pytest.importorskip("open3d", reason="Open3D is not installed: pip install open3d")
    cloud = o3d.geometry.PointCloud()
    cloud.points = o3d.utility.Vector3dVector(np.ones((4, 3), np.float32))
    assert np.asarray(cloud.points).dtype == np.float64
