"""What was derived from the real package: see ``tools/derive/page_mujoco.py``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

_TABLES: dict[str, Any] = json.loads(Path(__file__).with_name("derived.json").read_text("utf-8"))

#: {struct: {field: text}}; `Field.parse` reads the text.
STRUCTS: dict[str, dict[str, str]] = _TABLES["structs"]
#: What the real package has of models and states, and the page's engine has not.
ABSENT: dict[str, list[str]] = _TABLES["absent"]
#: {"MjModel" or "MjData": {accessor: {attribute: field}}}
VIEWS: dict[str, dict[str, dict[str, str]]] = _TABLES["views"]
#: {function: signature}; `_signature.py` reads it.
FUNCTIONS: dict[str, str] = _TABLES["functions"]
MODEL_WRITERS: frozenset[str] = frozenset(_TABLES["model_writers"])
#: {constant: "f", "i" or "s"}
CONSTANTS: dict[str, str] = _TABLES["constants"]
ENUMS: frozenset[str] = frozenset(_TABLES["enums"])
#: Names of the real package that the page has not.
ELSEWHERE: frozenset[str] = frozenset(_TABLES["elsewhere"])


class Field(NamedTuple):
    """A field of a struct: of which kind it is, and its sizes where it is an array."""

    kind: str
    sizes: tuple[str, ...]

    @classmethod
    def parse(cls, text: str) -> Field:
        """Read ``f8 ngeom 3``."""
        kind, *sizes = text.split()
        return cls(kind, tuple(sizes))


FIELDS = {
    struct: {name: Field.parse(text) for name, text in fields.items()}
    for struct, fields in STRUCTS.items()
}
