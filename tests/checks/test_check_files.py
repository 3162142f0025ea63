"""What is derived from the cards is current, and made the same way everywhere."""

import hashlib
import inspect
import io
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from content.chapters import get_chapter
from labutils.checks.table import Raised, load_table, read_completions
from solutions import load_exercises
from tools.derive import exercises

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    return exercises


@pytest.fixture(scope="module")
def files(tool: ModuleType) -> dict[Path, bytes]:
    return tool.make_files(load_exercises())


def test_derived_files_are_current(tool: ModuleType, files: dict[Path, bytes]) -> None:
    assert tool.find_stale(files, ROOT) == {}


def test_a_file_that_is_stale_missing_or_left_over_is_told(
    tool: ModuleType, files: dict[Path, bytes], tmp_path: Path
) -> None:
    for path, content in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_bytes(content)
    assert tool.find_stale(files, tmp_path) == {}
    (tmp_path / tool.RUBRIC).write_text("other")
    (tmp_path / tool.HINTS).unlink()
    (tmp_path / tool.TABLES / "old.npz").write_bytes(b"")
    assert tool.find_stale(files, tmp_path) == {
        tool.RUBRIC: "out of date",
        tool.HINTS: "missing",
        tool.TABLES / "old.npz": "left over",
    }


@pytest.mark.slow  # derives everything five times
def test_check_fails_where_a_file_is_stale_missing_or_left_over(
    tool: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert tool.main(["--root", str(tmp_path)]) == 0
    assert tool.main(["--root", str(tmp_path), "--check"]) == 0
    (tmp_path / tool.RUBRIC).write_text("other")
    (tmp_path / tool.HINTS).unlink()
    (tmp_path / tool.TABLES / "old.npz").write_bytes(b"")
    capsys.readouterr()
    assert tool.main(["--root", str(tmp_path), "--check"]) == 1
    told = capsys.readouterr().out
    for words in ("rubric.md is out of date", "hints.md is missing", "old.npz is left over"):
        assert words in told
    assert tool.main(["--root", str(tmp_path)]) == 0
    assert tool.main(["--root", str(tmp_path), "--check"]) == 0


def test_tables_are_the_same_bytes_in_another_process(files: dict[Path, bytes]) -> None:
    code = (
        "import hashlib; from tools.derive import exercises as m;"
        "from solutions import load_exercises as e; f = m.make_files(e());"
        "print(hashlib.sha256(b''.join(f[k] for k in sorted(f))).hexdigest())"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    joined = b"".join(files[path] for path in sorted(files))
    assert done.stdout.strip() == hashlib.sha256(joined).hexdigest()


def test_archives_hold_no_times_and_no_compression(files: dict[Path, bytes]) -> None:
    archives = [content for path, content in files.items() if path.suffix == ".npz"]
    assert len(archives) == len(load_exercises()) + len(read_completions())
    for content in archives:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            assert archive.infolist()
            for member in archive.infolist():
                assert member.date_time == (1980, 1, 1, 0, 0, 0)
                assert member.compress_type == zipfile.ZIP_STORED


def test_no_words_of_an_error_are_frozen_that_differ_between_versions_of_python() -> None:
    names = (*load_exercises(), *read_completions())
    wrong = [load_table(name).wrong for name in names]
    answers = [answer for one in wrong for outcomes in one.values() for answer in outcomes]
    raised = [answer for answer in answers if isinstance(answer, Raised)]
    assert "ValueError" in {one.kind for one in raised}
    assert {one.text for one in raised if one.kind != "TypeError"} == {""}


def test_tables_stay_small(files: dict[Path, bytes], tool: ModuleType) -> None:
    size = sum(len(content) for path, content in files.items() if path.parent == tool.TABLES)
    assert 0 < size < 160_000 * len(load_exercises())  # a page in the browser loads them all


def test_starters_hold_signature_and_docstring_and_nothing_of_the_body(
    files: dict[Path, bytes], tool: ModuleType
) -> None:
    for name, exercise in load_exercises().items():
        text = files[tool.STARTERS / f"{name}.py"].decode()
        assert f"def {name}(" in text
        head = re.search(r"def \w+\((.*?)\):", text, re.DOTALL)
        assert head is not None
        names = [word.partition("=")[0].strip() for word in head[1].split(",") if word.strip()]
        assert tuple(names) == exercise.parameters
        assert text.rstrip().endswith("raise NotImplementedError")
        source = inspect.getsource(exercise.reference)
        body = source.split('"""')[-1]
        for line in body.splitlines():
            if len(line.strip()) > 12:
                assert line.strip() not in text


def test_rubric_sums_to_100_or_is_refused(files: dict[Path, bytes], tool: ModuleType) -> None:
    assert "**100**" in files[tool.RUBRIC].decode()
    exercises = dict(load_exercises())
    del exercises["camera_to_world"]
    with pytest.raises(ValueError, match="expected 100 points, got 94"):
        tool.make_rubric(exercises)


def test_hints_name_every_mistake(files: dict[Path, bytes], tool: ModuleType) -> None:
    text = files[tool.HINTS].decode()
    for exercise in load_exercises().values():
        assert exercise.tolerance_reason in text
        assert all(f"| {one.name} | {one.text} |" in text for one in exercise.misconceptions)


def test_packed_arrays_come_back(tool: ModuleType) -> None:
    arrays = {"a0": np.arange(6.0).reshape(2, 3), "a1": np.array([[True]])}
    with np.load(io.BytesIO(tool.pack(arrays)), allow_pickle=False) as stored:
        for key, value in arrays.items():
            assert stored[key].shape == value.shape
            assert (stored[key] == value).all()


def test_pages_are_derived_and_what_does_not_fit_is_refused(
    files: dict[Path, bytes], tool: ModuleType
) -> None:
    exercises = load_exercises()
    step4 = get_chapter("step4")
    page = ROOT / f"{step4.exercises}.md"
    text = page.read_text(encoding="utf-8")
    assert files[page.relative_to(ROOT)] == text.encode()
    assert tool.fill_page(text.replace("12 points", "99 points"), exercises, step4) == text
    with pytest.raises(ValueError, match="expected headings"):
        tool.fill_page(text.replace("(exercise-nearest-object)=\n", ""), exercises, step4)
    with pytest.raises(ValueError, match="expected the marked parts"):
        tool.fill_page(text.replace("<!-- begin card -->", ""), exercises, step4)
    chapter = ROOT / f"{step4.page}.md"
    text = chapter.read_text(encoding="utf-8")
    assert tool.fill_chapter(text.replace("8 points", "9 points"), exercises, step4) == text
    without = {name: one for name, one in exercises.items() if one.chapter != "step4"}
    with pytest.raises(ValueError, match=r"step4: .* make new-exercise NAME=\.\.\. CHAPTER=step4"):
        tool.fill_chapter(text, without, step4)


def test_starters_fit_into_a_cell_without_scrolling(
    files: dict[Path, bytes], tool: ModuleType
) -> None:
    starters = {path: text for path, text in files.items() if path.parent == tool.STARTERS}
    assert len(starters) == len(load_exercises())
    for path, content in starters.items():
        code = content.decode().split('"""\n\n', 1)[1]
        lines = [line for line in code.splitlines() if not line.lstrip().startswith(">>>")]
        assert max(map(len, lines)) <= 76, f"{path}: expected lines of at most 76 characters"


def test_tables_may_differ_by_a_rounding_but_by_no_more(
    files: dict[Path, bytes], tool: ModuleType
) -> None:
    path = tool.TABLES / "depth_to_pointcloud.npz"
    with np.load(io.BytesIO(files[path])) as stored:
        arrays = {name: stored[name].copy() for name in stored.files}
    name = next(name for name, array in arrays.items() if array.dtype == np.float32 and array.size)
    rounded = arrays | {name: np.nextafter(arrays[name], np.float32(np.inf))}
    moved = arrays | {name: arrays[name] + np.float32(1e-4)}
    assert tool.is_current(tool.pack(rounded), files[path], ".npz")
    assert not tool.is_current(tool.pack(moved), files[path], ".npz")
    assert not tool.is_current(b"damaged", files[path], ".npz")
