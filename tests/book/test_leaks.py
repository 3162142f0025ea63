"""Nothing that learners get holds a solution, a hidden case, or a note for instructors."""

import ast
import inspect
import io
import os
import re
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest

from labutils.checks.table import Part
from solutions import load_exercises
from solutions._model import Exercise
from solutions._open_answers import load_marked_tasks
from tests.helpers.leaks import (
    ROOT,
    Secret,
    collect_answer_secrets,
    collect_secrets,
    find_leaks,
    get_lines,
    read_document,
    read_documents,
)
from tools.derive.completions import make_starter
from tools.editions.student import make_files, pack

HTML = ROOT / "_build" / "html"
NOTES = sorted((ROOT / "solutions" / "notes").glob("*.md"))


# A challenge as somebody might write it: its answer is in no library.
def count_bright_regions(depth_raw: np.ndarray, near: float, far: float) -> int:
    """Count what is bright."""
    threshold = np.percentile(depth_raw, 87.5) + near / (far + 3)
    labels = _spread_labels(
        depth_raw > threshold,  # no fingerprint may depend on a comment
        rounds=int(far * 41 + 7),
    )
    return np.unique(labels[labels > 0]).size


def _spread_labels(bright: np.ndarray, rounds: int) -> np.ndarray:
    labels = np.where(bright, np.arange(bright.size).reshape(bright.shape) + 1, 0)
    for _ in range(rounds):
        labels = np.where(bright, np.maximum(labels, np.roll(labels, 1, axis=0)), 0)
    return labels


@pytest.fixture(scope="module")
def challenge() -> Exercise:
    card = load_exercises()["process_depth"]
    return replace(
        card,
        name="count_bright_regions",
        example="show(count_bright_regions(depth, 0.02, 12.0))",
        reference=count_bright_regions,
        answer_with=count_bright_regions,
        parts=(Part("count", "number", "int"),),
        tolerance_reason="a count of bright regions is right or wrong, there is nothing in between",
    )


@pytest.fixture(scope="module")
def secrets() -> list[Secret]:
    cards = collect_secrets(load_exercises().values(), NOTES)
    return cards + collect_answer_secrets(load_marked_tasks().values())


@pytest.fixture(scope="module")
def challenge_secrets(challenge: Exercise) -> list[Secret]:
    return collect_secrets([challenge], NOTES)


@pytest.fixture(scope="module")
def student_zip() -> bytes:
    return pack(make_files())


SOLUTION = """def mine(depth_raw, near, far):
    threshold = np.percentile(depth_raw, 87.5) + near / (far + 3)
    labels = _spread(depth_raw > threshold)
"""


def test_every_card_leaves_fingerprints(secrets: list[Secret]) -> None:
    seen = {secret.origin.split(":")[0] for secret in secrets}
    assert set(load_exercises()) | {path.name for path in NOTES} <= seen
    for exercise in load_exercises().values():
        lines = [
            line for one in secrets if one.origin.startswith(exercise.name) for line in one.lines
        ]
        assert lines, f"{exercise.name}: expected one line of 24 characters that is its own"


def test_fingerprints_are_lines_of_code_without_comments_and_breaks() -> None:
    lines = get_lines(count_bright_regions)
    assert lines[0] == "threshold=np.percentile(depth_raw,87.5)+near/(far+3)"
    assert lines[1] == "labels=_spread_labels(depth_raw>threshold,rounds=int(far*41+7),)"
    assert "Countwhatisbright" not in "".join(lines)


def make_page(code: str) -> bytes:
    """Write code the way Sphinx does, every token in a tag of its own."""
    spans = "".join(f"<span class='n'>{c}</span>".replace(">>", ">&gt;") for c in code)
    return f"<html><pre>{spans}</pre></html>".encode()


def make_notebook(code: str) -> bytes:
    cells = [nbformat.v4.new_code_cell(code)]
    return nbformat.writes(nbformat.v4.new_notebook(cells=cells)).encode()


def make_archive(name: str, content: str | bytes) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr(name, content)
    return buffer.getvalue()


def make_arrays(name: str) -> bytes:
    buffer = io.BytesIO()
    arrays: dict[str, Any] = {name: np.zeros(3)}
    np.savez(buffer, **arrays)
    return buffer.getvalue()


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("book/page.html", make_page(SOLUTION)),
        ("_sources/page.md", SOLUTION.replace("    ", "\t").encode()),
        ("_sources/page.ipynb", make_notebook(SOLUTION)),
        ("search_index.js", b'{"index":[["_spread_labels",{"3":{"0":1}}]]}'),
        ("_static/quiz.json", b'{"feedback": "see _spread_labels"}'),
        ("lab.zip", make_archive("a/b.py", SOLUTION)),
        ("lab.zip", make_archive("a/table.npz", make_arrays("_spread_labels"))),
        (
            "page.html",
            "<p>Right or wrong: A count of bright regions is right or wrong, there"
            " is nothing <em>in between</em></p>".replace("A count", "a count").encode(),
        ),
    ],
    ids=["page", "source", "notebook", "search", "quiz", "zip", "arrays", "reason"],
)
def test_a_planted_leak_is_found(
    tmp_path: Path, challenge_secrets: list[Secret], name: str, content: bytes
) -> None:
    path = tmp_path / name
    path.parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / "clean.html").write_text("<p>nothing here</p>")
    assert find_leaks(challenge_secrets, read_documents(tmp_path)) == []
    path.write_bytes(content)
    found = find_leaks(challenge_secrets, read_documents(tmp_path))
    assert found
    assert all(line.startswith(name) for line in found)


