"""Sentences of the book about files, packages and windows that no cell of a page can show."""

from __future__ import annotations

import json
import os
import re
import struct
import subprocess
import sys
import zlib
from importlib.metadata import metadata
from pathlib import Path

import cv2
import numpy as np
import pytest

from labutils import save_pointcloud_xyz
from tools import ROOT

DRAW = """
import numpy as np, open3d as o3d
points = o3d.utility.Vector3dVector(np.random.default_rng(0).random((10, 3)))
print("drawing", flush=True)
o3d.visualization.draw_geometries([o3d.geometry.PointCloud(points)])
print("returned", flush=True)
"""


def make_png(red: int, green: int, blue: int) -> bytes:
    """Make the file of one pixel by the format's own rules, which say red first."""

    def pack(kind: bytes, data: bytes) -> bytes:
        check = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

    header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    pixel = zlib.compress(bytes([0, red, green, blue]))
    start = b"\x89PNG\r\n\x1a\n"
    return start + pack(b"IHDR", header) + pack(b"IDAT", pixel) + pack(b"IEND", b"")


def test_opencv_reads_and_writes_blue_first(tmp_path: Path) -> None:
    given = tmp_path / "given.png"
    given.write_bytes(make_png(red=200, green=100, blue=50))
    read = cv2.imread(str(given))
    assert read is not None
    assert read[0, 0].tolist() == [50, 100, 200]
    assert cv2.cvtColor(read, cv2.COLOR_BGR2RGB)[0, 0].tolist() == [200, 100, 50]
    written = tmp_path / "written.png"
    assert cv2.imwrite(str(written), np.array([[[50, 100, 200]]], np.uint8))
    again = cv2.imread(str(written))
    assert again is not None
    np.testing.assert_array_equal(again, read)


def test_opencv_writes_a_picture_of_fractions_without_an_error(tmp_path: Path) -> None:
    path = tmp_path / "dark.png"
    assert cv2.imwrite(str(path), np.linspace(0, 1, 48).reshape(4, 4, 3))
    written = cv2.imread(str(path))
    assert written is not None
    assert set(np.unique(written)) == {0, 1}


def test_the_text_of_a_cloud_is_read_by_numpy_and_open3d(tmp_path: Path) -> None:
    points = np.random.default_rng(0).random((50, 3))
    path = save_pointcloud_xyz(tmp_path, points)
    assert np.loadtxt(path).shape == (50, 3)
    o3d = pytest.importorskip("open3d", reason="Open3D is not installed: pip install open3d")
    assert len(o3d.io.read_point_cloud(str(path)).points) == 50


@pytest.mark.slow
def test_a_window_of_open3d_never_comes_back_without_a_screen() -> None:
    o3d = pytest.importorskip("open3d", reason="Open3D is not installed: pip install open3d")
    if not o3d.__version__.startswith("0.20"):
        pytest.skip(f"the sentence is about Open3D 0.20, and {o3d.__version__} is installed")
    hidden = {"DISPLAY", "WAYLAND_DISPLAY"}
    environment = {k: v for k, v in os.environ.items() if k not in hidden}
    command = [sys.executable, "-c", DRAW]
    # Where it returns, it does so within a second.
    with pytest.raises(subprocess.TimeoutExpired) as stopped:
        subprocess.run(command, env=environment, capture_output=True, check=False, timeout=20)
    said = (stopped.value.stdout or b"").decode()
    assert "drawing" in said
    assert "returned" not in said


def test_the_numpy_of_the_book_does_not_exist_for_python_3_10() -> None:
    oldest = re.search(r">=3\.(\d+)", metadata("numpy")["Requires-Python"])
    assert oldest is not None
    assert int(oldest[1]) > 10


def test_the_first_run_loads_as_many_megabytes_as_the_start_page_says() -> None:
    page = ROOT / "_build" / "html" / "book" / "step1_camera.html"
    if not page.is_file():
        pytest.skip("the book is not built; run `make book` first")
    said = re.search(r"into the page, (\d+) MB", (ROOT / "book" / "start.md").read_text("utf-8"))
    script = r'<script type="application/json" id="python-data">(.*?)</script>'
    found = re.search(script, page.read_text(encoding="utf-8"), re.DOTALL)
    assert said is not None
    assert found is not None
    data = json.loads(found[1])
    if data["remote"]:
        pytest.skip("NumPy and OpenCV are not beside these pages: they come from the network")
    size = sum(one["bytes"] for part in ("python", "simulator") for one in data["parts"][part])
    assert round(size / 1e6) == int(said[1])
