"""Relations that move values to other places, or exchange what stands for what."""

from __future__ import annotations

import itertools
from functools import partial
from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils.checks.explain.relation import Pair, Relation, on_due

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


def propose_pictures(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose mirrors, turns and a move by one pixel."""
    del pairs
    moves: tuple[tuple[str, str, Callable[[np.ndarray], np.ndarray]], ...] = (
        ("mirrored:left-right", "mirrored, left and right are exchanged", np.fliplr),
        ("mirrored:up-down", "upside down, its rows are reversed", np.flipud),
        ("turned:180", "turned by 180 degrees", lambda a: a[::-1, ::-1]),
        ("turned:90", "turned by 90 degrees, counterclockwise", np.rot90),
        ("turned:270", "turned by 90 degrees, clockwise", lambda a: np.rot90(a, 3)),
        ("transposed", "transposed, rows and columns are exchanged", lambda a: a.swapaxes(0, 1)),
    )
    for name, text, move in moves:
        yield Relation(name, text, 1.0, on_due(move))
    for (axis, words), step in itertools.product(
        ((0, ("up", "down")), (1, ("to the left", "to the right"))), (-1, 1)
    ):
        thing = "row" if axis == 0 else "column"
        yield Relation(
            f"moved:{thing}:{step:+d}",
            f"what is due, moved {words[step > 0]} by one {thing}",
            2.0,
            partial(_move, axis, step),
        )


def _move(axis: int, step: int, pair: Pair) -> np.ndarray:
    """Move by one; what enters at the border is whatever came there."""
    moved = np.roll(pair.due, step, axis)
    border = [slice(None)] * moved.ndim
    border[axis] = slice(0, 1) if step > 0 else slice(-1, None)
    moved[tuple(border)] = pair.yours[tuple(border)]
    return moved


def propose_masks(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose the complement, and masks that grew or shrank."""
    del pairs
    yield Relation(
        "complement", "the complement, white and black are exchanged", 1.0, lambda p: 255 - p.due
    )
    for size in (3, 5):
        kernel = np.ones((size, size), np.uint8)
        for word, change in (("grown", cv2.dilate), ("shrunk", cv2.erode)):
            pixels = "1 pixel" if size == 3 else f"{size // 2} pixels"
            yield Relation(
                f"{word}:{size // 2}",
                f"what is due, {word} by {pixels} on every side",
                2.0,
                partial(_grow, change, kernel),
            )


def _grow(change: Callable[..., np.ndarray], kernel: np.ndarray, pair: Pair) -> np.ndarray:
    return change(np.ascontiguousarray(pair.due), kernel)


def propose_colors(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose the negative, gray, and exchanged channels."""
    del pairs
    yield Relation("negative", "the negative, 255 minus what is due", 1.0, lambda p: 255 - p.due)
    yield Relation("gray", "gray, all three channels are the same", 2.0, _make_gray)
    names = "RGB"
    for order in itertools.permutations(range(3)):
        if order != (0, 1, 2):
            said = "".join(names[i] for i in order)
            moved = sum(place != i for i, place in enumerate(order))
            yield Relation(
                f"channels:{said}",
                f"in the order {said} in place of {names}",
                1.0 + 0.1 * moved,
                on_due(partial(np.take, indices=order, axis=-1)),
            )


def _make_gray(pair: Pair) -> np.ndarray:
    gray = cv2.cvtColor(np.ascontiguousarray(pair.due), cv2.COLOR_RGB2GRAY)
    return np.repeat(gray[..., None], 3, axis=2)


def propose_matrices(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose the transpose and the inverse."""
    del pairs
    yield Relation("transposed", "the transpose of what is due", 1.0, lambda pair: pair.due.T)
    yield Relation(
        "inverted", "the inverse of what is due", 1.0, lambda pair: np.linalg.inv(pair.due)
    )


def propose_lists(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose another order, and values that stand one place too early or too late."""
    del pairs
    changes: tuple[tuple[str, str, float, Callable[[np.ndarray], np.ndarray]], ...] = (
        ("reversed", "what is due in the reverse order", 1.1, lambda a: a[::-1]),
        ("early", "what is due, each one place too early", 1.5, lambda a: np.roll(a, -1, 0)),
        ("late", "what is due, each one place too late", 1.5, lambda a: np.roll(a, 1, 0)),
        ("sorted", "what is due, but sorted upward", 2.0, _sort_flat),
        ("sorted:down", "what is due, but sorted downward", 2.0, lambda a: _sort_flat(a)[::-1]),
    )
    for name, text, cost, change in changes:
        yield Relation(name, text, cost, on_due(change))


def _sort_flat(values: np.ndarray) -> np.ndarray:
    if values.ndim != 1:
        raise ValueError("only a list has one order")
    return np.sort(values)


def propose_flags(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that True and False are exchanged."""
    del pairs
    yield Relation(
        "complement", "the opposite, True and False are exchanged", 1.0, lambda pair: ~pair.due
    )
