"""Every exercise that a browser can check: the starter, the reference and a known mistake."""

from __future__ import annotations

import base64
import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from content.chapters import REGISTRY, get_chapter, load_chapters
from labutils.checks import judge
from labutils.checks.table import load_table
from solutions import load_exercises
from solutions._completion import Completion, Slip
from tools.derive.completions import make_starter
from tools.derive.exercise_cards import get_label

ROOT = Path(__file__).resolve().parents[2]
CHAPTERS = {card.chapter for card in load_exercises().values()}
CARDS = load_exercises()
COMPLETIONS = {card.name: card.completion for card in CARDS.values() if card.completion is not None}

# "import mujoco" is also what makes the page load the simulator, which some cards need.
SETUP = """
import base64, io, sys, zipfile
zipfile.ZipFile(io.BytesIO(base64.b64decode("{cards}"))).extractall("/tmp/cards")
sys.path.insert(0, "/tmp/cards")
import mujoco
from solutions import load_exercises
load_exercises()
print("ready")
"""
ANSWER = """
from solutions import load_exercises

{name} = load_exercises()["{name}"].make_wrong({made})
"""


@pytest.fixture(scope="module")
def plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted((ROOT / "solutions").rglob("*.py")):
            archive.write(path, path.relative_to(ROOT).as_posix())
        # a card asks the registry for its chapter, and the pages for its labels
        for path in sorted((ROOT / "content").glob("*.py")):
            archive.write(path, f"content/{path.name}")
        archive.write(ROOT / REGISTRY, REGISTRY.as_posix())
        for chapter in load_chapters():
            archive.write(ROOT / f"{chapter.page}.md", f"{chapter.page}.md")
        for path in sorted(Path(yaml.__file__).parent.glob("*.py")):
            archive.write(path, f"yaml/{path.name}")
    exercises = {
        name: {
            "reference": ANSWER.format(name=name, made=()),
            "wrong": ANSWER.format(name=name, made=(card.misconceptions[0].name,)),
        }
        for name, card in CARDS.items()
    }
    completions = {
        one.name: {
            "starter": make_starter(one),
            "whole": write_code(one),
            "wrong": write_code(one, one.slips[0]),
        }
        for one in COMPLETIONS.values()
    }
    cards = base64.b64encode(buffer.getvalue()).decode()
    path = tmp_path_factory.mktemp("plan") / "plan.json"
    setup = SETUP.format(cards=cards)
    content = {"setup": setup, "exercises": exercises, "completions": completions}
    path.write_text(json.dumps(content))
    return path


def write_code(completion: Completion, *slips: Slip) -> str:
    """Write the code of somebody who has completed it; their annotations need no imports."""
    head = "from __future__ import annotations\n"
    return "\n".join([head, *completion.imports, completion.write_with(*slips)])


#: The pages that run in `make test`: those that need the simulator, and answers of most kinds.
SAMPLE = ("step1", "step5")
PARAMETERS = [
    one if one in SAMPLE else pytest.param(one, marks=pytest.mark.slow) for one in sorted(CHAPTERS)
]


@pytest.fixture(scope="module", params=PARAMETERS)
def used(
    request: pytest.FixtureRequest,
    chromium: Callable[..., Any],
    file_site: str,
    plan: Path,
    page_python: dict[str, Any],  # noqa: ARG001 - needed to run
    once: Callable[..., Any],
) -> tuple[str, dict[str, Any]]:
    """One page with all its exercises, opened from a file."""
    page = page_of(request.param)
    make = lambda: chromium("exercises.mjs", file_site, page, plan)  # noqa: E731
    return request.param, once(f"exercises-{request.param}", make)


def page_of(chapter: str) -> str:
    return get_chapter(chapter).exercises


def test_every_exercise_of_the_page_is_checked_as_in_the_notebook(
    used: tuple[str, dict[str, Any]],
) -> None:
    chapter, done = used
    assert done["complaints"] == []
    assert "ready" in done["setup"]["text"]
    names = [name for name, card in CARDS.items() if card.chapter == chapter]
    assert sorted(done["said"]) == sorted(names)
    for name in names:
        said = done["said"][name]
        assert said["starter"]["result"] == "failed", name
        assert "Not started yet." in said["starter"]["text"]
        assert said["reference"]["result"] == "passed", (name, said["reference"])
        visible = len(load_table(name).cases)
        assert f"All {visible} visible cases agree." in said["reference"]["text"]
        assert said["wrong"]["result"] == "failed", name
        mistake = CARDS[name].misconceptions[0]
        assert f"Recognized: {mistake.text}" in said["wrong"]["text"], name
        # "Read again" carries the heading, not the address
        assert ".html" not in said["wrong"]["text"]


def test_a_completion_is_solved_on_the_page_and_counts_for_nothing(
    used: tuple[str, dict[str, Any]],
) -> None:
    chapter, done = used
    due = {name: one for name, one in COMPLETIONS.items() if CARDS[name].chapter == chapter}
    assert list(done["completed"]) == [one.name for one in due.values()]
    text = (ROOT / page_of(chapter)).with_suffix(".md").read_text(encoding="utf-8")
    for name, completion in due.items():
        said = done["completed"][completion.name]
        for part in ("starter", "half", "wrong"):
            assert said[part]["result"] == "failed", (name, part)
        assert "Not started yet." in said["starter"]["text"]
        assert f"Recognized: {completion.slips[0].text}" in said["wrong"]["text"]
        assert said["whole"]["result"] == "passed", (name, said["whole"])
        assert "Hint" not in said["buttons"]
        # the exercise comes next
        assert f"({get_label(name)})=\n### {said['next']}\n" in text
        before, after = said["solved"]
        assert before == after, "a completion was counted as an exercise"


def test_a_wrong_answer_shows_the_picture_that_the_notebook_shows(
    used: tuple[str, dict[str, Any]],
) -> None:
    _, done = used
    assert done["said"]
    for name, said in done["said"].items():
        wrong = CARDS[name].make_wrong((CARDS[name].misconceptions[0].name,))
        drawn = judge(load_table(name), wrong).picture is not None
        assert said["wrong"]["pictures"] == drawn, name


def test_from_a_server_python_works_as_well(
    chromium: Callable[..., Any],
    http_site: str,
    page_python: dict[str, Any],  # noqa: ARG001
) -> None:
    done = chromium("exercises.mjs", http_site, page_of("step3"))
    (said,) = done["said"].values()
    assert said["starter"]["result"] == "failed"
    assert "Not started yet." in said["starter"]["text"]
    assert done["complaints"] == []


def test_python_works_in_firefox_too(
    firefox: Callable[..., Any],
    site: str,
    page_python: dict[str, Any],  # noqa: ARG001
) -> None:
    done = firefox("exercises_firefox.mjs", site, page_of("step3"))
    assert "Not started yet." in done["text"]
    assert done["complaints"] == []
