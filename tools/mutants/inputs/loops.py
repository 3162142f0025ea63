"""Valid loops for what acts: the ball as fast, and pictures as noisy, as a statement allows."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solutions._loop_cases import make_loop_cases

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np


def _control(rng: np.random.Generator) -> tuple[Any, ...]:
    cases = make_loop_cases(rng)
    loop = cases[int(rng.integers(len(cases)))].args[0]
    speed = round(loop.speed * float(rng.uniform(0.3, 1.0)), 3)
    return (replace(loop, speed=speed, noise=round(float(rng.uniform(0.0, 3.0)), 2)),)


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {"control": _control}
