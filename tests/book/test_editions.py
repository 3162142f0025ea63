"""Two books and one zip from one source: the student's are the default, and differ as promised."""

import hashlib
import io
import json
import os
import re
import subprocess
import sys
import zipfile
from dataclasses import replace
from fnmatch import fnmatch
from pathlib import Path, PurePosixPath

import nbformat
import numpy as np
import pytest
import yaml

import labutils
from content.chapters import list_taught
from labutils.checks.table import Part, Raised
from solutions import load_exercises
from solutions._open_answers import load_marked_tasks
from tests.helpers.chapters import ROOT, get_executable_pages, get_toc_pages
from tools.build import book as build_book
from tools.build import memory
from tools.build.edition import EDITIONS, get_edition
from tools.editions import exercise_section
from tools.editions import instructor_pages as make_instructor_pages
from tools.editions import student as make_student
from tools.editions.card_code import is_answered_by_library
from tools.editions.mistakes import describe_residual, measure
from tools.editions.plain_markdown import Flattener, find_labels


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return make_student.make_files()


@pytest.fixture(scope="module")
def pages() -> dict[Path, str]:
    return make_instructor_pages.make_pages(ROOT)


# --- which book is built ---


def test_the_student_edition_is_the_default() -> None:
    assert get_edition("").name == get_edition("student").name == "student"
    assert get_edition("").html == ROOT / "_build" / "html"
    assert get_edition("instructor").html == ROOT / "_build" / "instructor" / "html"


