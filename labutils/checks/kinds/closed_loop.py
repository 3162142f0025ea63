"""The kind of answers that act: right is what keeps the properties of a closed loop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from labutils.checks.kinds.base import Kind
from labutils.checks.kinds.plots import draw_commands, draw_errors
from labutils.checks.loops.scenario import FOLLOWS, RECOVERS, SETTLES
from labutils.checks.loops.trace import (
    BOUND_PX,
    LIMITS,
    PROPERTIES,
    SLACK_RAD,
    Column,
    classify,
    find_failing,
    read_properties,
)

if TYPE_CHECKING:
    from labutils.checks.table import Part
    from labutils.checks.verdict import PanelPicture

_WORDS = {
    SETTLES: "The ball rests, and after the first second it is still {off}",
    FOLLOWS: "The ball moves, and on average it is {off}",
    RECOVERS: "The ball is back, and a second later it is {off}",
}
#: Half the width of the picture: what is farther from the middle is not seen.
_OUT_OF_SIGHT_PX = 320


@dataclass(frozen=True, kw_only=True)
class ClosedLoop(Kind):
    """A trace of what a controller did.

    Its canonical form has an entry per property, 1 where it holds, and the classes of single looks.
    An entry that is NaN in what is due, or in a known wrong answer, agrees with anything: what is
    due is every property, and a known mistake is known by its looks.
    """

    is_elementwise: ClassVar[bool] = False
    has_sizes: ClassVar[bool] = False
    is_repeatable: ClassVar[bool] = False
    properties: ClassVar[tuple[str, ...]] = PROPERTIES

    def to_canonical(self, value: np.ndarray) -> np.ndarray:
        """Read the properties and looks of a trace; what is read already stays."""
        return classify(value) if value.ndim > 1 else value

    def make_due(self, value: np.ndarray) -> np.ndarray:
        """Ask for every property that was measured, and for no look."""
        due = self.to_canonical(value).copy()
        due[len(PROPERTIES) :] = np.nan
        return due

    def make_known(self, value: np.ndarray) -> np.ndarray:
        """Know a mistake by its looks, whichever properties it costs."""
        known = self.to_canonical(value).copy()
        known[: len(PROPERTIES)] = np.nan
        return known

    def get_differences(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
        """Return 1 where an entry that is asked for differs."""
        del part
        due, found = self.to_canonical(expected), self.to_canonical(yours)
        return (~np.isnan(due) & (due != found)).astype(np.float64)

    def find_property(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Name the first property that does not hold."""
        found = find_failing(yours) if yours.ndim > 1 else ""
        return found or super().find_property(part, expected, yours)

    def describe_shape(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Say nothing: how long a trace is, is no answer of the learner's."""
        del part, expected, yours
        return ""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell how far off it is: the bound stands in the statement."""
        del part, expected, wrong
        failing = find_failing(yours) if yours.ndim > 1 else ""
        if not failing:
            return "This is the trace of another loop."
        if failing == LIMITS:
            return _describe_commands(yours)
        found = read_properties(yours)[failing]
        off = f"{found:.0f} px from the middle" if found < _OUT_OF_SIGHT_PX else "out of sight"
        return f"{_WORDS[failing].format(off=off)}; up to {BOUND_PX:.0f} of 640 are allowed."

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        """Draw the commands where they leave their limits, else the error over time."""
        del expected
        if yours.ndim < 2:
            return None
        draw = draw_commands if find_failing(yours) == LIMITS else draw_errors
        return draw(part.name, yours)


def _describe_commands(trace: np.ndarray) -> str:
    """Say what is wrong with commands that the neck cannot follow."""
    beyond = trace[:, Column.BEYOND]
    number = int(np.argmax(beyond > SLACK_RAD)) + 1
    if not np.isfinite(beyond).all():
        return f"Call {len(trace)} of the loop answers with a number that is not finite."
    count = int((beyond > SLACK_RAD).sum())
    return (
        f"{count} of {len(trace)} commands lie beyond state.limits, the first in call {number}; "
        f"the furthest by {beyond.max():.2g} rad."
    )


KINDS = (
    ClosedLoop(
        name="closed-loop",
        ndim=2,
        shape="two numbers",
        relations=(),
    ),
)
