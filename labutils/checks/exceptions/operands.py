"""Sentences for TypeError: an operation or a call got a value that it cannot take."""

from __future__ import annotations

import ast
import builtins
import inspect
import re
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.exceptions.facts import (
    Rule,
    find_value,
    get_child,
    name_type,
    tell_none,
)
from labutils.checks.exceptions.site import UNKNOWN, is_quiet

if TYPE_CHECKING:
    from labutils.checks.exceptions.site import Site

#: Fields of arrays that are no functions.
_NO_FUNCTIONS = ("shape", "size", "dtype", "T", "ndim")
_NUMBERS = ("int", "float", "bool", "float64", "float32", "int64", "int32", "uint8")
#: Longer signatures are told without their optional arguments.
_MAX_SIGNATURE = 60

_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**"}


def _explain_none(site: Site, found: re.Match[str]) -> str:
    """Say which part of an expression is None."""
    del found
    node, statement = site.node, site.statement
    parts = [getattr(node, name, None) for name in ("value", "left", "operand", "func", "right")]
    parts += [*getattr(node, "comparators", ()), *getattr(node, "args", ())]
    parts += [getattr(statement, name, None) for name in ("value", "iter")]
    nothing = [one for one in [node, *parts] if one is not None and site.get_value(one) is None]
    if nothing:
        return tell_none(site, nothing[0]) if len(set(nothing)) == 1 else ""
    # What a call returned cannot be looked at again; here nothing else can be meant.
    call = None
    if isinstance(node, ast.Subscript):
        call = node.value
    elif isinstance(node, ast.Tuple | ast.List) and isinstance(statement, ast.Assign):
        call = statement.value if isinstance(node.ctx, ast.Store) else None
    elif node is None and isinstance(statement, ast.For):
        call = statement.iter
    return tell_none(site, call) if isinstance(call, ast.Call) else ""


def _explain_call_of(site: Site, found: re.Match[str]) -> str:
    """Say what is called although it is no function."""
    kind, node = found[1], get_child(site, "func")
    shown = site.show(node)
    if isinstance(node, ast.Attribute) and node.attr in _NO_FUNCTIONS:
        return f".{node.attr} is no function: leave out the ( ) after it."
    if isinstance(node, ast.Name) and hasattr(builtins, node.id):
        return (
            f"{node.id} is {name_type(site.get_value(node))} here, which hides Python's function "
            f"{node.id}(): give your value another name."
        )
    whose = shown or "It"
    if kind in ("ndarray", "list", "tuple", "dict"):
        return f"{whose} is no function: items are taken with [ ], not with ( )."
    if kind in _NUMBERS:
        return f"{whose} is a number, and ( ) after it mean a call: a product needs *."
    if kind == "module":
        return f"{whose} is a module: call one of its functions, as in {whose}.name(...)."
    return ""


def _explain_arguments(site: Site, found: re.Match[str]) -> str:
    """Say how a function that got other arguments is called."""
    name = found[1].rpartition(".")[2]
    shown = site.show(get_child(site, "func"))
    if shown.rpartition(".")[2] != name:
        return ""  # it was called by what the learner called
    function = _find_function(site)
    if shown == "np.array" and "positional" in found[0]:
        return "The numbers are one argument, in brackets of their own: as in np.array([1, 2, 3])."
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return ""
    empty = inspect.Parameter.empty
    parameters = [one.replace(annotation=empty) for one in signature.parameters.values()]
    if inspect.ismethod(function) and not parameters:
        return f"Its ( ) stay empty: {name} takes nothing (Python counts what is before the dot)."
    text = str(signature.replace(parameters=parameters, return_annotation=empty))
    if len(text) > _MAX_SIGNATURE:
        needed = [one.name for one in parameters if one.default is empty]
        text = f"({', '.join((*needed, '...'))})"
    return f"It is called as {shown}{text}."


def _find_function(site: Site) -> Any:
    """Return the function that was called: of the learner, or of a known library."""
    node = get_child(site, "func")
    value = site.get_value(node)
    if value is UNKNOWN and isinstance(node, ast.Attribute):
        owner = site.get_value(node.value)
        value = getattr(owner, node.attr, UNKNOWN) if is_quiet(owner) else UNKNOWN
    return value


def _explain_incompatible(site: Site, found: re.Match[str]) -> str:
    """Read how a function of MuJoCo is called from what it says itself."""
    shown = site.show(get_child(site, "func")) or found[1]
    names = re.findall(r"(?:^|, )(\w+):", found[2])
    if "arg0" in names:
        return f"{shown} takes a name (str) or a number (int)." if "name: str" in found[0] else ""
    return f"It is called as {shown}({', '.join(names)})."


def _explain_operands(site: Site, found: re.Match[str]) -> str:
    """Say which side of an operation is no number or array."""
    symbol, left, right = found.groups()
    nodes: tuple[ast.expr | None, ast.expr | None]
    if isinstance(site.node, ast.BinOp):
        nodes = (site.node.left, site.node.right)
    elif isinstance(site.node, ast.Compare) and len(site.node.comparators) == 1:
        nodes = (site.node.left, site.node.comparators[0])
    elif isinstance(site.statement, ast.AugAssign):
        nodes = (site.statement.target, site.statement.value)
    else:
        return ""
    if text := tell_brackets(site):
        return text
    for kind, node, side in ((left, nodes[0], "left"), (right, nodes[1], "right")):
        if text := _tell_operand(kind, site.show(node), side):
            return text
    if symbol in ("^", "^="):
        return "In Python ^ is no power (it works on bits): a power is written **."
    return ""


