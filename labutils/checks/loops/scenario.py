"""What happens to the ball while a controller acts: one `Loop` is one case."""

from __future__ import annotations

from dataclasses import astuple, dataclass, replace
from typing import Any, ClassVar

from labutils._constants import COMMAND_S

#: Seconds from one call to the next.
DT = COMMAND_S

#: The properties that a stretch of time is measured for.
SETTLES, FOLLOWS, RECOVERS = "settles", "follows", "recovers"


@dataclass(frozen=True)
class Loop:
    """A following loop that the arguments of a controller come from, call by call.

    Kept as numbers, so that no table needs MuJoCo.

    Parameters
    ----------
    seconds : float
        How long it runs.
    windows : tuple of (str, float, float)
        Which property is measured from when to when.
    seed : int
        Of the ball's path and of the noise.
    speed : float
        Of the ball on the path of its seed, in m/s.
    places : tuple of (float, float, float, float)
        Another path: at so many seconds, at this pan and tilt as the eye sees it, so many meters
        away. Between two places it moves evenly; behind the last it rests.
    delay, noise, hidden
        As in `labutils.following.FollowingLoop`.
    blind : tuple of (float, float)
        From when to when depth holds nothing where the ball is.
    neck : tuple of float
        Pan and tilt at the start; empty for those of the scene.
    has_looks : bool
        Whether single pictures are shown afterwards, to tell one mistake from another.
    """

    seconds: float
    windows: tuple[tuple[str, float, float], ...]
    seed: int = 0
    speed: float = 0.0
    places: tuple[tuple[float, float, float, float], ...] = ()
    delay: int = 1
    noise: float = 0.0
    hidden: tuple[tuple[float, float], ...] = ()
    blind: tuple[tuple[float, float], ...] = ()
    neck: tuple[float, ...] = ()
    has_looks: bool = False

    #: The arguments that are made from it.
    gives: ClassVar[tuple[str, ...]] = ("rgb", "depth", "K", "state")

    def to_looks(self) -> Loop:
        """Return a loop of one call, with the same single pictures: all that names a mistake."""
        return replace(self, seconds=DT, windows=(), places=self.places[:1])

    def to_words(self) -> list[Any]:
        """Write it as JSON can hold it."""
        return list(astuple(self))

    @classmethod
    def from_words(cls, words: list[Any]) -> Loop:
        """Undo `to_words`: JSON knows lists only."""
        return cls(*map(_freeze, words))


def _freeze(value: Any) -> Any:
    return tuple(map(_freeze, value)) if isinstance(value, list | tuple) else value
