"""A chapter is made from its scaffolds alone: first each command, then a whole one on a copy."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from content.chapters import get_chapter, list_taught, load_chapters
from content.toc import list_pages
from solutions import load_exercises
from tests.helpers.chapters import ROOT
from tools.scaffold import chapter as chapter_tool
from tools.scaffold import exercise as exercise_tool
from tools.scaffold.chapter import plan_chapter
from tools.scaffold.exercise import plan_exercise
from tools.scaffold.plan import Plan, ScaffoldError, fill_template
from tools.scaffold.unfilled import find_unfilled

#: What a scaffold may touch, with the files that are derived from it.
CONTENT = re.compile(
    r"_toc\.yml|content/chapters\.yml|book/\w+\.md|exercises/.*|solutions/.*"
    r"|tests/solutions/variants/\w+\.py|labutils/checks/tables/.*|book/_generated/.*"
)
TEXTS = Path(__file__).with_name("ext_test")
#: What to write into which file.
FILLED = {
    "page": "book/ext_test.md",
    "exercises": "exercises/ext_test.md",
    "questions": "exercises/concepts/ext_test.yml",
    "predictions": "exercises/predictions/ext_test.yml",
    "notes": "solutions/notes/ext-test.md",
    "card_lab": "solutions/points_to_pixels.py",
    "card_challenge": "solutions/scale_intrinsics.py",
    "variants_lab": "tests/solutions/variants/points_to_pixels.py",
    "variants_challenge": "tests/solutions/variants/scale_intrinsics.py",
}
#: A place to fill in code: a whole statement, a line with the one after it, a comment, or words.
PLACE_IN_CODE = re.compile(
    r'raise NotImplementedError\("FILL: [^"\n]*"\)'
    r"|(?P<indent> *)# FILL: the next line: [^\n]*\n(?P<line>[^\n]*)"
    r'|# FILL: [^\n]*|FILL: [^"\n]*'
)
PLACE_IN_WORDS = re.compile(r'FILL: [^"|\n]*[^"|\n\s]')


def copy_repository(folder: Path, *names: str) -> Path:
    """Copy what git knows of the repository, or some of it, and begin a history there."""
    command = ["git", "ls-files", "-co", "--exclude-standard", "--", *names]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    for name in listed.stdout.splitlines():
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, folder / name)
    return folder


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A copy of what the scaffolds read and change."""
    return copy_repository(tmp_path, "_toc.yml", "content", "book/*.md", "exercises")


# ---- A chapter


def test_a_chapter_gets_its_row_its_place_and_its_files(small: Path) -> None:
    before = len(load_chapters(small))
    last = list_pages(small).index(list_taught(small)[-1].exercises)
    prefix = str(len(list_taught(small)) + 1)
    written = plan_chapter("two-eyes", "How far is it?", root=small).write()
    assert set(written) == {
        "_toc.yml",
        "content/chapters.yml",
        "book/two_eyes.md",
        "exercises/two_eyes.md",
        "exercises/concepts/two_eyes.yml",
        "exercises/predictions/two_eyes.yml",
        "exercises/objectives.yml",
        "solutions/notes/two-eyes.md",
    }
    load_chapters.cache_clear()
    made = get_chapter("two-eyes", small)
    assert len(load_chapters(small)) == before + 1
    assert (made.heading, made.prefix, made.kind) == (
        "Two eyes: How far is it?",
        prefix,
        "extension",
    )
    text = (small / "book/two_eyes.md").read_text(encoding="utf-8")
    assert "(page-two-eyes)=\n# Two eyes: How far is it?\n" in text
    assert re.findall(r"\*\*(\w+)\.\*\*", text) == [f"{prefix}{one}" for one in "abab"]
    pages = list_pages(small)
    assert pages.index("book/two_eyes") == last + 1
    assert pages.index("exercises/two_eyes") == pages.index("book/two_eyes") + 1
    sections = (small / "exercises/objectives.yml").read_text(encoding="utf-8")
    assert sections.endswith(f"  {prefix}a: two-eyes-first\n  {prefix}b: two-eyes-first\n")


