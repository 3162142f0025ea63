"""The parts of a PLY file: its header, the elements to skip, and the columns of its vertices.

Errors say what was expected and what came; `labutils.ply` adds the name of the file.
"""

from __future__ import annotations

import re
from typing import Literal, NamedTuple, Protocol

import numpy as np

#: The words for types: those of the paper from 1994, and those with a size, which came later.
_CODES = {"char": "i1", "short": "i2", "int": "i4", "float": "f4", "double": "f8"}
_CODES |= {"uchar": "u1", "ushort": "u2", "uint": "u4", "float32": "f4", "float64": "f8"}
_CODES |= {
    f"{sign}int{8 * size}": f"{sign or 'i'}{size}" for sign in ("", "u") for size in (1, 2, 4)
}

_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}

#: What a line of the header may be, by its first word.
_FORMS = {
    "format": "format ascii 1.0, binary_little_endian 1.0 or binary_big_endian 1.0",
    "element": "element NAME COUNT",
    "property": "property TYPE NAME or property list TYPE TYPE NAME with TYPE one of "
    + ", ".join(_CODES),
}

AXES = ("x", "y", "z")
CHANNELS = ("red", "green", "blue")

#: More digits than any file has elements: longer numbers are damage.
_MOST_DIGITS = 18


class Property(NamedTuple):
    """One number per row, or a list of them whose length stands before it."""

    name: str
    code: str
    length_code: str | None = None


class Element(NamedTuple):
    """A table of the file."""

    name: str
    rows: int
    properties: list[Property]


class Header(NamedTuple):
    """What a file says about itself."""

    order: str  # byte order as NumPy writes it; "" for text
    elements: list[Element]
    comments: tuple[str, ...]
    size: int  # bytes before the data


def read_header(content: bytes) -> Header:
    """Read what stands before the data, or raise ValueError."""
    start = re.match(rb"ply[ \t]*(\r\n|\n|\r)", content)
    if start is None:
        raise ValueError(f"expected a PLY file, which begins with ply, got {content[:12]!r}")
    newline = start[1]
    # In a binary file the next byte is data: so this line must end as the first one does.
    last = re.compile(newline + rb"end_header[ \t\r]*?(?:" + newline + rb"|\Z)")
    end = last.search(content, start.end() - len(newline))
    if end is None:
        raise ValueError("expected a header that ends with a line end_header, got none")
    text = content[start.end() : end.start()].decode("utf-8", errors="replace")
    lines = [(number, line) for number, line in enumerate(text.split(newline.decode()), start=2)]
    comments = tuple(
        line.strip().removeprefix("comment").strip()
        for _, line in lines
        if line.split()[:1] == ["comment"]
    )
    told = [one for one in lines if one[1].split()[:1] not in ([], ["comment"], ["obj_info"])]
    return Header(*_parse_lines(told), comments, end.end())


def _parse_lines(lines: list[tuple[int, str]]) -> tuple[str, list[Element]]:
    """Return the byte order and the elements that numbered lines declare."""
    order = None
    elements: list[Element] = []
    for number, line in lines:
        match line.split():
            case ["format", name, "1.0"] if name in _ORDERS and order is None:
                order = _ORDERS[name]
            case ["element", name, rows] if _is_count(rows):
                elements.append(Element(name, int(rows), []))
            case ["property", *types, name] if elements and (own := _parse_types(types)):
                elements[-1].properties.append(Property(name, *own))
            case [word, *_]:
                form = _FORMS.get(word, f"comment, obj_info, {', '.join(_FORMS)} or end_header")
                raise ValueError(f"line {number}: expected {form}, got {line.strip()[:60]!r}")
    if order is None:
        raise ValueError(f"header: expected a line {_FORMS['format']}, got none")
    return order, elements


def _parse_types(words: list[str]) -> tuple[str, str | None] | None:
    """Return the types of a number and of the length of a list of them; None for other words."""
    match words:
        case [kind] if kind in _CODES:
            return _CODES[kind], None
        case ["list", length, kind] if {length, kind} <= _CODES.keys():
            return None if _CODES[length][0] == "f" else (_CODES[kind], _CODES[length])
    return None


def _is_count(text: str) -> bool:
    return text.isascii() and text.isdecimal() and len(text) <= _MOST_DIGITS


def read_columns(content: bytes, header: Header) -> dict[str, np.ndarray]:
    """Read the axes and color channels of the vertices, and skip all else.

    Parameters
    ----------
    content : bytes
        The whole file.
    header : Header
        What `read_header` found in it.

    Returns
    -------
    dict of str to ndarray, shape (N,)
        By the name of the property, in its type, in the byte order of the machine. x, y and z are
        always there; red, green and blue all or none.

    Raises
    ------
    ValueError
        If there is not one element `vertex` with these properties and without lists, the data end
        too early, or a text is no number of its property's type.
    """
    names = [element.name for element in header.elements]
    if names.count("vertex") != 1:
        raise ValueError(f"header: expected one element vertex, got {', '.join(names) or 'none'}")
    place = names.index("vertex")
    vertex = header.elements[place]
    _check_vertex(vertex)
    data: _Data
    data = (_Binary if header.order else _Text)(content[header.size :], header.order)
    at = 0
    for element in header.elements[:place]:
        at = _skip(element, at, data)
    row = sum(data.get_size(one.code) for one in vertex.properties)
    if at + vertex.rows * row > data.size:
        found = max(0, data.size - at) // row
        raise ValueError(f"expected {vertex.rows} vertices, got {found}: the file is cut short")
    return data.get_columns(vertex, at)


