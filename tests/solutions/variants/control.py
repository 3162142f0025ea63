"""Right answers to control, written in ways that the card does not contain."""

from typing import Any

# FILL: the imports; at least three answers, one with single precision or with lists


def first(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: object) -> Any:
    raise NotImplementedError("FILL: a right answer, written in another way than the card")


def second(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: object) -> Any:
    raise NotImplementedError("FILL: another way")


def third(rgb: np.ndarray, depth: np.ndarray, K: np.ndarray, state: object) -> Any:
    raise NotImplementedError("FILL: a third way")


VARIANTS = [first, second, third]
