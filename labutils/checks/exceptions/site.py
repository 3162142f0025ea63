"""Where a learner's code stopped: the expression that failed, and what its names held."""

from __future__ import annotations

import ast
import builtins
import linecache
from dataclasses import dataclass, field
from itertools import islice
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.exceptions.source import (
    binds,
    find_expression,
    find_function,
    find_statement,
    get_head,
    parse,
    raises,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from types import FrameType, TracebackType

    from labutils.checks.exceptions.source import Position

#: What cannot be known without running a learner's code again.
UNKNOWN = object()

#: Longer pieces of a learner's code would fill the message.
_MAX_SHOWN = 36

#: Looking at their attributes runs no code of a learner.
_QUIET = ("numpy", "cv2", "mujoco", "labutils.renderers")

_FIELDS = {"T", "shape", "size", "ndim", "dtype"}


@dataclass(frozen=True)
class Call:
    """The call of a case: the arguments by the learner's own names, and the exception due."""

    arguments: Mapping[str, object] = field(default_factory=dict)
    raises: str = ""


@dataclass(frozen=True)
class Site:
    """An exception, and the place in the learner's own code where it came up.

    Parameters
    ----------
    error : BaseException
        The exception, still with its traceback.
    call : Call
        What the check called; empty where a cell itself stopped.
    frame : FrameType or None
        The deepest frame of the learner's file or cell; None where there is none.
    source : str
        The whole file or cell.
    node : ast.expr or None
        The expression that failed, where Python tells which.
    statement : ast.stmt or None
        The statement around it.
    is_raised_here : bool
        Whether the learner's own line raised it, instead of something that was called there.
    """

    error: BaseException
    call: Call
    frame: FrameType | None = None
    source: str = ""
    node: ast.expr | None = None
    statement: ast.stmt | None = None
    is_raised_here: bool = False

    # --- what its names held ---

    def list_names(self) -> set[str]:
        """List what a line there can name, without Python's own names."""
        if self.frame is None:
            return set()
        return {name for name in (*self.frame.f_locals, *self.frame.f_globals) if name[0] != "_"}

    def get_value(self, node: ast.AST | None) -> Any:
        """Return what an expression held when it failed; UNKNOWN where that cannot be known.

        Nothing of the learner's runs again: names, constants, and fields and items of types whose
        code is known.
        """
        value = self._read(node)
        return value if is_quiet(value) else UNKNOWN

    def _read(self, node: ast.AST | None) -> Any:
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Name):
            return self._look_up(node.id)
        if isinstance(node, ast.Attribute):
            return _get_field(self.get_value(node.value), node.attr)
        if isinstance(node, ast.Subscript):
            return _get_item(self.get_value(node.value), self.get_value(node.slice))
        if isinstance(node, ast.Call) and self.get_value(node.func) is len and len(node.args) == 1:
            return _get_length(self.get_value(node.args[0]))
        return UNKNOWN

    def _look_up(self, name: str) -> Any:
        if self.frame is None:
            return UNKNOWN
        for names in (self.frame.f_locals, self.frame.f_globals, vars(builtins)):
            if name in names:
                return names[name]
        return UNKNOWN

    def is_argument(self, node: ast.AST | None) -> bool:
        """Tell whether an expression is a name that still holds an argument of the case."""
        if not isinstance(node, ast.Name):
            return False
        value = self.get_value(node)
        if isinstance(value, np.ndarray):
            return any(value is given for given in self.call.arguments.values())
        return node.id in self.call.arguments and self.call.arguments[node.id] is value

    # --- how it was written ---

    def show(self, node: ast.AST | None) -> str:
        """Return an expression as it was written; empty where it is too long to be told."""
        text = (ast.get_source_segment(self.source, node) if node is not None else None) or ""
        text = " ".join(text.split())
        return text if len(text) <= _MAX_SHOWN else ""

    def walk(self) -> Iterator[ast.AST]:
        """Go through the expression that failed, or the head of its statement."""
        return self.walk_statement() if self.node is None else ast.walk(self.node)

    def walk_statement(self) -> Iterator[ast.AST]:
        """Go through the head of the statement that failed."""
        for root in get_head(self.statement):
            yield from ast.walk(root)

    def find_values(self) -> Iterator[tuple[ast.expr, Any]]:
        """Go through the names and fields of the expression, each once, with what they held."""
        seen = set()
        inside: set[ast.AST] = set()
        for node in self.walk():
            if not isinstance(node, ast.Name | ast.Attribute) or node in inside:
                continue
            value = self.get_value(node)
            text = self.show(node)
            if value is UNKNOWN or isinstance(value, ModuleType) or not text or text in seen:
                continue
            seen.add(text)
            inside.update(ast.walk(node))
            yield node, value

    def find_origin(self, name: str) -> tuple[int, str] | None:
        """Return line and called function where a name got its value, if there is one place."""
        function = find_function(self.source, self.frame)
        if function is None:
            return None
        given = [node for node in ast.walk(function) if binds(node, name) and node is not function]
        if len(given) != 1:
            return None
        assigned = next(
            (
                node
                for node in ast.walk(function)
                if isinstance(node, ast.Assign) and node.targets == given
            ),
            None,
        )
        if assigned is None or not isinstance(assigned.value, ast.Call):
            return None
        called = self.show(assigned.value.func)
        return (assigned.lineno, called) if called else None


