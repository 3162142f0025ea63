"""A build without changes does nothing; after a change, what depends on it is made again."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tools.build import book, edition, jupyter_settings, memory, setup_env
from tools.build.edition import EDITIONS, Edition
from tools.build.memory import Memory

ROOT = Path(__file__).resolve().parents[2]

PAGE = "book/step3_depth.md"
# what a build reads, one of each kind
SOURCES = (
    PAGE,
    "exercises/step3_depth.md",
    "labutils/depth_processing.py",
    "assets/textures/wood.png",
    "exercises/concepts/step3_depth.yml",
    "book/_ext/quiz.py",
    "book/_page_python/worker.js",
    "book/_static/book.css",
    "book/_static/figures/pinhole.svg",
    "book/_templates/search.html",
    "book/_generated/rubric.md",
    "content/quiz_items.py",
    "solutions/process_depth.py",
    "tools/vendor/pack_python.py",
    "_config.yml",
    "_toc.yml",
    "package-lock.json",
    "requirements.txt",
)
RUN_AGAIN = ("labutils/depth_processing.py", "assets/textures/wood.png", "requirements.txt")
DRAWN_AGAIN = (
    "book/_ext/quiz.py",
    "book/_static/book.css",
    "book/_static/figures/pinhole.svg",
    "book/_templates/search.html",
    "content/quiz_items.py",
    "_config.yml",
    "_toc.yml",
    "package-lock.json",
)


def write(folder: Path, name: str, text: str) -> None:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def find_left(student: Edition) -> set[str]:
    return {name for name in memory.CELL_MEMORY + memory.PAGE_MEMORY if is_left(student, name)}


def is_left(student: Edition, name: str) -> bool:
    return (student.build / name / "something").exists()


def fill(student: Edition) -> None:
    for name in {*memory.CELL_MEMORY, *memory.PAGE_MEMORY}:
        write(student.build, f"{name}/something", "old")


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for module in (memory, edition):
        monkeypatch.setattr(module, "ROOT", tmp_path)
    for name in (memory.OUTSIDE, *memory.CELL_VARIABLES):
        monkeypatch.delenv(name, raising=False)
    for name in SOURCES:
        write(tmp_path, name, "before")
    return tmp_path


@pytest.fixture
def built(repository: Path) -> Edition:  # noqa: ARG001 - what it is built from
    """An edition that has just been built, from the repository as it is."""
    student = EDITIONS["student"]
    student.build.mkdir()
    now = Memory(student)
    now.forget_what_changed()
    fill(student)
    now.note_built()
    assert Memory(student).is_up_to_date()
    return student


# --- has anything changed? ---


@pytest.mark.parametrize("name", SOURCES)
def test_a_changed_source_is_seen(name: str, built: Edition, repository: Path) -> None:
    write(repository, name, "after!")  # as long as before
    assert not Memory(built).is_up_to_date()


def test_a_new_a_renamed_and_a_lost_source_are_seen(built: Edition, repository: Path) -> None:
    write(repository, "book/new.md", "")
    assert not Memory(built).is_up_to_date()
    (repository / "book" / "new.md").unlink()
    assert Memory(built).is_up_to_date()
    (repository / PAGE).rename(repository / "book" / "other.md")
    assert not Memory(built).is_up_to_date()


def test_a_source_that_was_only_touched_is_no_change(built: Edition, repository: Path) -> None:
    os.utime(repository / PAGE)
    assert Memory(built).is_up_to_date()


@pytest.mark.parametrize(
    "name",
    [
        "tests/book/test_toc.py",
        ".git/index",
        ".venv/lib/x.py",
        "outputs/cloud.ply",
        "labutils/__pycache__/x.cpython-311.pyc",
        "labutils.egg-info/PKG-INFO",
        "solutions/pages/step1.md",
        "_build/npm/package.json",
    ],
)
def test_what_no_page_is_made_from_is_no_change(
    name: str, built: Edition, repository: Path
) -> None:
    write(repository, name, "something else")
    assert Memory(built).is_up_to_date()


def test_other_variables_and_other_wheels_are_seen(
    built: Edition, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    monkeypatch.setenv("MUJOCO_GL", "osmesa")
    assert not Memory(built).is_up_to_date()
    monkeypatch.delenv("MUJOCO_GL")
    folder = tmp_path_factory.mktemp("wheels")
    write(folder, "numpy.whl", "1")
    monkeypatch.setenv(memory.OUTSIDE, str(folder))
    assert not Memory(built).is_up_to_date()
    Memory(built).note_built()
    assert Memory(built).is_up_to_date()
    write(folder, "numpy.whl", "another")
    assert not Memory(built).is_up_to_date()


def test_a_lost_or_changed_page_is_drawn_again(built: Edition) -> None:
    (built.html / "something").unlink()
    now = Memory(built)
    assert not now.is_up_to_date()
    fill(built)
    assert "not as they were left" in now.forget_what_changed()
    assert find_left(built) == {".jupyter_cache", "jupyter_execute"}


def test_what_changes_during_a_build_is_seen_by_the_next(built: Edition, repository: Path) -> None:
    running = Memory(built)
    running.forget_what_changed()
    write(repository, PAGE, "after!")
    running.note_built()
    assert not Memory(built).is_up_to_date()


def test_a_build_that_failed_is_not_taken_for_one_that_stands(
    built: Edition, repository: Path
) -> None:
    write(repository, PAGE, "after!")
    Memory(built).forget_what_changed()  # and then a cell fails
    write(repository, PAGE, "before")
    assert not Memory(built).is_up_to_date()


def test_the_editions_are_told_apart(built: Edition) -> None:
    instructor = EDITIONS["instructor"]
    instructor.build.mkdir(parents=True)
    assert not Memory(instructor).is_up_to_date()
    assert Memory(built).is_up_to_date()


# --- what has to be made again? ---


@pytest.mark.parametrize("name", SOURCES)
def test_a_change_empties_the_memories_that_depend_on_it(
    name: str, built: Edition, repository: Path
) -> None:
    everything = find_left(built)
    write(repository, name, "after!")
    said = Memory(built).forget_what_changed()
    if name in RUN_AGAIN:
        assert "all run again" in said
        assert find_left(built) == {"html"}
    elif name in DRAWN_AGAIN:
        assert said == "all drawn again, because the configuration changed"
        assert find_left(built) == {".jupyter_cache", "jupyter_execute"}
    else:  # of these Sphinx knows which page they belong to
        assert said == "kept where the page is unchanged"
        assert find_left(built) == everything


def test_another_opengl_runs_all_cells_again(
    built: Edition, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MUJOCO_GL", "osmesa")
    assert "all run again" in Memory(built).forget_what_changed()
    assert not is_left(built, ".jupyter_cache")


@pytest.mark.usefixtures("repository")
def test_outputs_of_unknown_age_are_not_trusted() -> None:
    student = EDITIONS["student"]
    fill(student)
    assert Memory(student).forget_what_changed() == "none yet"
    assert find_left(student) == set()


# --- the build itself ---


def test_a_build_without_changes_prepares_nothing_and_says_what_to_open(
    built: Edition, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(book, "gather", lambda _: pytest.fail("went on"))
    monkeypatch.delenv("EDITION", raising=False)
    assert book.main() == 0
    said = capsys.readouterr().out
    assert "nothing has changed" in said
    assert f"open {(built.html / 'index.html').as_uri()}" in said


def test_the_question_whether_to_build_loads_no_library() -> None:
    code = (
        "import sys; import tools.build.book; print('numpy' in sys.modules, 'yaml' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["False", "False"]


# --- the environment before it ---


def test_missing_system_packages_are_asked_for_in_one_call(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = tmp_path / "dpkg-query"
    script.write_text(
        f"#!/bin/sh\necho call >> {tmp_path}/calls\n"
        "echo libegl1 installed; echo libgl1 config-files; exit 1\n"
    )
    script.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    assert setup_env.find_missing(["libegl1", "libgl1", "libx11-6"]) == ["libgl1", "libx11-6"]
    assert (tmp_path / "calls").read_text() == "call\n"


def test_settings_of_jupyterlab_go_where_an_environment_reads_them(tmp_path: Path) -> None:
    written = jupyter_settings.install_settings(tmp_path)
    places = {path.relative_to(tmp_path).as_posix() for path in written}
    assert places == {
        "etc/jupyter/jupyter_server_config.json",
        "etc/jupyter/labconfig/default_setting_overrides.json",
    }
    assert jupyter_settings.install_settings(tmp_path) == written  # once more changes nothing


def test_settings_need_an_environment(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="expected the folder of an environment"):
        jupyter_settings.install_settings(tmp_path / "none")


def test_changed_settings_are_installed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    before = setup_env.fingerprint()
    monkeypatch.setattr(setup_env, "list_settings", list)
    assert setup_env.fingerprint() != before
