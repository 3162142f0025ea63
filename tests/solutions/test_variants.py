"""Right answers that are written differently have to pass: three and more per function."""

from importlib import import_module
from pathlib import Path

import pytest

from labutils.checks import judge
from labutils.checks.calls import Function, collect_answers
from labutils.checks.gates import find_failure
from labutils.checks.table import load_table
from solutions import load_exercises
from tests.helpers.hidden_cases import make_hidden_table

#: One file per exercise, named like it: three functions and more.
FOLDER = Path(__file__).with_name("variants")
MIN_VARIANTS = 3
VARIANTS = {
    path.stem: import_module(f"tests.solutions.variants.{path.stem}").VARIANTS
    for path in sorted(FOLDER.glob("*.py"))
}


def test_every_exercise_has_three_variants() -> None:
    assert set(VARIANTS) == set(load_exercises())
    for name, functions in VARIANTS.items():
        found = f"got {len(functions)} in {FOLDER.name}/{name}.py"
        assert len(functions) >= MIN_VARIANTS, f"expected {MIN_VARIANTS} right answers, {found}"
        assert len({one.__name__ for one in functions}) == len(functions), f"{name}: one is twice"


@pytest.mark.parametrize(
    ("name", "function"),
    [(name, function) for name, functions in VARIANTS.items() for function in functions],
)
def test_right_answer_written_differently_passes(name: str, function: Function) -> None:
    verdict = judge(load_table(name), function)
    assert verdict.passed, verdict.message


@pytest.mark.parametrize(
    ("name", "function"),
    [
        # Six loops of seconds each: of what acts, hidden cases of three seeds are slow.
        pytest.param(name, function, marks=[pytest.mark.slow] if name == "control" else [])
        for name, functions in VARIANTS.items()
        for function in functions
    ],
)
def test_right_answer_written_differently_passes_hidden_cases(
    name: str, function: Function
) -> None:
    for seed in range(3):
        table = make_hidden_table(name, seed)
        assert find_failure(table, collect_answers(table, function)) is None
