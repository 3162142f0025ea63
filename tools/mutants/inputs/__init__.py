"""Valid input per exercise: wide over what its statement allows, small, the same every time.

Two right answers have to agree on every draw. So what a statement leaves open does not occur: ties,
halves where the rounding is free, comparisons that the last digit of a number decides.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tools.mutants.inputs import clouds, following, loops, numbers, pictures, scenes, stereo

if TYPE_CHECKING:
    from collections.abc import Callable

#: Function that draws the arguments of a call, by the name of the exercise.
MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    **numbers.MAKERS,
    **pictures.MAKERS,
    **clouds.MAKERS,
    **scenes.MAKERS,
    **following.MAKERS,
    **loops.MAKERS,
    **stereo.MAKERS,
}

#: How many draws decide whether a mutant differs, and where one call takes long, how many.
DRAWS = 10_000
FEWER_DRAWS = {
    "render_camera": 100,
    "get_camera_intrinsics": 500,
    "rank_cameras": 500,
    "level_cloud": 150,
    "locate_ball": 1000,
    "ssd_disparity": 2000,
    "control": 12,
}

#: Seeds of hidden cases that a score is of, and for what acts in loops of seconds, how many.
SEEDS = 50
FEWER_SEEDS = {"control": 3}

_SEED = 20_260


def count_draws(name: str) -> int:
    """Return how many draws an exercise gets."""
    return FEWER_DRAWS.get(name, DRAWS)


def count_seeds(name: str) -> int:
    """Return the hidden cases of how many seeds are scored."""
    return FEWER_SEEDS.get(name, SEEDS)


def draw_input(name: str, number: int) -> tuple[Any, ...]:
    """Return the arguments of draw `number` of an exercise."""
    return MAKERS[name](np.random.default_rng((_SEED, number)))
