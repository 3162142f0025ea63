"""The example of a card runs below any right answer, on the page of its exercise."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from importlib import import_module
from typing import Any

import pytest

from content.chapters import list_taught
from labutils import is_gl_available, make_scene
from labutils.checks.table import read_words
from solutions import load_exercises
from solutions._model import Exercise
from tests.helpers.chapters import ROOT
from tests.helpers.examples import make_names, run_example, run_set_up

#: What the cells at the top of every exercise page make.
TRYING = {"lab", "np", "show", "model", "data", "renderer", "rgb", "depth", "K", "fov_y"}


@pytest.fixture
def names(exercise: Exercise) -> dict[str, Any]:
    return make_names(exercise)


def test_an_example_shows_what_the_reference_does(
    exercise: Exercise, names: dict[str, Any]
) -> None:
    assert run_example(exercise, exercise.reference, names).strip()


def test_an_example_works_with_right_answers_written_differently(
    exercise: Exercise, names: dict[str, Any]
) -> None:
    if exercise.name == "render_camera" and not is_gl_available():
        pytest.skip("some of these answers make a renderer of MuJoCo's own, which needs OpenGL")
    for function in import_module(f"tests.solutions.variants.{exercise.name}").VARIANTS:
        assert run_example(exercise, function, names).strip()


def test_an_example_leaves_the_robot_as_it_was(exercise: Exercise, names: dict[str, Any]) -> None:
    run_example(exercise, exercise.reference, names)
    assert names["data"].qpos.tolist() == make_scene()[1].qpos.tolist()


def test_an_example_of_the_starter_stops_where_the_starter_does(
    exercise: Exercise, names: dict[str, Any]
) -> None:
    starter = (ROOT / "exercises/_generated" / f"{exercise.name}.py").read_text(encoding="utf-8")
    exec(starter, names)  # noqa: S102 - our own file
    with pytest.raises(NotImplementedError):
        run_example(exercise, names[exercise.name], names)


def test_examples_work_without_opengl() -> None:
    done = subprocess.run(
        [sys.executable, "-c", "from tests.helpers.examples import run_all; run_all()"],
        cwd=ROOT,
        env={**os.environ, "MUJOCO_GL": "disable", "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    assert set(printed) == set(load_exercises())
    assert [name for name, text in printed.items() if not text.strip()] == []


def test_an_example_goes_with_the_words_of_its_exercise(exercise: Exercise) -> None:
    assert read_words()[exercise.name]["example"] == exercise.example


@pytest.mark.parametrize("chapter", list_taught(), ids=lambda one: one.id)
def test_a_page_has_the_names_for_trying_and_no_function_of_an_exercise(chapter: Any) -> None:
    names = run_set_up(chapter.exercises)
    assert set(names) >= TRYING
    assert not set(names) & set(load_exercises()), "a learner's function may be missing unnoticed"


@pytest.mark.parametrize(
    ("example", "words"),
    [
        ("", "an example of 1 to 6 lines, got 0"),
        ("\n".join(["show(process_depth(1))"] * 7), "an example of 1 to 6 lines, got 7"),
        ("show(process_depth(1))\n", "an example without spaces around"),
        (f"show(process_depth({'1' * 60}))", "at most 76 columns, got 81"),
        ("show(process_depth(1)", "an example in Python, got '\\(' was never closed"),
        ("show(lab.process_depth(1))", "an example that calls it, got \\['show'\\]"),
        ("process_depth(1)", "an example that shows or prints"),
    ],
)
def test_an_example_that_shows_nothing_of_the_function_is_refused(example: str, words: str) -> None:
    card = load_exercises()["process_depth"]
    with pytest.raises(ValueError, match=words):
        replace(card, example=example)
