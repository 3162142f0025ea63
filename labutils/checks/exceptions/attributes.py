"""Sentences for what a value does not have: AttributeError and KeyError."""

from __future__ import annotations

import math
import re
import sys
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.exceptions.facts import Rule, find_close, get_child, holds, join, tell_none
from labutils.checks.exceptions.site import UNKNOWN, is_quiet
from labutils.checks.exceptions.tutorials import INSTEAD

if TYPE_CHECKING:
    from labutils.checks.exceptions.site import Site


def _explain_attribute(site: Site, found: re.Match[str]) -> str:
    del found
    name, owner = _get_attribute(site)
    if owner is None and "NoneType" in str(site.error):
        return tell_none(site, get_child(site, "value"))
    if not name or owner is UNKNOWN:
        return ""
    shown = site.show(get_child(site, "value"))
    steps = (_tell_instead, _tell_missing_function, _tell_not_called, _tell_array, _tell_field)
    return next(filter(None, (step(owner, shown, name) for step in steps)), "")


def _tell_instead(owner: object, shown: str, name: str) -> str:
    text = INSTEAD.get(_name_owner(owner), {}).get(name, "")
    if shown.isidentifier() and not isinstance(owner, ModuleType):
        text = re.sub(r"\bx\b", shown, text)
    return f"What exists instead: {text}." if text else ""


def _tell_not_called(owner: object, shown: str, name: str) -> str:
    del name
    kinds = ("function", "builtin_function_or_method", "method")
    return f"{shown} is a function: () after it calls it." if _name_owner(owner) in kinds else ""


def _tell_array(owner: object, shown: str, name: str) -> str:
    """Say of a list or a number that it is no array."""
    kind = type(owner).__name__
    words = {"list": "a list", "tuple": "a tuple", "int": "a number", "float": "a number"}
    if kind not in words or not hasattr(np.ndarray, name):
        return ""
    return f"{shown or 'It'} is {words[kind]}; .{name} belongs to arrays (np.asarray makes one)."


def _tell_field(owner: object, shown: str, name: str) -> str:
    if isinstance(owner, np.ndarray) and callable(getattr(np, name, None)):
        return f"Arrays have no .{name}, but NumPy has np.{name}({shown or 'x'})."
    if others := find_close(name, _list_public(owner)):
        return f"{shown or 'It'} has {join(others)}."
    return ""


def _get_attribute(site: Site) -> tuple[str, object]:
    """Return the missing name and what lacks it; UNKNOWN where that is not told."""
    error = site.error
    name, owner = getattr(error, "name", None) or "", getattr(error, "obj", UNKNOWN)
    if name:
        return name, owner if is_quiet(owner) else UNKNOWN
    # NumPy explains names that it dropped, and then the exception holds neither name nor object
    found = re.match(r"module '([\w.]+)' has no attribute '(\w+)'", str(error))
    return (found[2], sys.modules.get(found[1], UNKNOWN)) if found else ("", UNKNOWN)


def _name_owner(owner: object) -> str:
    if isinstance(owner, ModuleType):
        return owner.__name__
    kind = owner.__name__ if isinstance(owner, type) else type(owner).__name__
    return "Renderer" if kind == "RaycastRenderer" else kind


def _list_public(owner: object) -> list[str]:
    return [name for name in dir(owner) if name[0] != "_"]


def _tell_missing_function(owner: object, shown: str, name: str) -> str:
    """Say what a module has instead of a function."""
    if not isinstance(owner, ModuleType):
        return ""
    shown = shown or owner.__name__
    names = _list_public(owner)
    found = [f"mj_{name}"] if f"mj_{name}" in names else []
    for part in ("linalg", "random"):
        if callable(getattr(getattr(owner, part, None), name, None)):
            found = [f"{part}.{name}"]
    if found := found or find_close(name, names):
        return f"What exists instead: {join((f'{shown}.{one}' for one in found), 'or')}."
    if owner.__name__ == "cv2" and name in ("imshow", "waitKey", "destroyAllWindows"):
        instead = " labutils.show(picture) shows a picture." if name == "imshow" else ""
        return f"This OpenCV opens no windows: leave out {name}.{instead}"
    if owner is math and callable(getattr(np, name, None)):
        return f"{shown} has no {name}, NumPy has: np.{name}."
    return ""


def _explain_key(site: Site, found: re.Match[str]) -> str:
    del found
    known = holds(site, "value")
    key = site.error.args[0] if site.error.args else None
    if type(known) is not dict or not isinstance(key, str):
        return ""
    names = [name for name in known if isinstance(name, str)]
    shown = site.show(get_child(site, "value")) or "The dict"
    if others := find_close(key, names):
        return f"{shown} has {join(map(repr, others))}."
    if not names:
        return f"{shown} is empty here."
    more = "" if len(names) <= 6 else f", and {len(names) - 6} more"
    return f"Its keys are {', '.join(map(repr, names[:6]))}{more}."


def _explain_scene_name(site: Site, found: re.Match[str]) -> str:
    name, names = found[1], re.findall(r"'([^']*)'", found[2])
    if site.call.raises:
        return (
            f"The model has no {name}, and that is what this case is about: look whether the name "
            f"exists, and raise {site.call.raises} yourself."
        )
    if others := find_close(name, names):
        return f"The model has {join(others)}."
    return f"The model has {', '.join(names[:4])}." if names else "The model has none at all."


RULES = (
    Rule("AttributeError", "", _explain_attribute),
    Rule("KeyError", r"Invalid name '([^']*)'. Valid names: \[(.*)\]", _explain_scene_name),
    Rule("KeyError", "", _explain_key),
)