def test_chapters_keep_the_order_of_their_kinds(small: Path) -> None:
    standing = [one.id for one in list_taught(small) if one.is_extension]
    kinds = {"two-eyes": "extension", "three-eyes": "extension", "step7": "required"}
    for id_, kind in kinds.items():
        load_chapters.cache_clear()
        plan_chapter(id_, "How?", kind, small).write()
    load_chapters.cache_clear()
    rows = load_chapters(small)
    due = ["step7", *standing, "two-eyes", "three-eyes"]
    assert [one.id for one in rows][-len(due) :] == due
    pages = [page for page in list_pages(small) if page in {one.page for one in rows}]
    assert pages == [one.page for one in rows]
    exercises = [page for page in list_pages(small) if page.startswith("exercises/")]
    assert exercises == [one.exercises for one in rows if one.exercises]
    contents = (small / "_toc.yml").read_text(encoding="utf-8")
    assert contents.count("Beyond the lab") == 1
    prefix = len(list_taught(small))
    assert f"  {prefix}c: step7-first\n" in (small / "exercises/objectives.yml").read_text("utf-8")


def test_what_is_unfilled_is_named_by_file_line_and_words(small: Path) -> None:
    assert find_unfilled(small) == []
    plan_chapter("two-eyes", root=small).write()
    places = find_unfilled(small)
    files = {place.file for place in places}
    assert files >= {"content/chapters.yml", "book/two_eyes.md", "solutions/notes/two-eyes.md"}
    for place in places:
        line = (small / place.file).read_text(encoding="utf-8").splitlines()[place.line - 1]
        assert f"FILL: {place.what}" in line
        assert len(place.what.split()) >= 3, place
        assert str(place).startswith(f"{place.file}:{place.line}: ")


def test_the_repository_itself_has_no_unfilled_place() -> None:
    assert [str(place) for place in find_unfilled()] == []


@pytest.mark.parametrize(
    ("id_", "title", "kind", "message"),
    [
        ("", "", "extension", "ID: expected a name in small letters such as two-eyes, got ''"),
        ("Two_eyes", "", "extension", "ID: expected a name in small letters"),
        ("step1", "", "extension", "ID: there is a chapter step1 already"),
        ("rubric", "", "extension", r"book/rubric\.md exists already; choose another name"),
        ("two-eyes", "", "reading", "KIND: expected required or extension, got 'reading'"),
        ("two-eyes", 'Is "it"?', "extension", "TITLE: expected one line without double quotation"),
    ],
)
def test_a_chapter_that_cannot_be_made_is_refused_and_nothing_is_written(
    id_: str, title: str, kind: str, message: str, small: Path
) -> None:
    before = read_all(small)
    with pytest.raises(ScaffoldError, match=message):
        plan_chapter(id_, title, kind, small).write()
    assert read_all(small) == before


# ---- An exercise


def test_an_exercise_gets_its_card_its_statement_and_its_variants(small: Path) -> None:
    plan = plan_exercise("scale_intrinsics", "step2", args="K: np.ndarray, s: float", root=small)
    assert plan.write() == [
        "solutions/scale_intrinsics.py",
        "tests/solutions/variants/scale_intrinsics.py",
        "exercises/step2_intrinsics.md",
    ]
    card = (small / "solutions/scale_intrinsics.py").read_text(encoding="utf-8")
    assert "def scale_intrinsics(K: np.ndarray, s: float)" in card
    assert 'chapter="step2"' in card
    taken = [one.place for one in load_exercises().values() if one.chapter == "step2"]
    assert f"place={max(taken) + 1}," in card
    page = (small / "exercises/step2_intrinsics.md").read_text(encoding="utf-8")
    assert page.startswith((ROOT / "exercises/step2_intrinsics.md").read_text(encoding="utf-8"))
    assert "(exercise-scale-intrinsics)=\n### FILL: " in page
    assert 'example="show(scale_intrinsics(K, s))",' in card
    example, _, rest = page.partition("<!-- begin example scale_intrinsics -->\n")[2].partition(
        "\n"
    )
    assert example == "<!-- end example scale_intrinsics -->"
    assert rest.strip().startswith("<!-- begin exercise scale_intrinsics -->")


def test_an_exercise_of_the_lab_answers_for_a_function_of_the_library(small: Path) -> None:
    plan = plan_exercise("points_to_pixels", "step5", "lab", root=small)
    card = plan.texts[Path("solutions/points_to_pixels.py")]
    assert "reference=labutils.points_to_pixels," in card
    assert "mistakes: frozenset[str], points: Any, K: Any" in card


def test_a_new_card_can_be_loaded_before_it_is_filled(small: Path) -> None:
    plan = plan_exercise("scale_intrinsics", "step2", root=small)
    space: dict[str, Any] = {"__name__": "solutions.scale_intrinsics"}
    exec(plan.texts[Path("solutions/scale_intrinsics.py")], space)  # noqa: S102 - our own text
    card = space["EXERCISE"]
    assert card.is_challenge
    assert card.home.id == "step2"
    assert replace(card, place=99).place == 99


