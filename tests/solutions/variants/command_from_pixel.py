"""Right answers to command_from_pixel, written in ways that the card does not contain."""

from typing import Any

# FILL: the imports; at least three answers, one with single precision or with lists


def first(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    raise NotImplementedError("FILL: a right answer, written in another way than the card")


def second(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    raise NotImplementedError("FILL: another way")


def third(pixel: Any, K: Any, pan: Any, tilt: Any, limits: Any) -> Any:
    raise NotImplementedError("FILL: a third way")


VARIANTS = [first, second, third]
