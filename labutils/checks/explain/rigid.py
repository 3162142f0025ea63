"""A cloud that is turned, mirrored or moved as a whole: its shape and size agree."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.explain.relation import Pair, Relation, thin

if TYPE_CHECKING:
    from collections.abc import Iterator

#: With fewer points, some turn nearly always fits.
_MIN_POINTS = 8

#: Turns of less than this many radians, and moves of less than this many tolerances, are none.
_MIN_TURN = 1e-3
_TOLERANCES = 4


def propose(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that the whole is turned, mirrored or moved, in one way in all cases."""
    if any(pair.due.shape != pair.yours.shape or len(pair.due) < _MIN_POINTS for pair in pairs):
        return
    if (source := _find_source(pairs)) and not any(
        _has_same_distances(pair.args[source], pair.yours) for pair in pairs
    ):
        yield Relation(
            "not-rigid",
            "the distances between the points have changed: what was done is no rotation and no "
            "move",
            6.0,
            lambda pair: pair.yours,
        )
    if not all(_describe(thin(pair)) for pair in pairs):
        return
    words = {_describe(pair) for pair in pairs}
    if len(words) != 1 or not (word := words.pop()):
        return
    yield Relation(
        f"rigid:{word.replace(' ', '-')}",
        f"{word} as a whole; its shape and size agree",
        4.0,
        # That one motion carries all points was verified above.
        lambda pair: pair.yours,
    )


def _find_source(pairs: list[Pair]) -> str:
    """Name the points among the arguments that only had to be turned and moved, if they had."""
    for name, value in pairs[0].args.items():
        if isinstance(value, np.ndarray) and all(
            pair.args[name].shape == pair.due.shape
            and _has_same_distances(pair.args[name], pair.due)
            for pair in pairs
        ):
            return name
    return ""


def _has_same_distances(some: np.ndarray, others: np.ndarray) -> bool:
    """Compare the distances of all points from the first, and from each one's next."""
    for a, b in (
        (some - some[:1], others - others[:1]),
        (np.diff(some, axis=0), np.diff(others, axis=0)),
    ):
        lengths = np.linalg.norm(a, axis=1), np.linalg.norm(b, axis=1)
        if not np.allclose(*lengths, rtol=1e-3, atol=1e-3, equal_nan=False):
            return False
    return True


def _describe(pair: Pair) -> str:
    """Say how the points moved as a whole, or nothing where they did not."""
    good = np.isfinite(pair.due).all(axis=1) & np.isfinite(pair.yours).all(axis=1)
    x, y = pair.due[good].astype(np.float64), pair.yours[good].astype(np.float64)
    if len(x) < _MIN_POINTS or not good.any():
        return ""
    centered_x, centered_y = x - x.mean(axis=0), y - y.mean(axis=0)
    if np.linalg.matrix_rank(centered_x, tol=1e-3) < 3:
        return ""  # a flat cloud can be mirrored and turned to the same end
    # Kabsch without the sign that excludes mirrors: they are looked for as well.
    u, _, vt = np.linalg.svd(centered_x.T @ centered_y)
    rotation = (u @ vt).T
    move = y.mean(axis=0) - rotation @ x.mean(axis=0)
    slack = _TOLERANCES * pair.part.atol
    if np.abs(x @ rotation.T + move - y).max() > slack:
        return ""
    is_turned = np.abs(rotation - np.eye(3)).max() > _MIN_TURN
    is_moved = np.abs(move).max() > slack
    if np.linalg.det(rotation) < 0:
        return "mirrored"
    axes = [name for i, name in enumerate("xyz") if abs(rotation[i, i] - 1) < _MIN_TURN**2]
    turned = f"turned about {axes[0]}" if len(axes) == 1 else "turned"
    return " and ".join([turned] * int(is_turned) + ["moved"] * int(is_moved))
