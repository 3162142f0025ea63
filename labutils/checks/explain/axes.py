"""Relations that exchange columns or turn their signs, and those of single entries and columns."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.explain import numbers
from labutils.checks.explain.relation import Pair, Relation, choose, find_close
from labutils.checks.kinds import get_kind

if TYPE_CHECKING:
    from collections.abc import Iterator

#: Where a value stands: an entry of few numbers, or a column of many rows.
_Place = tuple[Any, ...]


def propose_axes(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose signed exchanges of two or three columns."""
    width = pairs[0].due.shape[-1] if pairs[0].due.ndim else 0
    if width not in (2, 3):
        return
    names = _name_columns(pairs[0].part, width)
    has_signs = pairs[0].due.dtype.kind == "f"
    signs = list(itertools.product((1, -1), repeat=width)) if has_signs else [(1,) * width]
    for order in itertools.permutations(range(width)):
        for sign in signs:
            flips = sum(one < 0 for one in sign)
            if order == tuple(range(width)) and flips in (0, width):
                continue
            yield _make_exchange(order, sign, names)


def _make_exchange(order: tuple[int, ...], sign: tuple[int, ...], names: list[str]) -> Relation:
    moved = [place for place, source in enumerate(order) if place != source]
    flips = [place for place, one in enumerate(sign) if one < 0]
    agree = [names[i] for i in range(len(order)) if i not in moved and i not in flips]
    if not moved:
        turned = " and ".join(names[i] for i in flips)
        text = f"{turned} {'have' if len(flips) > 1 else 'has'} the wrong sign"
    else:
        parts = [("-" if one < 0 else "") + names[i] for i, one in zip(order, sign, strict=True)]
        text = f"it holds ({', '.join(parts)}) of what is due in place of ({', '.join(names)})"
    if agree:
        text += f"; {' and '.join(agree)} {'agree' if len(agree) > 1 else 'agrees'}"
    said = ",".join(("-" if one < 0 else "") + names[i] for i, one in zip(order, sign, strict=True))
    return Relation(
        f"axes:{said}",
        text,
        1.1 + 0.1 * len(flips) + 0.1 * len(moved),
        lambda pair: pair.due[..., list(order)] * np.array(sign, pair.due.dtype),
        by_row=True,
    )


def _name_columns(part: Any, width: int) -> list[str]:
    names = getattr(get_kind(part), "columns", "") or getattr(get_kind(part), "places", "")
    return [names[i] if i < len(names) else f"{part.name}[{i}]" for i in range(width)]


def propose_entries(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that some entries, or columns, are right and each of the others has its own relation.

    One proposal at most: the simplest for every wrong place.
    """
    shape = pairs[0].due.shape
    if any(pair.due.shape != pair.yours.shape for pair in pairs) or not shape:
        return
    is_few = get_kind(pairs[0].part).is_few
    places: list[_Place] = (
        list(np.ndindex(shape)) if is_few else [(Ellipsis, i) for i in range(shape[-1])]
    )
    found: dict[_Place, Relation] = {}
    right = 0
    for place in places:
        own = [_take(pair, place) for pair in pairs]
        if all(find_close(pair, pair.due, pair.yours).all() for pair in own):
            right += 1
            continue
        one = choose(numbers.propose(own), own) or _find_exchanged(pairs, own, place, places)
        if one is None:
            return
        found[place] = one
    if not found or not right:
        return

    def predict(pair: Pair) -> np.ndarray:
        said = pair.due.astype(np.float64)
        for place, one in found.items():
            whole = one.name.startswith("other:")
            said[place] = one.predict(pair if whole else _take(pair, place))
        return said

    yield Relation(
        ";".join(f"{one.name}:{_name(pairs[0], place)}" for place, one in found.items()),
        f"{_tell(pairs[0], found)}; the rest agrees",
        sum(one.cost for one in found.values()) + 0.3 * len(found),
        predict,
        fitted=sum(one.fitted for one in found.values()),
        loose=max(1.0, *(one.loose for one in found.values())),
        by_row=not is_few,
    )


def _find_exchanged(
    pairs: list[Pair], own: list[Pair], place: _Place, places: list[_Place]
) -> Relation | None:
    """Find the one other place whose value came here."""
    fitting = []
    for other in places:
        if other == place:
            continue
        moved = [
            replace(one, due=np.asarray(pair.due[other]))
            for one, pair in zip(own, pairs, strict=True)
        ]
        agrees = all(find_close(pair, pair.due, pair.yours).all() for pair in moved)
        # Zeros agree with many places, and say nothing about where they came from.
        if agrees and any(np.abs(pair.due).max(initial=0) > pair.part.atol for pair in moved):
            fitting.append(other)
    if len(fitting) != 1:
        return None
    (source,) = fitting
    name = _name(pairs[0], source)
    return Relation(f"other:{name}", f"what is due at {name}", 1.8, lambda pair: pair.due[source])


def _take(pair: Pair, place: _Place) -> Pair:
    return replace(pair, due=np.asarray(pair.due[place]), yours=np.asarray(pair.yours[place]))


def _tell(pair: Pair, found: dict[_Place, Relation]) -> str:
    by_text: dict[str, list[str]] = {}
    for place, one in found.items():
        by_text.setdefault(one.text, []).append(_name(pair, place))
    return "; ".join(
        f"{' and '.join(names)} {'is' if len(names) == 1 else 'are'} {text}"
        for text, names in by_text.items()
    )


def _name(pair: Pair, place: _Place) -> str:
    if place[0] is Ellipsis:
        return _name_columns(pair.part, pair.due.shape[-1])[place[-1]]
    if len(place) == 1:
        return _name_columns(pair.part, len(pair.due))[place[0]]
    return f"{pair.part.name}[{', '.join(map(str, place))}]"