def _tell_operand(kind: str, shown: str, side: str) -> str:
    whose = shown or f"The {side} side"
    if kind in ("list", "tuple", "range"):
        return f"{whose} is a {kind}: np.array({shown or '...'}) calculates item by item."
    if kind == "str":
        return f"{whose} is a text: float(...) or int(...) reads a number from a text."
    if "function" in kind or kind == "method":
        return f"{whose} is a function: () after it calls it."
    if kind == "dict":
        return f"{whose} is a dict: [ ] chooses one of its values."
    return ""


def _explain_operand(site: Site, found: re.Match[str]) -> str:
    node = site.node
    operand = node.operand if isinstance(node, ast.UnaryOp) else None
    if isinstance(node, ast.Call) and len(node.args) == 1:
        operand = node.args[0]
    return _tell_operand(found[1], site.show(operand), "right")


def tell_brackets(site: Site) -> str:
    """Say that & and | are computed before comparisons, where that is what failed."""
    node = site.node
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.BitAnd | ast.BitOr):
        return ""
    for other in site.walk_statement():
        if isinstance(other, ast.Compare) and node in (other.left, *other.comparators):
            sign = "&" if isinstance(node.op, ast.BitAnd) else "|"
            return (
                f"{sign} is computed before < and >: put each comparison in brackets of its own, "
                f"as in (a > 0) {sign} (a < 1)."
            )
    return ""


def _explain_bits(site: Site, found: re.Match[str]) -> str:
    """Explain & | ^ ~ on numbers that are not whole."""
    if text := tell_brackets(site):
        return text
    symbols = {"bitwise_and": "&", "bitwise_or": "|", "bitwise_xor": "^", "invert": "~"}
    floats = find_value(site, lambda x: isinstance(x, np.ndarray) and x.dtype.kind == "f")
    if found[1] not in symbols or floats is None:
        return ""
    return (
        f"{symbols[found[1]]} works on True/False and on whole numbers; {floats[0]} holds "
        f"{floats[1].dtype}."
    )


def _explain_repeat(site: Site, found: re.Match[str]) -> str:
    del found
    shown = find_value(site, lambda value: type(value) in (list, tuple))
    if shown is None:
        return ""
    name, value = shown
    kind = type(value).__name__
    return f"{name} is a {kind}, which * repeats: np.array({name}) multiplies its numbers."


def _explain_casting(site: Site, found: re.Match[str]) -> str:
    result, kept = found.groups()
    if not isinstance(site.statement, ast.AugAssign) or type(site.statement.op) not in _OPERATORS:
        return f"The result is {result}, its place holds {kept}: .astype({result}) first."
    target = site.show(site.statement.target) or "it"
    sign = _OPERATORS[type(site.statement.op)]
    return (
        f"{sign}= keeps the type of {target}, {kept}, but the result is {result}: write "
        f"{target} = {target} {sign} ... instead."
    )


RULES = (
    Rule("TypeError", "NoneType", _explain_none),
    Rule("TypeError", r"^'(?:numpy\.)?(\w+)' object is not callable", _explain_call_of),
    Rule("TypeError", r"^([\w.<>]+)\(\) (?:missing|takes|got).*", _explain_arguments),
    Rule(
        "TypeError",
        r"^(\w+)\(\): incompatible function arguments.*?\n\s+1\. \((.*?)\) ->.*",
        _explain_incompatible,
    ),
    Rule(
        "TypeError",
        r"unsupported operand type\(s\) for (\S+): '([\w.]+)' and '([\w.]+)'",
        _explain_operands,
    ),
    Rule(
        "TypeError",
        r"'(\S+)' not supported between instances of '(\w+)' and '(\w+)'",
        _explain_operands,
    ),
    Rule("TypeError", r"bad operand type for (?:unary .|abs\(\)): '(\w+)'", _explain_operand),
    Rule("TypeError", "can't multiply sequence by non-int", _explain_repeat),
    Rule(
        "TypeError",
        r'can only concatenate str \(not "([\w.]+)"\)',
        "+ joins a text with a text only: str(...) makes one, float(...) reads a number from one.",
    ),
    Rule(
        "TypeError",
        r'can only concatenate (list|tuple) \(not "([\w.]+)"\)',
        "+ joins a {0} with another {0} only: np.array(...) of it adds to its numbers.",
    ),
    Rule("TypeError", r"ufunc '(bitwise_\w+|invert)' not supported", _explain_bits),
    Rule(
        "TypeError",
        r"boolean (?:subtract|negative), the `-` operator, is not supported",
        "Its values are True and False: ~ turns them around, .astype(int) makes numbers of them.",
    ),
    Rule(
        "UFuncTypeError",
        r"Cannot cast ufunc '\w+' output from dtype\('(\w+)'\) to dtype\('(\w+)'\)",
        _explain_casting,
    ),
    Rule(
        "UFuncTypeError",
        r"did not contain a loop with signature matching types.*(?:StrDType|'<U\d+')",
        "One side holds texts, the other numbers: .astype(float) reads numbers from texts.",
    ),
    Rule(
        "TypeError",
        r"unhashable type: '([\w.]+)'",
        "A {0} can be no key of a dict and no member of a set: a tuple can.",
    ),
    Rule(
        "TypeError",
        r"'(tuple|str|range)' object does not support item assignment",
        "A {0} cannot be changed: a list or an array can.",
    ),
    Rule(
        "TypeError",
        r"unsupported format string passed to numpy\.ndarray",
        "A format like :.2f is for one number, and this is an array.",
    ),
)
