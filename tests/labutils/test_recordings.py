"""The clip of the repository: complete, small, true; and how a recording is read."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import pixels_to_points
from labutils.recordings import (
    CLIPS,
    DEPTH_SCALE,
    Recording,
    add_noise,
    decode_depth,
    encode_depth,
    load_recording,
)
from labutils.stereo import depth_to_disparity

SIZE_LIMIT = 10e6  # bytes
VIEWS = ["table", "pole", "side"]
BASELINES = [0.02, 0.05, 0.10, 0.20, 0.30]


@pytest.fixture(scope="module")
def recording() -> Recording:
    return load_recording("room")


def test_the_clip_is_small_and_lossless() -> None:
    files = [path for path in CLIPS.rglob("*") if path.is_file()]
    assert 1e6 < sum(path.stat().st_size for path in files) < SIZE_LIMIT
    assert {path.suffix for path in files} == {".png", ".json", ".npz", ".txt"}


def test_the_clip_states_its_license() -> None:
    assert "CC BY 4.0" in (CLIPS / "README.txt").read_text(encoding="utf-8")
    assert "assets/clip/" in (CLIPS.parents[1] / "LICENSE-TEXT").read_text(encoding="utf-8")
    assert "CC BY 4.0" in (CLIPS / "room" / "clip.json").read_text(encoding="utf-8")


def test_a_pair_has_two_gray_pictures_and_the_truth(recording: Recording) -> None:
    assert [pair.view for pair in recording.pairs] == VIEWS
    for pair in recording.pairs:
        assert pair.baseline == 0.10
        for picture, kind in (
            (pair.left, "uint8"),
            (pair.right, "uint8"),
            (pair.labels, "uint8"),
            (pair.depth, "float32"),
            (pair.depth_right, "float32"),
        ):
            assert picture.shape == (480, 640)
            assert picture.dtype == np.dtype(kind)
        assert np.isfinite(pair.depth).all()
        assert_array_equal(pair.K, recording.K(640))
    color = recording.pairs[0].color
    assert color is not None
    assert color.shape == (480, 640, 3)


def test_one_view_has_five_baselines_and_one_left_picture(recording: Recording) -> None:
    pairs = recording.baseline_pairs
    assert [pair.baseline for pair in pairs] == BASELINES
    for pair in pairs:
        assert_array_equal(pair.left, pairs[0].left)
        assert_array_equal(pair.depth, pairs[0].depth)
    assert not np.array_equal(pairs[0].right, pairs[1].right)


def test_everything_planted_is_seen(recording: Recording) -> None:
    names = recording.label_names
    seen = {one for pair in recording.pairs for one in np.unique(pair.labels)}
    assert names["nothing"] == 0
    assert {names[one] for one in ("plain_panel", "wallpaper", "pole", "table")} <= seen
    assert names["nothing"] not in seen


@pytest.mark.parametrize("view", range(3))
def test_rows_are_aligned_and_the_disparity_is_fb_over_z(view: int) -> None:
    """Fetch the right picture's pixels for the left ones: what both see looks the same."""
    pair = load_recording("room", noise=0).pairs[view]
    disparity = depth_to_disparity(pair.depth, pair.K, pair.baseline).astype(np.float32)
    columns, rows = np.meshgrid(np.arange(640, dtype=np.float32), np.arange(480, dtype=np.float32))

    def fetch(picture: np.ndarray, down: float = 0.0, further: float = 0.0) -> np.ndarray:
        return cv2.remap(
            picture.astype(np.float32),
            columns - disparity - further,
            rows + down,
            cv2.INTER_LINEAR,
            borderValue=-1e3,
        )

    seen = np.abs(fetch(pair.depth_right) - pair.depth) < 0.002
    assert seen.mean() > 0.8

    def differ(**shift: float) -> float:
        return float(np.abs(fetch(pair.right, **shift) - pair.left)[seen].mean())

    here = differ()
    assert here < 3
    for down, further in ((1, 0), (-1, 0), (0, 1), (0, -1), (0.5, 0), (0, 0.5)):
        assert differ(down=down, further=further) > 1.3 * here


