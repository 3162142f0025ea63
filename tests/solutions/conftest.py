"""What the tests of the cards share: the shipped tables, and a verdict without a record of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from labutils.checks.table import CheckTable, load_table
from solutions import load_exercises
from solutions._model import Exercise

NAMES = tuple(load_exercises())


@pytest.fixture(params=NAMES)
def exercise(request: pytest.FixtureRequest) -> Exercise:
    return load_exercises()[request.param]


@pytest.fixture
def table(exercise: Exercise) -> CheckTable:
    return load_table(exercise.name)


@pytest.fixture
def hidden_table(exercise: Exercise, table: CheckTable) -> Callable[[int], CheckTable]:
    """Return a function: seed to a table of the hidden cases, without known wrong answers."""

    def make(seed: int) -> CheckTable:
        cases = exercise.hidden(np.random.default_rng(seed))
        expected = exercise.collect(exercise.reference, cases)
        return replace(table, cases=cases, expected=expected, wrong={})

    return make
