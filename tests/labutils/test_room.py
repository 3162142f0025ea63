"""The textured rooms: exact depth, rectified eyes, the same bytes again; and the walk's truth."""

from __future__ import annotations

import json
from pathlib import Path

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import (
    get_camera_intrinsics,
    get_camera_pose,
    is_gl_available,
    make_renderer,
    pixels_to_points,
    render_camera,
)
from labutils.recordings import CLIPS, Recording
from labutils.room import Walk, make_room, measure_imu, record_once, set_baseline, set_pose
from labutils.room.designs import DESIGNS
from labutils.room.recorder import VIEWS, Recorder, hash_textures, render_labels
from labutils.room.textures import make_grain, make_noise, make_poster, make_wallpaper
from labutils.room.walk import DURATION, ImuRecord, put

GRAVITY = np.array([0, 0, -9.81])
needs_opengl = pytest.mark.skipif(
    not is_gl_available(), reason="needs OpenGL: the ray caster draws no textures"
)
Room = tuple[mujoco.MjModel, mujoco.MjData]


@pytest.fixture(scope="module", params=DESIGNS)
def room(request: pytest.FixtureRequest) -> Room:
    return make_room(request.param)


@pytest.fixture(scope="module")
def walked() -> tuple[Room, ImuRecord]:
    one = make_room()
    return one, measure_imu(*one, Walk(), progress=False)


@needs_opengl
def test_rendered_depth_is_that_of_the_rays(room: Room) -> None:
    model, data = room
    set_pose(model, data, **VIEWS["table"])
    with make_renderer(model, 480, 640) as renderer:
        _, depth = render_camera(model, data, renderer, "left_eye")
    K, _ = get_camera_intrinsics(model, "left_eye", 640, 480)
    T_world_cam = get_camera_pose(model, data, "left_eye")
    pixels = np.random.default_rng(1).integers((0, 0), (640, 480), (400, 2))
    rays = pixels_to_points(pixels, np.ones(len(pixels)), K)
    directions = rays @ T_world_cam[:3, :3].T
    errors = []
    for (u, v), direction, length in zip(
        pixels, directions, np.linalg.norm(rays, axis=1), strict=True
    ):
        hit = mujoco.mj_ray(
            model, data, T_world_cam[:3, 3], direction / length, None, 1, -1, np.zeros(1, np.int32)
        )
        errors.append(abs(depth[v, u] - hit / length))
    # Where an edge passes between two pixels, ray and pixel see different things.
    assert np.median(errors) < 1e-5
    assert np.quantile(errors, 0.97) < 1e-3


def test_the_eyes_are_rectified_at_every_baseline(room: Room) -> None:
    model, data = room
    set_pose(model, data, **VIEWS["corner"])
    left = get_camera_pose(model, data, "left_eye")
    try:
        for baseline in (0.02, 0.1, 0.3):
            set_baseline(model, baseline)
            mujoco.mj_forward(model, data)
            right = get_camera_pose(model, data, "right_eye")
            assert_allclose(right[:3, :3], left[:3, :3], atol=1e-12)
            between = left[:3, :3].T @ (right - left)[:3, 3]
            assert_allclose(between, [baseline, 0, 0], atol=1e-12)
            assert_array_equal(get_camera_pose(model, data, "left_eye"), left)
    finally:
        set_baseline(model, 0.1)
    for name in ("left_eye", "right_eye"):
        assert np.rad2deg(get_camera_intrinsics(model, name, 640, 480)[1]) == pytest.approx(58)


def test_a_room_has_the_same_bytes_every_time() -> None:
    first, second = (make_room("held_out")[0] for _ in range(2))
    assert_array_equal(first.tex_data, second.tex_data)
    assert_array_equal(first.geom_pos, second.geom_pos)


def test_the_textures_are_those_that_the_clip_was_rendered_with() -> None:
    index = json.loads((CLIPS / "room" / "clip.json").read_text(encoding="utf-8"))
    assert hash_textures(make_room()[0]) == index["textures_sha256"]


