"""Sentences for what is indexed, counted and gone through: TypeError and IndexError."""

from __future__ import annotations

import ast
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.exceptions.facts import (
    Rule,
    get_child,
    holds,
    list_arrays,
    tell_empty,
    tell_nine,
)

if TYPE_CHECKING:
    import re

    from labutils.checks.exceptions.site import Site

_WHOLE = (
    "/ always gives floats, even of whole numbers: // keeps them whole, int(...) cuts the rest off."
)
_NUMBERS = ("int", "float", "bool")

#: Functions of Python that go through the items of what they get.
_GOES_THROUGH = ("enumerate", "list", "map", "max", "min", "sorted", "sum", "tuple", "zip", "set")


def _explain_index_of(site: Site, found: re.Match[str]) -> str:
    """Say what is indexed although it has no items."""
    kind = found[1]
    shown = site.show(get_child(site, "value")) or "It"
    if "func" in kind.lower() or kind == "method":
        return f"{shown} is a function: round brackets ( ) call it."
    if kind.startswith(_NUMBERS):
        return f"{shown} is a single number: it has no items to choose from with [ ]."
    return ""


def _explain_length(site: Site, found: re.Match[str]) -> str:
    node = site.node
    shown = site.show(node.args[0]) if isinstance(node, ast.Call) and node.args else ""
    if not found[1].startswith(_NUMBERS):
        return ""
    return f"{shown or 'It'} is a single number: it has no length."


def _explain_iteration(site: Site, found: re.Match[str]) -> str:
    kind = found[1]
    loop = site.statement.iter if isinstance(site.statement, ast.For) else None
    node = site.node or loop
    if not kind.startswith(_NUMBERS) or node is None:
        return ""
    if isinstance(node, ast.Call):
        called = site.show(node.func)
        given = site.show(node.args[0]) if len(node.args) == 1 else ""
        if called in _GOES_THROUGH and given:
            return f"{called}() goes through the items of a list or array; {given} is one {kind}."
        if called not in ("len", "int", "round"):
            return ""
    shown = site.show(node)
    if node is not loop or not shown:
        return ""
    if kind == "int":
        return f"{shown} is one number: a loop over 0, 1, 2, ... needs range({shown})."
    return f"{shown} is one number: it has no items to go through."


def _explain_unpacking(site: Site, found: re.Match[str]) -> str:
    if not found[1].startswith(_NUMBERS):
        return ""
    value = site.statement.value if isinstance(site.statement, ast.Assign) else None
    shown = site.show(value) or "The right side"
    return f"{shown} is one {found[1]}: several names on the left need as many values."


def _list_indices(site: Site) -> list[ast.expr]:
    """List the single indices of the indexing that failed."""
    index = get_child(site, "slice")
    parts = list(index.elts) if isinstance(index, ast.Tuple) else [index] if index else []
    found = []
    for part in parts:
        ends = [part.lower, part.upper, part.step] if isinstance(part, ast.Slice) else [part]
        found += [end for end in ends if end is not None]
    return found


def _divides(node: ast.expr) -> bool:
    """Tell whether the value of an expression comes of /, without a call around it."""
    if isinstance(node, ast.BinOp):
        return isinstance(node.op, ast.Div) or _divides(node.left) or _divides(node.right)
    return isinstance(node, ast.UnaryOp) and _divides(node.operand)


def _explain_index(site: Site, found: re.Match[str]) -> str:
    """Explain an index that is no whole number."""
    by_array = found[0].startswith("arrays used as indices")
    whose = site.show(get_child(site, "value")) or "it"
    for part in _list_indices(site):
        value, shown = site.get_value(part), site.show(part)
        if _divides(part):
            return _WHOLE
        if isinstance(value, float) and shown:
            return f"{shown} is a float here; an index has to be whole: int({shown})."
        if isinstance(value, str) and shown:
            return f"{shown} is a text here, and {whose} is indexed by whole numbers."
        if isinstance(value, np.ndarray) and value.dtype.kind == "f":
            return f"{shown} holds {value.dtype}; an index has to be whole: {shown}.astype(int)."
    return "An array as index holds whole numbers or True/False." if by_array else ""