@pytest.mark.parametrize(
    ("name", "chapter", "kind", "args", "message"),
    [
        ("", "step2", "challenge", "", "NAME: expected a function such as find_edges, got ''"),
        ("FindEdges", "step2", "challenge", "", "NAME: expected a function"),
        ("class", "step2", "challenge", "", "NAME: expected a function"),
        ("choose_pan", "step2", "challenge", "", "there is an exercise choose_pan already"),
        ("find_edges", "step9", "challenge", "", "chapter: expected one of start, .*, got 'step9'"),
        ("find_edges", "start", "challenge", "", "start is a page for reading, without exercises"),
        ("find_edges", "step2", "hard", "", "KIND: expected lab or challenge, got 'hard'"),
        ("find_edges", "step2", "lab", "", "labutils has no function find_edges; write it first"),
        ("points_to_pixels", "step2", "challenge", "", "labutils answers points_to_pixels already"),
        ("find_edges", "step2", "challenge", "a b", "ARGS: expected such as 'values: np.ndarray'"),
    ],
)
def test_an_exercise_that_cannot_be_made_is_refused(
    name: str, chapter: str, kind: str, args: str, message: str, small: Path
) -> None:
    before = read_all(small)
    with pytest.raises(ScaffoldError, match=message):
        plan_exercise(name, chapter, kind, args, small).write()
    assert read_all(small) == before


# ---- The commands, and what they stand on


def test_commands_say_why_they_refuse_in_one_sentence(capsys: pytest.CaptureFixture[str]) -> None:
    assert chapter_tool.main(["--id", "step1"]) == 1
    said = capsys.readouterr().err
    assert said == "new-chapter: ID: there is a chapter step1 already; choose another name\n"
    assert exercise_tool.main(["--name", "choose_pan", "--chapter", "step1"]) == 1
    assert capsys.readouterr().err.startswith("new-exercise: NAME: there is an exercise")


