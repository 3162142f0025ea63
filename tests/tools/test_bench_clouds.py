"""The bench of clouds: its routes agree before a clock runs, and what is missing says so."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import numpy as np
import pytest

from labutils import depth_to_pointcloud
from tools.bench import clouds, workers
from tools.bench.clouds import CLOUD, RENDER, TURN, WORLD, WORLD_ROUTES
from tools.bench.serving import make_pose
from tools.bench.workers import Entry, measure_group, sort_by_pixel
from tools.environments import NoEnvironmentError, list_environments

ROOT = Path(__file__).resolve().parents[2]
GROUPS = (CLOUD, WORLD, TURN, RENDER)


@pytest.fixture(autouse=True)
def look_for_environments_anew() -> None:
    """Forget which Pythons the test before has found."""
    workers.find_python.cache_clear()


@pytest.fixture
def frame(tmp_path: Path) -> Path:
    """A small frame with a window of sky."""
    rng = np.random.default_rng(0)
    depth = rng.uniform(0.5, 3, (24, 32)).astype(np.float32)
    depth[3:9, 5:20] = 12
    path = tmp_path / "frame.npz"
    np.savez(
        path,
        depth=depth,
        rgb=rng.integers(0, 256, (24, 32, 3), np.uint8),
        K=np.array([[30.0, 0, 15], [0, 28.0, 12], [0, 0, 1]]),
        xpos=[1.0, 2.0, 3.0],
        xmat=np.array([0.0, -1, 0, 0, 0, 1, -1, 0, 0]),
        points=rng.uniform(-2, 2, (500, 3)).astype(np.float32),
    )
    return path


def test_routes_to_the_world_agree_and_take_turns(frame: Path) -> None:
    world = {name: WORLD[name] for name in ("cloud_labutils", "cloud_numpy")}
    for group in (world, {name: TURN[name] for name in ("turn_opencv", "turn_labutils")}):
        seconds = measure_group(group, frame, {}, rounds=2, burst=3)
        assert list(seconds) == list(group)
        # The first run of each burst only wakes the process.
        assert [len(times) for times in seconds.values()] == [4, 4]
        assert min(map(min, seconds.values())) > 0


def test_a_route_with_another_result_stops_the_bench(frame: Path) -> None:
    # The cloud in the camera frame, offered as one in the world.
    group = {"cloud_labutils": WORLD["cloud_labutils"], "labutils": CLOUD["labutils"]}
    with pytest.raises(SystemExit, match="bench: 'labutils' does not give the result"):
        measure_group(group, frame, {}, rounds=1, burst=2)


def test_a_route_that_does_less_need_not_agree(frame: Path) -> None:
    group = {"labutils": CLOUD["labutils"], "opencv": CLOUD["opencv"]}
    assert list(measure_group(group, frame, {}, rounds=1, burst=2)) == ["labutils", "opencv"]


def test_a_route_that_fails_is_named(frame: Path) -> None:
    with pytest.raises(SystemExit, match="bench: the route 'nothing' stopped"):
        measure_group({"nothing": Entry("", WORLD_ROUTES)}, frame, {}, rounds=1, burst=2)


def test_colors_may_be_bytes_and_points_in_any_order(frame: Path) -> None:
    with np.load(frame) as file:
        depth, rgb, K = file["depth"], file["rgb"], file["K"]
    points, colors = depth_to_pointcloud(depth, K, rgb)
    assert colors is not None
    mixed = np.random.default_rng(1).permutation(len(points))
    again = sort_by_pixel([points[mixed].astype(np.float64), colors[mixed]], K)
    assert all(map(workers.is_same, [points, colors], again))
    assert not workers.is_same(points, points[mixed])
    assert not workers.is_same(points, points[:-1])
    assert workers.is_same(colors, (colors * 255).round().astype(np.uint8))


def test_a_pose_takes_what_lies_ahead_along_mujocos_negative_z() -> None:
    pose = make_pose({"xmat": np.eye(3).ravel(), "xpos": np.array([10.0, 20, 30])})
    assert (pose @ [0, 0, 2, 1]).tolist() == [10, 20, 28]


def test_an_environment_that_cannot_be_made_is_told_once_and_its_routes_are_left_out(
    frame: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(name: str) -> Path:
        raise NoEnvironmentError(f"uv pip failed: no network for {name}")

    monkeypatch.setattr(workers, "make_environment", fail)
    group = {name: WORLD[name] for name in ("cloud_labutils", "drake")}
    columns = {
        setting: measure_group(group, frame, {}, rounds=1, burst=2) for setting in ("one", "two")
    }
    said = capsys.readouterr().err
    assert said == "bench: drake is not measured: uv pip failed: no network for drake\n"
    table = clouds.make_table("Clouds", group, columns)
    assert table.splitlines()[3].endswith("| 1.00 (1.00) | 1.00 (1.00) |")
    assert table.splitlines()[4].endswith("| not measured | not measured |")


def test_tables_hold_ratios_of_medians_and_of_the_fastest() -> None:
    group = {"first": Entry("ours"), "second": Entry("theirs")}
    columns = {"as installed": {"first": [2.0, 1.0, 3.0], "second": [7.0, 3.0, 4.0]}}
    assert clouds.make_table("Clouds", group, columns).splitlines() == [
        ":::{table} Clouds",
        "| route | as installed |",
        "|---|---:|",
        "| ours | 1.00 (1.00) |",
        "| theirs | 2.00 (3.0) |",
        ":::",
    ]


def test_every_route_stands_in_the_book_measured() -> None:
    page = (ROOT / "book" / "_generated" / "bench.md").read_text(encoding="utf-8")
    for group in GROUPS:
        assert next(iter(group.values())).comparable
        for entry in group.values():
            assert f"| {entry.label} |" in page, "run `make bench`"
            assert not entry.environment or entry.environment in list_environments()
    assert "not measured" not in page


def test_drakes_route_needs_nothing_that_its_environment_lacks() -> None:
    there = {"numpy", "pydrake", "tools"}
    for name in ("drake_route", "serving"):
        path = ROOT / "tools" / "bench" / f"{name}.py"
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom):
                root, _, rest = str(node.module).partition(".")
                assert root in there | sys.stdlib_module_names, node.module
                assert root != "tools" or rest == "bench.serving"
            elif isinstance(node, ast.Import):
                assert {one.name for one in node.names} <= there | sys.stdlib_module_names
