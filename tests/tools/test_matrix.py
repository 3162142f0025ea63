"""What the book says about versions is what `make matrix` found in the environments there are."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NoReturn

import pytest

from tools import ROOT
from tools.environments import ROOM, NoEnvironmentError, matrix, read_python
from tools.environments.matrix import MatrixError, Outcome

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"].values()
#: Lower bound by package.
BOUNDS = dict(
    one.split(">=") for one in [*PROJECT["dependencies"], *(one for few in EXTRAS for one in few)]
)

GREEN = Outcome(7, Counter(), ())
MIXED = Outcome(5, Counter({"no Open3D": 2, "no network": 1}), ("tests.a::test_b",))


def read_lock(row: str) -> dict[str, str]:
    text = (ROOM / f"{matrix.PREFIX}{row}.txt").read_text(encoding="utf-8")
    found = dict(re.findall(r"^([\w-]+)==([\w.]+)", text, re.MULTILINE))
    if version := found.get("open3d-cpu"):
        found["open3d"] = version  # the same, without what a graphics card needs
    return found


@pytest.fixture
def table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A table to write, with something in it already."""
    path = tmp_path / "matrix.md"
    path.write_text("old", encoding="utf-8")
    monkeypatch.setattr(matrix, "TABLE", path)
    return path


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every environment is there."""
    monkeypatch.setattr(matrix, "make_environment", lambda name: Path(name, "python"))


def test_the_book_shows_every_environment_in_its_versions_and_green() -> None:
    shown = matrix.read_table(matrix.TABLE.read_text(encoding="utf-8"))
    columns = len(matrix.describe_row("oldest"))
    assert {row: cells[:columns] for row, cells in shown.items()} == {
        row: matrix.describe_row(row) for row in matrix.list_rows()
    }, "run `make matrix`"
    for passed, _, failed in (cells[columns:] for cells in shown.values()):
        assert int(passed) > 1000
        assert failed == "0"


def test_the_oldest_environment_holds_the_lower_bounds_of_the_package() -> None:
    held = read_lock("oldest")
    assert set(BOUNDS) >= {"numpy", "mujoco", "opencv-python-headless", "matplotlib", "tqdm"}
    for package, bound in BOUNDS.items():
        assert f"{held[package]}.".startswith(f"{bound}."), package


@pytest.mark.parametrize("row", matrix.list_rows())
def test_an_environment_holds_all_that_the_package_asks_for(row: str) -> None:
    asked = {one.split(">=")[0] for one in PROJECT["dependencies"]}
    assert asked <= set(read_lock(row))


def test_the_environments_have_every_python_that_the_package_names() -> None:
    named = [one.rpartition(" ")[2] for one in PROJECT["classifiers"] if "Python :: 3" in one]
    assert {read_python(f"{matrix.PREFIX}{row}") for row in matrix.list_rows()} == set(named)
    assert PROJECT["requires-python"] == f">={named[0]}"


def test_a_report_of_pytest_is_counted(tmp_path: Path) -> None:
    lines = [
        "import pytest",
        "def test_good(): pass",
        "def test_other(): pass",
        "def test_bad(): assert False",
        "@pytest.fixture",
        "def broken(): raise OSError",
        "def test_broken(broken): pass",
        "@pytest.mark.parametrize('n', [1, 2])",
        "def test_left_out(n): pytest.skip('no | network')",
    ]
    (tmp_path / "test_some.py").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "pytest.ini").write_text("[pytest]\n", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:dash"]
    done = subprocess.run(
        [*command, "--junitxml=report.xml"],
        cwd=tmp_path,
        check=False,
        capture_output=True,
        timeout=60,
    )
    assert done.returncode == 1
    found = matrix.read_outcome(tmp_path / "report.xml")
    assert found.passed == 2
    assert found.skipped == {"no | network": 2}
    assert found.failed == ("test_some::test_bad", "test_some::test_broken")


def test_the_table_says_what_was_skipped_and_what_failed_and_no_date() -> None:
    text = matrix.make_table({"oldest": MIXED, "numpy1": GREEN, "python3.12": MIXED})
    assert text.startswith(f"{matrix.MADE_BY}\n\n| environment | Python | NumPy |")
    notes = [
        "- `oldest`, `python3.12`, failed: `tests.a::test_b`",
        "- `oldest`, `python3.12`, 2 skipped: no Open3D",
        "- `oldest`, `python3.12`, 1 skipped: no network",
    ]
    assert "\n\n{}\n\n".format("\n".join(notes)) in text
    shown = matrix.read_table(text)
    assert shown["oldest"] == (*matrix.describe_row("oldest"), "5", "3", "1")
    assert shown["numpy1"] == (*matrix.describe_row("numpy1"), "7", "0", "0")
    assert re.search(r"built and tested with NumPy 2\.\d.*, MuJoCo 4\.\d", text)
    assert not re.search(r"20\d\d-|\d\d:\d\d", text)


def test_a_lock_for_two_pythons_names_both_versions(tmp_path: Path) -> None:
    lock = tmp_path / "lock.txt"
    lines = ["numpy==2.4.6 ; python_full_version < '3.12' \\", "    --hash=sha256:00"]
    lines += ["numpy==2.5.5 ; python_full_version >= '3.12'", "mujoco-core==4.0.0"]
    lock.write_text("\n".join(lines), encoding="utf-8")
    assert matrix.read_versions(lock) == {
        "NumPy": "2.4.6 or 2.5.5",
        "OpenCV": "-",
        "MuJoCo": "-",
        "Open3D": "-",
    }


def test_an_environment_that_cannot_be_made_is_named_and_the_table_stays(
    table: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def make(name: str) -> Path:
        if "3.1" in name:
            raise NoEnvironmentError("uv venv failed: no interpreter found")
        return Path(name)

    monkeypatch.setattr(matrix, "make_environment", make)
    monkeypatch.setattr(matrix, "run_tests", lambda *_: pytest.fail("nothing can be written"))
    assert matrix.main([]) == 1
    words = capsys.readouterr().err
    for python in ("3.12", "3.13"):
        assert f"python{python} (Python {python}) cannot be made: uv venv failed" in words
    assert "matrix.md stays as it was" in words
    assert table.read_text(encoding="utf-8") == "old"


@pytest.mark.usefixtures("made")
def test_the_table_is_written_and_a_failure_told(
    table: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(matrix, "run_tests", lambda *_: GREEN)
    assert matrix.main([]) == 0
    assert list(matrix.read_table(table.read_text(encoding="utf-8"))) == matrix.list_rows()
    monkeypatch.setattr(matrix, "run_tests", lambda *_: MIXED)
    assert matrix.main([]) == 1
    assert "matrix: failed: oldest: tests.a::test_b" in capsys.readouterr().err
    assert matrix.read_table(table.read_text(encoding="utf-8"))["oldest"][-1] == "1"


@pytest.mark.usefixtures("made")
def test_rows_that_are_named_are_tested_alone_and_nothing_is_written(
    table: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(matrix, "run_tests", lambda *_: GREEN)
    assert matrix.main(["oldest"]) == 0
    assert capsys.readouterr().out == "matrix: oldest: 7 passed, 0 skipped, 0 failed\n"
    assert matrix.main(["newest"]) == 1
    assert re.search("expected some of oldest, .*, got newest", capsys.readouterr().err)
    assert table.read_text(encoding="utf-8") == "old"


def test_tests_that_do_not_end_as_tests_do_are_no_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*_: object, **__: object) -> Any:
        return SimpleNamespace(returncode=-11, stdout="", stderr="Segmentation fault")

    def linger(*_: object, **__: object) -> NoReturn:
        raise subprocess.TimeoutExpired("pytest", matrix.TIMEOUT_S)

    monkeypatch.setattr(matrix, "MADE", tmp_path)
    monkeypatch.setattr("tools.environments.matrix.subprocess.run", crash)
    with pytest.raises(MatrixError, match="oldest: pytest ended with code -11:\nSegmentation"):
        matrix.run_tests("oldest", Path("python"))
    monkeypatch.setattr("tools.environments.matrix.subprocess.run", linger)
    with pytest.raises(MatrixError, match="oldest: the tests took longer than 3600 s"):
        matrix.run_tests("oldest", Path("python"))


def test_make_matrix_runs_it() -> None:
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert "\nmatrix: setup ##" in text
    assert "-m tools.environments.matrix\n" in text
