"""Kinds of answers that are right or wrong, with nothing between: a choice, a flag, a text."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from labutils.checks.kinds.base import Kind

if TYPE_CHECKING:
    from labutils.checks.table import Part


@dataclass(frozen=True, kw_only=True)
class Flag(Kind):
    """What is seen after the call, such as the state of an argument; told by its note."""

    is_observed: ClassVar[bool] = True

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell what the card says of a flag that is not set."""
        del expected, yours, wrong
        return part.note


@dataclass(frozen=True, kw_only=True)
class Choice(Kind):
    """A number that names something."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell no more than that it is another one: a side or a size has no meaning."""
        del expected, yours, wrong
        return f"{part.name} is not the right one."


@dataclass(frozen=True, kw_only=True)
class Names(Kind):
    """Texts, one per thing."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Count the wrong ones."""
        del expected, yours
        return f"{np.count_nonzero(wrong)} of {wrong.size} {part.name} are not the right ones."


@dataclass(frozen=True, kw_only=True)
class Flags(Kind):
    """True or False, one per thing."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Count what should be False and what should be True."""
        count = np.count_nonzero(wrong)
        extra = np.count_nonzero(wrong & yours & ~expected)
        return (
            f"{part.name}: {count} of {wrong.size} are wrong: {extra} True that should be False, "
            f"{count - extra} False that should be True."
        )


KINDS = (
    # A choice among a few fits by accident: nothing is told of how it differs.
    Flag(name="flag", ndim=0, shape="a single value", relations=()),
    Choice(name="choice", ndim=0, shape="a single whole number", relations=()),
    Flags(
        name="flags",
        ndim=1,
        shape="(N,), one value per thing that came in",
        relations=("flags", "lists", "regions"),
    ),
    Names(
        name="names",
        ndim=1,
        shape="(N,), one text per object",
        counts_rows=True,
        empty_shape=(0,),
        relations=("lists", "selections"),
    ),
)
