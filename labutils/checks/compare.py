"""When two answers are the same.

The same comparison decides whether an answer is right and whether it equals a known wrong one, so
that neither is judged more strictly than the other. What differs from kind to kind of answer is
asked of the kind.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from labutils.checks.kinds import get_kind
from labutils.checks.table import Misfit, Outcome, Part, Parts, Raised

if TYPE_CHECKING:
    import numpy as np


def is_same_outcome(parts: tuple[Part, ...], a: Outcome, b: Outcome) -> bool:
    """Tell whether two answers to one case are the same within the tolerances."""
    if isinstance(a, Misfit) or isinstance(b, Misfit):
        return a == b
    if isinstance(a, Raised) or isinstance(b, Raised):
        return isinstance(a, Raised) and isinstance(b, Raised) and _is_same_error(a, b)
    a, b = _read_traces(parts, a), _read_traces(parts, b)
    if not _is_alike(a, b):
        return False
    b = align_rows(parts, a, b)
    return all(is_close(part, x, y) for part, x, y in zip(parts, a, b, strict=True))


def _read_traces(parts: tuple[Part, ...], outcome: Parts) -> Parts:
    """Bring traces of loops into the form in which they are compared: their lengths differ."""
    return tuple(
        value if value is None or kind.is_repeatable else kind.to_canonical(value)
        for value, kind in zip(outcome, map(get_kind, parts), strict=True)
    )


def _is_same_error(a: Raised, b: Raised) -> bool:
    # A TypeError comes of any wrong call, so its words have to agree too. The words of others
    # differ between versions of Python.
    return a.kind == b.kind and (a.kind != "TypeError" or a.text == b.text)


def _is_alike(a: Parts, b: Parts) -> bool:
    """Compare what is cheap: None, whole or broken numbers, and shapes."""
    for x, y in zip(a, b, strict=True):
        if x is None or y is None:
            if x is not y:
                return False
        elif x.shape != y.shape or any(
            (x.dtype.kind == kind) != (y.dtype.kind == kind) for kind in "fU"
        ):
            return False
    return True


def is_close(part: Part, expected: np.ndarray | None, yours: np.ndarray | None) -> bool:
    """Tell whether one part agrees within its tolerance; shapes have to agree already."""
    if expected is None or yours is None:
        return expected is yours
    return get_kind(part).is_close(part, expected, yours)


def align_rows(parts: tuple[Part, ...], expected: Parts, yours: Parts) -> Parts:
    """Bring the points of a cloud, and what is attached to them, into the expected order.

    Returns `yours` as it is where no order makes the points agree.
    """
    for part, x, y in zip(parts, expected, yours, strict=True):
        if x is None or y is None or x.shape != y.shape:
            continue
        order = get_kind(part).find_order(part, x, y)
        if order is not None:
            return tuple(_move(*pair, order) for pair in zip(parts, yours, strict=True))
    return yours


def _move(part: Part, value: np.ndarray | None, order: np.ndarray) -> np.ndarray | None:
    if value is None or not get_kind(part).moves_with_cloud or len(value) != len(order):
        return value
    return value[order]


def to_canonical(parts: tuple[Part, ...], outcome: Outcome) -> Outcome:
    """Bring an answer into the form that comparing needs, so that this is done once."""
    if isinstance(outcome, Raised | Misfit):
        return outcome
    return tuple(
        None if value is None else get_kind(part).to_canonical(value)
        for part, value in zip(parts, outcome, strict=True)
    )
