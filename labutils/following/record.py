"""What happened while the head followed the ball, and how well it did. Stands on NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from labutils._constants import FULL_WIDTH, NEAR_PX

if TYPE_CHECKING:
    from collections.abc import Sequence

#: The first second is for finding the ball, the second after a board for finding it again.
SETTLING_S = 1.0


class FollowingMoment(NamedTuple):
    """One command, and what was true when it was given."""

    time: float
    ball: np.ndarray
    pan: float
    tilt: float
    command: np.ndarray
    pixel: np.ndarray
    is_hidden: bool
    seen_time: float
    center: np.ndarray
    render_s: float = 0.0
    control_s: float = 0.0


class FollowingScore(NamedTuple):
    """How well the head followed.

    `mean_px` and `recovery_s` are NaN where nothing was to be measured, `center_mm` where the
    controller did not tell a center; `recovery_s` is infinite where it did not recover.
    """

    mean_px: float
    center_mm: float
    recovery_s: float
    command_rad: float


@dataclass(frozen=True)
class FollowingRecord:
    """What was true at each of N commands.

    Parameters
    ----------
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of the picture.
    time : ndarray, shape (N,)
        Seconds.
    ball : ndarray, shape (N, 3)
        The ball's center in the world, in meters.
    neck, command : ndarray, shape (N, 2)
        Pan and tilt, as they were and as they were commanded, in radians.
    pixel : ndarray, shape (N, 2)
        Where the ball's center is in a picture taken at that time; NaN behind the camera.
    is_hidden : ndarray, bool, shape (N,)
        Whether the board was before the ball.
    seen_time : ndarray, shape (N,)
        When the picture was taken that the controller saw.
    center : ndarray, shape (N, 3)
        Where the controller said the ball's center was at `seen_time`; NaN where it said nothing.
    render_s, control_s : ndarray, shape (N,)
        Seconds that drawing and deciding took on this machine.
    """

    K: np.ndarray
    time: np.ndarray
    ball: np.ndarray
    neck: np.ndarray
    command: np.ndarray
    pixel: np.ndarray
    is_hidden: np.ndarray
    seen_time: np.ndarray
    center: np.ndarray
    render_s: np.ndarray
    control_s: np.ndarray

    @classmethod
    def from_moments(cls, moments: Sequence[FollowingMoment], K: np.ndarray) -> FollowingRecord:
        """Put moments below each other."""

        def collect(values: list[object], *shape: int) -> np.ndarray:
            return np.array(values, dtype=np.float64).reshape(len(values), *shape)

        return cls(
            K=K,
            time=collect([one.time for one in moments]),
            ball=collect([one.ball for one in moments], 3),
            neck=collect([(one.pan, one.tilt) for one in moments], 2),
            command=collect([one.command for one in moments], 2),
            pixel=collect([one.pixel for one in moments], 2),
            is_hidden=np.array([one.is_hidden for one in moments], dtype=bool),
            seen_time=collect([one.seen_time for one in moments]),
            center=collect([one.center for one in moments], 3),
            render_s=collect([one.render_s for one in moments]),
            control_s=collect([one.control_s for one in moments]),
        )

    @property
    def error_px(self) -> np.ndarray:
        """How far the ball's center is from the middle of the picture, in pixels, (N,)."""
        return np.hypot(*(self.pixel - self.K[:2, 2]).T)

    @property
    def center_error_mm(self) -> np.ndarray:
        """How far the told center is from where the ball was in the picture, in mm, (N,)."""
        if not self.time.size:  # nothing to look between
            return np.empty(0)
        axes = [np.interp(self.seen_time, self.time, self.ball[:, axis]) for axis in range(3)]
        return 1000 * np.linalg.norm(self.center - np.stack(axes, axis=1), axis=1)

    @property
    def near_px(self) -> float:
        """What counts as near the middle: 15 of 640 pixels, and as much of any other width."""
        return NEAR_PX * float(2 * self.K[0, 2] + 1) / FULL_WIDTH

    @property
    def is_measured(self) -> np.ndarray:
        """When the head is due to follow: not while it finds the ball, bool (N,)."""
        lost = self.is_hidden.copy()
        for start in self._find_reveals():
            lost |= (self.time >= start) & (self.time < start + SETTLING_S)
        return ~lost & (self.time >= SETTLING_S - 1e-9)

    def get_score(self) -> FollowingScore:
        """Measure how well the head followed."""
        errors = self.error_px
        followed = errors[self.is_measured]
        located = self.center_error_mm[self.is_measured]
        located = located[np.isfinite(located)]
        return FollowingScore(
            mean_px=float(followed.mean()) if followed.size else float("nan"),
            center_mm=float(located.mean()) if located.size else float("nan"),
            recovery_s=self._get_recovery(errors),
            command_rad=float(np.abs(self.command).max()) if len(self.command) else float("nan"),
        )

    def _find_reveals(self) -> np.ndarray:
        """Return the times at which the board went away."""
        return self.time[1:][self.is_hidden[:-1] & ~self.is_hidden[1:]]

    def _get_recovery(self, errors: np.ndarray) -> float:
        """Return the longest time from a reveal until the ball is near the middle again."""
        needed = []
        for start in self._find_reveals():
            near = self.time[(self.time >= start) & (errors <= self.near_px)]
            needed.append(near[0] - start if near.size else np.inf)
        return float(max(needed, default=float("nan")))
