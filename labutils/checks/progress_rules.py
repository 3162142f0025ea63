"""What a progress file may hold: one schema, by which the library and the pages read it alike.

The words are those of JSON Schema, as many of them as are needed here. `tools/derive/shared.py`
writes the rules for the pages; ``book/_page_python/progress.js`` has the same `find_fault`.

Predictions are made on the pages of the book and kept by everyone: a file without them, such as one
of an older release, has none, and an older release reads a file with them as if it had none. Where
a page joins two files, an answer wins over none, and of two answers the one that was there first:
a prediction is what one said before one knew.
"""

from __future__ import annotations

from typing import Any

FILE_NAME = "labutils-progress.json"
VERSION = 1

#: Hints per exercise; `hint` counts up to here.
MAX_HINTS = 3

#: A file of ours has a few thousand characters.
MAX_CHARACTERS = 1_000_000

_COUNT = {"type": ["integer"], "minimum": 0}
_COUNTS = {"type": ["object"], "additionalProperties": _COUNT}
SCHEMA: dict[str, Any] = {
    "type": ["object"],
    "required": ["version", "exercises"],
    "properties": {
        "version": {"type": ["integer"], "minimum": VERSION, "maximum": VERSION},
        "exercises": {
            "type": ["object"],
            "additionalProperties": {
                "type": ["object"],
                # files of the first release have no relations and no probes
                "required": ["passed", "attempts", "hints", "last_property", "mistakes"],
                "properties": {
                    "passed": {"type": ["boolean"]},
                    "attempts": _COUNT,
                    "hints": {"type": ["integer"], "minimum": 0, "maximum": MAX_HINTS},
                    "last_property": {"type": ["string", "null"]},
                    "mistakes": _COUNTS,
                    "relations": _COUNTS,
                    "probes": _COUNTS,
                },
            },
        },
        "predictions": {
            "type": ["object"],
            "additionalProperties": {
                "type": ["object"],
                "required": ["said", "right"],
                "properties": {
                    # the number of a choice, or a number as it was typed; null if only shown
                    "said": {"type": ["string", "null"]},
                    "right": {"type": ["boolean"]},
                },
            },
        },
    },
}

_INEXACT = 2**53
#: What the kinds of values are called.
WORDS = {
    "object": "an object",
    "array": "a list",
    "string": "a text",
    "boolean": "true or false",
    "integer": "a whole number",
    "number": "a number",
    "null": "null",
}


def find_fault(value: Any, schema: dict[str, Any], place: str = "the file") -> str:
    """Say where JSON differs from a schema, and how: the first fault; "" where there is none."""
    kind = get_kind(value)
    if kind not in schema["type"]:
        wanted = " or ".join(WORDS[one] for one in schema["type"])
        return f"{place}: expected {wanted}, got {WORDS[kind]}"
    low, high = schema.get("minimum"), schema.get("maximum")
    if kind == "integer" and (value < low or (high is not None and value > high)):
        wanted = f"{low} or more" if high is None else low if low == high else f"{low} to {high}"
        return f"{place}: expected {wanted}, got {int(value)}"
    if kind == "object":
        for name in schema.get("required", ()):
            if name not in value:
                return f'{place}: expected "{name}", got none'
        rules = schema.get("properties", {})
        for name in sorted(value):
            rule = rules.get(name, schema.get("additionalProperties"))
            inside = name if place == "the file" else f"{place}.{name}"
            if rule and (fault := find_fault(value[name], rule, inside)):
                return fault
    return ""


def get_kind(value: Any) -> str:
    """Name the kind of a value of JSON.

    As in JavaScript, which knows one kind of number: what has no fraction, and is small enough to
    be exact, is an integer.
    """
    if type(value) in (int, float):
        is_whole = value == value // 1 and abs(value) < _INEXACT
        return "integer" if is_whole else "number"
    kinds = {dict: "object", list: "array", str: "string", bool: "boolean"}
    return kinds.get(type(value), "null")
