"""Relations that act on every number alone: scaled, shifted, rounded, cut off, another argument."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from labutils.checks.explain.relation import Pair, Predict, Relation, thin
from labutils.checks.kinds import get_kind

if TYPE_CHECKING:
    from collections.abc import Iterator

#: Reads a number off the arguments of a case.
Get: TypeAlias = Callable[[dict[str, Any]], float]

#: Factors that have a meaning of their own.
_FACTORS = {
    -1.0: "-1",
    2.0: "2",
    0.5: "1/2",
    1000.0: "1000",
    0.001: "1/1000",
    100.0: "100",
    0.01: "1/100",
    255.0: "255",
    1 / 255: "1/255",
    256.0: "256",
    255 / 256: "255/256",
    180 / np.pi: "180/pi (degrees in place of radians)",
    np.pi / 180: "pi/180 (radians in place of degrees)",
}

#: Functions of what is due.
_FUNCTIONS: dict[str, tuple[str, Callable[[np.ndarray], np.ndarray]]] = {
    "rounded": ("what is due, rounded to whole numbers", np.round),
    "cut": ("what is due, cut to whole numbers", np.trunc),
    "floor": ("what is due, rounded down", np.floor),
    "ceil": ("what is due, rounded up", np.ceil),
    "decimals:1": ("what is due, rounded to one decimal", lambda value: np.round(value, 1)),
    "decimals:2": ("what is due, rounded to two decimals", lambda value: np.round(value, 2)),
    "square": ("the square of what is due", np.square),
    "root": ("the square root of what is due", np.sqrt),
    "unsigned": ("what is due without its sign", np.abs),
    "reciprocal": ("one divided by what is due", np.reciprocal),
}

#: Of fewer numbers, smallest and largest say too little.
_SAMPLE = 8

#: Shifts that have a meaning of their own: half a pixel, one place.
_SHIFTS = (-1.0, -0.5, 0.5, 1.0)

_OPERATIONS: tuple[tuple[str, str, Callable[[Any, float], Any]], ...] = (
    ("*", "times", np.multiply),
    ("/", "divided by", np.divide),
    ("+", "plus", np.add),
    ("-", "minus", np.subtract),
)


def propose(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose what every number may have suffered."""
    if any(one.dtype.kind not in "biuf" for pair in pairs for one in (pair.due, pair.yours)):
        return
    if any(pair.due.shape != pair.yours.shape for pair in pairs):
        return
    for one in (*_propose_known(), *_propose_fitted(pairs), *_propose_arguments(pairs)):
        yield replace(one, by_row=True)
    yield from _propose_per_case(pairs)


def _propose_known() -> Iterator[Relation]:
    for factor, words in _FACTORS.items():
        name = f"scaled:{words.split()[0]}"
        yield Relation(name, f"{words} times what is due", 1.0, _scale(factor), loose=abs(factor))
    yield Relation("zero", "0 everywhere", 1.0, _fill(lambda _: 0.0))
    for name, (text, function) in _FUNCTIONS.items():
        yield Relation(name, text, 1.5, _apply(function))
    for shift in _SHIFTS:
        side = "large" if shift > 0 else "small"
        yield Relation(f"shifted:{shift:g}", f"{abs(shift):g} too {side}", 1.2, _shift(shift))


def _scale(factor: float) -> Predict:
    return lambda pair: factor * pair.due.astype(np.float64)


def _fill(get: Get) -> Predict:
    return lambda pair: np.full(pair.due.shape, get(pair.args))


def _apply(function: Callable[[np.ndarray], np.ndarray]) -> Predict:
    return lambda pair: function(pair.due.astype(np.float64))


def _shift(shift: float) -> Predict:
    # Two tolerances: less than that is no shift but rounding.
    return lambda pair: pair.due + shift if abs(shift) > 2 * pair.part.atol else None


def _clip(clip: Callable[[Any, float], Any], limit: float) -> Predict:
    return lambda pair: clip(pair.due, limit)


def _combine(operation: Callable[[Any, float], Any], get: Get) -> Predict:
    return lambda pair: operation(pair.due.astype(np.float64), get(pair.args))


