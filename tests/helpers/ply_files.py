"""PLY files of every form, made without the library, and what is in them."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

#: The words of the format, and what they mean to NumPy.
CODES = {"float": "f4", "double": "f8", "uchar": "u1", "ushort": "u2", "uint8": "u1"}
CODES |= {"float32": "f4", "float64": "f8", "uint16": "u2", "int": "i4", "short": "i2"}
ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True)
class Form:
    """What makes one PLY file different from another."""

    kind: str = "ascii"
    points: str = "float"
    colors: str | None = None
    normals: bool = False
    before: bool = False
    after: bool = False
    newline: str = "\n"

    def __str__(self) -> str:
        extras = [name for name in ("normals", "before", "after") if getattr(self, name)]
        return "-".join([self.kind, self.points, self.colors or "plain", *extras])


def make_forms() -> list[Form]:
    """List every kind with every type of points and colors, bare and in the midst of other data."""
    bare_or_not = [(False, False, False), (True, False, True), (False, True, False)]
    return [
        Form(kind, points, colors, *extras)
        for kind, points, colors, extras in itertools.product(
            ORDERS, ("float", "double"), (None, "uchar", "ushort", "float"), bare_or_not
        )
    ]


@dataclass(frozen=True)
class File:
    """A file, and the truth about it."""

    content: bytes
    points: np.ndarray
    colors: np.ndarray | None


def make_file(form: Form, rng: np.random.Generator, count: int = 6) -> File:
    """Make a file of random points and colors, with damage nowhere."""
    order = ORDERS[form.kind]
    types = dict.fromkeys("xyz", form.points)
    if form.normals:
        types |= {f"n{axis}": "float" for axis in "xyz"}
    if form.colors:
        types |= dict.fromkeys(("red", "green", "blue"), form.colors)
    names = list(types)
    rng.shuffle(names)
    vertices = np.empty(count, [(name, order + CODES[types[name]]) for name in names])
    for name in names:
        whole = vertices[name].dtype.kind == "u"
        top = np.iinfo(vertices[name].dtype).max + 1 if whole else 1
        vertices[name] = rng.integers(0, top, count) if whole else rng.random(count)

    header = ["ply", f"format {form.kind} 1.0", "comment a test", "obj_info made by a test"]
    chunks = []
    if form.before:
        header += ["element camera 2", "property list uchar int ids", "property float focal"]
        chunks += [_pack_list(form.kind, ids, tail=0.5) for ids in ([7, 8, 9], [4])]
    header += [f"element vertex {count}"]
    header += [f"property {types[name]} {name}" for name in names]
    chunks += [_pack_row(form.kind, row) for row in vertices]
    if form.after:
        header += ["element face 2", "property list uchar int vertex_indices"]
        chunks += [_pack_list(form.kind, corners) for corners in ([0, 1, 2], [0, 1, 2, 3])]
    text = form.newline.join([*header, "end_header", ""])
    points = np.stack([vertices[axis] for axis in "xyz"], axis=1)
    colors = None
    if form.colors:
        stored = np.stack([vertices[name] for name in ("red", "green", "blue")], axis=1)
        colors = stored / (np.iinfo(stored.dtype).max if stored.dtype.kind == "u" else 1)
    content = text.encode() + b"".join(chunks)
    return File(content, points.astype(CODES[form.points]), colors)


def _pack_row(kind: str, row: np.void) -> bytes:
    if kind != "ascii":
        return row.tobytes()
    return (" ".join(repr(number) for number in row.tolist()) + "\n").encode()


def _pack_list(kind: str, numbers: list[int], tail: float | None = None) -> bytes:
    if kind == "ascii":
        words = [len(numbers), *numbers, *([] if tail is None else [tail])]
        return (" ".join(map(str, words)) + "\n").encode()
    order = ORDERS[kind]
    last = b"" if tail is None else np.array(tail, order + "f4").tobytes()
    return bytes([len(numbers)]) + np.array(numbers, order + "i4").tobytes() + last
