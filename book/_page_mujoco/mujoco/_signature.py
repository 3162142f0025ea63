"""How a function is called: its parameters by name, and what each of them may be."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np

from ._structs import MODULE

_NUMBERS = {
    "int": "typing.SupportsInt | typing.SupportsIndex",
    "float": "typing.SupportsFloat | typing.SupportsIndex",
}
_ACCEPTED: dict[str, tuple[type, ...]] = {
    "bool": (bool, np.bool_, int),
    "int": (int, np.integer),
    "float": (int, float, np.number),
    "str": (str,),
}
_DTYPES = {"f8": "float64", "f4": "float32", "i4": "int32", "i8": "int64", "u1": "uint8"}


class Parameter(NamedTuple):
    """One parameter of a function."""

    name: str
    kind: str  # a type of Python, a struct, or the dtype of an array
    sizes: tuple[str, ...] = ()
    is_written: bool = False
    is_optional: bool = False
    default: str = ""

    @classmethod
    def parse(cls, text: str) -> Parameter:
        """Read ``geomid:i4[1,1]w?=None``."""
        found = re.fullmatch(r"(\w+):([^\[?=]+)(?:\[([^\]]*)\])?(w?)(\??)(?:=(.*))?", text)
        if not found:
            raise ValueError(f"expected a parameter such as 'm:MjModel', got {text!r}")
        name, kind, sizes, written, optional, default = found.groups()
        parts = tuple(sizes.split(",")) if sizes else ()
        return cls(name, kind, parts, bool(written), bool(optional), default or "")

    def accepts(self, value: Any) -> bool:
        """Tell whether the real package would take a value here."""
        if value is None:
            return self.is_optional
        if self.sizes:
            return self._accepts_array(value)
        if self.kind in _ACCEPTED:
            return isinstance(value, _ACCEPTED[self.kind]) or self._is_one_number(value)
        return type(value).__name__ == self.kind

    def _is_one_number(self, value: Any) -> bool:
        return self.kind in _NUMBERS and isinstance(value, np.ndarray) and value.size == 1

    def _accepts_array(self, value: Any) -> bool:
        if self.is_written:
            is_array = isinstance(value, np.ndarray) and value.dtype == np.dtype(self.kind)
            if not (is_array and value.flags.writeable):
                return False
        try:
            array = np.asarray(value, self.kind)
        except (TypeError, ValueError):
            return False
        if "n" in self.sizes:
            return array.ndim == 2 or (array.ndim == 1 and not self.is_written)
        is_vector = array.ndim == 1 or (array.ndim == 2 and array.shape[1] == 1)
        length = self.sizes[0]
        return is_vector and (not length.isdecimal() or len(array) == int(length))

    def describe(self) -> str:
        """Write the parameter as the real package does in its messages."""
        if self.sizes:
            shape = ", ".join(self.sizes)
            flags = ', "flags.writeable"' if self.is_written else ""
            dtype = _DTYPES[self.kind]
            kind = f'typing.Annotated[numpy.typing.NDArray[numpy.{dtype}], "[{shape}]"{flags}]'
        elif self.kind.startswith("Mj"):
            kind = f"{MODULE}.{self.kind}"
        else:
            kind = _NUMBERS.get(self.kind, self.kind)
        optional = " | None" if self.is_optional else ""
        return f"{self.name}: {kind}{optional}{f' = {self.default}' if self.default else ''}"

    def get_default(self) -> Any:
        """Return the value where none is given."""
        return None if self.default == "None" else int(self.default)


class Signature(NamedTuple):
    """The parameters of a function, in their order."""

    name: str
    parameters: tuple[Parameter, ...]
    returns: str

    @classmethod
    def parse(cls, name: str, text: str) -> Signature:
        """Read ``m:MjModel d:MjData -> None``."""
        given, _, returns = text.partition(" -> ")
        return cls(name, tuple(Parameter.parse(one) for one in given.split()), returns)

    def bind(self, arguments: tuple[Any, ...], named: dict[str, Any]) -> list[Any]:
        """Put arguments in order; raise TypeError, with the real package's words, if none fits."""
        names = [parameter.name for parameter in self.parameters]
        given = dict(zip(names, arguments, strict=False))
        is_right = len(arguments) <= len(names) and not given.keys() & named.keys()
        given |= named
        values = []
        for parameter in self.parameters:
            if parameter.name in given:
                values.append(given.pop(parameter.name))
            elif parameter.default:
                values.append(parameter.get_default())
            else:
                is_right = False
                break
            is_right = is_right and parameter.accepts(values[-1])
        if not is_right or given:
            raise TypeError(self._complain(arguments, named))
        return values

    def _complain(self, arguments: tuple[Any, ...], named: dict[str, Any]) -> str:
        shown = [repr(one) for one in arguments]
        shown += [f"{name}={value!r}" for name, value in named.items()]
        expected = ", ".join(parameter.describe() for parameter in self.parameters)
        return (
            f"{self.name}(): incompatible function arguments. The following argument types are "
            f"supported:\n    1. ({expected}) -> {self.returns}\n\nInvoked with: {', '.join(shown)}"
        )
