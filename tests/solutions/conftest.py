"""What the tests of the cards share: the shipped tables, and a verdict without a record of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labutils.checks.table import load_table
from solutions import load_exercises

NAMES = tuple(load_exercises())


@pytest.fixture(params=NAMES)
def exercise(request):
    return load_exercises()[request.param]


@pytest.fixture
def table(exercise):
    return load_table(exercise.name)


@pytest.fixture
def hidden_table(exercise, table):
    """Return a function: seed to a table of the hidden cases, without known wrong answers."""

    def make(seed):
        cases = exercise.hidden(np.random.default_rng(seed))
        expected = exercise.collect(exercise.reference, cases)
        return replace(table, cases=cases, expected=expected, wrong={})

    return make
