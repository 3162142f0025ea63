"""Sentences for names that stand for nothing: NameError and what cannot be imported."""

from __future__ import annotations

import ast
import builtins
import sys
from importlib.util import find_spec
from pkgutil import iter_modules
from types import ModuleType
from typing import TYPE_CHECKING

from labutils.checks.exceptions.facts import Rule, find_close, join

if TYPE_CHECKING:
    import re

    from labutils.checks.exceptions.site import Site

#: A name to the line that brings it, where there is more than `import name`.
_IMPORTS = {
    "np": "import numpy as np",
    "cv": "import cv2 as cv",
    "mj": "import mujoco as mj",
    "plt": "import matplotlib.pyplot as plt",
    "lab": "import labutils as lab",
    "o3d": "import open3d as o3d",
    "Path": "from pathlib import Path",
    "deque": "from collections import deque",
    "defaultdict": "from collections import defaultdict",
    "Counter": "from collections import Counter",
}
_MODULES = (
    "collections",
    "copy",
    "cv2",
    "functools",
    "itertools",
    "json",
    "labutils",
    "math",
    "mujoco",
    "numpy",
    "os",
    "random",
    "re",
    "sys",
    "time",
)

#: Python's words of other languages.
_SPELLINGS = {
    "true": "True",
    "false": "False",
    "none": "None",
    "null": "None",
    "NULL": "None",
    "nil": "None",
}

#: Packages by names that they are not imported by.
_PACKAGES = {
    "cv": 'OpenCV is imported by "import cv2".',
    "opencv": 'OpenCV is imported by "import cv2".',
    "np": 'NumPy is imported by "import numpy as np".',
    "mujoco_py": 'mujoco_py is an older package: MuJoCo itself is imported by "import mujoco".',
}

#: Libraries whose functions are called by their bare name: what they are, and how to call them.
_LIBRARIES = (("NumPy", "np", "numpy"), ("OpenCV", "cv2", "cv2"), ("MuJoCo", "mujoco", "mujoco"))
_CONSTANTS = ("pi", "nan", "inf")


def _explain_name(site: Site, found: re.Match[str]) -> str:
    name = found[1]
    steps = (_tell_spelling, _tell_import, _tell_library, _tell_close, _tell_outside, _tell_builtin)
    text = next(filter(None, (step(site, name) for step in steps)), "")
    return text or (
        f"Nothing is called {name} here: give it a value in a line before, or correct its name."
    )


def _tell_spelling(site: Site, name: str) -> str:
    if name in _SPELLINGS:
        return f"Python spells it {_SPELLINGS[name]}."
    if name == "sim" and {"model", "data"} <= site.list_names():
        return "sim belongs to the older package mujoco_py; here there are model and data."
    return ""


def _tell_import(site: Site, name: str) -> str:
    line = _IMPORTS.get(name) or (f"import {name}" if name in _MODULES else "")
    if not line:
        return ""
    package = line.split()[1].partition(".")[0]
    for other in site.list_names():
        value = None if site.frame is None else site.frame.f_globals.get(other)
        if isinstance(value, ModuleType) and value.__name__ == package:
            return f"{package} is imported under the name {other} here: write {other}."
    if not _is_installed(package):
        return f"Nothing is called {name} here, and {package} is not installed in this Python."
    return f'It is not imported: put "{line}" at the top of your code.'


def _is_installed(package: str) -> bool:
    try:
        return find_spec(package) is not None
    except (ImportError, ValueError):
        return False


def _tell_library(site: Site, name: str) -> str:
    """Find a function that is called there, or a constant, in a library."""
    calls = [node for node in site.walk_statement() if isinstance(node, ast.Call)]
    called = any(isinstance(node.func, ast.Name) and node.func.id == name for node in calls)
    if not called and name not in _CONSTANTS:
        return ""
    for title, short, package in _LIBRARIES:
        if name in vars(sys.modules.get(package) or builtins) and package in sys.modules:
            return f"{title} has it: write {short}.{name}."
    if name in getattr(sys.modules.get("labutils"), "__all__", ()):
        return f'labutils has it: "from labutils import {name}".'
    return ""


def _tell_close(site: Site, name: str) -> str:
    others = find_close(name, site.list_names())
    return f"Nothing is called {name} here; there is {join(others)}." if others else ""


def _tell_outside(site: Site, name: str) -> str:
    """Say which function, further out in the same code, has a value of that name."""
    frame = site.frame
    while frame is not None and site.frame is not None:
        code = frame.f_code
        is_own = code.co_filename == site.frame.f_code.co_filename
        if is_own and name in frame.f_locals and code.co_name.isidentifier():
            return f"{name} belongs to the function {code.co_name}: hand it on as an argument."
        frame = frame.f_back
    return ""


def _tell_builtin(site: Site, name: str) -> str:
    del site
    others = find_close(name, [one for one in vars(builtins) if one[0] != "_"])
    return f"Nothing is called {name} here; Python has {join(others)}." if others else ""


def _explain_unbound(site: Site, found: re.Match[str]) -> str:
    name = found[1]
    if site.frame is not None and name in site.frame.f_globals:
        return (
            f"The function gives {name} a value, so it is another {name} than the one outside: "
            "give it one before this line, or choose a new name."
        )
    return (
        f"{name} has no value at this line: give it one on every way that leads here, also past an "
        "if or a loop that is skipped."
    )


def _explain_module(site: Site, found: re.Match[str]) -> str:
    name = found[1]
    if name in _PACKAGES:
        return _PACKAGES[name]
    parent, _, last = name.rpartition(".")
    if parent in sys.modules:
        paths = getattr(sys.modules[parent], "__path__", ())
        others = find_close(last, [one.name for one in iter_modules(paths)])
        return f"{parent} has {join(others)}." if others else ""
    if others := find_close(name, (*_MODULES, *sys.stdlib_module_names), 1):
        return f"There is no {name} here; there is {others[0]}."
    root = name.partition(".")[0]
    end = " What the starter imports is enough." if site.call.arguments else ""
    return f"{root} is not installed in the Python that runs this.{end}"


def _explain_from(site: Site, found: re.Match[str]) -> str:
    del site
    name, package = found.groups()
    module = sys.modules.get(package)
    others = [] if module is None else find_close(name, dir(module))
    return f"{package} has {join(others)}." if others else ""


RULES = (
    Rule("UnboundLocalError", r"variable '(\w+)'", _explain_unbound),
    Rule("NameError", r"free variable '(\w+)'", _explain_unbound),
    Rule("NameError", r"name '(\w+)' is not defined", _explain_name),
    Rule("ModuleNotFoundError", r"No module named '([\w.]+)'", _explain_module),
    Rule("ImportError", r"cannot import name '(\w+)' from '([\w.]+)'", _explain_from),
)
