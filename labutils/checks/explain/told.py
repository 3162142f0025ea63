"""What an explanation is."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Explanation:
    """What is told of a difference, and its short name."""

    name: str
    text: str

    def say(self) -> str:
        """Return the paragraph of a verdict."""
        return f"Seen: {self.text}"