def test_planted_notes_and_hidden_cases_of_real_cards_are_found(
    tmp_path: Path, secrets: list[Secret]
) -> None:
    (tmp_path / "notes.html").write_bytes(make_page(NOTES[0].read_text(encoding="utf-8")))
    (tmp_path / "card.md").write_text((ROOT / "solutions/process_depth.py").read_text("utf-8"))
    found = find_leaks(secrets, read_documents(tmp_path))
    assert any(line.startswith(f"notes.html: {NOTES[0].name}") for line in found)
    assert any(line.startswith("card.md: process_depth: _hidden") for line in found)


@pytest.mark.parametrize("page", load_marked_tasks())
def test_a_planted_example_answer_is_found(tmp_path: Path, page: str) -> None:
    marked = load_marked_tasks()[page]
    secrets = collect_answer_secrets([marked])
    for answer in marked.answers:
        (tmp_path / "page.html").write_bytes(make_page(answer.fill(answer.text)))
        found = find_leaks(secrets, read_documents(tmp_path))
        assert f"page.html: {page}: {answer.kind} (a sentence for instructors)" in found
    (tmp_path / "page.html").write_bytes(
        make_page(Path(inspect.getfile(answer.measure)).read_text())
    )
    told = " ".join(find_leaks(secrets, read_documents(tmp_path)))
    assert "strong (" in told
    assert " lines)" in told


@pytest.mark.parametrize("card", [one for one in load_exercises().values() if one.completion])
def test_a_planted_line_of_a_completion_is_found(card: Exercise, secrets: list[Secret]) -> None:
    assert card.completion is not None
    marked = card.completion.write_with()
    for code in (marked, re.sub(r"  # open: .*", "", marked)):
        found = find_leaks(secrets, read_document("page.ipynb", make_notebook(code)))
        assert [line for line in found if f"{card.name}: completion" in line]
    starter = make_starter(card.completion)
    assert find_leaks(secrets, read_document("page.ipynb", make_notebook(starter))) == []


def test_a_common_line_alone_is_no_leak(challenge_secrets: list[Secret]) -> None:
    page = "<p>return np.unique(labels[labels > 0]).size</p>"
    documents = list(read_document("page.html", page.encode()))
    assert find_leaks(challenge_secrets, documents) == []


def test_the_questions_hold_no_leak(secrets: list[Secret]) -> None:
    assert find_leaks(secrets, read_documents(ROOT / "exercises")) == []


def test_the_student_zip_holds_no_leak(secrets: list[Secret], student_zip: bytes) -> None:
    assert find_leaks(secrets, read_document("student.zip", student_zip)) == []


def test_the_student_zip_holds_none_of_our_rooms(student_zip: bytes) -> None:
    with zipfile.ZipFile(io.BytesIO(student_zip)) as archive:
        names = [name.split("/", 1)[1] for name in archive.namelist()]
    assert not [
        name for name in names if name.startswith(("solutions", "tests", "tools", "grader"))
    ]
    assert {name.split("/")[0] for name in names} <= {
        "LICENSE",
        "LICENSE-TEXT",
        "README.md",
        "apt.txt",
        "assets",
        "book",
        "exercises",
        "labutils",
        "pyproject.toml",
        "requirements.txt",
    }


def test_solutions_cannot_be_imported_from_the_student_zip(
    tmp_path: Path, student_zip: bytes
) -> None:
    with zipfile.ZipFile(io.BytesIO(student_zip)) as archive:
        archive.extractall(tmp_path)
    (folder,) = tmp_path.iterdir()
    tried = subprocess.run(
        [sys.executable, "-c", "import labutils; print(labutils.__file__); import solutions"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(folder)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert str(folder) in tried.stdout
    assert "No module named 'solutions'" in tried.stderr


def test_the_library_never_imports_the_solutions() -> None:
    paths = list((ROOT / "labutils").rglob("*.py"))
    assert len(paths) > 20
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [alias.name for alias in getattr(node, "names", [])]
            names.append(getattr(node, "module", None) or "")
            assert not any(name.split(".")[0] == "solutions" for name in names), path


def test_the_built_book_holds_no_leak(secrets: list[Secret]) -> None:
    if not (HTML / "index.html").is_file():
        done = subprocess.run(
            [sys.executable, "-m", "tools.build.book"],
            cwd=ROOT,
            env={**os.environ, "EDITION": "student"},
            check=False,
        )
        assert done.returncode == 0
    documents = list(read_documents(HTML))
    kinds = {name.rsplit(".", 1)[-1] for name, _ in documents}
    assert {"html", "ipynb", "js", "inv"} <= kinds
    assert "_static/search_index.js" in {name for name, _ in documents}
    assert find_leaks(secrets, documents) == []
    assert not list(HTML.rglob("*solutions*"))
