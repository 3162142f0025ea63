"""Say how an answer differs: an exact relation between what came and what was due, or nothing.

Where no listed mistake fits, `find_relation` looks for the simplest relation that holds in every
case, out of a small algebra; each kind of answer names the families of it that make sense. What is
told was seen in every value of every case. It is never a guess, and never the value that is due.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.compare import align_rows
from labutils.checks.explain import axes, numbers, places, regions, selections
from labutils.checks.explain.relation import Pair, Relation, choose
from labutils.checks.explain.told import Explanation
from labutils.checks.kinds import get_kind
from labutils.checks.table import Scene

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from labutils.checks.table import CheckTable, Outcome

#: The families of relations, by the names that kinds of answers give them.
FAMILIES: dict[str, Callable[[list[Pair]], Iterator[Relation]]] = {
    "numbers": numbers.propose,
    "pictures": places.propose_pictures,
    "masks": places.propose_masks,
    "colors": places.propose_colors,
    "matrices": places.propose_matrices,
    "lists": places.propose_lists,
    "flags": places.propose_flags,
    "axes": axes.propose_axes,
    "entries": axes.propose_entries,
    "selections": selections.propose,
    "regions": regions.propose,
}

_SCOPES = {1: "", 2: "In both cases: "}


def find_relation(table: CheckTable, answers: tuple[Outcome, ...]) -> Explanation | None:
    """Find the relation of every wrong part, the same one in all cases where both exist.

    Parameters
    ----------
    table : CheckTable
        The cases and the answers due.
    answers : tuple of Outcome
        What came, one per case.

    Returns
    -------
    Explanation or None
        None unless every wrong part has exactly one simplest relation.
    """
    texts, names, right, seen = [], [], [], set()
    with np.errstate(all="ignore"):
        for pairs in collect_pairs(table, answers):
            if not pairs:
                continue
            part = pairs[0].part
            if all(pair.is_right for pair in pairs):
                right.append(part.name)
                continue
            relation = _relate(pairs)
            if relation is None:
                return None
            # A cloud and its colors lose the same rows: that is said once.
            if relation.text in seen:
                continue
            seen.add(relation.text)
            # An entry bears the name of its part already.
            start = "" if relation.text.startswith(f"{part.name}[") else f"{part.name}: "
            texts.append(f"{start}{relation.text}")
            names.append(f"{relation.name}:{part.name}" if len(table.parts) > 1 else relation.name)
            count = len({pair.case for pair in pairs})
    if not texts:
        return None
    scope = _SCOPES.get(count, f"In all {count} cases: ")
    agree = f" {' and '.join(right)} agree{'' if len(right) > 1 else 's'}." if right else ""
    return Explanation("+".join(names), f"{scope}{'. '.join(texts)}.{agree}")


def _relate(pairs: list[Pair]) -> Relation | None:
    kind = get_kind(pairs[0].part)
    proposals = [one for family in kind.relations for one in FAMILIES[family](pairs)]
    return choose([*proposals, *_propose_arguments(pairs)], pairs)


def _propose_arguments(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that an argument came back unchanged."""
    for name, value in pairs[0].args.items():
        if isinstance(value, np.ndarray) and all(name in pair.args for pair in pairs):
            yield Relation(
                f"returned:{name}",
                f"{name}, unchanged",
                0.9,
                partial(_get_argument, name),
            )


def _get_argument(name: str, pair: Pair) -> np.ndarray:
    return pair.args[name]


def collect_pairs(table: CheckTable, answers: tuple[Outcome, ...]) -> list[list[Pair]]:
    """Pair what was due with what came: one list per part, of the cases where both exist."""
    found: list[list[Pair]] = [[] for _ in table.parts]
    for index, (case, due, yours) in enumerate(
        zip(table.cases, table.expected, answers, strict=True)
    ):
        if not isinstance(due, tuple) or not isinstance(yours, tuple):
            continue
        aligned = align_rows(table.parts, due, yours)
        args = _name_arguments(table, case.args)
        for number, (part, x, y) in enumerate(zip(table.parts, due, aligned, strict=True)):
            if x is None or y is None or not (x.size or y.size):
                continue
            canonical = get_kind(part).to_canonical
            try:
                pair = Pair(index, args, part, canonical(x), canonical(y))
            except (ValueError, IndexError):  # no picture of this kind
                continue
            found[number].append(pair)
    return found


def _name_arguments(table: CheckTable, args: tuple[object, ...]) -> dict[str, object]:
    """Name the arguments that are no scene; a scene fills several parameters."""
    names = list(table.parameters)
    found: dict[str, object] = {}
    for value in args:
        if isinstance(value, Scene):
            del names[: len(value.gives)]
        else:
            found[names.pop(0)] = value
    return found