def _explain_list_index(site: Site, found: re.Match[str]) -> str:
    """Explain an index that only arrays take."""
    whose = site.show(get_child(site, "value")) or "It"
    if found[2] in ("tuple", "ndarray"):
        how = "[i, j]" if found[2] == "tuple" else "an array as index"
        return f"{whose} is a {found[1]}, and {how} works on arrays only: np.array(...) makes one."
    return _explain_index(site, found)


def _explain_scalar_index(site: Site, found: re.Match[str]) -> str:
    del found
    value = holds(site, "value")
    if type(value) not in (list, tuple):
        return ""
    whose, kind = site.show(get_child(site, "value")) or "It", type(value).__name__
    return f"{whose} is a {kind}: np.array({whose}) takes an array as index, a {kind} does not."


def _explain_whole(site: Site, found: re.Match[str]) -> str:
    """Explain a count or a size that is no whole number."""
    node = site.node
    if not isinstance(node, ast.Call) or not found[1].rpartition(".")[2].startswith("float"):
        return ""
    args = [*node.args, *(one.value for one in node.keywords)]
    name = site.show(node.func).rpartition(".")[2]
    if name in ("zeros", "ones", "empty", "full", "eye", "identity"):
        args = args[:1]
    parts = [arg.elts if isinstance(arg, ast.Tuple | ast.List) else [arg] for arg in args]
    broken = [
        one
        for one in chain.from_iterable(parts)
        if _divides(one) or isinstance(site.get_value(one), float)
    ]
    if not broken or (len(broken) > 1 and name not in ("range", "reshape")):
        return ""
    shown = site.show(broken[0])
    if _divides(broken[0]):
        return _WHOLE
    return f"{shown} is a float here, and a whole number is needed: int({shown})." if shown else ""


def _explain_scalar(site: Site, found: re.Match[str]) -> str:
    """Explain a function for one number that got an array."""
    del found
    node = site.node
    shown = site.show(get_child(site, "func"))
    given = node.args[0] if isinstance(node, ast.Call) and len(node.args) == 1 else None
    array = site.get_value(given)
    is_named = isinstance(array, np.ndarray) and site.show(given)
    start = f"{site.show(given)} has shape {array.shape}" if is_named else "It got an array"
    if shown.startswith("math.") and callable(getattr(np, shown[5:], None)):
        return f"{start}: {shown} takes one number, np.{shown[5:]} takes arrays."
    if shown in ("int", "float"):
        return f"{start}: {shown}() takes one number, .astype({shown}) converts all of them."
    return f"{start}, and one number is needed." if is_named else ""


def _explain_conversion(site: Site, found: re.Match[str]) -> str:
    """Explain int(), float() and functions of math that got no number."""
    kind, node = found[1], site.node
    shown = site.show(node.args[0]) if isinstance(node, ast.Call) and len(node.args) == 1 else ""
    if kind in ("list", "tuple"):
        return f"{shown or 'It'} is a {kind}, and one number is needed: np.array(...) takes many."
    return "" if kind == "NoneType" else f"{shown or 'It'} is a {kind}, and one number is needed."


def _explain_outside(site: Site, found: re.Match[str]) -> str:
    """Explain an index beyond the end of an array."""
    index, axis, size = map(int, found.groups())
    if size == 0:
        return tell_empty(site)
    if size == 9 and (text := tell_nine(site)):
        return text
    text = f"Axis {axis} has {size} entries, numbered from 0 to {size - 1}"
    array = holds(site, "value")
    if isinstance(array, np.ndarray) and array.ndim > 1 and min(array.shape[:2]) > 4 and axis < 2:
        other = array.shape[1 - axis]
        shown = site.show(get_child(site, "value"))
        if index < other and shown:
            return f"{text}: {shown} is indexed [row, column], which is [v, u] for a pixel (u, v)."
    if index < 0:
        text += f", or from -1 back to -{size}"
    return f"{text}."


