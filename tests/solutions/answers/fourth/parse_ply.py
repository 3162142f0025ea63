"""Right answers to parse_ply, as strangers wrote them."""
import io
import re
from dataclasses import dataclass, field

import numpy as np


# 1. beginner
def f1(text):
    lines = text.splitlines()
    names = []
    count = 0
    in_vertex = False
    i = 0
    while True:
        words = lines[i].split()
        i += 1
        if len(words) == 0 or words[0] == "comment":
            continue
        if words[0] == "end_header":
            break
        if words[0] == "element":
            in_vertex = words[1] == "vertex"
            if in_vertex:
                count = int(words[2])
        elif words[0] == "property" and in_vertex:
            names.append(words[-1])
    rows = [[float(w) for w in line.split()] for line in lines[i:i + count]]
    table = np.array(rows, dtype=float).reshape(count, len(names))
    points = table[:, [names.index("x"), names.index("y"), names.index("z")]]
    if "red" not in names:
        return points, None
    colors = table[:, [names.index("red"), names.index("green"), names.index("blue")]] / 255
    return points, colors


# 2. regular expressions
def f2(text):
    header, body = re.split(r"^end_header[ \t]*\r?\n?", text, maxsplit=1, flags=re.M)
    header = re.sub(r"^[ \t]*(comment|obj_info)\b.*$", "", header, flags=re.M)
    found = re.search(r"^element[ \t]+vertex[ \t]+(\d+)[ \t]*\r?$(.*?)(?=^element\b|\Z)", header, re.M | re.S)
    n = int(found.group(1))
    names = re.findall(r"^property[ \t]+\S+[ \t]+(\S+)", found.group(2), re.M)
    values = body.split("\n")[:n]
    data = np.array([v.split() for v in values], dtype=np.float64).reshape(n, len(names))
    column = dict(zip(names, data.T))
    pick = lambda *keys: np.column_stack([column[k] for k in keys])
    return pick("x", "y", "z"), (pick("red", "green", "blue") / 255.0 if "red" in column else None)


# 3. np.loadtxt
def f3(text):
    stream = io.StringIO(text)
    names, count, element = [], 0, None
    for line in iter(stream.readline, ""):
        word = line.split() or [""]
        match word[0]:
            case "end_header":
                break
            case "element":
                element = word[1]
                if element == "vertex":
                    count = int(word[2])
            case "property" if element == "vertex":
                names.append(word[2])
    if count:
        table = np.loadtxt(stream, max_rows=count, ndmin=2)
    else:
        table = np.zeros((0, len(names)))
    xyz = table[:, [names.index(n) for n in "xyz"]]
    rgb = None
    if {"red", "green", "blue"} <= set(names):
        rgb = table[:, [names.index(n) for n in ("red", "green", "blue")]] / 255
    return xyz, rgb


# 4. flat list of tokens; the header word by word per line
def f4(text):
    end = None
    lines = [line.strip() for line in text.split("\n")]
    end = lines.index("end_header")
    head = [line.split() for line in lines[:end] if line and not line.startswith("comment")]
    start = next(k for k, w in enumerate(head) if w[:2] == ["element", "vertex"])
    n = int(head[start][2])
    names = []
    for w in head[start + 1:]:
        if w[0] == "element":
            break
        if w[0] == "property":
            names.append(w[-1])
    tokens = " ".join(lines[end + 1:end + 1 + n]).split()
    grid = np.fromiter(map(float, tokens), dtype=float, count=n * len(names)).reshape(n, -1 if n else len(names))
    at = {name: k for k, name in enumerate(names)}
    points = np.stack([grid[:, at[k]] for k in "xyz"], axis=1)
    colors = np.stack([grid[:, at[k]] for k in ("red", "green", "blue")], axis=1) / 255 if "blue" in at else None
    return points, colors


# 5. dataclasses, state machine, validation
@dataclass
class Element:
    name: str
    count: int
    properties: list = field(default_factory=list)


class PlyReader:
    def __init__(self, text):
        self.lines = iter(text.splitlines())
        self.elements = []
        if next(self.lines).strip() != "ply":
            raise ValueError("not a PLY file")
        for line in self.lines:
            keyword, _, rest = line.strip().partition(" ")
            if keyword == "end_header":
                break
            handler = getattr(self, f"on_{keyword}", None)
            if handler:
                handler(rest.split())

    def on_element(self, words):
        self.elements.append(Element(words[0], int(words[1])))

    def on_property(self, words):
        self.elements[-1].properties.append(words[-1])

    def vertices(self):
        vertex = next(e for e in self.elements if e.name == "vertex")
        columns = {p: [] for p in vertex.properties}
        for _ in range(vertex.count):
            for name, word in zip(vertex.properties, next(self.lines).split(), strict=True):
                columns[name].append(float(word))
        return columns


def f5(text):
    columns = PlyReader(text).vertices()

    def take(names):
        return np.array([columns[n] for n in names], dtype=np.float64).T.reshape(-1, 3)

    has_colors = all(n in columns for n in ("red", "green", "blue"))
    return take("xyz"), take(("red", "green", "blue")) / 255 if has_colors else None


# 6. structured array via genfromtxt / generator; float32 colors
def f6(text):
    lines = text.splitlines()
    end = [l.strip() for l in lines].index("end_header")
    where, fields, n = "", [], 0
    for l in lines[:end]:
        key, *rest = l.split() or ["comment"]
        if key == "element":
            where = rest[0]
            n = int(rest[1]) if where == "vertex" else n
        if key == "property" and where == "vertex":
            fields.append((rest[-1], np.float64))
    rows = np.array([tuple(map(float, l.split())) for l in lines[end + 1:][:n]], dtype=fields)
    xyz = np.stack([rows["x"], rows["y"], rows["z"]], -1).reshape(n, 3)
    names = rows.dtype.names
    if "red" in names:
        rgb = np.stack([rows[c] for c in ("red", "green", "blue")], -1).astype(np.float32) / np.float32(255)
        return xyz, rgb.reshape(n, 3)
    return xyz, None


ANSWERS = [f1, f2, f3, f4, f5, f6]