def test_the_held_out_room_shares_no_texture_no_thing_and_no_light() -> None:
    (one, _), (other, _) = make_room("room"), make_room("held_out")
    assert hash_textures(one) != hash_textures(other)
    assert not {thing.name for thing in DESIGNS["room"].things} & {
        thing.name for thing in DESIGNS["held_out"].things
    }
    assert not (one.light_diffuse[:3] == other.light_diffuse[:3]).all(axis=1).any()
    assert not (one.light_dir[:3] == other.light_dir[:3]).all(axis=1).any()


def test_the_robot_is_the_one_of_the_book(scene: Room, room: Room) -> None:
    book = {scene[0].geom(one).name for one in range(scene[0].ngeom)}
    here = {room[0].geom(one).name for one in range(room[0].ngeom)}
    assert {"head", "chest", "left_thumb", "eye_left"} <= book & here
    assert "wall_left" not in here
    assert room[0].camera("head_camera").pos == pytest.approx(scene[0].camera("head_camera").pos)


def test_an_unknown_room_and_an_unknown_joint_are_named(room: Room) -> None:
    with pytest.raises(ValueError, match="name: expected one of room, held_out, got 'hall'"):
        make_room("hall")
    with pytest.raises(ValueError, match=r"pose: expected joints of base_x.*got 'neck_roll'"):
        set_pose(*room, neck_roll=0.1)


