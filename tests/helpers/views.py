"""Find the views of all explorers."""

from __future__ import annotations

from labutils import explorers
from labutils.explorers._base import View


def find_view_classes() -> list[type[View]]:
    """List the views that the explorers show; what they have in common is none."""
    return [one for one in _find_below(View) if _is_shown(one)]


def _is_shown(view_class: type[View]) -> bool:
    package, _, module = view_class.__module__.rpartition(".")
    return package == explorers.__name__ and not module.startswith("_")


def _find_below(view_class: type[View]) -> list[type[View]]:
    return [one for child in view_class.__subclasses__() for one in (child, *_find_below(child))]