def test_where_one_file_cannot_be_written_all_stay_as_they_were(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("before\n", encoding="utf-8")
    (tmp_path / "taken").write_text("a file, and no folder", encoding="utf-8")
    plan = Plan(tmp_path)
    plan.append("old", "after\n")
    plan.add("new/file", "text")
    plan.add("taken/file", "text")
    before = read_all(tmp_path)
    with pytest.raises(ScaffoldError, match="nothing is written"):
        plan.write()
    assert read_all(tmp_path) == before


def test_a_line_to_insert_at_has_to_be_there_once(tmp_path: Path) -> None:
    (tmp_path / "list").write_text("a\nb\na\n", encoding="utf-8")
    plan = Plan(tmp_path)
    plan.insert("list", "c\n", after="b")
    plan.insert("list", "d\n", before="b")
    assert plan.read("list") == "a\nd\nb\nc\na\n"
    for line in ("a", "x"):
        with pytest.raises(ScaffoldError, match=f"list: expected the line '{line}' once"):
            plan.insert("list", "e\n", after=line)


def test_a_slot_without_a_value_is_an_error() -> None:
    with pytest.raises(KeyError, match="name"):
        fill_template("statement.md", label="x")


def read_all(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


# ---- A whole chapter, on a copy of the repository


def fill(path: Path, texts: Iterable[str]) -> None:
    """Fill the places of a file in their order; an empty text leaves the next line as it is."""
    rest = iter(texts)

    def write(place: re.Match[str]) -> str:
        text = next(rest)
        if "line" in place.re.groupindex and place["line"] is not None:
            return f"{place['indent']}{text}" if text else place["line"]
        return text

    pattern = PLACE_IN_CODE if path.suffix == ".py" else PLACE_IN_WORDS
    filled = pattern.sub(write, path.read_text(encoding="utf-8"))
    assert next(rest, None) is None, f"{path.name}: more texts than places"
    path.write_text(filled, encoding="utf-8")


def read_texts(name: str) -> list[str]:
    text = (TEXTS / f"{name}.txt").read_text(encoding="utf-8")
    return [one.strip("\n") for one in re.split(r"^%%\n", text, flags=re.MULTILINE)]


class Copy:
    """A copy of the repository, with this environment and a history of its own."""

    def __init__(self, folder: Path) -> None:
        self.folder = copy_repository(folder)
        self.git("init", "-q")
        self.commit()

    def run(self, *command: str, **variables: str) -> str:
        environment = {name: v for name, v in os.environ.items() if not name.startswith("PYTEST")}
        environment |= {"PYTHONPATH": str(self.folder), "PYTHONDONTWRITEBYTECODE": "1", **variables}
        done = subprocess.run(
            [sys.executable, *command],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=1800,
        )
        assert done.returncode == 0, done.stdout[-6000:] + done.stderr[-6000:]
        return done.stdout

    def git(self, *arguments: str) -> str:
        command = ["git", "-c", "user.name=test", "-c", "user.email=test@example.org", *arguments]
        done = subprocess.run(
            command, cwd=self.folder, capture_output=True, text=True, check=True, timeout=60
        )
        return done.stdout

    def commit(self) -> None:
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "as it is")

    def list_changed(self) -> list[str]:
        return self.git("diff", "--name-only", "HEAD", "--no-renames").splitlines()


@pytest.fixture(scope="module")
def extended(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """The repository with a chapter more, made by the commands and filled from the texts."""
    copy = Copy(tmp_path_factory.mktemp("copy"))
    title = "Where does a point land in a smaller picture?"
    copy.run("-m", "tools.scaffold.chapter", "--id", "ext-test", "--title", title)
    exercise = ("-m", "tools.scaffold.exercise", "--chapter", "ext-test", "--name")
    copy.run(*exercise, "points_to_pixels", "--kind", "lab")
    copy.run(*exercise, "scale_intrinsics", "--args", "K: np.ndarray, factor: float")
    for name, file in FILLED.items():
        fill(copy.folder / file, read_texts(name))
    assert find_unfilled(copy.folder) == []
    copy.run("-m", "tools.derive.exercises")
    copy.run("-m", "tools.derive.objectives")
    return copy


@pytest.mark.slow
def test_a_new_chapter_touches_content_only_and_its_tests_are_green(extended: Copy) -> None:
    extended.git("add", "-A")
    changed = extended.list_changed()
    assert set(FILLED.values()) <= set(changed)
    assert [name for name in changed if not CONTENT.fullmatch(name)] == []
    extended.run("-m", "ruff", "check", ".")
    extended.run("-m", "ruff", "format", "--check", ".")
    new = "ext_test or ext-test or points_to_pixels or scale_intrinsics"
    tests = ("-m", "pytest", "-q", "-p", "no:cacheprovider")
    contents = ("toc", "objectives", "quiz", "predictions", "editions")
    extended.run(
        *tests,
        *("-m", "not slow", "tests/content", "tests/test_rooms.py"),
        *(f"tests/book/test_{name}.py" for name in contents),
        *("tests/checks/test_check_files.py", "tests/checks/test_check_progress.py"),
    )
    said = extended.run(*tests, "tests/solutions", "tests/book/test_chapters.py", "-k", new)
    passed = re.search(r"(\d+) passed", said)
    assert passed, said
    assert int(passed[1]) > 40
    report = extended.run("-c", "from labutils.checks import report; print(report())")
    assert "0 of 9 exercises, 0 of 90 points in reach" in report
    assert re.search(r"^Ext test +points_to_pixels +0/3 +not started$", report, re.MULTILINE)
    others = sum(one.home.is_extension for one in load_exercises().values())
    assert f"Extensions: 0 of {others + 2}." in report


@pytest.mark.slow
def test_the_book_with_a_new_chapter_is_built(extended: Copy) -> None:
    built = ROOT / "_build"
    if not (built / ".jupyter_cache").is_dir():
        pytest.skip("the book is not built; run `make book` first")
    copied = extended.folder / "_build"
    shutil.copytree(
        built, copied, ignore=shutil.ignore_patterns("html", ".doctrees", "instructor", "*.lock")
    )
    # Only the tables of the library have changed, which no other page reads: keep what was run.
    digest = "import os; from tools.build.memory import make_cell_stamp as m; print(m(os.environ))"
    cells = extended.run("-c", digest).strip()
    (copied / "stamps.json").write_text(json.dumps({"cells": cells}), encoding="utf-8")
    said = extended.run("-m", "tools.build.book", EDITION="student")
    assert "no warnings" in said
    page = (copied / "html/book/ext_test.html").read_text(encoding="utf-8")
    assert "half [" in page  # what its cell has printed
    assert page.count("quiz-item") == 2
    assert page.count("predict-cell") == 1
    exercises = (copied / "html/exercises/ext_test.html").read_text(encoding="utf-8")
    assert 'id="exercise-scale-intrinsics"' in exercises
    assert 'href="ext_test.html"' in (copied / "html/book/index.html").read_text(encoding="utf-8")