def test_pictures_of_two_places_agree_about_the_room(recording: Recording) -> None:
    """A point of the pole's view lands on the same surface in the first view."""
    first, second = recording.pairs[:2]
    pixels = np.stack(np.meshgrid(np.arange(8, 640, 16), np.arange(8, 480, 16)), axis=-1)
    pixels = pixels.reshape(-1, 2)
    depth = second.depth[pixels[:, 1], pixels[:, 0]]
    points = pixels_to_points(pixels, depth, second.K)
    pose = np.linalg.inv(first.T_world_cam) @ second.T_world_cam
    points = points @ pose[:3, :3].T + pose[:3, 3]
    flat = (points @ first.K.T)[points[:, 2] > 0.1]
    places = np.round(flat[:, :2] / flat[:, 2:]).astype(int)
    inside = ((places >= 0) & (places < (640, 480))).all(axis=1)
    expected = points[points[:, 2] > 0.1][inside, 2]
    found = first.depth[places[inside, 1], places[inside, 0]]
    assert inside.sum() > 200
    assert (np.abs(found - expected) < 0.05).mean() > 0.7  # the others are hidden there
    assert np.median(np.abs(found - expected)) < 0.01


def test_keyframes_show_the_walk(recording: Recording) -> None:
    frames = recording.keyframes
    assert len(frames) == 65
    assert_allclose(np.diff([frame.time for frame in frames]), 0.4, atol=1e-12)
    places = np.array([frame.T_world_cam[:3, 3] for frame in frames])
    assert 5 < np.linalg.norm(np.diff(places, axis=0), axis=1).sum() < 9
    for frame in frames:
        assert frame.gray.shape == (240, 320)
        assert frame.gray.dtype == np.uint8
        assert np.isfinite(frame.depth).all()
        assert_array_equal(frame.K, recording.K(320))


def test_the_inertial_sensor_rests_first_and_sees_gravity(recording: Recording) -> None:
    imu = recording.imu
    assert imu.time.shape == (5200,)
    assert_allclose(np.diff(imu.time), 0.005, atol=1e-12)
    assert_allclose(imu.T_world_imu[:3, :3] @ imu.accel[0], [0, 0, 9.81], atol=1e-5)
    assert_allclose(imu.gyro[0], 0, atol=1e-9)
    assert np.abs(imu.gyro).max() > 0.3


def test_noise_is_that_of_its_seed_and_of_its_size() -> None:
    clean = load_recording("room", noise=0).pairs[0]
    one, again, other = (load_recording("room", seed=seed).pairs[0] for seed in (1, 1, 2))
    assert_array_equal(one.left, again.left)
    assert_array_equal(one.depth, other.depth)
    difference = one.left.astype(float) - clean.left
    assert difference.std() == pytest.approx(2, abs=0.05)
    assert abs(difference.mean()) < 0.02
    for second in (other.left.astype(float) - clean.left, one.right.astype(float) - clean.right):
        assert abs(np.corrcoef(difference.ravel(), second.ravel())[0, 1]) < 0.01


def test_gray_and_color_of_a_picture_have_the_same_noise(recording: Recording) -> None:
    pair = recording.pairs[0]
    assert pair.color is not None
    gray = cv2.cvtColor(pair.color, cv2.COLOR_RGB2GRAY).astype(float)
    assert np.median(np.abs(gray - pair.left)) <= 1


def test_noise_stays_in_a_byte() -> None:
    for value in (0, 255):
        noisy = add_noise(np.full((50, 50), value, np.uint8), 20.0, 3)
        assert abs(float(noisy.astype(float).mean()) - value) < 20


def test_stored_depth_comes_back_to_a_thousandth_of_a_pixel() -> None:
    depth = np.linspace(0.31, 6, 5000)
    disparity = 0.1 * 433 / depth
    back = 0.1 * 433 / decode_depth(encode_depth(depth)).astype(np.float64)
    assert np.abs(back - disparity).max() < 0.0012
    assert DEPTH_SCALE / 0.3 == 65535


def test_depth_without_a_surface_is_nan_and_too_near_is_refused() -> None:
    assert_array_equal(encode_depth(np.array([np.inf, np.nan])), [0, 0])
    assert np.isnan(decode_depth(np.zeros(2, np.uint16))).all()
    with pytest.raises(ValueError, match=r"depth: expected 0.3 m or more, got 0.200 m"):
        encode_depth(np.array([1.0, 0.2]))


def test_what_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="expected one of room, got 'rom'"):
        load_recording("rom")
    with pytest.raises(FileNotFoundError, match="expected one of room, got"):
        load_recording(tmp_path)
    with pytest.raises(ValueError, match="noise: expected gray levels >= 0, got -1"):
        load_recording("room", noise=-1)
