"""Why no fair case refuses a mutant: by its name, or by the beginning of its name."""

from __future__ import annotations

#: Begin of a mutant's name to the reason; the longest that fits counts.
REASONS: dict[str, str] = {}


def get_reason(mutant: str) -> str:
    """Return why a mutant may pass, or ""."""
    fitting = [start for start in REASONS if mutant.startswith(start)]
    return REASONS[max(fitting, key=len)] if fitting else ""
