"""The enums of the engine, in the form of the real package: numbers with names."""

from __future__ import annotations

import enum
import functools
from typing import Any

from ._engine import engine


class MjEnum(enum.IntEnum):
    """A number with a name; text shows the name."""

    __module__ = "mujoco._enums"

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"

    def __format__(self, spec: str) -> str:
        return format(int(self), spec) if spec else str(self)

    @classmethod
    def _missing_(cls, value: object) -> Any:
        raise ValueError(f"Invalid int value for {cls.__name__}: {value}")


@functools.cache
def make_enum(name: str) -> type[MjEnum]:
    """Make an enum with the numbers that the engine gives its names."""
    source = getattr(engine, name)
    values = {key: getattr(source, key).value for key in dir(source) if key.startswith("mj")}
    members = sorted(values.items(), key=lambda one: one[1])
    make: Any = MjEnum  # called with members, an enum makes another one
    made: type[MjEnum] = make(name, members, module=MjEnum.__module__)
    return made
