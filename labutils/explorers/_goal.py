"""What a reader is to reach in an explorer, measured by values that its view tells."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping


@dataclass(frozen=True)
class GoalPart:
    """A value, and the limits it has to lie in.

    Parameters
    ----------
    value : str
        Its name in `View.compute`, and among the values the JavaScript tells.
    name : str
        What the reader calls it.
    low, high : float, optional
        Both included; at least one of the two.
    unit : str
        Written directly behind the number, so usually with a space in front.
    digits : int
        Behind the decimal point.
    scale : float, optional
        How far outside the limits the bar is empty; by default as far as at first.
    """

    value: str
    name: str
    low: float | None = None
    high: float | None = None
    unit: str = ""
    digits: int = 2
    scale: float | None = None

    def __post_init__(self) -> None:
        if self.low is None and self.high is None:
            raise ValueError(f"{self.name}: expected low, high or both, got neither")
        if self.low is not None and self.high is not None and self.low > self.high:
            raise ValueError(f"{self.name}: expected low <= high, got {self.low} and {self.high}")
        if self.scale is not None and self.scale <= 0:
            raise ValueError(f"{self.name}: expected a scale above 0, got {self.scale}")

    def holds(self, values: Mapping[str, Any]) -> bool:
        """Say whether the value lies in its limits; None lies nowhere."""
        value = values[self.value]
        if value is None:
            return False
        low = -math.inf if self.low is None else self.low
        high = math.inf if self.high is None else self.high
        return low <= float(value) <= high


@dataclass(frozen=True)
class Goal:
    """An aim in one sentence, and the parts that all have to hold.

    The view draws it below its picture: how far each part is, and that all hold. Give it to
    `Explorer.goal`; None there takes the goal away.
    """

    text: str
    parts: tuple[GoalPart, ...]

    def __init__(self, text: str, *parts: GoalPart) -> None:
        if not parts:
            raise ValueError("parts: expected at least one, got none")
        object.__setattr__(self, "text", text)
        object.__setattr__(self, "parts", parts)

    def holds(self, values: Mapping[str, Any]) -> bool:
        """Say whether values, as `View.compute` gives them, reach the goal."""
        return all(part.holds(values) for part in self.parts)

    def to_trait(self) -> dict[str, Any]:
        """Return what the view reads."""
        return {"text": self.text, "parts": [asdict(part) for part in self.parts]}

    @classmethod
    def from_trait(cls, trait: Mapping[str, Any]) -> Goal | None:
        """Read back what `to_trait` wrote; an empty one is no goal."""
        if not trait:
            return None
        return cls(trait["text"], *(GoalPart(**part) for part in trait["parts"]))
