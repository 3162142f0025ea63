"""The benches: all of them always run, and none calls a slow machine a failure."""

import re
from pathlib import Path
from types import ModuleType

import pytest

from tools import headless
from tools.bench import __main__ as every
from tools.bench import checks, explorers, page_following, page_python, stereo
from tools.vendor import npm

ROOT = Path(__file__).resolve().parents[2]


def test_make_bench_runs_every_bench() -> None:
    folder = ROOT / "tools" / "bench"
    routes = {"routes", "world_routes", "drake_route"}
    helpers = {"__init__", "__main__", "serving", "workers", *routes}
    assert set(every.BENCHES) == {path.stem for path in folder.glob("*.py")} - helpers
    assert "-m tools.bench\n" in (ROOT / "Makefile").read_text()


def test_a_bench_that_cannot_run_stops_no_other_and_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    package = tmp_path / "tools" / "bench"
    package.mkdir(parents=True)
    for name, code in (("good", "print('measured')"), ("bad", "raise SystemExit('no browser')")):
        (package / f"{name}.py").write_text(code)
    monkeypatch.setattr(every, "ROOT", tmp_path)
    assert every.main(["bad", "good", "bad"]) == 1
    said = capfd.readouterr()
    assert re.findall(r"--- (\w+) ---", said.out) == ["bad", "good", "bad"]
    assert "measured" in said.out
    assert "bench: could not run: bad, bad" in said.err
    assert every.main(["good"]) == 0


def test_checks_are_told_as_ratios_and_a_slow_one_is_no_failure(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Slow:
        def __call__(self, *_: object) -> dict[str, float]:
            return {
                checks.REFERENCE: 2.0,
                checks.PEER: 1.0,
                "right": 10_000.0,
                checks.UNKNOWN: 30.0,
                checks.EXPLAINING: 20.0,
            }

    monkeypatch.setattr(checks, "measure", Slow())
    assert checks.main(["--rounds", "1"]) == 0
    said = capsys.readouterr().out
    assert "right 5000.0 / 10000.0 (10000 ms)" in said
    assert "explained 3.0 x unexplained" in said


def test_a_check_is_compared_with_peers_that_do_something() -> None:
    case = checks.make_large_cases()["find_object_centroid"]
    times = checks.measure("find_object_centroid", case, 1)
    wrong = ["first mistake", "last pair", checks.UNKNOWN, checks.EXPLAINING]
    assert list(times) == [checks.REFERENCE, checks.PEER, "right", *wrong]
    assert min(times.values()) > 0


def test_frames_are_told_as_ratios_and_slow_ones_are_no_failure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "index.html").write_text("")
    (tmp_path / "page.html").write_text("")
    found = [{"name": "hsv", "times": [400.0, 500.0, 600.0], "parameters": {}}]
    monkeypatch.setattr(headless, "STUDENT_PAGES", tmp_path)
    monkeypatch.setattr(headless, "find_browser", lambda *_: "chromium")
    monkeypatch.setattr(headless, "run_script", lambda *_: found)
    monkeypatch.setattr(npm, "install", lambda: "up to date")
    monkeypatch.setattr(explorers, "find_pages", lambda: ["page"])
    monkeypatch.setattr(explorers, "read_views", lambda _: [None])
    monkeypatch.setattr(explorers, "measure_python", lambda *_: 10.0)
    assert explorers.main([]) == 0
    (row,) = [line for line in capsys.readouterr().out.splitlines() if line.startswith("hsv")]
    assert row.split() == ["hsv", "3", "500.0", "ms", "600.0", "ms", "10.0", "ms", "50.00"]


@pytest.mark.parametrize("bench", [explorers, page_following, page_python])
def test_what_could_not_be_measured_is_no_success(
    bench: ModuleType,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(headless, "STUDENT_PAGES", tmp_path)
    monkeypatch.setattr(page_python, "HTML", tmp_path)  # where `has_wheels` looks
    assert bench.main([]) == 1
    assert "not measured" in capsys.readouterr().out


def test_python_in_the_page_is_told_as_a_ratio(capsys: pytest.CaptureFixture[str]) -> None:
    page_python.print_line("every later check", [9000.0], "the native check", [3.0])
    assert "3000.0 x the native check (9000 ms to 3 ms" in capsys.readouterr().out


def test_matching_is_told_in_times_of_block_matching(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    times = {name: [10.0 if name.startswith("ssd") else 0.5] for name in stereo.ROUTES}
    monkeypatch.setattr(stereo, "measure", lambda *_: times)
    assert stereo.main([]) == 0  # 20 times is slower than the goal, and no failure
    said = capsys.readouterr().out
    assert re.search(r"^ssd_disparity, 9x9 +20\.0 +10000\.0 ms$", said, re.MULTILINE)
    assert next(iter(stereo.ROUTES)) == "cv2.StereoBM, 15x15"


def test_the_live_loop_is_told_as_a_ratio_to_the_bare_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = {"shown": [900.0, 1000.0, 1100.0], "bare": [400.0, 500.0, 600.0]}
    monkeypatch.setattr(headless, "find_browser", lambda *_: "chromium")
    monkeypatch.setattr(headless, "run_script", lambda *_: found)
    monkeypatch.setattr(npm, "install", lambda: "up to date")
    monkeypatch.setattr(page_following, "has_wheels", lambda: True)
    assert page_following.main([]) == 0
    assert "2.0 x the bare loop (1000 ms to 500 ms" in capsys.readouterr().out
