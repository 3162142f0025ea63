"""Sentences for values that cannot be used: nothing there, zero, NaN, texts that are no numbers."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from labutils.checks.exceptions.facts import Rule, get_child, tell_empty

if TYPE_CHECKING:
    import re

    from labutils.checks.exceptions.site import Site

_EMPTY = (
    r"zero-size array to reduction|of an empty sequence|arg is an empty sequence"
    r"|iterable argument is empty|need at least one array|cannot take a .* of empty"
)

#: Repeats of one function in a traceback that are no accident.
_DEEP = 50


def _explain_empty(site: Site, found: re.Match[str]) -> str:
    del found
    return tell_empty(site) or "There is nothing to choose from: decide what to return then."


def _explain_division(site: Site, found: re.Match[str]) -> str:
    del found
    divisor, operation = None, getattr(site.node or site.statement, "op", None)
    if isinstance(operation, ast.Div | ast.FloorDiv | ast.Mod):
        if isinstance(site.node, ast.BinOp):
            divisor = site.node.right
        elif isinstance(site.statement, ast.AugAssign):
            divisor = site.statement.value
    shown = "" if isinstance(divisor, ast.Constant) else site.show(divisor)
    where = " in this case" if site.call.arguments else ""
    text = f"{shown} is 0{where}: ask for that before you divide" if shown else ""
    empty = tell_empty(site).partition(":")[0]
    return f"{text}{f' ({empty})' if empty else ''}." if text else ""


def _explain_nan(site: Site, found: re.Match[str]) -> str:
    del found
    if empty := tell_empty(site):
        return empty
    return (
        "NaN comes of 0/0, of the mean of nothing, or of NaN in the data: ask for it with np.isnan."
    )


def _explain_text(site: Site, found: re.Match[str]) -> str:
    """Explain a text that was read as a number."""
    del site
    text = found[1].removeprefix("np.str_(").rstrip(")").strip("'\"")
    if not text.strip():
        return "The text is empty: there is no number in it."
    try:
        float(text)
    except ValueError:
        shown = text if len(text) <= 30 else f"{text[:27]}..."
        return (
            f'"{shown}" is no number: leave out such words, or split the text into its parts first.'
        )
    return f"{text} is no whole number: float(...) reads it, int(...) only reads whole ones."


def _explain_format(site: Site, found: re.Match[str]) -> str:
    del site
    return f"The format {found[1]} is not for a {found[2]}." if found[2] else ""


def _explain_overflow(site: Site, found: re.Match[str]) -> str:
    del site
    number, kind = found.groups()
    limits = {"uint8": "0 to 255", "int8": "-128 to 127", "uint16": "0 to 65535"}
    if kind not in limits:
        return f"{kind} has no room for {number}."
    return f"{kind} holds {limits[kind]}: np.clip keeps inside, .astype(int) has room for more."


def _explain_recursion(site: Site, found: re.Match[str]) -> str:
    del found
    count, traceback = 0, site.error.__traceback__
    while traceback is not None and site.frame is not None:
        count += traceback.tb_frame.f_code is site.frame.f_code
        traceback = traceback.tb_next
    if site.frame is None or count < _DEEP:
        return ""
    return f"{site.frame.f_code.co_name}() calls itself again and again: nothing ends it."


def _explain_assert(site: Site, found: re.Match[str]) -> str:
    del found
    if not isinstance(site.statement, ast.Assert):
        return ""
    shown = site.show(site.statement.test)
    where = " in this case" if site.call.arguments else ""
    return f"Your own assert does not hold{where}{f': {shown}' if shown else ''}."


def _explain_file(site: Site, found: re.Match[str]) -> str:
    end = " A check gives your function all it needs as arguments." if site.call.arguments else ""
    return f"There is no file {found[1]} where this runs.{end}"


def _explain_generator(site: Site, found: re.Match[str]) -> str:
    del found
    shown = site.show(get_child(site, "func"))
    return "next() found nothing: next(..., None) gives None then." if shown == "next" else ""


#: What a learner's own `raise` or `assert` may be told about.
OWN_RULES = (
    Rule(
        "NotImplementedError",
        "",
        "This case comes to a branch that nobody has written yet: replace its raise by your code.",
    ),
    Rule("AssertionError", "", _explain_assert),
    Rule(
        "TypeError",
        r"exceptions must derive from BaseException",
        'raise needs an exception, as in raise ValueError("...").',
    ),
)

RULES = (
    Rule("ValueError", _EMPTY, _explain_empty),
    Rule("TypeError", r"cannot take a .* of empty", _explain_empty),
    Rule("ZeroDivisionError", "", _explain_division),
    Rule("ValueError", r"cannot convert float NaN to integer", _explain_nan),
    Rule(
        "OverflowError",
        r"cannot convert float infinity to integer",
        "In NumPy a number divided by 0 is infinite: ask for it with np.isfinite.",
    ),
    Rule("ValueError", r"could not convert string to float: (.*)", _explain_text),
    Rule("ValueError", r"could not convert string (.*) to float", _explain_text),
    Rule("ValueError", r"invalid literal for int\(\) with base 10: (.*)", _explain_text),
    Rule("ValueError", r"Unknown format code '(.)' for object of type '(\w+)'", _explain_format),
    Rule("OverflowError", r"Python integer (-?\d+) out of bounds for (\w+)", _explain_overflow),
    Rule(
        "ValueError",
        r"math domain error|nonnegative input",
        "This function has no value for the number it got here.",
    ),
    Rule("RecursionError", "", _explain_recursion),
    Rule("FileNotFoundError", r"No such file or directory: '([^']{1,40})'", _explain_file),
    Rule("StopIteration", "", _explain_generator),
    Rule(
        "SystemExit",
        "",
        "exit() and sys.exit() end the whole program: a function ends with return.",
    ),
    *OWN_RULES,
)
