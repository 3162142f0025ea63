"""A learner's file or cell as a tree: which expression stands at the place that failed."""

from __future__ import annotations

import ast
from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from types import FrameType

#: First and last line, first and last column.
Position: TypeAlias = "tuple[int | None, int | None, int | None, int | None]"


@lru_cache(maxsize=4)  # every case of a check may stop in the same file
def parse(source: str) -> ast.Module | None:
    """Parse a file or cell; return None for what is more than Python."""
    try:
        return ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None  # a cell with commands of IPython in it


def find_statement(tree: ast.Module, where: Position) -> ast.stmt | None:
    """Find the innermost statement around a place."""
    line, end_line, column, end_column = where
    start, end = (line or 0, column or 0), (end_line or 0, end_column or 0)
    found = None
    for node in ast.walk(tree):
        if not isinstance(node, ast.stmt) or node.end_lineno is None:
            continue
        first, last = (node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset or 0)
        if column is None:
            first, last = (node.lineno, 0), (node.end_lineno, 0)
        if first <= start and end <= last:
            found = node  # level by level: what is inside comes after what is around
    return found


def find_expression(statement: ast.stmt, where: Position) -> ast.expr | None:
    """Find the expression that stands exactly at a place."""
    for node in ast.walk(statement):
        if isinstance(node, ast.expr) and where == (
            node.lineno,
            node.end_lineno,
            node.col_offset,
            node.end_col_offset,
        ):
            return node
    return None


def get_head(statement: ast.stmt | None) -> list[ast.AST]:
    """Return what a statement itself computes, without the statements inside it."""
    if statement is None:
        return []
    return [node for node in ast.iter_child_nodes(statement) if not isinstance(node, ast.stmt)]


def raises(statement: ast.stmt | None, error: BaseException) -> bool:
    """Tell whether it is the purpose of a statement to raise such an exception."""
    is_assert = isinstance(statement, ast.Assert) and isinstance(error, AssertionError)
    return is_assert or isinstance(statement, ast.Raise)


def find_function(source: str, frame: FrameType | None) -> ast.AST | None:
    """Find the function that a frame runs; the whole cell where it runs that."""
    tree = parse(source)
    if tree is None or frame is None:
        return None
    name, line = frame.f_code.co_name, frame.f_code.co_firstlineno
    if name == "<module>":
        return tree
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and node.name == name:
            first = min([node.lineno, *(one.lineno for one in node.decorator_list)])
            if first == line:
                return node
    return None


def binds(node: ast.AST, name: str) -> bool:
    """Tell whether a node gives a name a value: as target, parameter, function or import."""
    if isinstance(node, ast.Name):
        return node.id == name and not isinstance(node.ctx, ast.Load)
    names = (getattr(node, "arg", None), getattr(node, "name", None), getattr(node, "asname", None))
    return not isinstance(node, ast.keyword) and name in names