def _explain_list_end(site: Site, found: re.Match[str]) -> str:
    value = holds(site, "value")
    shown = site.show(get_child(site, "value"))
    if type(value) not in (list, tuple, str) or not shown:
        # what a call returned cannot be looked at again, but the arguments of the case can
        return tell_empty(site) if found[1] != "string" else ""
    if not value:
        return tell_empty(site) or f"{shown} is empty here."
    count = len(value)
    if count == 1:
        return f"{shown} has one entry here, number 0."
    return f"{shown} has {count} entries here, numbered from 0 to {count - 1}."


def _explain_many_indices(site: Site, found: re.Match[str]) -> str:
    if text := tell_nine(site):
        return text
    del found
    value, shown = holds(site, "value"), site.show(get_child(site, "value"))
    if not isinstance(value, np.ndarray) or not shown:
        return ""
    many = {0: "no index", 1: "one index"}.get(value.ndim, f"at most {value.ndim} indices")
    return f"{shown} has shape {value.shape}: it takes {many}."


def _explain_mask(site: Site, found: re.Match[str]) -> str:
    """Explain a mask that has another shape than what it chooses from."""
    del found
    arrays = dict(list_arrays(site))
    index = _list_indices(site)
    mask = site.get_value(index[0]) if len(index) == 1 else None
    value, shown = holds(site, "value"), site.show(get_child(site, "value"))
    name = site.show(index[0]) if index else ""
    if isinstance(mask, np.ndarray) and isinstance(value, np.ndarray) and name in arrays:
        return f"{shown} has shape {value.shape}, {name} {mask.shape}: a mask needs the same sizes."
    return "A mask of True and False needs the shape of the array that it chooses from."


RULES = (
    Rule("TypeError", r"^'(?:numpy\.)?(\w+)' object is not subscriptable", _explain_index_of),
    Rule("TypeError", r"^'(?:numpy\.)?(\w+)' object is not iterable", _explain_iteration),
    Rule("TypeError", r"object of type '(?:numpy\.)?(\w+)' has no len", _explain_length),
    Rule("TypeError", r"cannot unpack non-iterable (?:numpy\.)?(\w+) object", _explain_unpacking),
    Rule(
        "TypeError", r"(list|tuple) indices must be .*, not (?:numpy\.)?(\w+)", _explain_list_index
    ),
    Rule("TypeError", r"slice indices must be integers", _explain_index),
    Rule("TypeError", r"only integer scalar arrays can be converted", _explain_scalar_index),
    Rule("TypeError", r"'([\w.]+)' object cannot be interpreted as an integer", _explain_whole),
    Rule("TypeError", r"only (?:0-dimensional|length-1|size-1) arrays", _explain_scalar),
    Rule("TypeError", r"argument must be a string.*not '(\w+)'", _explain_conversion),
    Rule("TypeError", r"must be real number, not (\w+)", _explain_conversion),
    Rule(
        "TypeError",
        r"Cannot interpret '.*' as a data type",
        "The shape is one argument, in brackets of its own: as in np.zeros((2, 3)).",
    ),
    Rule(
        "IndexError", r"only integers, slices|arrays used as indices must be of int", _explain_index
    ),
    Rule(
        "IndexError",
        r"index (-?\d+) is out of bounds for axis (\d+) with size (\d+)",
        _explain_outside,
    ),
    Rule("IndexError", r"(list|tuple|string) index out of range", _explain_list_end),
    Rule("IndexError", r"too many indices for array", _explain_many_indices),
    Rule("IndexError", r"boolean index did not match", _explain_mask),
    Rule(
        "IndexError",
        r"invalid index to scalar variable",
        "It is a single number: it has no items to choose from with [ ].",
    ),
    Rule(
        "IndexError",
        r"pop from empty (\w+)",
        "Nothing is left in the {0}: ask for its length first.",
    ),
    Rule("IndexError", r"Invalid index (\d+)\. (Valid indices from \d+ to \d+)", "{1}."),
)
