"""Relations that hold in a part of a picture or of a list, and what marks that part."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils.checks.explain import numbers
from labutils.checks.explain.relation import Pair, Relation, choose, find_close
from labutils.checks.kinds import get_kind

if TYPE_CHECKING:
    from collections.abc import Iterator

#: With fewer values, wrong ones form a region by accident.
_MIN_VALUES = 12

#: Where more than this share is wrong, there is no region to speak of.
_MAX_SHARE = 0.9

#: A region that wrong places lie in, without being all of it: its largest share of everything, and
#: how many wrong places there are, at least, in numbers and as a share of it.
_MAX_REGION = 0.6
_MIN_WRONG = 5
_MIN_FILLED = 0.2


def propose(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that it is wrong exactly where something holds of the arguments or of the place."""
    if get_kind(pairs[0].part).is_few or not pairs[0].due.ndim:
        return
    if any(pair.due.shape != pair.yours.shape for pair in pairs):
        return
    wrongs = [_find_wrong_places(pair) for pair in pairs]
    sizes = [wrong.size for wrong in wrongs]
    if min(sizes) < _MIN_VALUES or not 0 < sum(w.sum() for w in wrongs) < _MAX_SHARE * sum(sizes):
        return
    places = [list_places(pair) for pair in pairs]
    seen: set[bytes] = set()
    for name in places[0]:
        if not all(name in one for one in places):
            continue
        marked = [one[name] for one in places]
        content = b"".join(mark.tobytes() for mark in marked)
        # Two names for one place: the first, which is the simpler, stands.
        if content in seen:
            continue
        seen.add(content)
        if all(np.array_equal(*both) for both in zip(marked, wrongs, strict=True)):
            yield _tell_exact(name, pairs, wrongs)
        elif _lie_within(wrongs, marked):
            yield Relation(
                f"within:{name}",
                f"it is wrong only where {name}; elsewhere it agrees",
                # The smaller the region, the more it says.
                5.0 + sum(int(mark.sum()) for mark in marked) / sum(sizes),
                lambda pair: pair.yours,
            )


def _tell_exact(name: str, pairs: list[Pair], wrongs: list[np.ndarray]) -> Relation:
    inside = [
        replace(pair, due=pair.due[wrong], yours=pair.yours[wrong])
        for pair, wrong in zip(pairs, wrongs, strict=True)
        if wrong.any()
    ]
    what = _describe_inside(inside)
    return Relation(
        f"where:{name}",
        f"it is wrong exactly where {name}" + (f"; there it is {what}" if what else ""),
        2.0,
        # The place is what is claimed, and was compared before.
        lambda pair: pair.yours,
    )


def _lie_within(wrongs: list[np.ndarray], marked: list[np.ndarray]) -> bool:
    """Tell whether all wrong places lie in a region that is small, and fill a good part of it."""
    if any((wrong & ~mark).any() for wrong, mark in zip(wrongs, marked, strict=True)):
        return False
    size = sum(int(mark.sum()) for mark in marked)
    count = sum(int(wrong.sum()) for wrong in wrongs)
    total = sum(mark.size for mark in marked)
    return size < _MAX_REGION * total and count >= max(_MIN_WRONG, _MIN_FILLED * size)


def _find_wrong_places(pair: Pair) -> np.ndarray:
    wrong = ~find_close(pair, pair.due, pair.yours)
    return np.asarray(wrong.any(axis=-1) if wrong.ndim > _count_axes(pair) else wrong)


def _count_axes(pair: Pair) -> int:
    """Count the axes of places: two of a picture, one of rows."""
    kind = get_kind(pair.part)
    return 2 if "pictures" in kind.relations else 1


def _describe_inside(pairs: list[Pair]) -> str:
    """Say what stands in the wrong places, if that is one value, one argument or one relation."""
    if pairs[0].yours.dtype.kind not in "iuf":
        return ""
    rows = [pair.yours.reshape(len(pair.yours), -1).astype(np.float64) for pair in pairs]
    values = np.unique(np.concatenate(rows), axis=0)
    if len(values) == 1:
        same = np.unique(values)
        if len(same) == 1:
            return get_kind(pairs[0].part).name_value(float(same[0]))
        return str(tuple(values[0].tolist()))
    for name, get in numbers.list_scalars(pairs):
        if "/" not in name and all(
            np.allclose(pair.yours, get(pair.args), rtol=0, atol=pair.part.atol or 1e-6)
            for pair in pairs
        ):
            return name
    one = choose(numbers.propose(pairs), pairs)
    return one.text if one and not one.fitted else ""