def _propose_fitted(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose one factor, one shift and one limit that are read off the answers."""
    some = [thin(pair) for pair in pairs]
    x = np.concatenate([pair.due.astype(np.float64).ravel() for pair in some])
    y = np.concatenate([pair.yours.astype(np.float64).ravel() for pair in some])
    atol = pairs[0].part.atol
    good = np.isfinite(x) & np.isfinite(y) & (np.abs(x) > 20 * atol)
    if not good.any():
        return
    factor = float(np.median(y[good] / x[good]))
    known = any(abs(factor / one - 1) < 1e-5 for one in (1.0, *_FACTORS))
    if 1e-6 < abs(factor) < 1e6 and not known:
        text = f"{factor:.4g} times what is due"
        name = f"scaled:{factor:.4g}"
        yield Relation(name, text, 3.0, _scale(factor), fitted=1, loose=abs(factor))
    shift = float(np.median((y - x)[good]))
    if abs(shift) > 4 * atol and not any(abs(shift - one) < 2 * atol for one in _SHIFTS):
        sign = "positive" if shift > 0 else "negative"
        text = f"what is due plus one and the same {sign} number"
        yield Relation(f"shifted:{shift:.4g}", text, 3.0, _shift(shift), fitted=1)
    first = float(y[good][0])
    text = f"{get_kind(pairs[0].part).name_value(first)} everywhere"
    yield Relation(f"constant:{first:.4g}", text, 1.4, _fill(lambda _: first), fitted=1)
    finite = [pair.yours[np.isfinite(pair.yours)] for pair in pairs]
    for word, limit, clip in (
        ("above", max(float(one.max()) for one in finite if one.size), np.minimum),
        ("below", min(float(one.min()) for one in finite if one.size), np.maximum),
    ):
        # Where nearly nothing, or nearly all, is cut off there is no limit to speak of.
        if 0.05 < np.mean(clip(x[good], limit) != x[good]) < 0.95:
            text = f"what is due, but cut off {word} {limit:.4g}"
            name = f"clipped:{word}:{limit:.4g}"
            yield Relation(name, text, 3.0, _clip(clip, limit), fitted=1)


def _propose_per_case(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose a length of its own in every case, and a stretch of every case to 0 to 1 or 255."""
    fitted = len(pairs)
    if all(pair.due.ndim == 1 and pair.due.size > 2 for pair in pairs):
        yield Relation(
            "length",
            "of the right direction, but of another length",
            3.5,
            _give_length,
            fitted=fitted,
        )
    for top in (1, 255):
        if all(_ranges_from_zero_to(top, pair.yours) for pair in pairs):
            text = f"what is due, stretched to 0 to {top} in every case"
            yield Relation(f"stretched:{top}", text, 3.0, partial(_stretch, top), fitted=2 * fitted)


def _ranges_from_zero_to(top: int, values: np.ndarray) -> bool:
    finite = values[np.isfinite(values)]
    return finite.size > 2 * _SAMPLE and bool(
        abs(finite.min()) < 1e-6 and abs(finite.max() / top - 1) < 1e-6
    )


def _give_length(pair: Pair) -> np.ndarray:
    return pair.due * (np.vdot(pair.due, pair.yours) / np.vdot(pair.due, pair.due))


def _stretch(top: int, pair: Pair) -> np.ndarray:
    finite = pair.due[np.isfinite(pair.due)]
    low, high = finite.min(), finite.max()
    return top * (pair.due.astype(np.float64) - low) / (high - low)


def _propose_arguments(pairs: list[Pair]) -> Iterator[Relation]:
    """Propose that a number among the arguments came into it."""
    for name, get in list_scalars(pairs):
        for sign, words, operation in _OPERATIONS:
            if sign == "/" and name.startswith("("):
                continue  # the ratio the other way round says it already
            text = f"what is due {words} {name}"
            yield Relation(f"argument:{sign}{name}", text, 2.5, _combine(operation, get))
        yield Relation(f"is:{name}", f"{name} itself", 1.8, _fill(get))


def list_scalars(pairs: list[Pair]) -> list[tuple[str, Get]]:
    """List the numbers among the arguments, their ratios and functions; each value once."""
    first = {
        name: value
        for name, value in pairs[0].args.items()
        if all(name in pair.args for pair in pairs)
    }
    numbers = [
        name
        for name, value in first.items()
        if isinstance(value, int | float) and not isinstance(value, bool)
    ]
    found = [(name, _get(name)) for name in numbers]
    found += [
        (f"({one} / {other})", _get_ratio(one, other))
        for one, other in itertools.permutations(numbers, 2)
    ]
    for name in numbers:
        if isinstance(first[name], int):
            found.append((f"(({name} - 1) / {name})", _get_with(lambda n: (n - 1) / n, name)))
            found.append((f"({name} / ({name} - 1))", _get_with(lambda n: n / (n - 1), name)))
        elif abs(first[name]) < np.pi:
            found += [
                (f"{function.__name__}({name})", _get_with(function, name))
                for function in (np.sin, np.cos, np.tan)
            ]
    for name, value in first.items():
        if isinstance(value, np.ndarray) and value.ndim:
            found.append((f"len({name})", _get_with(len, name)))
    seen = set()
    kept = []
    for name, get in found:
        try:
            values = tuple(float(f"{get(pair.args):.6g}") for pair in pairs)
        except (ArithmeticError, TypeError):
            continue
        # 0 added and 1 multiplied change nothing.
        if values not in seen and not set(values) <= {0.0, 1.0}:
            seen.add(values)
            kept.append((name, get))
    return kept


def _get(name: str) -> Get:
    return lambda args: float(args[name])


def _get_ratio(one: str, other: str) -> Get:
    return lambda args: float(args[one] / args[other])


def _get_with(function: Callable[[Any], Any], name: str) -> Get:
    return lambda args: float(function(args[name]))
