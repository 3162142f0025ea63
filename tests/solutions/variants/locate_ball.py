"""Right answers to locate_ball, written in ways that the card does not contain."""

from typing import Any

# FILL: the imports; at least three answers, one with single precision or with lists


def first(mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> Any:
    raise NotImplementedError("FILL: a right answer, written in another way than the card")


def second(mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> Any:
    raise NotImplementedError("FILL: another way")


def third(mask: np.ndarray, depth: np.ndarray, K: np.ndarray, radius: float) -> Any:
    raise NotImplementedError("FILL: a third way")


VARIANTS = [first, second, third]
