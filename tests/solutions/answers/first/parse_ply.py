"""Right answers to parse_ply, as strangers wrote them."""
import io
import itertools
import re

import numpy as np


def line_by_line(text):
    """Splits into lines, loops over the header, list of columns by name."""
    lines = text.splitlines()
    names, count, in_vertex, k = [], 0, False, 0
    for k, line in enumerate(lines):
        words = line.split()
        if not words or words[0] == "comment":
            continue
        if words[0] == "end_header":
            break
        if words[0] == "element":
            in_vertex = words[1] == "vertex"
            if in_vertex:
                count = int(words[2])
        elif words[0] == "property" and in_vertex:
            names.append(words[-1])
    rows = [[float(w) for w in line.split()] for line in lines[k + 1:k + 1 + count]]
    table = np.array(rows, dtype=np.float64).reshape(count, len(names))
    points = table[:, [names.index(n) for n in "xyz"]]
    if "red" not in names:
        return points, None
    return points, table[:, [names.index(n) for n in ("red", "green", "blue")]] / 255


def with_loadtxt(text):
    """np.loadtxt with usecols for the numbers, apart for zero points."""
    lines = [line.strip() for line in text.split("\n")]
    end = lines.index("end_header")
    header = [line.split() for line in lines[:end] if line and not line.startswith("comment")]
    start = next(i for i, w in enumerate(header) if w[:2] == ["element", "vertex"])
    n = int(header[start][2])
    properties = [w[-1] for w in itertools.takewhile(lambda w: w[0] != "element", header[start + 1:])
                  if w[0] == "property"]
    wanted = ["x", "y", "z"] + (["red", "green", "blue"] if "red" in properties else [])
    if n == 0:
        data = np.zeros((0, len(wanted)))
    else:
        data = np.loadtxt(lines[end + 1:end + 1 + n], usecols=[properties.index(w) for w in wanted],
                          ndmin=2, comments=None, dtype=np.float64)
    return data[:, :3].copy(), (data[:, 3:] / 255.0 if len(wanted) == 6 else None)


def with_regular_expressions(text):
    """re for the header; one flat array of numbers for the body."""
    match = re.search(r"^end_header[ \t]*\r?(?:\n|\Z)", text, flags=re.MULTILINE)
    header, body = text[:match.start()], text[match.end():]
    element = re.search(r"^[ \t]*element[ \t]+vertex[ \t]+(\d+)[ \t]*\r?$(.*?)(?=^[ \t]*element[ \t]|\Z)", header,
                        flags=re.MULTILINE | re.DOTALL)
    n = int(element.group(1))
    names = re.findall(r"^[ \t]*property[ \t]+\S+[ \t]+(\S+)[ \t]*\r?$", element.group(2), flags=re.MULTILINE)
    body_lines = body.split("\n")[:n]
    flat = np.array(" ".join(body_lines).split(), dtype=np.float64)
    columns = dict(zip(names, flat.reshape(n, len(names)).T))
    points = np.stack([columns[k] for k in ("x", "y", "z")], axis=1)
    if {"red", "green", "blue"} <= columns.keys():
        return points, np.stack([columns[k] for k in ("red", "green", "blue")], axis=1) / 255
    return points, None


def reading_a_stream(text):
    """io.StringIO as a file: the header consumes lines, islice takes exactly N more; a dictionary per point."""
    stream = io.StringIO(text)
    element, names, n = None, [], 0
    for line in stream:
        word, *rest = line.split() or [""]
        if word == "end_header":
            break
        if word == "element":
            element = rest[0]
            n = int(rest[1]) if element == "vertex" else n
        if word == "property" and element == "vertex":
            names.append(rest[-1])
    vertices = [dict(zip(names, map(float, line.split()))) for line in itertools.islice(stream, n)]
    points = np.array([(p["x"], p["y"], p["z"]) for p in vertices], dtype=np.float64).reshape(-1, 3)
    if "green" not in names:
        return points, None
    colors = np.array([(p["red"], p["green"], p["blue"]) for p in vertices], dtype=np.float64).reshape(-1, 3)
    return points, colors / 255.0


class _Ply:
    """A small state machine: start, vertex, other, body."""

    def __init__(self):
        self.state, self.count, self.columns = "start", 0, {}

    def feed(self, line):
        if self.state == "body":
            if self.count > 0:
                self.count -= 1
                for values, word in zip(self.columns.values(), line.split()):
                    values.append(float(word))
            return
        words = line.split()
        keyword = words[0] if words else "comment"
        if keyword == "end_header":
            self.state = "body"
        elif keyword == "element" and words[1] == "vertex":
            self.state, self.count = "vertex", int(words[2])
        elif keyword == "element":
            self.state = "other"
        elif keyword == "property" and self.state == "vertex":
            self.columns[words[2]] = []

    def get(self, *names):
        if any(name not in self.columns for name in names):
            return None
        return np.array([self.columns[name] for name in names], dtype=np.float64).T.copy()


def state_machine(text):
    """A class fed line by line; a list per column."""
    ply = _Ply()
    for line in text.split("\n"):
        ply.feed(line)
    colors = ply.get("red", "green", "blue")
    return ply.get("x", "y", "z"), None if colors is None else colors / 255


def structured_array(text):
    """A structured dtype with one field per property, filled from tuples."""
    head, _, body = text.replace("\r\n", "\n").partition("\nend_header\n")
    fields, n, mine = [], 0, False
    for words in map(str.split, head.split("\n")):
        if words[:1] == ["element"]:
            mine = words[1] == "vertex"
            n = int(words[2]) if mine else n
        elif words[:1] == ["property"] and mine:
            fields.append((words[-1], np.float64))
    table = np.array([tuple(line.split()) for line in body.split("\n")[:n]], dtype=fields)

    def columns(names):
        return np.column_stack([table[k] for k in names]).astype(np.float64)

    has_colors = all(k in table.dtype.names for k in ("red", "green", "blue"))
    return columns("xyz"), columns(["red", "green", "blue"]) / 255 if has_colors else None


def with_checks(text):
    """Over-engineered: complains about files that the statement does not promise; colors by a table of 256 numbers where they are whole."""
    rows = iter(text.splitlines())
    if next(rows, "").strip() != "ply":
        raise ValueError("no PLY file")
    sections = {}
    current = None
    for row in rows:
        words = row.split()
        if words == ["end_header"]:
            break
        if words[:1] == ["format"] and words[1] != "ascii":
            raise ValueError("only ASCII files")
        if words[:1] == ["element"]:
            current = words[1]
            sections[current] = (int(words[2]), [])
        elif words[:1] == ["property"]:
            sections[current][1].append(words[-1])
    n, names = sections["vertex"]
    values = np.empty((n, len(names)), dtype=np.float64)
    for i in range(n):
        values[i] = next(rows).split()
    xyz, rgb = ([names.index(k) for k in group if k in names] for group in (("x", "y", "z"), ("red", "green", "blue")))
    if len(xyz) != 3 or len(rgb) not in (0, 3):
        raise ValueError("x, y, z and all or none of red, green, blue expected")
    points = np.ascontiguousarray(values[:, xyz])
    return points, (np.multiply(values[:, rgb], 1 / 255) if rgb else None)


ANSWERS = [line_by_line, with_loadtxt, with_regular_expressions, reading_a_stream,
           state_machine, structured_array, with_checks]
