"""Say how an answer differs: an exact relation between what came and what was due, or nothing.

Where no listed mistake fits, `Differences` looks for the simplest relation that holds in every
case, out of a small algebra; each kind of answer names the families of it that make sense. What is
told was seen in every value of every case. It is never a guess, and never the value that is due.
"""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.compare import align_rows
from labutils.checks.explain import axes, numbers, places, regions, rigid, selections
from labutils.checks.explain.arguments import find_places
from labutils.checks.explain.relation import Pair, Relation, choose, may_fit
from labutils.checks.explain.told import Explanation
from labutils.checks.kinds import get_kind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

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
    "rigid": rigid.propose,
}

#: So many wrong cases at most are named, one by one.
_MOST_ODD_CASES = 3

#: A part that is right in fewer cases may be so by accident.
_MIN_CASES = 2

_SCOPES = {1: "", 2: "In both cases: "}


class Differences:
    """What can be told of how answers differ from what was due.

    Parameters
    ----------
    table : CheckTable
        The cases and the answers due.
    answers : tuple of Outcome
        What came, one per case.
    """

    def __init__(self, table: CheckTable, answers: tuple[Outcome, ...]) -> None:
        self._table = table
        self._parts = [pairs for pairs in collect_pairs(table, answers) if pairs]
        self._wrong, self._right = _sort_cases(self._parts)

    @cached_property
    def _relations(self) -> list[Relation | None]:
        """The relation of every part in all cases; None also of those that are right."""
        with np.errstate(all="ignore"):
            return [
                None if all(pair.is_right for pair in pairs) else _relate(pairs)
                for pairs in self._parts
            ]

    def find_relation(self) -> Explanation | None:
        """Find how every wrong part differs: in all cases, or in those that are wrong alone.

        Returns
        -------
        Explanation or None
            None unless every wrong part has exactly one simplest relation.
        """
        if found := _tell_parts(self._table, self._parts, self._relations, ""):
            return found
        if not self._wrong or not self._right:
            return None
        some = [[pair for pair in pairs if pair.case in self._wrong] for pairs in self._parts]
        some = [pairs for pairs in some if pairs]
        many = "s" if len(self._wrong) > 1 else ""
        cases = f"case{many} {_join([str(case + 1) for case in self._wrong])}"
        others = "the others agree" if len(self._right) > 1 else "the other agrees"
        with np.errstate(all="ignore"):
            return _tell_parts(
                self._table, some, map(_relate, some), f"Only in {cases}, {others}: "
            )

    def find_partial(self) -> Explanation | None:
        """Tell of several parts what can be told: the relation of some, or which are right.

        Weaker than a relation: another part is wrong as well, and nobody knows how.
        """
        if len(self._parts) < 2:
            return None
        if found := _tell_parts(self._table, self._parts, self._relations, "", partly=True):
            return found
        shown = [pairs for pairs in self._parts if not get_kind(pairs[0].part).is_observed]
        right = [pairs[0].part.name for pairs in shown if all(pair.is_right for pair in pairs)]
        wrong = [pairs[0].part.name for pairs in shown if not all(pair.is_right for pair in pairs)]
        if not right or not wrong or len({pair.case for pair in shown[0]}) < _MIN_CASES:
            return None
        return Explanation(
            f"only-part:{'+'.join(wrong)}",
            f"{_join(right)} agree{'' if len(right) > 1 else 's'} in every case: only "
            f"{_join(wrong)} {'is' if len(wrong) == 1 else 'are'} wrong.",
        )

    def find_odd_case(self) -> Explanation | None:
        """Name the only case that is wrong, or the only one that is right: its label says why.

        The weakest that can be told. Two or three wrong cases are named as well, where more are
        right.
        """
        wrong, right, cases = self._wrong, self._right, self._table.cases
        count = len(wrong) + len(right)
        if len(wrong) == 1 < len(right):
            text = f"Of {count} cases only this one is wrong: {cases[wrong[0]].label}."
            return Explanation(f"only-wrong:{wrong[0] + 1}", text)
        if 1 < len(wrong) <= _MOST_ODD_CASES and len(wrong) < len(right):
            labels = "; ".join(cases[case].label for case in wrong)
            text = f"Of {count} cases only {len(wrong)} are wrong: {labels}."
            return Explanation(f"only-wrong:{'+'.join(str(case + 1) for case in wrong)}", text)
        if len(right) == 1 < len(wrong):
            text = f"Of {count} cases only one is right: {cases[right[0]].label}."
            return Explanation(f"only-right:{right[0] + 1}", text)
        return None


def _join(names: list[str]) -> str:
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last


def _tell_parts(
    table: CheckTable,
    parts: list[list[Pair]],
    relations: Iterable[Relation | None],
    scope: str,
    *,
    partly: bool = False,
) -> Explanation | None:
    """Put the relations of parts into words; None where a wrong part has none of its own.

    With ``partly``, one that has none is told to be wrong, too.
    """
    texts, names, right, lost, seen = [], [], [], [], set()
    count = 0
    for pairs, relation in zip(parts, relations, strict=True):
        part = pairs[0].part
        if all(pair.is_right for pair in pairs):
            right.append(part.name)
            continue
        if relation is None and not partly:
            return None
        if relation is None:
            lost.append(part.name)
            continue
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
    scope = scope or _SCOPES.get(count, f"In all {count} cases: ")
    agree = f" {_join(right)} agree{'' if len(right) > 1 else 's'}." if right else ""
    if lost:
        agree += f" {_join(lost)} {'is' if len(lost) == 1 else 'are'} wrong in another way."
    return Explanation("+".join(names), f"{scope}{'. '.join(texts)}.{agree}")


def _sort_cases(parts: list[list[Pair]]) -> tuple[list[int], list[int]]:
    """Return the cases with a wrong part, and the others; an empty one is right by itself."""
    state: dict[int, bool] = {}
    for pairs in parts:
        for pair in pairs:
            if pair.due.size or not pair.is_right:
                state[pair.case] = state.get(pair.case, True) and pair.is_right
    wrong = [case for case, is_right in state.items() if not is_right]
    return wrong, [case for case, is_right in state.items() if is_right]


def _relate(pairs: list[Pair]) -> Relation | None:
    if not may_fit(pairs):
        return None
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
    places_of = find_places(table)
    for index, (case, due, yours) in enumerate(
        zip(table.cases, table.expected, answers, strict=True)
    ):
        if not isinstance(due, tuple) or not isinstance(yours, tuple):
            continue
        aligned = align_rows(table.parts, due, yours)
        args = {name: case.args[place] for name, place in places_of.items()}
        for number, (part, x, y) in enumerate(zip(table.parts, due, aligned, strict=True)):
            if x is None or y is None or not (x.size or y.size):
                continue
            if x.ndim == y.ndim:
                x, y = map(get_kind(part).to_canonical, (x, y))  # noqa: PLW2901
            found[number].append(Pair(index, args, part, x, y))
    return found
