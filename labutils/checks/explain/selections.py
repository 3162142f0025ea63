"""Relations between lists of different length: rows that are missing or too many."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.explain.relation import Pair, Relation

if TYPE_CHECKING:
    from collections.abc import Iterator

#: Fewer rows than this are in no order to speak of.
_MIN_ROWS = 4

#: In more rows than this, a sample is looked at first.
_MANY_ROWS = 5000
_SAMPLE = 12

#: Side of the cells that rows are compared in, in tolerances.
_CELL_TOLERANCES = 8


def propose(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that all rows but some are right, and say what those share."""
    lost_count = extra_count = 0
    shared: set[str] | None = None
    for pair in pairs:
        if pair.due.ndim != pair.yours.ndim or pair.due.shape[1:] != pair.yours.shape[1:]:
            return
        if _differs_both_ways(pair):
            return
        lost, extra = compare_rows(pair)
        if (len(lost) and len(extra)) or len(pair.yours) - len(pair.due) != len(extra) - len(lost):
            return
        lost_count, extra_count = lost_count + len(lost), extra_count + len(extra)
        if len(lost) or len(extra):
            traits = describe_rows(pair, lost if len(lost) else extra)
            shared = traits if shared is None else shared & traits
    if not lost_count + extra_count:
        if any(len(pair.due) >= _MIN_ROWS for pair in pairs):
            text = "the right rows, but in another order"
            yield Relation("reordered", text, 3.0, lambda pair: pair.yours)
        return
    if lost_count and extra_count:
        return
    word = "missing" if lost_count else "too many"
    # Two traits of the same rows cannot be told apart, so neither is told.
    trait = next(iter(shared)) if shared and len(shared) == 1 else ""
    count = lost_count + extra_count
    rows = "1 row is" if count == 1 else f"{count} rows are"
    yield Relation(
        f"rows:{word.replace(' ', '-')}" + (f":{trait}" if trait else ""),
        f"{rows} {word}{', all with ' + trait if trait else ''}; the others are right",
        2.0 if trait else 3.5,
        # What came is claimed to differ by these rows alone, which was verified above.
        lambda pair: pair.yours,
    )


def _differs_both_ways(pair: Pair) -> bool:
    """Tell from a few rows of a large pair whether each side has some that the other has not."""
    if min(len(pair.due), len(pair.yours)) < _MANY_ROWS or pair.due.dtype.kind not in "iuf":
        return False
    for own, other in ((pair.due, pair.yours), (pair.yours, pair.due)):
        near = _CELL_TOLERANCES * max(pair.part.atol, 1e-9)
        flat = other.reshape(len(other), -1)
        some = own.reshape(len(own), -1)[:: len(own) // _SAMPLE]
        some = some[np.isfinite(some).all(axis=1)] if own.dtype.kind == "f" else some
        if all((np.abs(flat - row) <= near).all(axis=1).any() for row in some):
            return False
    return True


def compare_rows(pair: Pair) -> tuple[np.ndarray, np.ndarray]:
    """Return the rows of what is due that are missing, and the rows of yours that are too many."""
    sides = []
    for own, other in ((pair.due, pair.yours), (pair.yours, pair.due)):
        left = np.ones(len(own), dtype=bool)
        # Shifted cells: a row near the border of one is inside another.
        for shift in (0.0, 0.25, 0.5, 0.75):
            known = set(_make_keys(pair, other, shift))
            left &= np.array([key not in known for key in _make_keys(pair, own, shift)], dtype=bool)
        sides.append(own[left])
    return sides[0], sides[1]


def _make_keys(pair: Pair, rows: np.ndarray, shift: float) -> list[tuple[object, ...]]:
    flat = rows.reshape(len(rows), int(np.prod(rows.shape[1:])))
    if flat.dtype.kind == "U":
        return [tuple(row) for row in flat.tolist()]
    step = max(pair.part.atol * _CELL_TOLERANCES, 1e-9)
    filled = np.nan_to_num(flat.astype(np.float64), nan=1e9, posinf=2e9, neginf=-2e9)
    return [tuple(row) for row in np.floor(filled / step + shift).tolist()]


def describe_rows(pair: Pair, rows: np.ndarray) -> set[str]:  # noqa: PLR0911 - one per trait
    """Say what all of these rows share, and none of the right ones has."""
    if rows.dtype.kind == "U":
        return set()
    flat = rows.reshape(len(rows), int(np.prod(rows.shape[1:]))).astype(np.float64)
    if np.isnan(flat).any(axis=1).all():
        return {"NaN"}
    if np.isinf(flat).any(axis=1).all():
        return {"infinite numbers"}
    if not np.isfinite(flat).all(axis=1).any():
        return {"NaN or infinite numbers"}
    if (flat == 0).all():
        return {"zeros only"}
    right = pair.due if len(pair.due) <= len(pair.yours) else pair.yours
    if len(right) <= 5:  # with so few, whatever a row has is special
        return set()
    right = right.astype(np.float64).reshape(len(right), -1)
    found = set()
    names = "xyz" if flat.shape[1] == 3 else [f"entry {i}" for i in range(flat.shape[1])]
    for column, name in enumerate(names):
        if flat[:, column].min() > np.nanmax(right[:, column]):
            found.add(f"a larger {name} than every right one")
        if flat[:, column].max() < np.nanmin(right[:, column]):
            found.add(f"a smaller {name} than every right one")
    return found
