"""Which names the page's package has: the tests compare them with what the book uses."""

from __future__ import annotations

import enum

import mujoco


def list_names() -> dict[str, list[str]]:
    """Return every name of the package, and the members of those that are enums."""
    found: dict[str, list[str]] = {}
    for name in dir(mujoco):
        value = getattr(mujoco, name)
        is_enum = isinstance(value, type) and issubclass(value, enum.Enum)
        found[name] = list(value.__members__) if is_enum else []
    return found


def every_function_is_there_and_knows_how_it_is_called() -> None:
    for name in dir(mujoco):
        if name.startswith(("mj_", "mju_", "mjv_", "mjd_")):
            function = getattr(mujoco, name)
            try:
                function(nothing=None)
            except TypeError as error:
                assert str(error).startswith(f"{name}(): incompatible function arguments"), error
            else:
                raise AssertionError(f"{name} took an argument that no function has")
