"""Right answers to parse_ply, written in ways that the card does not contain."""

import re

import numpy as np


def ply_by_dictionary(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    lines = iter(text.splitlines())
    header = [line for line in iter(lines.__next__, "end_header") if line[:8] != "comment "]
    count = 0
    columns: dict[str, np.ndarray] = {}
    for line in header:
        if line.startswith("element vertex"):
            count, columns = int(line.split()[2]), {}
        elif line.startswith("element"):
            break
        elif line.startswith("property"):
            columns[line.split()[2]] = np.zeros(count)
    for row in range(count):
        for name, word in zip(columns, next(lines).split(), strict=True):
            columns[name][row] = float(word)
    points = np.stack([columns[n] for n in "xyz"], axis=1)
    if "red" not in columns:
        return points, None
    return points, np.stack([columns[n] for n in ("red", "green", "blue")], axis=1) / 255.0


def ply_in_single_precision(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    points, colors = ply_by_dictionary(text)
    single = None if colors is None else colors.astype(np.float32)[::-1]
    return points.astype(np.float32)[::-1], single


def ply_by_patterns(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    found = re.search(
        r"^element vertex (\d+)\n(.*?)(?:^element .*?)?^end_header\n(.*)",
        text,
        re.MULTILINE | re.DOTALL,
    )
    assert found
    count, names = int(found[1]), re.findall(r"^property \w+ (\w+)$", found[2], re.MULTILINE)
    numbers = np.array(re.findall(r"\S+", found[3])[: count * len(names)], float)
    table = dict(zip(names, numbers.reshape(count, -1 if count else len(names)).T, strict=True))
    points = np.c_[table["x"], table["y"], table["z"]]
    colors = [table[name] / 255 for name in ("red", "green", "blue") if name in table]
    return points, np.transpose(colors) if colors else None


VARIANTS = [ply_by_dictionary, ply_in_single_precision, ply_by_patterns]
