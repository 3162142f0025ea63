"""The hidden cases of an exercise as a table, for whoever asks whether an answer passes them."""

from __future__ import annotations

from functools import cache

import numpy as np

from labutils.checks.table import CheckTable, load_table
from solutions import load_exercises


@cache
def make_hidden_table(name: str, seed: int) -> CheckTable:
    """Make the table of one seed: its cases and the answers due."""
    exercise = load_exercises()[name]
    cases = exercise.hidden(np.random.default_rng(seed))
    expected = exercise.collect_due(cases)
    return load_table(name).with_cases(cases, expected)
