"""Compile a mutant beside the reference, so that nothing else ever sees it.

What may be faulty is the reference, the functions of our own code that it calls, and the constants
of their modules. A mutant is made of fresh copies of all of these: the checker and the renderer,
which use the same library, keep the originals.
"""

from __future__ import annotations

import ast
import copy
import inspect
import math
import sys
from dataclasses import dataclass
from functools import cache
from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from tools.mutants.operators import Mutation, apply, find_mutations

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: Our own code below the reference; the renderers and the checker are what an exercise is given.
_ROOMS = ("labutils", "solutions")
_GIVEN = ("labutils.renderers", "labutils.raycast", "labutils.checks")

_Tree = ast.FunctionDef | ast.Assign | ast.AnnAssign


@dataclass(frozen=True)
class _Piece:
    """A function, or a constant of a module, that a mutant has a copy of."""

    module: str
    name: str
    tree: _Tree


@dataclass(frozen=True)
class Mutant:
    """A faulty function and its name: file, function, place in its tree, what was done."""

    id: str
    change: str
    piece: _Piece
    mutation: Mutation


def list_mutants(reference: Callable[..., Any]) -> list[Mutant]:
    """List all mutants of a reference and of what it stands on."""
    return [
        Mutant(
            f"{piece.module.replace('.', '/')}.py:{piece.name}:{mutation.place}:"
            f"{mutation.operator}",
            mutation.change,
            piece,
            mutation,
        )
        for piece in collect_pieces(reference)
        for mutation in find_mutations(piece.tree)
    ]


def find_lines(mutant: Mutant) -> range | None:
    """Return the lines of the statement with the fault; None for a constant of the module."""
    node: Any = mutant.piece.tree
    statement: ast.stmt | None = None
    for step in mutant.mutation.path:
        node = node[step] if isinstance(step, int) else getattr(node, step)
        if isinstance(node, ast.stmt):
            statement = node
    if statement is None or isinstance(mutant.piece.tree, ast.Assign | ast.AnnAssign):
        return None
    return range(statement.lineno, (statement.end_lineno or statement.lineno) + 1)


def get_file(module: str) -> str:
    """Return what the code of a copy names as its file."""
    return f"<copy of {module}>"


def build(reference: Callable[..., Any], mutant: Mutant | None = None) -> Callable[..., Any]:
    """Compile the reference anew, with the fault of a mutant; without one for comparison."""
    pieces = collect_pieces(reference)
    spaces: dict[str, dict[str, Any]] = {
        one.module: {**vars(sys.modules[one.module]), "_make_dirty": _make_dirty} for one in pieces
    }
    # Constants first: a default argument is read where its function is defined.
    for piece in sorted(pieces, key=lambda one: isinstance(one.tree, ast.FunctionDef)):
        if mutant is not None and piece == mutant.piece:
            code = _compile(apply(piece.tree, mutant.mutation), piece.module)
        else:
            code = _compile_original(piece)
        original = vars(sys.modules[piece.module])[piece.name]
        exec(code, spaces[piece.module])  # noqa: S102 - our own source, changed by us
        fresh = spaces[piece.module][piece.name]
        for space in spaces.values():
            if space.get(piece.name) is original:
                space[piece.name] = fresh
    function: Callable[..., Any] = spaces[reference.__module__][reference.__name__]
    return function


@cache
def collect_pieces(reference: Callable[..., Any]) -> tuple[_Piece, ...]:
    """Collect the reference, the functions it calls and their constants, innermost first."""
    pieces: list[_Piece] = []
    seen: set[tuple[str, str]] = set()

    def visit(module: ModuleType, name: str) -> None:
        tree = _read_module(module).get(name)
        if tree is None or (module.__name__, name) in seen:
            return
        seen.add((module.__name__, name))
        for used in _list_names(tree):
            if home := _find_home(module, used):
                visit(home, used)
        pieces.append(_Piece(module.__name__, name, tree))

    visit(sys.modules[reference.__module__], reference.__name__)
    return tuple(pieces)


@cache
def _read_module(module: ModuleType) -> dict[str, _Tree]:
    """Return the functions and constants of a module by name."""
    trees: dict[str, _Tree] = {}
    for node in ast.parse(inspect.getsource(module)).body:
        if isinstance(node, ast.FunctionDef):
            trees[node.name] = node
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            if isinstance(target, ast.Name) and not isinstance(node.value, ast.Subscript):
                trees[target.id] = node
    return trees


def _list_names(tree: ast.AST) -> Iterator[str]:
    """Give the names a piece reads, but for those that only words of an error need."""
    if isinstance(tree, ast.Raise):
        return
    if isinstance(tree, ast.Name):
        yield tree.id
    for field, value in ast.iter_fields(tree):
        if field in ("annotation", "returns"):
            continue
        for one in value if isinstance(value, list) else [value]:
            if isinstance(one, ast.AST):
                yield from _list_names(one)


def _find_home(module: ModuleType, name: str) -> ModuleType | None:
    """Return the module of ours in which a name is defined, or None."""
    value = vars(module).get(name)
    if value is None or inspect.isclass(value):
        return None
    if name in _read_module(module):
        home = module
    elif isinstance(inspect.unwrap(value) if callable(value) else value, FunctionType):
        home = sys.modules[inspect.unwrap(value).__module__]
    elif "labutils._constants" in sys.modules and name in vars(sys.modules["labutils._constants"]):
        home = sys.modules["labutils._constants"]
    else:
        return None
    is_ours = home.__name__.partition(".")[0] in _ROOMS
    return home if is_ours and not home.__name__.startswith(_GIVEN) else None


@cache
def _compile_original(piece: _Piece) -> Any:
    return _compile(piece.tree, piece.module)


def _compile(tree: _Tree, module: str) -> Any:
    tree = _Dirty().visit(copy.deepcopy(tree))
    future = ast.parse("from __future__ import annotations").body
    whole = ast.Module(body=[*future, tree], type_ignores=[])
    return compile(ast.fix_missing_locations(whole), get_file(module), "exec")


class _Dirty(ast.NodeTransformer):
    """Let memory that nobody has written hold nothing that could be right by chance."""

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.func, ast.Attribute) and node.func.attr == "empty":
            node.func = ast.Name(id="_make_dirty", ctx=ast.Load())
        return node


def _make_dirty(shape: Any, dtype: Any = np.float64) -> np.ndarray:
    fill = math.nan if np.dtype(dtype).kind == "f" else 113
    return np.full(shape, fill, dtype)
