"""Challenge of Following: FILL: what it asks for, in a few words."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Case, Exercise, Misconception, Part, asked, given


def locate_ball(mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> Any:
    """FILL: one sentence that says what comes back.

    FILL: what a learner has to know: what counts, in which order.

    Parameters
    ----------
    mask : FILL: dtype, shape
        FILL: what it holds, with its unit.
    depth : FILL: dtype, shape
        FILL: what it holds, with its unit.
    K : FILL: dtype, shape
        FILL: what it holds, with its unit.
    radius : FILL: dtype, shape
        FILL: what it holds, with its unit.

    Returns
    -------
    FILL: dtype, shape
        FILL: what it holds, with its unit.
    """
    raise NotImplementedError("FILL: the right answer")


def _answer_with(mistakes: frozenset[str], mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> Any:
    raise NotImplementedError("FILL: answer with these mistakes; without any, as the reference")


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    raise NotImplementedError("FILL: two cases and more, each a Case of a label and arguments")


EXERCISE = Exercise(
    name="locate_ball",
    title="FILL: what the learner does, in a few words",
    chapter="following",
    place=1,
    points=0,
    # FILL: the next line: the label of the section to read again
    section="following-first",
    # FILL: the next line: the objectives it practices
    objectives=("7a",),
    reference=locate_ball,
    answer_with=_answer_with,
    # FILL: the next line: what comes back, one Part each; see Part for the kinds
    parts=(Part("result", "number", "float", atol=1e-3),),
    tolerance_reason="FILL: why the tolerance is neither tighter nor wider",
    misconceptions=(
        Misconception(
            # FILL: the next line: a name in-small-letters; a card has 4 mistakes or more
            "first",
            "FILL: what was done and what to do, 40 to 176 characters, with a full stop.",
        ),
        Misconception(
            # FILL: the next line: a name in-small-letters
            "second",
            "FILL: what was done and what to do, 40 to 176 characters, with a full stop.",
        ),
        Misconception(
            # FILL: the next line: a name in-small-letters
            "third",
            "FILL: what was done and what to do, 40 to 176 characters, with a full stop.",
        ),
        Misconception(
            # FILL: the next line: a name in-small-letters
            "fourth",
            "FILL: what was done and what to do, 40 to 176 characters, with a full stop.",
        ),
    ),
    hints=(
        "FILL: the first hint, a question that leads on",
        "FILL: the second hint, more direct",
        "FILL: the third hint, everything but the code",
    ),
    # FILL: the next line: 1 to 6 lines that call it with the names of the page and show the result
    example="show(locate_ball(mask, depth, K, radius))",
    contract=(
        # FILL: the next line: a row for each sentence that a learner reads; see solutions/_contract.py
        asked("all-of-it", "all of it", "every case"),
    ),
    visible=lambda: _make_cases(np.random.default_rng(1138)),
    hidden=_make_cases,
)
