"""Right answers to parse_ply, as strangers wrote them."""
import csv
import io
import itertools
from dataclasses import dataclass, field

import numpy as np


# 1. plain lines
def f1(text):
    lines = text.splitlines()
    names, count, inside = [], 0, False
    for i, line in enumerate(lines):
        words = line.split()
        if not words:
            continue
        if words[0] == "end_header":
            break
        if words[0] == "element":
            inside = words[1] == "vertex"
            if inside:
                count = int(words[2])
        elif words[0] == "property" and inside:
            names.append(words[-1])
    table = np.array([row.split() for row in lines[i + 1:i + 1 + count]], dtype=float)
    table = table.reshape(count, len(names))
    points = table[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, table[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


# 2. C programmer: an iterator and numbers one by one
def f2(text):
    stream = iter(text.split("\n"))
    where, n, n_props = {}, 0, 0
    current = ""
    while True:
        tokens = next(stream).strip().split()
        if len(tokens) == 0 or tokens[0] in ("ply", "format", "comment", "obj_info"):
            continue
        if tokens[0] == "end_header":
            break
        if tokens[0] == "element":
            current = tokens[1]
            if current == "vertex":
                n = int(tokens[2])
        if tokens[0] == "property" and current == "vertex":
            where[tokens[2]] = n_props
            n_props += 1
    with_color = "red" in where and "green" in where and "blue" in where
    points = np.zeros((n, 3))
    colors = np.zeros((n, 3)) if with_color else None
    for i in range(n):
        numbers = next(stream).split()
        for k, axis in enumerate(("x", "y", "z")):
            points[i, k] = float(numbers[where[axis]])
        if with_color:
            for k, channel in enumerate(("red", "green", "blue")):
                colors[i, k] = float(numbers[where[channel]]) / 255.0
    return points, colors


# 3. StringIO and loadtxt
def f3(text):
    file = io.StringIO(text)
    columns, element, n = {}, None, 0
    for line in file:
        word, *rest = line.split() or [""]
        if word == "end_header":
            break
        if word == "element":
            element = rest[0]
            n = int(rest[1]) if element == "vertex" else n
        if word == "property" and element == "vertex":
            columns[rest[-1]] = len(columns)
    body = list(itertools.islice(file, n))
    data = np.loadtxt(body, ndmin=2) if n else np.empty((0, len(columns)))
    xyz = data[:, [columns["x"], columns["y"], columns["z"]]]
    if "red" in columns:
        return xyz, data[:, [columns[c] for c in ("red", "green", "blue")]] / 255.0
    return xyz, None


# 4. over-engineered
@dataclass
class _Element:
    name: str
    count: int
    properties: list = field(default_factory=list)


class _PlyText:
    def __init__(self, text):
        lines = [line.rstrip("\r") for line in text.split("\n")]
        if lines[0].strip() != "ply":
            raise ValueError("this is no PLY file")
        self.elements = []
        for number, line in enumerate(lines):
            key, *args = line.split() or ["comment"]
            if key == "end_header":
                self.body = lines[number + 1:]
                return
            handler = getattr(self, "_on_" + key, None)
            if handler:
                handler(*args)
        raise ValueError("no end_header")

    def _on_format(self, kind, *version):
        if kind != "ascii":
            raise ValueError("only ASCII")

    def _on_element(self, name, count, *rest):
        self.elements.append(_Element(name, int(count)))

    def _on_property(self, *args):
        self.elements[-1].properties.append(args[-1])

    def vertices(self):
        element = next(e for e in self.elements if e.name == "vertex")
        rows = [[float(w) for w in line.split()] for line in self.body[:element.count]]
        table = dict(zip(element.properties, zip(*rows))) if rows else {p: () for p in element.properties}
        return {name: np.array(column, dtype=np.float64) for name, column in table.items()}


def f4(text: str):
    v = _PlyText(text).vertices()
    points = np.column_stack([v["x"], v["y"], v["z"]])
    if not {"red", "green", "blue"} <= v.keys():
        return points, None
    return points, np.column_stack([v["red"], v["green"], v["blue"]]) / 255


# 5. partition at the end of the header, structured rows, float32 result
def f5(text):
    head, rows = [], None
    lines = text.splitlines()
    cut = next(i for i, l in enumerate(lines) if l.strip() == "end_header")
    head, rows = lines[:cut], lines[cut + 1:]
    at = next(i for i, l in enumerate(head) if l.split()[:2] == ["element", "vertex"])
    n = int(head[at].split()[2])
    rest = itertools.takewhile(lambda l: l.split()[:1] != ["element"], head[at + 1:])
    names = [l.split()[2] for l in rest if l.split()[:1] == ["property"]]
    kind = np.dtype([(name, np.float64) for name in names])
    record = np.array([tuple(map(float, r.split())) for r in rows[:n]], dtype=kind)
    stack = lambda keys: np.stack([record[k] for k in keys], axis=-1).astype(np.float32)
    return stack("xyz"), stack(["red", "green", "blue"]) / np.float32(255) if "red" in names else None


# 6. csv
def f6(text):
    reader = csv.reader(io.StringIO(text.replace("\t", " ")), delimiter=" ", skipinitialspace=True, quoting=csv.QUOTE_NONE)
    words = ([w for w in row if w] for row in reader)
    fields, vertex, n = [], False, 0
    for row in words:
        if row[:1] == ["end_header"]:
            break
        if row[:1] == ["element"]:
            vertex = row[1] == "vertex"
            n = int(row[2]) if vertex else n
        elif row[:1] == ["property"] and vertex:
            fields.append(row[2])
    points, colors = [], []
    for row in itertools.islice(words, n):
        entry = dict(zip(fields, map(float, row)))
        points.append([entry[k] for k in "xyz"])
        if "red" in entry:
            colors.append([entry[k] / 255 for k in ("red", "green", "blue")])
    shape = lambda a: np.array(a, dtype=float).reshape(-1, 3)
    return shape(points), shape(colors) if "red" in fields else None


# 7. short: words of the header, all numbers at once
def f7(text):
    L = text.splitlines()
    e = [l.strip() for l in L].index("end_header")
    h = [w for w in map(str.split, L[:e]) if w and w[0] in ("element", "property")]
    i = [w[:2] for w in h].index(["element", "vertex"])
    j = next((k for k in range(i + 1, len(h)) if h[k][0] == "element"), len(h))
    n, p = int(h[i][2]), [w[-1] for w in h[i + 1:j]]
    A = np.array(" ".join(L[e + 1:e + 1 + n]).split(), dtype=float).reshape(n, len(p))
    g = lambda *k: np.stack([A[:, p.index(c)] for c in k], 1)
    return g(*"xyz"), g("red", "green", "blue") / 255 if "red" in p else None


# 8. a state machine as a generator
def _events(text):
    state, left = "header", 0
    element, names = None, []
    for line in text.splitlines():
        words = line.split()
        if state == "header":
            if not words or words[0] == "comment":
                continue
            if words[0] == "element":
                element = words[1]
                if element == "vertex":
                    left = int(words[2])
            elif words[0] == "property" and element == "vertex":
                names.append(words[-1])
            elif words[0] == "end_header":
                yield names
                state = "vertices"
        elif left > 0:
            left -= 1
            yield dict(zip(names, words))
        else:
            return


def f8(text):
    events = _events(text)
    names = next(events)
    vertices = list(events)
    grid = lambda keys: np.array([[float(v[k]) for k in keys] for v in vertices]).reshape(len(vertices), len(keys))
    points = grid(("x", "y", "z"))
    colors = None
    if set(names) >= {"red", "green", "blue"}:
        colors = grid(("red", "green", "blue"))
        colors /= 255
    return points, colors


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