def _check_vertex(vertex: Element) -> None:
    names = [one.name for one in vertex.properties]
    if lists := [one.name for one in vertex.properties if one.length_code is not None]:
        raise ValueError(f"vertex: expected no list among its properties, got {', '.join(lists)}")
    if any(names.count(name) != 1 for name in AXES):
        raise ValueError(
            f"vertex: expected one each of x, y and z, got {', '.join(names) or 'none'}"
        )
    if any(names.count(name) != 1 for name in CHANNELS) and not set(names).isdisjoint(CHANNELS):
        raise ValueError(
            f"vertex: expected one each of red, green and blue, got {', '.join(names)}"
        )


class _Data(Protocol):
    """What follows the header, as a row of places: bytes, or numbers as text."""

    size: int

    def __init__(self, content: bytes, order: str) -> None: ...

    def get_size(self, code: str) -> int:
        """Return how many places a number takes."""

    def get_length(self, code: str, at: int) -> int:
        """Read the length of a list; below 0 where there is none."""

    def get_columns(self, vertex: Element, at: int) -> dict[str, np.ndarray]:
        """Read the vertices, all of which are there."""


def _skip(element: Element, at: int, data: _Data) -> int:
    """Return the place after an element."""
    sizes = [(data.get_size(one.code), one.length_code) for one in element.properties]
    if all(length_code is None for _, length_code in sizes):
        return at + element.rows * sum(size for size, _ in sizes)
    for row in range(element.rows):
        for size, length_code in sizes:
            if length_code is None:
                at += size
                continue
            length = data.get_length(length_code, at)
            if length < 0:
                raise ValueError(f"{element.name} {row}: expected the length of a list, got none")
            at += data.get_size(length_code) + length * size
    return at


class _Binary:
    def __init__(self, content: bytes, order: str) -> None:
        self._content = content
        self._order = order
        self.size = len(content)

    def get_size(self, code: str) -> int:
        return int(code[1])

    def get_length(self, code: str, at: int) -> int:
        number = self._content[at : at + int(code[1])]
        if len(number) < int(code[1]):
            return -1
        order: Literal["little", "big"] = "little" if self._order == "<" else "big"
        return int.from_bytes(number, order, signed=code[0] == "i")

    def get_columns(self, vertex: Element, at: int) -> dict[str, np.ndarray]:
        # Fields by number: a name may be anything, also twice.
        fields = [(str(i), self._order + one.code) for i, one in enumerate(vertex.properties)]
        table = np.frombuffer(self._content, np.dtype(fields), count=vertex.rows, offset=at)
        return {
            one.name: table[str(i)].astype(one.code)
            for i, one in enumerate(vertex.properties)
            if one.name in AXES + CHANNELS
        }


class _Text:
    def __init__(self, content: bytes, order: str) -> None:
        del order
        self._words = content.split()
        self.size = len(self._words)

    def get_size(self, code: str) -> int:
        del code
        return 1

    def get_length(self, code: str, at: int) -> int:
        del code
        word = self._words[at].decode("ascii", "replace") if at < self.size else ""
        return int(word) if _is_count(word) else -1

    def get_columns(self, vertex: Element, at: int) -> dict[str, np.ndarray]:
        width = len(vertex.properties)
        words = self._words[at : at + vertex.rows * width]
        return {
            one.name: _parse_column(one.name, words[i::width], one.code)
            for i, one in enumerate(vertex.properties)
            if one.name in AXES + CHANNELS
        }


def _parse_column(name: str, words: list[bytes], code: str) -> np.ndarray:
    """Return the numbers of a column in their type; NaN and infinity stay what they are."""
    try:
        values = np.array(words, dtype=np.float64)
    except ValueError as error:
        raise ValueError(
            f"{name}: expected numbers, got {str(error).rpartition(': ')[2]}"
        ) from None
    if code[0] == "f":
        limit = np.finfo(code).max
        held = ~np.isfinite(values) | (np.abs(values) <= limit)
        expected = f"at most {limit:.2g}, as {np.dtype(code)} holds"
    else:
        low, high = np.iinfo(code).min, np.iinfo(code).max
        held = (values >= low) & (values <= high) & (values == np.floor(values))
        expected = f"a whole number from {low} to {high}"
    if not held.all():
        first = int(held.argmin())
        raise ValueError(f"{name} of vertex {first}: expected {expected}, got {values[first]:g}")
    return values.astype(code)
