"""Sentences for arrays whose shapes do not fit."""

from __future__ import annotations

import ast
import re
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.exceptions.facts import (
    Rule,
    find_value,
    get_child,
    join,
    list_arrays,
    tell_nine,
    tell_shapes,
)

if TYPE_CHECKING:
    from labutils.checks.exceptions.site import Site

Shape = tuple[int, ...]


def _read_shapes(text: str) -> list[Shape]:
    """Read the shapes in a message of NumPy."""
    found = re.findall(r"\(((?:\d+,? ?)*)\)", text)
    return [tuple(int(number) for number in re.findall(r"\d+", one)) for one in found]


def _explain_broadcast(site: Site, found: re.Match[str]) -> str:
    shapes = [shape for shape in _read_shapes(found[0]) if shape]
    if (9,) in shapes and (text := tell_nine(site)):
        return text
    told = tell_shapes(site, shapes)
    start = f"{told}: " if told else ""
    for a, b in (shapes, shapes[::-1]) if len(shapes) == 2 else ():
        name = _find_name(site, a)
        if name and b[:-1] == a:
            index = "[:, None]" if len(a) == 1 else "[..., None]"
            return f"{start}{name}{index} fits, it has shape {(*a, 1)}."
        if name and a == b[::-1] and len(a) == 2:
            return f"{start}rows and columns are exchanged ({name}.T has shape {b})."
    return f"{start or 'Here: '}sizes are compared from the last one on; they must be equal or 1."


def _find_name(site: Site, shape: Shape) -> str:
    return next((name for name, array in list_arrays(site) if array.shape == shape), "")


def _explain_place(site: Site, found: re.Match[str]) -> str:
    given, place = _read_shapes(found[0])
    text = tell_nine(site) if (9,) in (given, place) else ""
    return text or f"The right side has shape {given}, the place on the left has {place}."


def _list_known(site: Site, nodes: list[ast.expr]) -> list[tuple[str, np.ndarray]]:
    """List those of some expressions whose value is known to be an array."""
    values = [(site.show(node), site.get_value(node)) for node in nodes]
    return [(name, value) for name, value in values if name and isinstance(value, np.ndarray)]


def _explain_product(site: Site, found: re.Match[str]) -> str:
    """Explain a matrix product whose inner sizes differ."""
    if "9" in re.findall(r"\d+", found[0]) and (text := tell_nine(site)):
        return text
    node = site.node
    sides = node.args[:2] if isinstance(node, ast.Call) else []
    if isinstance(node, ast.BinOp):
        sides = [node.left, node.right]
    arrays = _list_known(site, sides)
    if len(arrays) != 2:
        return "The last size of the left has to be the first of the right."
    for (name, one), (other, two) in (arrays, arrays[::-1]):
        if one.shape == (4, 4) and 3 in (*two.shape[:1], *two.shape[-1:]):
            return (
                f"{name} is 4x4 and needs four numbers per point, (x, y, z, 1); {other} has three: "
                f"append ones, or use {name}[:3, :3] and {name}[:3, 3]."
            )
    (left, a), (right, b) = arrays
    told = f"{left} has shape {a.shape} and {right} has shape {b.shape}"
    is_plain = isinstance(node, ast.BinOp) and right.isidentifier()
    if is_plain and b.ndim == 2 and a.shape[-1] == b.shape[-1]:
        return f"{told}: {left} @ {right}.T would fit."
    return f"{told}: the last size of the left has to be the first of the right."


def _explain_dimensions(site: Site, found: re.Match[str]) -> str:
    del found
    number = find_value(site, lambda value: isinstance(value, int | float | np.number))
    if number is None:
        return ""
    return f"{number[0]} is a single number: * multiplies by it, @ is for matrices."


def _explain_reshape(site: Site, found: re.Match[str]) -> str:
    size, shape = int(found[1]), found[2]
    sizes = [int(number) for number in re.findall(r"\d+", shape)]
    owner = getattr(get_child(site, "func"), "value", None)
    shown = site.show(owner) if isinstance(site.get_value(owner), np.ndarray) else "It"
    if "newaxis" in shape:
        return f"{shown} holds {size} values, and they do not divide into groups of {prod(sizes)}."
    text = " * ".join(map(str, sizes))
    product = f"{text} = {prod(sizes)}" if len(sizes) > 1 else text
    return f"{shown} holds {size} values, and the new shape has room for {product}."


def _explain_unpacking(site: Site, found: re.Match[str]) -> str:
    """Explain as many names on the left as there are not values on the right."""
    wanted = int(found[1])
    statement = site.statement
    value = statement.value if isinstance(statement, ast.Assign) else None
    if value is None:
        return ""
    if isinstance(value, ast.Call) and site.show(value.func).endswith("findContours"):
        return "findContours returns two things since OpenCV 4: contours, hierarchy = ..."
    if isinstance(value, ast.Attribute) and value.attr == "shape":
        array, shown = site.get_value(value.value), site.show(value.value)
        if isinstance(array, np.ndarray) and shown:
            text = f"{shown} has shape {array.shape}, and {wanted} names stand on the left"
            end = f": {shown}.shape[:2] is height and width." if wanted == 2 < array.ndim else "."
            return f"{text}{end}"
    given = site.get_value(value)
    count = found[2] or (len(given) if type(given) in (list, tuple, np.ndarray) else "more")
    return f"{site.show(value) or 'The right side'} gives {count} values, the left takes {wanted}."


