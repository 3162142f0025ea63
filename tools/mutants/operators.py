"""The small faults: every way to change one node of a function.

A mutation is named without line numbers: by the place of its node in the tree of the function and
by what is done to it, so that names survive reformatting and edits elsewhere in the file.
"""

from __future__ import annotations

import ast
import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

_COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_ARITHMETIC: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}
#: Names whose meaning turns around or shifts a little, functions and dtypes alike.
_NAMES = {
    "min": "max",
    "max": "min",
    "argmin": "argmax",
    "argmax": "argmin",
    "floor": "ceil",
    "ceil": "floor",
    "rint": "floor",
    "round": "floor",
    "any": "all",
    "all": "any",
    "mean": "median",
    "median": "mean",
    "zeros": "ones",
    "ones": "zeros",
    "float64": "float32",
    "float32": "float64",
    "uint8": "int64",
    "int16": "uint8",
    "int64": "uint8",
    "int": "float",
    "float": "int",
    "COLOR_RGB2HSV": "COLOR_BGR2HSV",
    "MORPH_OPEN": "MORPH_CLOSE",
    "MORPH_CLOSE": "MORPH_OPEN",
    "RETR_EXTERNAL": "RETR_LIST",
}


@dataclass(frozen=True)
class Mutation:
    """One fault: where (fields and indices from the root of the tree), what, and its new node.

    A new node of None removes what was there from its list.
    """

    path: tuple[str | int, ...]
    operator: str
    node: ast.AST | None
    change: str

    @property
    def place(self) -> str:
        """The path in one word."""
        return ".".join(map(str, self.path))


def find_mutations(tree: ast.FunctionDef | ast.Assign | ast.AnnAssign) -> list[Mutation]:
    """List all faults of a function, or of a constant of its module, in the order of the text."""
    found: list[Mutation] = []
    seen = {ast.dump(tree)}
    for mutation in _walk(tree, ()):
        text = ast.dump(apply(tree, mutation))
        if text not in seen:  # 0 + 1 and 0 - -1 are one fault
            seen.add(text)
            found.append(mutation)
    return found


def apply(tree: Any, mutation: Mutation) -> Any:
    """Return a copy of the tree with the fault."""
    tree = copy.deepcopy(tree)
    *parents, last = mutation.path
    holder: Any = tree
    for step in parents:
        holder = holder[step] if isinstance(step, int) else getattr(holder, step)
    if mutation.node is None:
        del holder[last]
    elif isinstance(last, int):
        holder[last] = copy.deepcopy(mutation.node)
    else:
        setattr(holder, last, copy.deepcopy(mutation.node))
    return ast.fix_missing_locations(tree)


def _walk(node: ast.AST, path: tuple[str | int, ...], *, index: bool = False) -> Iterator[Mutation]:
    """Visit what computes: no annotation, no default, no decorator, no message of an error."""
    if isinstance(node, ast.Raise):
        return
    for operator, new in _change(node, index=index):
        yield Mutation(path, operator, new, f"`{_shorten(node)}` to `{_shorten(new)}`")
    if isinstance(node, ast.Call):
        for number, keyword in enumerate(node.keywords):
            lost = f"`{keyword.arg}={_shorten(keyword.value)}` lost in `{_shorten(node.func)}()`"
            yield Mutation((*path, "keywords", number), "keyword-lost", None, lost)
    if isinstance(node, ast.FunctionDef):
        yield from _walk_body(node.body, (*path, "body"), _collect_arguments(node))
    else:
        yield from _walk_fields(node, path, index=index)


def _walk_fields(node: ast.AST, path: tuple[str | int, ...], *, index: bool) -> Iterator[Mutation]:
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "type_comment", "ctx"):
            continue
        if isinstance(value, ast.AST):
            inside = name == "slice" or (index and isinstance(node, ast.Slice | ast.Tuple))
            yield from _walk(value, (*path, name), index=inside)
        elif isinstance(value, list) and value and isinstance(value[0], ast.stmt):
            yield from _walk_body(value, (*path, name), set())
        elif isinstance(value, list):
            for number, one in enumerate(value):
                if isinstance(one, ast.AST):
                    inside = index and isinstance(node, ast.Tuple)
                    yield from _walk(one, (*path, name, number), index=inside)


def _collect_arguments(node: ast.FunctionDef) -> set[str]:
    given = node.args
    return {one.arg for one in (*given.posonlyargs, *given.args, *given.kwonlyargs)}


