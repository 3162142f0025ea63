"""What happens to the ball in the cases of `control`: one loop each, drawn from a seed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from labutils.checks.loops.scenario import FOLLOWS, RECOVERS, SETTLES, Loop
from labutils.checks.table import Case

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np

#: What the head looks at first, in radians: pan and tilt of the scene's pose "home".
_HOME = (0.0, 0.52)


def make_loop_cases(rng: np.random.Generator, *, has_looks: bool = False) -> tuple[Case, ...]:
    """Make a loop for each thing that can happen to the ball and its pictures."""

    def draw(low: float, high: float) -> float:
        return round(float(rng.uniform(low, high)), 3)

    def seed() -> int:
        return int(rng.integers(1000))

    resting = (0.0, _HOME[0] - draw(0.15, 0.3), _HOME[1] + draw(-0.3, -0.12), draw(0.75, 1.0))
    hidden = (1.2, 1.2 + draw(0.6, 0.8))
    return (
        Case(
            "a ball that rests, off the middle",
            (Loop(1.8, ((SETTLES, 1.0, 1.8),), places=(resting,), has_looks=has_looks),),
        ),
        Case(
            "a ball that moves at 0.12 m/s, with noise",
            (Loop(3.0, ((FOLLOWS, 1.0, 3.0),), seed=seed(), speed=0.12, noise=draw(1.5, 3.0)),),
        ),
        Case(
            "a board before the ball for a while",
            (
                Loop(
                    hidden[1] + 2.0,
                    ((RECOVERS, hidden[1] + 1.0, hidden[1] + 2.0),),
                    seed=seed(),
                    speed=0.12,
                    hidden=(hidden,),
                ),
            ),
        ),
        Case(
            "pictures that are 0.1 s late",
            (Loop(3.0, ((FOLLOWS, 1.0, 3.0),), seed=seed(), speed=0.08, delay=2),),
        ),
        Case("a ball beyond the limits of pan and tilt, and back", (_make_far(draw),)),
        Case(
            "no depth where the ball is, after a second",
            (
                Loop(
                    3.0,
                    ((FOLLOWS, 1.0, 3.0),),
                    seed=seed(),
                    speed=0.12,
                    blind=((1.0, 3.0),),
                ),
            ),
        ),
    )


def _make_far(draw: Callable[[float, float], float]) -> Loop:
    """Make a ball that goes beyond both limits, stays there, and comes back."""
    away = 0.5
    near = (1.22, 0.84)
    far = (1.4 + draw(0.14, 0.2), 1.0 + draw(0.1, 0.15))
    back = (1.4 - draw(0.12, 0.2), 1.0 - draw(0.12, 0.2))
    places = ((0.0, *near, away), (0.6, *far, away), (2.6, *far, away), (2.9, *back, away))
    return Loop(4.6, ((RECOVERS, 3.9, 4.6),), places=places, neck=near)
