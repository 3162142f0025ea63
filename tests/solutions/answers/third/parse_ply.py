"""Right answers to parse_ply, as strangers wrote them."""
import io
import re
from dataclasses import dataclass, field

import numpy as np


# 1. straight: split into lines, note the names, build the table
def ply_lines(text):
    lines = text.splitlines()
    end = [line.strip() for line in lines].index("end_header")
    names, n, in_vertex = [], 0, False
    for line in lines[:end]:
        words = line.split()
        if not words:
            continue
        if words[0] == "element":
            in_vertex = words[1] == "vertex"
            if in_vertex:
                n = int(words[2])
        elif words[0] == "property" and in_vertex:
            names.append(words[-1])
    table = np.array([[float(w) for w in line.split()] for line in lines[end + 1:end + 1 + n]])
    table = table.reshape(n, len(names))
    points = table[:, [names.index(a) for a in "xyz"]]
    if "red" not in names:
        return points, None
    colors = table[:, [names.index(a) for a in ("red", "green", "blue")]] / 255
    return points, colors


# 2. beginner, a state machine line by line
def ply_state_machine(text):
    state = "header"
    current_element = ""
    number_of_vertices = 0
    property_names = []
    points = []
    colors = []
    for line in text.split("\n"):
        line = line.strip()
        if state == "header":
            if line.startswith("comment"):
                continue
            elif line.startswith("element"):
                parts = line.split()
                current_element = parts[1]
                if current_element == "vertex":
                    number_of_vertices = int(parts[2])
            elif line.startswith("property"):
                if current_element == "vertex":
                    property_names.append(line.split()[-1])
            elif line == "end_header":
                state = "vertices"
        elif state == "vertices":
            if len(points) == number_of_vertices:
                break
            numbers = line.split()
            values = {}
            for k in range(len(property_names)):
                values[property_names[k]] = float(numbers[k])
            points.append([values["x"], values["y"], values["z"]])
            if "red" in values and "green" in values and "blue" in values:
                colors.append([values["red"] / 255.0, values["green"] / 255.0,
                               values["blue"] / 255.0])
    points = np.array(points, dtype=float).reshape(-1, 3)
    if "red" in property_names:
        return points, np.array(colors, dtype=float).reshape(-1, 3)
    return points, None


# 3. Java habits: header as objects
@dataclass
class _Element:
    name: str
    count: int
    properties: list = field(default_factory=list)


class _PlyFile:
    def __init__(self, text):
        reader = io.StringIO(text)
        self.elements = []
        for raw in reader:
            tokens = raw.split()
            keyword = tokens[0] if tokens else ""
            if tokens == ["end_header"]:
                break
            if keyword == "element":
                self.elements.append(_Element(tokens[1], int(tokens[2])))
            elif keyword == "property":
                self.elements[-1].properties.append(tokens[-1])
        else:
            raise ValueError("no end_header")
        self._reader = reader

    def vertex(self):
        for element in self.elements:
            if element.name == "vertex":
                return element
        raise ValueError("no element vertex")

    def read_columns(self):
        vertex = self.vertex()
        columns = {name: np.empty(vertex.count) for name in vertex.properties}
        for i in range(vertex.count):
            for name, word in zip(vertex.properties, next(self._reader).split()):
                columns[name][i] = float(word)
        return columns


def ply_java(text):
    columns = _PlyFile(text).read_columns()
    points = np.column_stack([columns[k] for k in ("x", "y", "z")])
    if {"red", "green", "blue"} <= columns.keys():
        return points, np.column_stack([columns[k] for k in ("red", "green", "blue")]) / 255.0
    return points, None


# 4. regular expressions
def ply_regex(text):
    text = text.replace("\r\n", "\n")
    header, body = re.split(r"^end_header[ \t]*\n?", text, maxsplit=1, flags=re.M)
    block = re.search(r"^element\s+vertex\s+(\d+)[ \t]*\n(.*?)(?=^element\b|\Z)", header,
                      flags=re.M | re.S)
    n = int(block.group(1))
    names = re.findall(r"^property\s+\S+\s+(\S+)", block.group(2), flags=re.M)
    rows = [list(map(float, row.split())) for row in body.split("\n")[:n]]
    data = np.asarray(rows, dtype=np.float64).reshape(n, len(names))
    pick = lambda wanted: data[:, list(map(names.index, wanted))]
    return pick(["x", "y", "z"]), (pick(["red", "green", "blue"]) / 255 if "red" in names else None)


# 5. np.loadtxt
def ply_loadtxt(text):
    lines = text.splitlines()
    k = next(i for i, line in enumerate(lines) if line.strip() == "end_header")
    owner, names, count = None, [], None
    for line in lines[:k]:
        match line.split():
            case ["comment", *_]:
                pass
            case ["element", owner, number]:
                if owner == "vertex":
                    count = int(number)
            case ["property", *_, name] if owner == "vertex":
                names.append(name)
    if count == 0:
        empty = np.zeros((0, 3))
        return empty, (empty.copy() if "red" in names else None)
    position = [names.index("x"), names.index("y"), names.index("z")]
    body = lines[k + 1:k + 1 + count]
    points = np.loadtxt(body, usecols=position, ndmin=2, comments=None)
    colors = None
    if "red" in names:
        rgb = [names.index("red"), names.index("green"), names.index("blue")]
        colors = np.loadtxt(body, usecols=rgb, ndmin=2, comments=None) / 255.0
    return points, colors


# 6. R habits: a data frame, that is a structured array
def ply_dataframe(text):
    # a comment may speak of end_header too: cut at the line, not at the word
    lines = text.replace("\r", "").split("\n")
    at = lines.index("end_header")
    names, n, element = [], 0, ""
    for words in map(str.split, lines[:at]):
        if words[:1] == ["element"]:
            element, n = words[1], (int(words[2]) if words[1] == "vertex" else n)
        elif words[:1] == ["property"] and element == "vertex":
            names += [words[-1]]
    frame = np.array([tuple(float(w) for w in line.split()) for line in lines[at + 1:at + 1 + n]],
                     dtype=[(name, "f8") for name in names])
    points = np.stack([frame["x"], frame["y"], frame["z"]], axis=-1)
    colors = None
    if "red" in names:
        colors = np.stack([frame[c] for c in ("red", "green", "blue")], axis=-1) / 255
    return points, colors


# 7. one stream of numbers
def ply_tokens(text):
    it = iter(text.splitlines())
    names, n, mine = [], 0, False
    for line in it:
        head, *rest = line.split() or [""]
        if head == "end_header":
            break
        if head == "element":
            mine = rest[0] == "vertex"
            n = int(rest[1]) if mine else n
        if head == "property" and mine:
            names.append(rest[-1])
    words = " ".join(line for _, line in zip(range(n), it)).split()
    table = np.array(words, dtype=np.float64).reshape(n, len(names)).T
    by_name = dict(zip(names, table))
    points = np.array([by_name["x"], by_name["y"], by_name["z"]]).T
    if "red" not in by_name:
        return points, None
    return points, np.array([by_name["red"], by_name["green"], by_name["blue"]]).T / 255.0


ANSWERS = [ply_lines, ply_state_machine, ply_java, ply_regex, ply_loadtxt, ply_dataframe,
           ply_tokens]