def _explain_join(site: Site, found: re.Match[str]) -> str:
    del found
    told = tell_shapes(site)
    return f"{told}: apart from the axis they are joined along, sizes must agree." if told else ""


def _explain_stack(site: Site, found: re.Match[str]) -> str:
    del found
    told = tell_shapes(site)
    return f"{told}: all of them need one shape." if told else ""


def _explain_element(site: Site, found: re.Match[str]) -> str:
    """Explain several values for the place of one."""
    del found
    target = site.statement.targets[0] if isinstance(site.statement, ast.Assign) else None
    shown = site.show(target)
    if not isinstance(target, ast.Subscript) or not shown:
        return ""
    return f"{shown} has room for one number, and the right side is more than one."


def _explain_axis(site: Site, found: re.Match[str]) -> str:
    count, node = int(found[2]), site.node
    if count == 1 and (text := tell_nine(site)):
        return text
    parts = [*node.args[:1], node.func] if isinstance(node, ast.Call) else []
    parts += [part.value for part in parts if isinstance(part, ast.Attribute)]
    arrays = [one for one in _list_known(site, parts) if one[1].ndim == count]
    start = f"{arrays[0][0]} has shape {arrays[0][1].shape}: its" if arrays else "Its"
    if count == 0:
        return "It is a single number, which has no axis."
    if count == 1:
        return f"{start} only axis is 0."
    return f"{start} axes are {join(map(str, range(count)))}, and -1 is the last."


def _explain_square(site: Site, found: re.Match[str]) -> str:
    wish = "a square matrix is needed" if "square" in found[0] else "a matrix of two axes is needed"
    told = tell_nine(site) or tell_shapes(site)
    if told.endswith("."):
        return told
    return f"{told}, and {wish}." if told else f"{wish[0].upper()}{wish[1:]}."


def _explain_solution(site: Site, found: re.Match[str]) -> str:
    del found
    bad = find_value(
        site,
        lambda x: isinstance(x, np.ndarray) and x.dtype.kind == "f" and not np.isfinite(x).all(),
    )
    return f"{bad[0]} holds NaN or infinity: drop these values before." if bad else ""


def _explain_singular(site: Site, found: re.Match[str]) -> str:
    del found
    zero = find_value(site, lambda x: isinstance(x, np.ndarray) and x.ndim == 2 and not x.any())
    if zero:
        return f"{zero[0]} holds nothing but zeros: such a matrix has no inverse."
    return "A row of the matrix follows from its other rows: such a matrix has no inverse."


RULES = (
    Rule("ValueError", r"could not broadcast input array from shape .*", _explain_place),
    Rule(
        "ValueError", r"array of shape .* broadcast to indexing result of shape .*", _explain_place
    ),
    Rule(
        "ValueError",
        r"cannot assign (\d+) input values to the (\d+) output values where the mask is true",
        "The mask marks {1} places, the right side has {0} values: take the same mask there too.",
    ),
    Rule(
        "ValueError",
        r"(?:could not|cannot) be broadcast .*|non-broadcastable .*",
        _explain_broadcast,
    ),
    Rule("ValueError", r"not have enough dimensions", _explain_dimensions),
    Rule(
        "ValueError",
        r"^matmul: .* core dimension.*|shapes \(.* not aligned.*",
        _explain_product,
    ),
    Rule("ValueError", r"cannot reshape array of size (\d+) into shape (\(.*\))", _explain_reshape),
    Rule(
        "ValueError",
        r"not enough values to unpack \(expected (\d+), got (\d+)\)",
        _explain_unpacking,
    ),
    Rule(
        "ValueError",
        r"too many values to unpack \(expected (\d+)(?:, got (\d+))?\)",
        _explain_unpacking,
    ),
    Rule("ValueError", r"concatenation axis must match|same number of dimensions", _explain_join),
    Rule("ValueError", r"all input arrays must have the same shape", _explain_stack),
    Rule(
        "ValueError",
        r"inhomogeneous shape",
        "The rows are of different lengths: an array needs rows of one length, a list does not.",
    ),
    Rule("ValueError", r"setting an array element with a sequence", _explain_element),
    Rule(
        "ValueError",
        r"either both or neither of x and y",
        "np.where takes one argument or three: np.where(condition, value if true, value if not).",
    ),
    Rule("AxisError", r"axis (-?\d+) is out of bounds for array of dimension (\d+)", _explain_axis),
    Rule("LinAlgError", r"must be square|must be (?:at least )?two-dimensional", _explain_square),
    Rule("LinAlgError", r"did not converge|must not contain infs or NaNs", _explain_solution),
    Rule("LinAlgError", r"Singular matrix", _explain_singular),
)