def test_an_unknown_edition_is_refused_before_anything_is_built(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("EDITION", "teacher")
    monkeypatch.setattr(build_book, "gather", lambda _: pytest.fail("went on"))
    assert build_book.main() == 2
    error = capsys.readouterr().err
    assert "EDITION: expected one of student, instructor, got 'teacher'" in error


def test_the_editions_share_no_memory() -> None:
    student, instructor = EDITIONS.values()
    for name in (*memory.CELL_MEMORY, *memory.PAGE_MEMORY):
        assert student.build / name != instructor.build / name
        assert not (instructor.build / name).is_relative_to(student.build / name)


def test_only_the_instructor_edition_depends_on_the_solutions() -> None:
    student, instructor = EDITIONS.values()
    assert student.sources == ()
    assert "solutions" in instructor.sources
    toc = (ROOT / student.toc).read_text(encoding="utf-8")
    assert "solutions" not in toc
    config = yaml.safe_load((ROOT / student.config).read_text(encoding="utf-8"))
    assert "solutions" in config["exclude_patterns"]


def test_the_configuration_of_the_instructor_edition_differs_where_it_has_to() -> None:
    config = yaml.safe_load((ROOT / "_config.yml").read_text(encoding="utf-8"))
    hooks = config["sphinx"]["local_extensions"]
    made = make_instructor_pages.make_config(
        yaml.safe_load((ROOT / "_config.yml").read_text(encoding="utf-8"))
    )
    assert made["sphinx"]["config"]["html_theme_options"]["announcement"]
    assert "solutions" not in made["exclude_patterns"]
    assert {"solutions/notes", "solutions/_generated", "_build"} <= set(made["exclude_patterns"])
    for name, folder in made["sphinx"]["local_extensions"].items():
        found = (ROOT / make_instructor_pages.EDITION / folder).resolve()
        assert found == ROOT / hooks[name]


# --- what its pages say ---


def test_every_card_has_its_section_with_everything_in_it(pages: dict[Path, str]) -> None:
    for exercise in load_exercises().values():
        text = pages[make_instructor_pages.PAGES / f"{exercise.chapter}.md"]
        section = text.split(f"## `{exercise.name}`: ")[1].split("\n## ")[0]
        assert f"def {exercise.name}(" in section
        for mistake in exercise.misconceptions:
            assert f"**{mistake.name}**" in section
            assert mistake.text[1:] in section
        assert f"{{ref}}`{exercise.section}`" in section
        for hint in exercise.hints:
            assert hint in section
        for one in exercise.absorbed:
            assert f"- {one.first} and {one.second}: {one.reason}" in section
        shares = [
            float(x) for x in re.findall(r"^\| hidden .* (\d+\.\d+) \|$", section, re.MULTILINE)
        ]
        assert sum(shares) == pytest.approx(exercise.points, abs=0.01 * len(shares))


def test_every_step_has_its_open_task_with_two_marked_answers(pages: dict[Path, str]) -> None:
    for page, marked in load_marked_tasks().items():
        chapter = next(one for one in list_taught() if one.stem == page)
        text = pages[make_instructor_pages.PAGES / f"{chapter.id}.md"]
        section = text.split(f"## Open task: {marked.task.title}\n")[1]
        for name, levels in marked.levels.items():
            assert f"| {name} | {' | '.join(levels)} |" in section
        for answer in marked.answers:
            assert f"**{answer.total} of 8**" in section
            assert f"open_tasks/{chapter.id}_{answer.kind}.png" in section
            for mark in answer.marks.values():
                assert f"| {mark.mark} | {answer.fill(mark.because)} |" in section
            assert f"def {answer.measure.__name__}(" in section
        shown = section.split(":::")[0]  # without the code
        names = [name for answer in marked.answers for name in answer.numbers]
        assert not [name for name in names if f"{{{name}}}" in shown], "numbers are not filled in"


def test_the_map_of_objectives_is_a_page_of_its_own(pages: dict[Path, str]) -> None:
    text = pages[make_instructor_pages.PAGES / "objectives.md"]
    assert "| Objective | Taught | Worked | Practiced | Checked |" in text
    rows = re.findall(r"^\| \*\*(\d[a-e])\*\* ", text, re.MULTILINE)
    taught = yaml.safe_load((ROOT / "exercises" / "objectives.yml").read_text(encoding="utf-8"))
    assert rows == sorted(name for name in taught["sections"] if name[0] != "0")
    assert len(rows) >= 29  # those of the lab


def test_every_chapter_has_notes_and_minutes(pages: dict[Path, str]) -> None:
    for chapter in list_taught():
        notes = make_instructor_pages.read_notes(ROOT, chapter)
        count = len(notes.splitlines())
        assert 15 <= count <= 30, f"notes of {chapter.id}: expected 15 to 30 lines, got {count}"
        for heading in ("What they stumble over", "Ask", "Show live"):
            assert f"**{heading}.**" in notes, f"notes of {chapter.id}: expected **{heading}.**"
        text = pages[make_instructor_pages.PAGES / f"{chapter.id}.md"]
        assert notes in text
        minutes = re.findall(r"^\| (?:Reading|Doing) \| about (\d+) minutes", text, re.MULTILINE)
        assert len(minutes) == 2, f"{chapter.page}: expected a card with Reading and Doing"
        assert min(map(int, minutes)) > 0, f"{chapter.page}: expected minutes to read and to do"


def test_what_is_measured_of_a_mistake_agrees_with_the_card() -> None:
    found = {one.name: one for one in measure(load_exercises()["process_depth"])}
    assert found["nan-lost"].cases == (2, 3)  # the even ramp has no NaN
    assert found["not-clipped"].gate == "range"
    assert found["linear"].kept == 0
    wrap = {one.name: one for one in measure(load_exercises()["segment_by_color"])}["no-wrap"]
    assert 0 < wrap.kept < 1  # most colors do not wrap


def test_residuals_are_told_in_units_and_tolerances() -> None:
    part = Part("depth", "depth", "float", atol=0.001, unit="m")
    due, off = np.zeros((2, 2)), np.array([[0, 0.25], [0, 0]])
    size, words = describe_residual((part,), (due,), (off,))
    assert size == pytest.approx(250)
    assert words == "depth: 1 of 4 values off, typically by 0.25 m, 250 times the tolerance"
    assert describe_residual((part,), (due,), Raised("TypeError"))[1] == "stops with TypeError"
    assert describe_residual((part,), Raised("ValueError"), (due,))[1] == (
        "answers where a ValueError is due"
    )
    assert "2 values for 2 x 2" in describe_residual((part,), (due,), (due[0],))[1]


# --- the student's zip ---


def test_every_page_is_in_the_zip_as_a_notebook_or_as_text(files: dict[str, bytes]) -> None:
    for page in get_toc_pages():
        text = (ROOT / page).with_suffix(".md").read_text(encoding="utf-8")
        ending = ".ipynb" if "```{code-cell}" in text else ".md"
        name = page.with_suffix(ending).as_posix()
        assert name in files
        assert f"]({name})" in files["README.md"].decode()


def test_notebooks_are_clean_and_name_the_kernel(files: dict[str, bytes]) -> None:
    contents = [content for name, content in files.items() if name.endswith(".ipynb")]
    assert len(contents) == len(get_executable_pages())
    for content in contents:
        notebook = nbformat.reads(content.decode(), as_version=4)
        nbformat.validate(notebook)
        assert notebook.metadata.kernelspec.name == "python3"
        for cell in notebook.cells:
            if cell.cell_type == "code":
                assert (cell.outputs, cell.execution_count) == ([], None)


def test_no_markup_of_the_book_is_left_for_a_notebook_to_show(files: dict[str, bytes]) -> None:
    read = 0
    for name, content in files.items():
        if name.endswith(".ipynb"):
            cells = nbformat.reads(content.decode(), as_version=4).cells
            text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
        elif name.endswith(".md") and name != "README.md":
            text = content.decode()
        else:
            continue
        read += 1
        assert not re.search(r"^(:::|```)\{|\{(term|ref|eq|numref|doc)\}`", text, re.MULTILINE), (
            name
        )
    assert read == len(get_toc_pages())


def test_the_zip_brings_the_recordings_and_their_license(files: dict[str, bytes]) -> None:
    clip = {name for name in files if name.startswith("assets/clip/")}
    on_disk = {path for path in (ROOT / "assets" / "clip").rglob("*") if path.is_file()}
    assert clip == {path.relative_to(ROOT).as_posix() for path in on_disk}
    assert "assets/clip/room/clip.json" in clip
    assert b"assets/clip/" in files["LICENSE-TEXT"]


def test_links_and_pictures_lead_to_files_of_the_zip(files: dict[str, bytes]) -> None:
    followed = set()
    for name, content in files.items():
        if not name.endswith((".ipynb", ".md")):
            continue
        for link in re.findall(r"\]\((?!\w+:|#)([^)#\s]+)[^)]*\)", content.decode()):
            target = os.path.normpath(PurePosixPath(name).parent / link)
            if Path(target).suffix in (".md", ".ipynb", ".svg", ".png", ".webm", ".webp"):
                assert Path(target).as_posix() in files, (name, link)
                followed.add(Path(target).suffix)
    assert {".md", ".ipynb", ".svg", ".webm", ".webp"} <= followed


def test_two_zips_are_the_same_to_the_byte(files: dict[str, bytes]) -> None:
    first, second = make_student.pack(files), make_student.pack(make_student.make_files())
    assert hashlib.sha256(first).hexdigest() == hashlib.sha256(second).hexdigest()
    with zipfile.ZipFile(io.BytesIO(first)) as archive:
        assert archive.namelist() == sorted(archive.namelist())
        assert {member.date_time for member in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_pyproject_of_the_zip_installs_the_library_and_nothing_else(
    files: dict[str, bytes],
) -> None:
    import tomllib  # noqa: PLC0415

    project = tomllib.loads(files["pyproject.toml"].decode())
    assert project["project"]["name"] == "labutils"
    assert set(project["tool"]) == {"setuptools"}
    wanted = project["tool"]["setuptools"]["packages"]["find"]["include"]
    packages = {name.rpartition("/")[0] for name in files if name.endswith("/__init__.py")}
    assert packages
    for package in packages:
        assert package.startswith("labutils")
        assert any(fnmatch(package.replace("/", "."), pattern) for pattern in wanted)
    for license_file in project["project"]["license-files"]:
        assert license_file in files


def test_a_link_to_a_page_outside_is_refused() -> None:
    with pytest.raises(ValueError, match=r"expected a link to a page of _toc.yml, got gone\.md"):
        make_student.verify_links("[x](gone.md)", "book/a.md", {"book/a.md": "book/a.md"})


def flatten(
    text: str, page: str = "book/page.md", labels: dict[str, tuple[str, str]] | None = None
) -> str:
    def resolve(link: str) -> str:
        return link.replace(".md", ".ipynb")

    return Flattener(page, ROOT, labels or {}, resolve).flatten(text)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("{term}`masks <mask>` and {term}`pixel`", "masks and pixel"),
        ("(here)=\n## Heading\n", "## Heading\n"),
        ("[there](step2.md#x)", "[there](step2.ipynb)"),
        ("[out](https://example.org/a.md)", "[out](https://example.org/a.md)"),
        (":::{admonition} Predict\n:class: predict\nWhich?\n:::\n", "> **Predict**\n>\n> Which?\n"),
        ("```{math}\n:label: eq-a\nx\n```\n", "$$\nx\n\\tag{a}\n$$\n"),
        ("$$ x $$ (eq-b)", "$$ x \\tag{b} $$"),
        ("By {eq}`eq-b`", "By (b)"),
        ("```{figure} a.svg\n:alt: What.\n\nHow.\n```\n", "![What.](a.svg)\n\n*How.*\n"),
        (
            "```{list-table} T\n:name: t\n\n* - a\n  - b\n* - c\n  - d\n```\n",
            "| a | b |\n|---|---|\n| c | d |\n",
        ),
        ("```python\n{term}\n```\n", "```python\n{term}\n```\n"),
    ],
)
def test_markup_of_the_book_becomes_plain(text: str, plain: str) -> None:
    assert flatten(text) == plain


