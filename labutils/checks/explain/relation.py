"""What a relation is, and when it may be told.

A relation predicts what came from what was due and from the arguments. It is told only where it
predicts every value of every case, moves enough values to mean something, and is the only one of
its size that does.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

import cv2
import numpy as np

from labutils.checks.kinds import get_kind

if TYPE_CHECKING:
    from collections.abc import Iterable

    from labutils.checks.table import Part

#: No picture supports a relation more than this many numbers do: its pixels depend on each other.
_MOST_SUPPORT = 50

#: A relation that is seen in a single case needs this many values to move.
_SUPPORT_OF_ONE_CASE = 8

#: Of arrays with more values than twice as many, some rows are looked at first.
_MANY = 6000

#: In some rows, this share may be wrong where any may be.
_SHARE_OF_SOME = 0.1

#: Costs that differ by less are the same size.
_SAME_COST = 0.05

#: What a proposal may raise where it makes no sense, such as the inverse of a singular matrix.
_NO_SENSE = (
    ArithmeticError,
    IndexError,
    KeyError,
    TypeError,
    ValueError,
    np.linalg.LinAlgError,
    cv2.error,
)


@dataclass(frozen=True)
class Pair:
    """One part of one case: the arguments by name, what was due and what came."""

    case: int
    args: dict[str, Any]
    part: Part
    due: np.ndarray
    yours: np.ndarray

    @cached_property
    def is_right(self) -> bool:
        """Whether the part agrees within its tolerance."""
        same_shape = self.due.shape == self.yours.shape
        return same_shape and get_kind(self.part).is_close(self.part, self.due, self.yours)


#: From a pair, what should have come; None where a relation says nothing of it.
Predict: TypeAlias = Callable[[Pair], Any]


def on_due(change: Callable[[Any], Any]) -> Predict:
    """Make a prediction of what a change does to what was due."""
    return lambda pair: change(pair.due)


@dataclass(frozen=True)
class Relation:
    """One way in which what came follows from what was due.

    Parameters
    ----------
    name : str
        Short and stable, such as "scaled:1000".
    text : str
        What to say after the name of the part and a colon: "1000 times what is due".
    cost : float
        The simpler, the less.
    predict : callable
        From a `Pair`, what should have come; None where it says nothing of this pair.
    fitted : int
        Numbers taken from the answers themselves: as many more values have to support it.
    loose : float
        How much the tolerance grows: a value scaled by 1000 is off by 1000 times as much.
    by_row : bool
        Whether it says of each row, or pixel, by itself what should have come: then some rows can
        refute it before all are computed.
    """

    name: str
    text: str
    cost: float
    predict: Predict
    fitted: int = 0
    loose: float = 1.0
    by_row: bool = False


def thin(pair: Pair) -> Pair:
    """Return some rows of a large pair: most proposals fail there already."""
    step = pair.due.size // _MANY if pair.due.ndim else 0
    if step < 2 or pair.due.shape != pair.yours.shape:
        return pair
    return replace(pair, due=pair.due[::step], yours=pair.yours[::step])


def find_close(pair: Pair, a: np.ndarray, b: np.ndarray, loose: float = 1.0) -> np.ndarray:
    """Mark the values that agree within the tolerance of the part, which a scale widens."""
    if a.dtype.kind not in "biuf" or b.dtype.kind not in "biuf":
        return np.asarray(a == b)
    x, y = a.astype(np.float64), b.astype(np.float64)
    rounding = 2e-6 * np.abs(x) if loose != 1 else 0.0  # of float32, on a number that was scaled
    with np.errstate(all="ignore"):
        near = np.abs(x - y) <= pair.part.atol * max(loose, 1e-3) * (1 + 1e-6) + rounding
    return near | (x == y) | (np.isnan(x) & np.isnan(y))


def predicts(relation: Relation, pair: Pair) -> np.ndarray | None:
    """Return what a relation says of a pair if that is what came, or None."""
    try:
        with np.errstate(all="ignore"):
            said = relation.predict(pair)
    except _NO_SENSE:
        return None
    if said is None:
        return None
    said = np.asarray(said)
    if said.shape != pair.yours.shape:
        return None
    # Some values first: they refute nearly everything that is wrong. A share of wrong ones that is
    # allowed in all may be exceeded in some.
    share = pair.part.share
    if (step := said.size // _MANY) > 1 and share <= _SHARE_OF_SOME:
        some, came = said.ravel()[::step], pair.yours.ravel()[::step]
        wrong = np.count_nonzero(~find_close(pair, some, came, relation.loose))
        if wrong > (_SHARE_OF_SOME * some.size if share else 0):
            return None
    wrong = np.count_nonzero(~find_close(pair, said, pair.yours, relation.loose))
    return said if wrong <= share * said.size else None


def fits(relation: Relation, pairs: list[Pair]) -> bool:
    """Tell whether a relation holds in every case, and says more than it took to fit it."""
    support, cases = 0, set()
    if relation.by_row and any(_some_rows_refute(relation, pair) for pair in pairs):
        return False
    for pair in pairs:
        said = predicts(relation, pair)
        if said is None:
            return False
        if said.shape == pair.due.shape:
            moved = ~find_close(pair, said, pair.due, max(1.0, relation.loose))
            count = int(np.count_nonzero(moved))
        else:
            count = 1
        support += min(count, _MOST_SUPPORT)
        cases |= {pair.case} if count else set()
    if len(cases) < 2 and support < _SUPPORT_OF_ONE_CASE + relation.fitted:
        return False
    return support >= 2 + relation.fitted


def may_fit(pairs: list[Pair]) -> bool:
    """Tell whether there are values enough for any relation."""
    return len({pair.case for pair in pairs}) > 1 or pairs[0].due.size >= _SUPPORT_OF_ONE_CASE


def _some_rows_refute(relation: Relation, pair: Pair) -> bool:
    some = thin(pair)
    if some is pair:
        return False
    # A share of wrong values that is allowed in all may be exceeded in some.
    share = max(_SHARE_OF_SOME, pair.part.share) if pair.part.share else 0.0
    return predicts(relation, replace(some, part=replace(some.part, share=share))) is None


def choose(proposals: Iterable[Relation], pairs: list[Pair]) -> Relation | None:
    """Return the simplest relation that fits; None where two of its size do.

    Proposals come in any order. Two that say the same of every pair count as two: what cannot be
    told apart must not be told.
    """
    found = sorted((one for one in proposals if fits(one, pairs)), key=lambda one: one.cost)
    if not found:
        return None
    rivals = [one for one in found[1:] if one.cost - found[0].cost < _SAME_COST]
    return None if rivals else found[0]
