"""What a card makes of answers before they are frozen."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from labutils.checks.kinds import get_kind
from labutils.checks.loops.scenario import Loop
from labutils.checks.table import Case, Misfit, Outcome, Part, Raised


def change(
    parts: tuple[Part, ...], outcome: Outcome, method: Literal["make_due", "make_known"]
) -> Outcome:
    """Let the kind of each part change its value."""
    if not isinstance(outcome, tuple):
        return outcome
    return tuple(
        None if value is None else getattr(get_kind(part), method)(value)
        for part, value in zip(parts, outcome, strict=True)
    )


def shorten(case: Case) -> Case:
    """Leave of a loop what names a mistake; how it ends differs from controller to controller."""
    return replace(case, args=tuple(a.to_looks() if isinstance(a, Loop) else a for a in case.args))


def round_outcome(outcome: Outcome) -> Outcome:
    """Leave out what differs between machines: frozen bytes have to be the same on all.

    Numbers are rounded to a millionth, for the last digit depends on the processor. Of errors the
    words go that no comparison reads: they differ between versions of Python.
    """
    if isinstance(outcome, Raised):
        return Raised(outcome.kind, outcome.text if outcome.kind == "TypeError" else "")
    if isinstance(outcome, Misfit):
        return outcome
    return tuple(
        value
        if value is None or value.dtype.kind != "f"
        # Adding zero turns -0.0 into 0.0; np.asarray keeps a single number an array.
        else np.asarray(np.round(value.astype(np.float64), 6) + 0.0, dtype=value.dtype)
        for value in outcome
    )