def test_references_become_links_to_the_heading() -> None:
    labels = find_labels({"book/other.md": "(far)=\n## How far?\n"})
    assert flatten("[far](other.md#far)", labels=labels) == "[far](other.ipynb#How-far%3F)"
    assert flatten("{ref}`far`", labels=labels) == "[How far?](other.ipynb#How-far%3F)"
    assert flatten("{ref}`read <far>`", "exercises/a.md", labels) == (
        "[read](../book/other.ipynb#How-far%3F)"
    )


def test_questions_keep_their_choices_and_fold_their_answers() -> None:
    text = flatten("```{quiz} step3_depth\n(on the page)\n```\n")
    assert "**Question 1.**" in text
    assert "- A: " in text
    assert text.index("<details>") < text.index("is right.**")
    assert "(on the page)" not in text


def test_the_zip_runs_on_its_own(tmp_path: Path, files: dict[str, bytes]) -> None:
    with zipfile.ZipFile(io.BytesIO(make_student.pack(files))) as archive:
        archive.extractall(tmp_path)
    folder = tmp_path / make_student.FOLDER
    environment = {**os.environ, "PYTHONPATH": str(folder), "PYDEVD_DISABLE_FILE_VALIDATION": "1"}

    def run(*arguments: str, cwd: Path = folder / "book") -> str:
        done = subprocess.run(
            [sys.executable, *arguments],
            cwd=cwd,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    answer = (
        "import labutils\n"
        "def process_depth(d, near, far):\n"
        "    return near + d * (far - near)\n"
        "print(labutils.__file__)\n"
        "print(labutils.check('process_depth', process_depth).misconception)\n"
    )
    said = run("-c", answer)
    assert str(folder) in said
    assert "linear" in said
    assert "process_depth" in run("-m", "labutils", "report")
    assert json.loads((folder / "book" / "labutils-progress.json").read_text())
    chapter = next(p for p in sorted((folder / "book").glob("step2*.ipynb")))
    run("-m", "jupyter", "execute", "--inplace", chapter.name)
    cells = nbformat.read(chapter, as_version=4).cells
    assert any(cell.get("outputs") for cell in cells)


def test_a_challenge_shows_its_helpers() -> None:
    from tests.book.test_leaks import count_bright_regions  # noqa: PLC0415

    source = exercise_section.get_source(count_bright_regions)
    assert "def count_bright_regions" in source
    assert "def _spread_labels" in source
    card = load_exercises()["process_depth"]
    assert is_answered_by_library(card)
    assert card.reference is labutils.process_depth
    challenge = replace(
        card,
        name="count_bright_regions",
        example="show(count_bright_regions(depth, 0.02, 12.0))",
        reference=count_bright_regions,
    )
    assert not is_answered_by_library(challenge)
