"""Writing PLY: what goes in comes out in readers that are not ours, and nothing else is written."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import read_ply, read_ply_comments, visualize_pointcloud, write_ply
from labutils.cloud_view import find_open3d_problem
from tests.helpers.tolerances import FLOAT32_RTOL


@pytest.mark.skipif(find_open3d_problem() is not None, reason=str(find_open3d_problem()))
@pytest.mark.parametrize("count", [1, 7, 5000])
@pytest.mark.parametrize("colored", [True, False])
def test_open3d_reads_back_what_was_written(tmp_path: Path, count: int, colored: bool) -> None:
    import open3d as o3d  # noqa: PLC0415 - heavy, and missing on some machines

    rng = np.random.default_rng(count)
    points = rng.normal(size=(count, 3)).astype(np.float32)
    colors = rng.integers(0, 256, (count, 3)) / 255 if colored else None
    # Open3D's stub: no str
    path: Any = str(write_ply(tmp_path / "a.ply", points, colors, frame="camera"))
    cloud = o3d.io.read_point_cloud(path)
    assert_array_equal(np.asarray(cloud.points), points)
    assert cloud.has_colors() is colored
    if colored:
        assert colors is not None
        assert_array_equal(np.round(np.asarray(cloud.colors) * 255), np.round(colors * 255))


@pytest.mark.parametrize("colored", [True, False])
def test_our_reader_reads_back_what_was_written(tmp_path: Path, colored: bool) -> None:
    rng = np.random.default_rng(5)
    points = rng.normal(size=(70, 3)).astype(np.float32)
    colors = (rng.integers(0, 256, (70, 3)) / 255).astype(np.float32) if colored else None
    read_points, read_colors = read_ply(write_ply(tmp_path / "a.ply", points, colors))
    assert read_points.dtype == np.float32
    assert_array_equal(read_points, points)
    if colors is None:
        assert read_colors is None
    else:
        assert read_colors is not None
        assert read_colors.dtype == np.float32
        assert_allclose(read_colors, colors, rtol=FLOAT32_RTOL)


def test_the_file_is_a_header_and_fifteen_bytes_a_point(tmp_path: Path) -> None:
    content = write_ply(tmp_path / "a.ply", np.zeros((4, 3)), np.ones((4, 3))).read_bytes()
    header, _, body = content.partition(b"end_header\n")
    assert header.startswith(b"ply\nformat binary_little_endian 1.0\n")
    assert b"\nelement vertex 4\n" in header
    assert len(body) == 4 * 15


def test_colors_are_called_uint8_which_every_reader_takes_for_unsigned(tmp_path: Path) -> None:
    # meshio 5.3.5 reads `uchar` as int8 in binary files: 200 comes out as -56
    content = write_ply(tmp_path / "a.ply", np.zeros((1, 3)), np.ones((1, 3))).read_bytes()
    assert content.count(b"property uint8 ") == 3
    assert b"uchar" not in content


def test_an_empty_cloud_is_a_valid_file(tmp_path: Path) -> None:
    path = write_ply(tmp_path / "a.ply", np.empty((0, 3)), np.empty((0, 3)))
    assert b"element vertex 0\n" in path.read_bytes()
    points, colors = read_ply(path)
    assert points.shape == (0, 3)
    assert colors is not None
    assert colors.shape == (0, 3)


@pytest.mark.parametrize(
    ("frame", "told"),
    [
        ("camera", "OpenCV camera (x right, y down, z forward)"),
        ("world", "world (z up)"),
        ("base_link, ROS (x forward, y left, z up)", "base_link, ROS (x forward, y left, z up)"),
        ("element face 3", "element face 3"),
        (None, "unknown"),
    ],
)
def test_the_header_says_frame_and_unit(tmp_path: Path, frame: str | None, told: str) -> None:
    points = np.arange(6.0).reshape(2, 3)
    path = write_ply(tmp_path / "a.ply", points, frame=frame)
    assert read_ply_comments(path) == (f"frame: {told}", "unit: meter")
    assert_array_equal(read_ply(path)[0], points)  # and no comment is taken for anything else


@pytest.mark.parametrize(
    ("points", "colors", "words"),
    [
        (np.zeros((2, 2)), None, r"points: expected shape \(N, 3\)"),
        ([[0, 0, 0], [1, np.nan, 2]], None, r"points\[1\]: expected finite .*\[1.0, nan, 2.0\]"),
        ([[0, 0, -np.inf]], None, r"points\[0\]: expected finite numbers, got \[0.0, 0.0, -inf\]"),
        (
            [[0, 0, 0], [0, 0, 0], [0, -1e39, 0]],
            None,
            r"points\[2\]: expected at most 3.4e\+38, as float32 holds, got \[0.0, -1e\+39, 0.0\]",
        ),
        (np.zeros((2, 3)), np.zeros((1, 3)), r"colors: expected one per point \(2\)"),
        (np.zeros((2, 3)), np.full((2, 3), 2.0), "colors: expected 0 to 1"),
        (np.zeros((2, 3)), np.full((2, 3), np.nan), "colors: expected 0 to 1"),
    ],
)
def test_bad_input_writes_nothing(
    tmp_path: Path, points: Any, colors: np.ndarray | None, words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        write_ply(tmp_path / "a.ply", points, colors)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("write", [write_ply, lambda _, *cloud: visualize_pointcloud(*cloud)])
def test_colors_of_a_picture_are_not_taken_for_zero_to_one(
    tmp_path: Path, write: Callable[..., object], dtype: type
) -> None:
    """A dark picture holds nothing but 0 and 1: as colors these would be black and full."""
    dark: np.ndarray = np.array([[0, 1, 1], [1, 0, 0]], dtype)
    with pytest.raises(TypeError, match=f"colors: .* divide those .* by {np.iinfo(dtype).max}"):
        write(tmp_path / "a.ply", np.ones((2, 3)), dark)
    assert list(tmp_path.iterdir()) == []


def test_whole_numbers_zero_and_one_are_colors(tmp_path: Path) -> None:
    _, colors = read_ply(write_ply(tmp_path / "a.ply", np.zeros((1, 3)), np.array([[1, 0, 0]])))
    assert_array_equal(colors, [[1, 0, 0]])


@pytest.mark.parametrize(
    "frame", ["", "  ", "two\nlines", "two\rlines", "m\u00e9ters", "x end_header", "x" * 201]
)
def test_a_frame_that_would_break_a_header_is_refused(tmp_path: Path, frame: str) -> None:
    with pytest.raises(ValueError, match="frame: expected 'camera', 'world' or one line"):
        write_ply(tmp_path / "a.ply", np.zeros((1, 3)), frame=frame)
    assert list(tmp_path.iterdir()) == []


def test_a_frame_that_is_no_text_is_refused(tmp_path: Path) -> None:
    wrong: Any = np.eye(4)
    with pytest.raises(TypeError, match="frame: expected text, got ndarray"):
        write_ply(tmp_path / "a.ply", np.zeros((1, 3)), frame=wrong)


def test_a_write_that_fails_leaves_the_old_file_and_nothing_beside_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_ply(tmp_path / "a.ply", np.ones((3, 3)))
    before = path.read_bytes()

    def write_half(self: Path, content: bytes) -> int:
        with self.open("wb") as file:
            file.write(content[: len(content) // 2])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", write_half)
    with pytest.raises(OSError, match="No space left"):
        write_ply(path, np.zeros((3, 3)))
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_is_no_file_to_write(tmp_path: Path) -> None:
    (tmp_path / "a.ply").mkdir()
    with pytest.raises(OSError, match=r"a\.ply"):
        write_ply(tmp_path / "a.ply", np.zeros((3, 3)))
    assert [one.name for one in tmp_path.iterdir()] == ["a.ply"]


@pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")
def test_a_link_stays_a_link_to_the_file_that_was_written(tmp_path: Path) -> None:
    link = tmp_path / "latest.ply"
    link.symlink_to(tmp_path / "first.ply")
    assert write_ply(link, np.ones((2, 3))) == link
    assert link.is_symlink()
    assert len(read_ply(tmp_path / "first.ply")[0]) == 2


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such rights")
def test_the_file_has_the_rights_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "plain").write_bytes(b"")
    path = write_ply(tmp_path / "a.ply", np.ones((2, 3)))
    assert path.stat().st_mode == (tmp_path / "plain").stat().st_mode