def list_places(pair: Pair) -> dict[str, np.ndarray]:
    """Name regions of a picture or of a list: masks over its pixels or rows."""
    axes = _count_axes(pair)
    shape = pair.due.shape[:axes]
    found: dict[str, np.ndarray] = {}
    limits = {
        name: float(value)
        for name, value in pair.args.items()
        if isinstance(value, int | float) and not isinstance(value, bool)
    }
    for name, value in pair.args.items():
        if not isinstance(value, np.ndarray) or value.dtype.kind not in "iuf":
            continue
        if value.ndim < axes or value.shape[:axes] != shape:
            continue
        found |= _list_value_places(name, value, limits, axes)
    found |= _list_due_places(pair, axes)
    found |= _list_border_places(shape)
    return found


def _list_value_places(
    name: str, value: np.ndarray, limits: dict[str, float], axes: int
) -> dict[str, np.ndarray]:
    columns = {name: value}
    if value.ndim > axes:
        if value.ndim != axes + 1 or value.shape[-1] > 3 or value.dtype.kind != "f":
            return {}
        letters = "xyz" if value.shape[-1] == 3 else "uv"
        columns = {f"{letters[i]} of {name}": value[..., i] for i in range(value.shape[-1])}
    found: dict[str, np.ndarray] = {}
    if value.ndim > axes:
        found[f"{name} has NaN"] = np.isnan(value).any(axis=-1)
    with np.errstate(invalid="ignore"):
        for word, one in columns.items():
            if one.dtype.kind == "f":
                found |= {
                    f"{word} is NaN": np.isnan(one),
                    f"{word} is infinite": np.isinf(one),
                    f"{word} is NaN or infinite": ~np.isfinite(one),
                    f"{word} is negative": one < 0,
                    f"{word} is 0 or less": one <= 0,
                    f"{word} is NaN, infinite, or 0 or less": ~(np.isfinite(one) & (one > 0)),
                    f"{word} is above 1": np.isfinite(one) & (one > 1),
                    f"{word} is outside 0 to 1": (one < 0) | (one > 1),
                    f"{word} is {MAX_DEPTH:g} or more": one >= MAX_DEPTH,
                    f"{word} is no valid depth": ~(
                        np.isfinite(one) & (one > MIN_DEPTH) & (one < MAX_DEPTH)
                    ),
                }
            found[f"{word} is 0"] = one == 0
            for other, limit in limits.items():
                found[f"{word} is above {other}"] = np.isfinite(one) & (one > limit)
                found[f"{word} is below {other}"] = np.isfinite(one) & (one < limit)
    return found


def _list_due_places(pair: Pair, axes: int) -> dict[str, np.ndarray]:
    due = pair.due
    if due.dtype.kind == "f":
        has_nan = np.isnan(due)
        found = {"NaN is due": has_nan.any(axis=-1) if due.ndim > axes else has_nan}
        if due.ndim == axes == 2 and np.isfinite(due).any():
            largest = due[np.isfinite(due)].max()
            found["the largest value of the picture is due"] = due == largest
        return found
    if due.dtype == np.uint8 and due.ndim > axes:
        black = (due == 0).all(axis=-1)
        return {"black is due": black, "a color is due": ~black}
    return {}


def _list_border_places(shape: tuple[int, ...]) -> dict[str, np.ndarray]:
    if len(shape) == 2:
        rim = np.zeros(shape, dtype=bool)
        rim[[0, -1]] = True
        rim[:, [0, -1]] = True
        return {"the border of the picture is": rim}
    first, last = np.zeros(shape, dtype=bool), np.zeros(shape, dtype=bool)
    if first.size:
        first[0] = last[-1] = True
    return {"the first one stands": first, "the last one stands": last}