def test_wallpaper_repeats_and_noise_has_no_seam() -> None:
    paper = make_wallpaper(np.random.default_rng(1), size=256, repeats=8)
    assert_array_equal(paper, np.roll(paper, 256 // 8, axis=1))
    assert not np.array_equal(paper, np.roll(paper, 256 // 16, axis=1))
    noise = make_noise(np.random.default_rng(1), 128, 5, 5)
    inside = np.abs(np.diff(noise, axis=1)).mean()
    assert np.abs(noise[:, 0] - noise[:, -1]).mean() < 2 * inside


def test_textures_are_pictures_of_their_size() -> None:
    poster = make_poster(np.random.default_rng(1), size=160, shapes=20)
    grain = make_grain(np.random.default_rng(1), 64, (200.0, 100.0, 50.0), 10)
    for picture, size in ((poster, 160), (grain, 64)):
        assert picture.shape == (size, size, 3)
        assert picture.dtype == np.uint8
        assert picture.std() > 5
    assert_allclose(grain.mean(axis=(0, 1)), [200, 100, 50], atol=1)


def test_the_spline_knows_its_own_derivatives() -> None:
    walk, step = Walk(), 1e-4
    for time in np.random.default_rng(2).uniform(0.1, DURATION - 0.1, 20):
        before, here, after = (walk(time + shift) for shift in (-step, 0, step))
        assert_allclose((after[0] - before[0]) / (2 * step), here[1], atol=2e-6)
        assert_allclose((after[1] - before[1]) / (2 * step), here[2], atol=2e-5)


def test_the_walk_is_smooth_starts_at_rest_and_keeps_clear_of_the_table() -> None:
    walk = Walk()
    for part in walk(0.0)[1:]:
        assert_allclose(part, 0, atol=1e-12)
    places = np.array([walk(time)[0][:2] for time in np.arange(0, DURATION, 0.1)])
    table = DESIGNS["room"].table
    outside = np.abs(places) - np.array(table[:2])
    assert outside.max(axis=1).min() > 0.3
    jumps = [np.abs(walk(t + 1e-7)[2] - walk(t - 1e-7)[2]).max() for t in np.arange(1, 25) * 1.0]
    assert max(jumps) < 1e-4
    with pytest.raises(ValueError, match="time: expected 0 to 26"):
        walk(DURATION + 1)


def test_accelerometer_agrees_with_second_differences(walked: tuple[Room, ImuRecord]) -> None:
    _, imu = walked
    step = imu.time[1]
    change = (imu.position[2:] - 2 * imu.position[1:-1] + imu.position[:-2]) / step**2
    felt = np.einsum("nji,nj->ni", imu.rotation[1:-1], change - GRAVITY)
    # A second difference is off by a twelfth of the squared step times the fourth derivative.
    assert np.abs(felt - imu.accel[1:-1]).max() < 2e-3
    assert np.sqrt(((felt - imu.accel[1:-1]) ** 2).mean()) < 3e-4


def test_gyro_agrees_with_the_turns_between_readings(walked: tuple[Room, ImuRecord]) -> None:
    _, imu = walked
    turn = np.einsum("nji,njk->nik", imu.rotation[:-1], imu.rotation[1:])
    # Small turns: the axis, times the sine of the angle, is the antisymmetric part.
    axis = np.stack([turn[:, 2, 1], turn[:, 0, 2], turn[:, 1, 0]], axis=1)
    axis -= np.stack([turn[:, 1, 2], turn[:, 2, 0], turn[:, 0, 1]], axis=1)
    between = (imu.gyro[1:] + imu.gyro[:-1]) / 2
    assert np.abs(axis / 2 / imu.time[1] - between).max() < 1e-4


def test_the_sensor_feels_gravity_and_not_a_fall(walked: tuple[Room, ImuRecord]) -> None:
    (model, data), imu = walked
    assert_allclose(imu.rotation[0] @ imu.accel[0], -GRAVITY, atol=1e-9)
    assert np.linalg.norm(imu.accel, axis=1).mean() == pytest.approx(9.81, abs=0.1)
    put(model, data, Walk(), 5.0)
    assert data.time == 5.0
    assert_allclose(data.sensor("accelerometer").data, imu.accel[1000], atol=1e-12)


@needs_opengl
def test_two_recordings_are_the_same_bytes(tmp_path: Path) -> None:
    found = []
    for name in ("first", "second"):
        recorder = Recorder(*make_room(), tmp_path / name, progress=False)
        recorder.record_pairs({"pole": VIEWS["pole"]}, (0.05, 0.1))
        recorder.record_walk(frames_per_second=0.1)
        recorder.finish()
        files = sorted(path for path in (tmp_path / name).rglob("*") if path.is_file())
        found.append([(path.name, path.read_bytes()) for path in files])
    assert found[0] == found[1]
    pairs = Recording(tmp_path / "first").baseline_pairs
    assert [pair.baseline for pair in pairs] == [0.05, 0.1]


@needs_opengl
def test_the_clip_is_what_this_room_looks_like() -> None:
    """Other drivers round otherwise: a gray level here and there, and where an edge falls."""
    model, data = make_room()
    clip = Recording(CLIPS / "room", noise=0)
    pair = clip.pairs[0]
    set_pose(model, data, **VIEWS[pair.view])
    with make_renderer(model, 480, 640) as renderer:
        rgb, depth = render_camera(model, data, renderer, "left_eye")
        labels = render_labels(model, data, renderer)
    assert pair.color is not None
    assert (np.abs(rgb.astype(int) - pair.color) <= 2).mean() > 0.98
    assert (np.abs(depth - pair.depth) < 0.001).mean() > 0.99
    assert (labels == pair.labels).mean() > 0.99
    assert_allclose(pair.T_world_cam, get_camera_pose(model, data, "left_eye"), atol=1e-9)


@needs_opengl
def test_a_walk_is_recorded_once_and_anew_where_it_was_interrupted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def ask(seed: int = 0) -> Recording:
        return record_once(frames_per_second=0.1, width=64, seed=seed, cache=tmp_path)

    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(Recorder, "record_walk", stop)
        with pytest.raises(KeyboardInterrupt):
            ask()
    first = ask()
    assert "keyframes" in capsys.readouterr().err  # the progress bar
    assert [frame.gray.shape for frame in first.keyframes] == [(48, 64)] * 3
    assert first.imu.time.shape == (5200,)
    with monkeypatch.context() as patch:
        patch.setattr(Recorder, "record_walk", stop)
        again, noisier = ask(), ask(seed=1)
    assert_array_equal(again.keyframes[1].gray, first.keyframes[1].gray)
    assert not np.array_equal(noisier.keyframes[1].gray, first.keyframes[1].gray)
    assert_array_equal(again.keyframes[1].depth, first.keyframes[1].depth)
    assert not list(tmp_path.glob("*.part"))