def _walk_body(
    body: list[ast.stmt], path: tuple[str | int, ...], bound: set[str]
) -> Iterator[Mutation]:
    """Visit statements; lose those without which the function still has all its names."""
    for number, statement in enumerate(body):
        place = (*path, number)
        if _is_text(statement):
            continue
        if _may_be_lost(statement, bound):
            yield Mutation(place, "line-lost", ast.Pass(), f"`{_shorten(statement)}` lost")
        yield from _walk(statement, place)
        bound |= {
            one.id
            for one in ast.walk(statement)
            if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)
        }


def _is_text(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def _may_be_lost(statement: ast.stmt, bound: set[str]) -> bool:
    if isinstance(statement, ast.Assign):
        names = [one for target in statement.targets for one in ast.walk(target)]
        stored = [
            one.id for one in names if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)
        ]
        return all(name in bound for name in stored)
    return isinstance(
        statement, ast.Expr | ast.AugAssign | ast.If | ast.Continue | ast.For | ast.While
    )


def _change(node: ast.AST, *, index: bool) -> Iterator[tuple[str, ast.AST]]:  # noqa: C901, PLR0912
    """Give the other nodes that may stand here, one fault each."""
    if isinstance(node, ast.Constant):
        yield from _change_constant(node.value, index=index)
    elif isinstance(node, ast.Compare):
        for number, kind in enumerate(node.ops):
            for other in _COMPARISONS.get(type(kind), ()):
                ops = [*node.ops[:number], other(), *node.ops[number + 1 :]]
                which = f"-{number}" if len(node.ops) > 1 else ""
                yield (
                    f"compare{which}-{other.__name__}",
                    ast.Compare(left=node.left, ops=ops, comparators=node.comparators),
                )
    elif isinstance(node, ast.BinOp):
        if other_kind := _ARITHMETIC.get(type(node.op)):
            yield (
                f"arithmetic-{other_kind.__name__}",
                ast.BinOp(left=node.left, op=other_kind(), right=node.right),
            )
        if isinstance(node.op, ast.MatMult):
            yield "product-swapped", ast.BinOp(left=node.right, op=node.op, right=node.left)
    elif isinstance(node, ast.AugAssign):
        if other_kind := _ARITHMETIC.get(type(node.op)):
            yield (
                f"arithmetic-{other_kind.__name__}",
                ast.AugAssign(target=node.target, op=other_kind(), value=node.value),
            )
    elif isinstance(node, ast.UnaryOp):
        yield f"{type(node.op).__name__}-lost", node.operand
    elif isinstance(node, ast.BoolOp):
        swapped = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield "and-or", ast.BoolOp(op=swapped, values=node.values)
    elif isinstance(node, ast.Slice):
        for bound in ("lower", "upper", "step"):
            if getattr(node, bound) is not None:
                kept = {one: getattr(node, one) for one in ("lower", "upper", "step")}
                yield f"{bound}-lost", ast.Slice(**{**kept, bound: None})
    elif isinstance(node, ast.If | ast.While | ast.IfExp):
        if not isinstance(node.test, ast.Compare):  # a comparison is turned around elsewhere
            other_node = copy.copy(node)
            other_node.test = ast.UnaryOp(op=ast.Not(), operand=node.test)
            yield "not", other_node
    elif isinstance(node, ast.Attribute) and node.attr == "T":
        yield "transpose-lost", node.value
    elif isinstance(node, ast.Attribute) and node.attr in _NAMES:
        yield "name", ast.Attribute(value=node.value, attr=_NAMES[node.attr], ctx=node.ctx)
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in _NAMES:
        yield "name", ast.Name(id=_NAMES[node.id], ctx=node.ctx)


def _change_constant(value: object, *, index: bool) -> Iterator[tuple[str, ast.AST]]:
    if isinstance(value, bool):
        yield "flipped", ast.Constant(not value)
    elif isinstance(value, int | float):
        changes = {"plus-1": value + 1, "minus-1": value - 1}
        if not index:
            changes |= {"doubled": 2 * value, "zero": 0 * value, "negated": -value}
        for name, other in changes.items():
            if other != value:
                yield name, ast.Constant(other)


def _shorten(node: ast.AST | None) -> str:
    if node is None:
        return ""
    text = ast.unparse(node).splitlines()[0]
    return text if len(text) <= 60 else text[:57] + "..."
