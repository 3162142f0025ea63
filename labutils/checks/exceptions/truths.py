"""Sentences for arrays where one True or False was asked for."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from labutils.checks.exceptions.facts import Rule, get_child, take_first, tell_empty

if TYPE_CHECKING:
    import re

    from labutils.checks.exceptions.site import Site


def _explain_truth(site: Site, found: re.Match[str]) -> str:
    """Explain where one True or False was asked of many values."""
    del found
    steps = (_tell_builtin, _tell_compare_none, _tell_joined, _tell_membership, _tell_condition)
    return take_first(site, steps)


def _tell_builtin(site: Site) -> str:
    called = site.show(get_child(site, "func"))
    if called in ("max", "min"):
        return (
            f"Python's {called}() compares whole arrays: x.{called}() finds the {called} of one, "
            f"np.{called}imum(x, y) compares two value by value."
        )
    if called in ("sorted", "any", "all"):
        other = "sort" if called == "sorted" else called
        return f"Python's {called}() looks at whole rows here: NumPy has np.{other}."
    return ""


def _tell_joined(site: Site) -> str:
    """Explain and, or, not and chains of comparisons."""
    for node in site.walk_statement():
        if isinstance(node, ast.BoolOp) and site.node in (None, node, *node.values):
            word, sign = ("and", "&") if isinstance(node.op, ast.And) else ("or", "|")
            return f"{word} joins single truths; for arrays write (...) {sign} (...), in brackets."
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return "not turns one truth around; for arrays write ~(...)."
        if isinstance(node, ast.Compare) and len(node.ops) > 1:
            return "a < b < c joins two comparisons by and; for arrays write (a < b) & (b < c)."
    return ""


def _tell_membership(site: Site) -> str:
    node = site.node
    if not isinstance(node, ast.Compare) or not isinstance(node.ops[0], ast.In | ast.NotIn):
        return ""
    return "in compares whole arrays: np.isin(x, y) looks value by value."


def _tell_condition(site: Site) -> str:
    node, statement = site.node, site.statement
    choices = [one.test for one in site.walk_statement() if isinstance(one, ast.IfExp)]
    if isinstance(statement, ast.If | ast.While | ast.Assert):
        choices.append(statement.test)
    if node is not None and node not in choices:
        return ""
    return (
        "The condition holds one truth per value: .any() or .all() makes one of them; np.where or "
        "a mask decides value by value."
    )


def _tell_compare_none(site: Site) -> str:
    for node in site.walk_statement():
        if not isinstance(node, ast.Compare) or not isinstance(node.ops[0], ast.Eq | ast.NotEq):
            continue
        sides = (node.left, node.comparators[0])
        if any(isinstance(side, ast.Constant) and side.value is None for side in sides):
            signs = ("==", "is") if isinstance(node.ops[0], ast.Eq) else ("!=", "is not")
            shown = site.show(node.left) or "..."
            return f"{signs[0]} compares an array value by value: ask {shown} {signs[1]} None."
    return ""


def _explain_no_truth(site: Site, found: re.Match[str]) -> str:
    return tell_empty(site) or _explain_truth(site, found)


RULES = (
    Rule("ValueError", r"truth value of an empty array", _explain_no_truth),
    Rule("ValueError", r"truth value of an array", _explain_truth),
)
