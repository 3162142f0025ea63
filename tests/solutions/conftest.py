"""What the tests of the cards share: the shipped tables, and a verdict without a record of it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest

from labutils.checks.table import CheckTable, load_table
from solutions import load_exercises
from solutions._model import Exercise
from tests.helpers.hidden_cases import make_hidden_table

NAMES = tuple(load_exercises())


@pytest.fixture(params=NAMES)
def exercise(request: pytest.FixtureRequest) -> Exercise:
    return load_exercises()[request.param]


@pytest.fixture
def table(exercise: Exercise) -> CheckTable:
    return load_table(exercise.name)


@pytest.fixture
def hidden_table(exercise: Exercise) -> Callable[[int], CheckTable]:
    """Return a function: seed to a table of the hidden cases, without known wrong answers."""
    return partial(make_hidden_table, exercise.name)