def find_site(error: BaseException, filename: str, call: Call) -> Site:
    """Find the deepest place in the learner's file or cell on the way to an exception."""
    frames = list(_walk_traceback(error.__traceback__))
    own = [place for place in frames if place.tb_frame.f_code.co_filename == filename]
    if not own:
        return Site(error, call)
    place = own[-1]
    source = "".join(linecache.getlines(filename, place.tb_frame.f_globals))
    tree = parse(source)
    code = place.tb_frame.f_code
    where: Position = next(
        islice(code.co_positions(), place.tb_lasti // 2, None), (None, None, None, None)
    )
    if where[0] is None:  # Python was told to keep no columns
        where = (place.tb_lineno, place.tb_lineno, None, None)
    statement = None if tree is None else find_statement(tree, where)
    return Site(
        error,
        call,
        place.tb_frame,
        source,
        None if statement is None else find_expression(statement, where),
        statement,
        place is frames[-1] and raises(statement, error),
    )


def _walk_traceback(traceback: TracebackType | None) -> Iterator[TracebackType]:
    while traceback is not None:
        yield traceback
        traceback = traceback.tb_next


def is_quiet(value: object) -> bool:
    """Tell whether looking at the attributes of a value runs no code of a learner."""
    kind = type(value)
    if issubclass(kind, ModuleType):
        return True
    module = (value if issubclass(kind, type) else kind).__module__
    return isinstance(module, str) and (module.startswith(_QUIET) or module == "builtins")


def _get_field(value: object, name: str) -> Any:
    if isinstance(value, ModuleType):
        return vars(value).get(name, UNKNOWN)
    if type(value) is np.ndarray:
        return getattr(value, name) if name in _FIELDS else UNKNOWN
    if type(value).__module__.startswith("mujoco._structs"):
        return getattr(value, name, UNKNOWN)
    return UNKNOWN


def _get_length(value: object) -> Any:
    if type(value) is np.ndarray:
        return len(value) if value.ndim else UNKNOWN
    return len(value) if type(value) in (list, tuple, dict, str) else UNKNOWN  # type: ignore[arg-type]


def _get_item(value: object, index: object) -> Any:
    if type(value) not in (dict, list, tuple, np.ndarray) or type(index) not in (int, str):
        return UNKNOWN
    try:
        return value[index]  # type: ignore[index]  # one of the four above
    except (LookupError, TypeError, ValueError):
        return UNKNOWN
