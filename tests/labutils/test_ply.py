"""PLY files: what goes in comes out, in a reader that is not ours."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import write_ply
from labutils.cloud_view import find_open3d_problem


@pytest.mark.skipif(find_open3d_problem() is not None, reason=str(find_open3d_problem()))
@pytest.mark.parametrize("count", [1, 7, 5000])
@pytest.mark.parametrize("colored", [True, False])
def test_open3d_reads_back_what_was_written(tmp_path: Path, count: int, colored: bool) -> None:
    import open3d as o3d  # noqa: PLC0415 - heavy, and missing on some machines

    rng = np.random.default_rng(count)
    points = rng.normal(size=(count, 3)).astype(np.float32)
    colors = rng.integers(0, 256, (count, 3)) / 255 if colored else None
    path: Any = str(write_ply(tmp_path / "a.ply", points, colors))  # Open3D's stub: no str
    cloud = o3d.io.read_point_cloud(path)
    assert_array_equal(np.asarray(cloud.points), points)
    assert cloud.has_colors() is colored
    if colored:
        assert colors is not None
        assert_array_equal(np.round(np.asarray(cloud.colors) * 255), np.round(colors * 255))


def test_the_file_is_a_header_and_fifteen_bytes_a_point(tmp_path: Path) -> None:
    content = write_ply(tmp_path / "a.ply", np.zeros((4, 3)), np.ones((4, 3))).read_bytes()
    header, _, body = content.partition(b"end_header\n")
    assert header.startswith(b"ply\nformat binary_little_endian 1.0\nelement vertex 4\n")
    assert len(body) == 4 * 15


def test_an_empty_cloud_is_a_valid_file(tmp_path: Path) -> None:
    assert b"element vertex 0\n" in write_ply(tmp_path / "a.ply", np.empty((0, 3))).read_bytes()


@pytest.mark.parametrize(
    ("points", "colors", "words"),
    [
        (np.zeros((2, 2)), None, r"points: expected shape \(N, 3\)"),
        (np.zeros((2, 3)), np.zeros((1, 3)), r"colors: expected one per point \(2\)"),
        (np.zeros((2, 3)), np.full((2, 3), 2.0), "colors: expected 0 to 1"),
        (np.zeros((2, 3)), np.full((2, 3), np.nan), "colors: expected 0 to 1"),
    ],
)
def test_bad_input_writes_nothing(
    tmp_path: Path, points: np.ndarray, colors: np.ndarray | None, words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        write_ply(tmp_path / "a.ply", points, colors)
    assert list(tmp_path.iterdir()) == []
