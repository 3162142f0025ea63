"""What can be told of the values at the place where code stopped. Nothing here is guessed."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from labutils.checks.exceptions.site import UNKNOWN

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from labutils.checks.exceptions.site import Site

#: Tries to explain one thing; "" where that is not what happened.
Step: TypeAlias = "Callable[[Site], str]"

#: Says the sentence for an exception whose text matched; "" where there is nothing to say.
Say: TypeAlias = "Callable[[Site, re.Match[str]], str]"


@dataclass(frozen=True)
class Rule:
    """Which exceptions a sentence is for: a kind, by name, and a pattern in its text.

    ``say`` is a function, or a sentence with ``{0}``, ``{1}`` for the groups of the pattern.
    """

    kind: str
    pattern: str
    say: Say | str

    def explain(self, site: Site, text: str) -> str:
        """Return the sentence, or nothing."""
        if self.kind not in (kind.__name__ for kind in type(site.error).__mro__):
            return ""
        found = re.search(self.pattern, text, re.DOTALL)
        if found is None:
            return ""
        if isinstance(self.say, str):
            return self.say.format(*found.groups())
        return self.say(site, found)


def take_first(site: Site, steps: Iterable[Step]) -> str:
    """Return the first sentence that one of the steps has."""
    return next(filter(None, (step(site) for step in steps)), "")


def join(words: Iterable[str], last: str = "and") -> str:
    """Join words as in a sentence: a, b and c."""
    *first, end = words
    return f"{', '.join(first)} {last} {end}" if first else end


def find_close(name: str, names: Iterable[str], count: int = 2) -> list[str]:
    """Return names that are spelled nearly so; other capitals first."""
    return _find_close(name, tuple(sorted(set(names) - {name})), count)


@lru_cache(maxsize=32)  # OpenCV has thousands of names, and every case stops for the same one
def _find_close(name: str, known: tuple[str, ...], count: int) -> list[str]:
    same = [one for one in known if one.lower() == name.lower()]
    return same or get_close_matches(name, known, n=count, cutoff=0.76)


def name_type(value: object) -> str:
    """Say what something is, in words a learner uses."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    if value is None:
        return "None"
    if callable(value) and not isinstance(value, type):
        return "a function"
    words = {
        "str": "a text (str)",
        "int": "a whole number (int)",
        "float": "a number (float)",
        "bool": "True or False (bool)",
        "module": "a module",
    }
    name = type(value).__name__
    return words.get(name, f"a {name}")


def tell_none(site: Site, node: ast.AST | None) -> str:
    """Say where a None came from, as far as that is certain."""
    shown = site.show(node)
    if isinstance(node, ast.Call):
        called = site.show(node.func)
        if called.endswith(".imread"):
            return f"{called}() returned None: that is how it says that it cannot read the file."
        return f"{called}() returned None." if called else ""
    if not shown or isinstance(node, ast.Constant) or site.get_value(node) is not None:
        return ""
    if site.is_argument(node):
        return f"{shown} is None in this case: ask for that first (if {shown} is None)."
    origin = site.find_origin(shown) if isinstance(node, ast.Name) else None
    if origin:
        return f"{shown} is None: that is what {origin[1]}() returned in line {origin[0]}."
    return f"{shown} is None here: it has to get a value before this line."


def list_arrays(site: Site) -> list[tuple[str, np.ndarray]]:
    """List the arrays that the failed expression names."""
    values = site.find_values()
    return [(site.show(node), value) for node, value in values if isinstance(value, np.ndarray)]


def tell_shapes(site: Site, shapes: Iterable[tuple[int, ...]] | None = None) -> str:
    """Say which names of the expression have which shapes; only the given shapes, if any."""
    arrays = list_arrays(site)
    if shapes is not None:
        wanted = set(shapes)
        arrays = [(name, array) for name, array in arrays if array.shape in wanted]
    return join(f"{name} has shape {array.shape}" for name, array in arrays[:3]) if arrays else ""


def tell_nine(site: Site) -> str:
    """Say which array of the expression is a flat 3x3 matrix."""
    for node, value in site.find_values():
        if isinstance(value, np.ndarray) and value.shape == (9,):
            if isinstance(node, ast.Attribute) and node.attr == "T":  # of nine numbers: the same
                node = node.value  # noqa: PLW2901
            name = site.show(node)
            where = " in this case" if site.is_argument(node) else " here"
            return f"{name} holds nine numbers{where}: {name}.reshape(3, 3) makes them a matrix."
    return ""


def tell_empty(site: Site) -> str:
    """Say what is empty: in the expression, and among the arguments of the case."""
    texts = []
    for node, value in site.find_values():
        if _is_empty(value) and not site.is_argument(node):
            texts.append(f"{site.show(node)} is empty here")
            break
    for name, value in site.call.arguments.items():
        if _is_empty(value):
            texts.append(f"{name} is empty in this case")
        elif _is_blank(value):
            texts.append(f"{name} has no marked pixel in this case")
    return f"{join(texts)}: decide what to return then, before this line." if texts else ""


def _is_empty(value: object) -> bool:
    if isinstance(value, np.ndarray):
        return value.size == 0
    return type(value) in (list, tuple, dict, str) and not value


def _is_blank(value: object) -> bool:
    """Tell whether a value is a mask in which nothing is marked."""
    if not isinstance(value, np.ndarray) or value.ndim != 2 or value.dtype.kind not in "bu":
        return False
    return not value.any()


def find_value(site: Site, test: Callable[[Any], bool]) -> tuple[str, Any] | None:
    """Return the first name or field of the expression whose value passes a test."""
    return next(
        ((site.show(node), value) for node, value in site.find_values() if test(value)), None
    )


def get_child(site: Site, name: str) -> ast.expr | None:
    """Return a part of the expression that failed: func, value, left, ..."""
    child = getattr(site.node, name, None)
    return child if isinstance(child, ast.expr) else None


def holds(site: Site, name: str) -> Any:
    """Return what a part of the expression that failed held."""
    return site.get_value(get_child(site, name)) if site.node is not None else UNKNOWN
