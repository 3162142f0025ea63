"""Measure how well a controller follows the ball, over several seeds and with the native renderer.

The bounds of the book are for a picture 640 wide: the ball at most 15 px from the middle on
average, its center located within 15 mm, and back within 15 px one second after a board has hidden
it. A smaller picture has as much less of the pixels.

Usage: ``python -m tools.measure.following_score [--seeds 5] [--width 640]``.
"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from labutils._constants import FULL_WIDTH, NEAR_PX
from labutils.following import FollowingLoop
from solutions.control import control as reference

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from labutils.following import FollowingScore

_SECONDS = 8.0
MAX_CENTER_MM, MAX_RECOVERY_S = 15.0, 1.0


def measure(control: Callable[..., object], seed: int, width: int) -> FollowingScore:
    """Let a controller follow the ball of a seed as the chapter does; return its score."""
    with FollowingLoop(width, width * 3 // 4, seed=seed) as loop:
        return loop.run(control, _SECONDS).get_score()


def is_within(score: FollowingScore, width: int) -> bool:
    """Tell whether a score keeps all bounds."""
    return (
        score.mean_px <= NEAR_PX * width / FULL_WIDTH
        and score.center_mm <= MAX_CENTER_MM
        and score.recovery_s <= MAX_RECOVERY_S
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a row per seed; return a shell's exit code: 1 where a bound is missed."""
    parser = argparse.ArgumentParser(description="Measure the reference of control.")
    parser.add_argument("--seeds", type=int, default=5, help="how many paths of the ball")
    parser.add_argument("--width", type=int, default=FULL_WIDTH, help="of the picture, in pixels")
    options = parser.parse_args(arguments)
    print("seed  mean px  center mm  recovery s  largest command rad")
    kept = True
    for seed in range(options.seeds):
        score = measure(reference, seed, options.width)
        kept &= is_within(score, options.width)
        print(
            f"{seed:4}  {score.mean_px:7.1f}  {score.center_mm:9.1f}  {score.recovery_s:10.2f}  "
            f"{score.command_rad:19.2f}"
        )
    print("all within the bounds" if kept else "a bound is missed")
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
