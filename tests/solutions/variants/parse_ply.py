"""Right answers to parse_ply, written in ways that the card does not contain."""

from typing import Any

import numpy as np


def ply_by_dictionary(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    header, body = text.split("end_header\n")
    vertex = header[header.index("element vertex") :].splitlines()
    count, names = int(vertex[0].split()[2]), []
    for line in vertex[1:]:
        if line.startswith("element"):
            break
        if line.startswith("property"):
            names.append(line.split()[2])
    values = [line.split() for line in body.splitlines()[:count]]
    columns = {
        n: [float(v) for v in c] for n, c in zip(names, zip(*values, strict=True), strict=True)
    }
    points = np.stack([columns[n] for n in "xyz"], axis=1)
    if "red" not in columns:
        return points, None
    return points, np.stack([columns[n] for n in ("red", "green", "blue")], axis=1) / 255.0


def ply_in_single_precision(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    points, colors = ply_by_dictionary(text)
    single = None if colors is None else colors.astype(np.float32)[::-1]
    return points.astype(np.float32)[::-1], single


def ply_as_lists(text: str) -> tuple[list[Any], list[Any] | None]:
    points, colors = ply_by_dictionary(text)
    return points.tolist(), None if colors is None else colors.tolist()


VARIANTS = [ply_by_dictionary, ply_in_single_precision, ply_as_lists]
