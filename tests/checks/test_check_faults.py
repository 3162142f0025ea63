"""What is no fault of the learner: a broken checker, damaged tables, no MuJoCo."""

import json
import subprocess
import sys
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

from labutils.checks import check, judge
from labutils.checks.table import TABLES, TableError, load_table, read_words


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def right_depth(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    return near * far / (far - np.clip(depth_raw, 0, 1) * (far - near))


def test_fault_of_the_checker_is_not_blamed_on_the_learner(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def break_down(*_: object, **__: object) -> NoReturn:
        raise RuntimeError("a bug of ours")

    monkeypatch.setattr("labutils.checks.judging.find_failure", break_down)
    verdict = check("process_depth", right_depth)
    assert (verdict.result, verdict.passed, verdict.property) == ("not checked", False, None)
    assert "The checker itself failed: RuntimeError: a bug of ours" in verdict.message
    assert "no mistake of yours" in verdict.message
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("target", ["read_words", "load_table"])
def test_damaged_installation_is_not_blamed_on_the_learner(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> NoReturn:
        raise TableError("the check tables cannot be read (gone)")

    monkeypatch.setattr(f"labutils.checks.keeping.{target}", fail)
    verdict = check("process_depth", right_depth)
    assert verdict.result == "not checked"
    assert "cannot be read" in verdict.message


def test_missing_or_damaged_tables_are_reported(tmp_path: Path) -> None:
    with pytest.raises(TableError, match="check tables cannot be read"):
        read_words(tmp_path)
    (tmp_path / "exercises.json").write_bytes((TABLES / "exercises.json").read_bytes())
    with pytest.raises(TableError, match="table of process_depth cannot be read"):
        load_table("process_depth", tmp_path)


def test_tables_hold_no_objects_and_no_code() -> None:
    for path in TABLES.glob("*.npz"):
        with np.load(path, allow_pickle=False) as stored:
            assert all(stored[key].dtype.kind in "biufU" for key in stored.files)
    text = (TABLES / "exercises.json").read_text(encoding="utf-8")
    assert "lambda" not in text
    assert json.loads(text).keys() == read_words().keys()


def test_frozen_arrays_cannot_be_overwritten() -> None:
    due = load_table("process_depth").expected[0]
    assert isinstance(due, tuple)
    (depth,) = due
    assert depth is not None
    with pytest.raises(ValueError, match="read-only"):
        depth[0, 0] = 1


def test_checks_need_neither_mujoco_nor_matplotlib() -> None:
    code = (
        "import sys; sys.modules['mujoco'] = None; import labutils.checks as c;"
        "print([m for m in ('matplotlib', 'open3d', 'ipywidgets') if m in sys.modules]);"
        "print(c.check('camera_to_world', lambda p, t, R: p * 1.0).property);"
        "v = c.check('render_camera', lambda m, d, r, n: None); print(v.result); print(v)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    assert lines[:3] == ["[]", "value", "not checked"]
    assert "needs MuJoCo, which this Python does not have" in done.stdout
    assert "Open the page as a notebook" in done.stdout


def test_without_mujoco_every_other_exercise_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    monkeypatch.delitem(sys.modules, "labutils.checks.scenes", raising=False)
    seen = set()
    for name in read_words():
        table = load_table(name)
        verdict = judge(table, lambda *_: 0.5)
        due = "not checked" if table.needs_mujoco else "failed"
        assert verdict.result == due, name
        seen.add(due)
    assert seen == {"not checked", "failed"}
