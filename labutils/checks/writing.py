"""Write the tables that checks read, words as JSON, every array once: for `make exercises`."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.loops.scenario import Loop
from labutils.checks.table import Misfit, Raised, Scene

if TYPE_CHECKING:
    from labutils.checks.table import Part


def part_to_words(part: Part) -> dict[str, Any]:
    """Write a part as JSON, leaving out what is at its default."""
    return {
        one.name: list(value) if isinstance(value, tuple) else value
        for one in fields(part)
        if (value := getattr(part, one.name)) != one.default
    }


def encode(value: Any, arrays: dict[str, np.ndarray]) -> Any:  # noqa: PLR0911 - one per form
    """Turn an argument or an answer into JSON; arrays go to `arrays`, each content once."""
    if isinstance(value, np.ndarray):
        return _encode_array(value, arrays)
    if isinstance(value, Raised):
        return {"raised": [value.kind, value.text]}
    if isinstance(value, Misfit):
        return {"misfit": value.text}
    if isinstance(value, Scene):
        return {
            "scene": [value.xml, list(value.gives), list(value.qpos), value.width, value.height]
        }
    if isinstance(value, Loop):
        return {"loop": value.to_words()}
    if isinstance(value, tuple | list):
        return {"tuple": [encode(item, arrays) for item in value]}
    return value


def _encode_array(value: np.ndarray, arrays: dict[str, np.ndarray]) -> dict[str, Any]:
    is_mask = value.dtype == np.uint8 and value.ndim == 2 and bool(np.isin(value, (0, 255)).all())
    stored = np.packbits(value > 0) if is_mask else np.array(value, order="C")
    key = next((key for key, known in arrays.items() if is_same_array(known, stored)), "")
    if not key:
        key = f"a{len(arrays)}"
        arrays[key] = stored
    return {"mask": [key, list(value.shape)]} if is_mask else {"array": key}


def is_same_array(a: np.ndarray, b: np.ndarray) -> bool:
    """Tell whether two arrays agree, up to roundings in which processors differ.

    Vector units may round the last bit of a float32 differently, and with it the sixth digit after
    the point, to which answers are rounded. One of these is ten times below the finest tolerance of
    a card.
    """
    if a.dtype != b.dtype or a.shape != b.shape:
        return False
    if a.dtype.kind != "f":
        return a.tobytes() == b.tobytes()
    return bool(np.allclose(a, b, rtol=1e-6, atol=1.001e-6, equal_nan=True))
