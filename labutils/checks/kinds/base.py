"""What every kind of answer is asked: how it looks, when it is right, what to say, what to draw.

A kind is one entry of this package. The gates, the comparison, the pictures and the instructor's
pages know none of them by name: whatever differs from kind to kind is a field or a method here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

if TYPE_CHECKING:
    from labutils.checks.table import Part
    from labutils.checks.verdict import PanelPicture

#: About as many values of a large answer are looked at first.
_SAMPLES = 8192


@dataclass(frozen=True, kw_only=True)
class Kind(ABC):
    """One kind of answer.

    Parameters
    ----------
    name : str
        What a `Part` calls it.
    ndim : int
        Dimensions of its array.
    shape : str
        Its shape in words, for the shape gate.
    counts_rows : bool
        Whether the number of its rows is part of the answer.
    empty_shape : tuple of int or None
        Of a list of things, the shape where there is none: an empty list has no dtype and no
        columns. None where it is no list.
    moves_with_cloud : bool
        Whether its rows are brought into another order together with those of a cloud.
    relations : tuple of str
        The families of `labutils.checks.explain` that make sense for it.
    """

    name: str
    ndim: int
    shape: str
    counts_rows: bool = False
    empty_shape: tuple[int, ...] | None = None
    moves_with_cloud: bool = False
    relations: tuple[str, ...] = ("numbers",)

    #: Whether every value is compared by itself, so that a sample of them can refute an answer.
    is_elementwise: ClassVar[bool] = True
    #: Whether it is seen after the call instead of returned, and right or wrong as a whole.
    is_observed: ClassVar[bool] = False
    #: Whether its numbers are so few that a message could give them away.
    is_few: ClassVar[bool] = False
    #: Whether a wrong value is off by some amount, instead of just wrong.
    has_sizes: ClassVar[bool] = True
    #: Whether a call says all that it will ever say: then probes may call again.
    is_repeatable: ClassVar[bool] = True
    #: The last gates, in their order: what has to hold of a value that looks as it should.
    properties: ClassVar[tuple[str, ...]] = ("value",)

    # --- when it is right ---

    def to_canonical(self, value: np.ndarray) -> np.ndarray:
        """Bring a value into the form that comparing needs, so that this is done once."""
        return value

    def make_due(self, value: np.ndarray) -> np.ndarray:
        """Make of the reference's answer what is due of everybody."""
        return value

    def make_known(self, value: np.ndarray) -> np.ndarray:
        """Make of a wrong answer what others who made the same mistake have in common with it."""
        return self.to_canonical(value)

    def unify(self, dues: list[np.ndarray], yours: list[np.ndarray]) -> list[np.ndarray]:
        """Bring the answers of all cases into one form, where a choice was free."""
        del dues
        return yours

    def get_differences(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
        """Return yours minus expected; infinite where one of the two is no number."""
        if part.dtype == "str":
            return np.asarray(expected != yours).astype(np.int32)
        return subtract(expected, yours)

    def find_wrong(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
        """Mark the values that are off by more than the tolerance."""
        # A billionth of slack: the tolerance itself, computed in binary, must not count as more.
        return np.abs(self.get_differences(part, expected, yours)) > part.atol * (1 + 1e-9)

    def is_close(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> bool:
        """Tell whether a part agrees within its tolerance; shapes have to agree already."""
        if self.is_elementwise and expected.size > 2 * _SAMPLES:
            # Every n-th value refutes most wrong answers: there are never fewer wrong ones in all.
            step = expected.size // _SAMPLES
            some = self.find_wrong(part, expected.ravel()[::step], yours.ravel()[::step])
            if np.count_nonzero(some) > part.share * expected.size:
                return False
        wrong = self.find_wrong(part, expected, yours)
        return bool(np.count_nonzero(wrong) <= part.share * wrong.size)

    def find_order(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray | None:
        """Return the order of rows in which `yours` agrees with `expected`, or None.

        None also where they agree as they are, and where the order of rows carries a meaning.
        """
        del part, expected, yours
        return None

    def find_property(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Name the first of `properties` that does not hold, where the value is wrong."""
        del part, expected, yours
        return self.properties[0]

    # --- what to say, and what to draw ---

    def describe_shape(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Say what is wrong with the shape of `yours`, or nothing."""
        if expected.shape == yours.shape:
            return ""
        if self.counts_rows and yours.ndim == self.ndim and yours.shape[1:] == expected.shape[1:]:
            many = "too many" if len(yours) > len(expected) else "too few"
            things = "entries" if self.ndim == 1 else "rows"
            return f"{part.name} has {many} {things} ({len(yours)}): what is kept is not right."
        return f"{part.name} has shape {yours.shape}; due is {self.shape}."

    @abstractmethod
    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Say how `yours` is off where `wrong` is marked, without saying what is right.

        Of many numbers (a picture, a cloud) tell how many are off, to which side and by how much
        typically. Of few numbers (a matrix, a pixel) tell which, to which side and roughly by
        which share: "off by 12.5" would give the right number away.
        """

    def name_value(self, value: float) -> str:
        """Write one value of the canonical form, in words where it stands for something."""
        return f"{value:.4g}"

    def describe_worst(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Name the place that is off most, where there is one to look at."""
        del part, expected, yours
        return ""

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        """Draw expected and yours side by side; None where there is nothing to compare by eye.

        Asked for wrong shapes as well: a cloud with too few points is worth a look.
        """
        del part, expected, yours
        return None

    # --- what a card has to prove ---

    def make_shifted(self, part: Part, value: np.ndarray, amount: float) -> np.ndarray:
        """Return a right answer that is off by `amount` everywhere, in the dtype that is due.

        Cards are tested with it: ten tolerances off have to fail, a tenth of one has to pass.
        """
        if part.dtype == "uint8":  # to the side where there is room
            wide = value.astype(int)
            moved = np.where(wide < 128, wide + round(amount), wide - round(amount))
            return moved.astype(np.uint8)
        if part.dtype == "int":
            return value + round(amount)
        return value.astype(np.float64) + amount


def subtract(expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
    """Return yours minus expected; infinite where one of the two is no number."""
    if expected.dtype.kind in "biu" and yours.dtype.kind in "biu":
        # Pictures of small numbers are compared in small numbers: it is several times as fast.
        wide = np.int32 if max(expected.itemsize, yours.itemsize) <= 2 else np.int64
        return yours.astype(wide) - expected.astype(wide)
    x, y = expected.astype(np.float64), yours.astype(np.float64)
    # Equal infinities and NaN at the same place agree.
    agree = (x == y) | (np.isnan(x) & np.isnan(y))
    with np.errstate(invalid="ignore"):
        difference = np.where(agree, 0.0, y - x)
    return np.where(np.isnan(difference), np.inf, difference)


def round_to_digit(value: float, largest: float = np.inf) -> str:
    """Write a number with one digit that counts: 0.04, 3, 200; no more than the largest there is.

    255 levels are 255, not 300: no picture has so many.
    """
    return np.format_float_positional(min(float(f"{value:.1g}"), largest), trim="-")


def get_largest_gap(part: Part) -> float:
    """Return how far two values of a part can be apart."""
    return 255.0 if part.dtype == "uint8" else np.inf
