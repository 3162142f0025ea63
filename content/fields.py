"""Read entries of YAML files strictly: every field known, of its type, and filled."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import yaml

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path


def read_yaml(path: Path, error: type[ValueError]) -> Any:
    """Return what a file of YAML holds; raise `error`, with its name, where it cannot be read."""
    try:
        return yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, yaml.YAMLError) as reason:
        raise error(f"{path.name}: cannot be read: {reason}") from reason


def check_fields(
    where: str,
    entry: Any,
    required: Mapping[str, type],
    optional: Mapping[str, type],
    error: type[ValueError],
) -> dict[str, Any]:
    """Return the entry if it has the fields it should have, all of them filled.

    Parameters
    ----------
    where : str
        Names the entry in a message.
    entry : object
        What YAML gave.
    required, optional : dict of str to type
        The fields that have to be there, and those that may.
    error : type
        What to raise, with a message.
    """
    if not isinstance(entry, dict):
        raise error(f"{where}: expected fields with names, got {entry!r}")
    known = {**required, **optional}
    if unknown := sorted(map(str, entry.keys() - known.keys())):
        raise error(f"{where}: unknown field {unknown[0]}; known are {', '.join(known)}")
    for name in required:
        if name not in entry:
            raise error(f"{where}: the field {name} is missing")
    for name, value in entry.items():
        wanted = known[name]
        if not isinstance(value, wanted):
            hint = "; write it in quotes" if wanted is str else ""
            raise error(f"{where}: {name}: expected {wanted.__name__}, got {value!r}{hint}")
        if isinstance(value, str) and not value.strip():
            raise error(f"{where}: {name}: is empty")
    return entry
