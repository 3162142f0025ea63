"""Challenge of step 6: read a cloud back from the text of a PLY file."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification


def parse_ply(text: str) -> tuple[np.ndarray, np.ndarray | None]:
    """Read points and colors from the text of an ASCII PLY file.

    The header ends with the line ``end_header``. Its line ``element vertex N`` says that the first
    N lines after the header hold one point each, with one number of any type per ``property`` line
    that follows ``element vertex``, in that order. N may be 0. Numbers may have an exponent, as in
    ``1.5e-03``, and several spaces or tabs between them. Points have x, y and z, and either red,
    green and blue (0 to 255) or none of the three, in any order among other properties. There may
    be ``comment`` lines in the header, with any words, and other elements after the vertices.

    Parameters
    ----------
    text : str
        The whole file.

    Returns
    -------
    points : ndarray, float, (N, 3)
        x, y, z.
    colors : ndarray, float, (N, 3), or None
        Red, green, blue from 0 to 1, or None where the file has no colors.
    """
    lines = text.splitlines()
    end = lines.index("end_header")
    count, names, element = 0, [], ""
    for words in (line.split() for line in lines[:end]):
        if words[0] == "element":
            element = words[1]
            if element == "vertex":
                count = int(words[2])
        elif words[0] == "property" and element == "vertex":
            names.append(words[-1])
    rows = [line.split() for line in lines[end + 1 : end + 1 + count]]
    table = np.array(rows, dtype=np.float64).reshape(count, len(names))
    points = table[:, [names.index(axis) for axis in "xyz"]]
    if "red" not in names:
        return points, None
    return points, table[:, [names.index(name) for name in ("red", "green", "blue")]] / 255


def _answer_with(mistakes: frozenset[str], text: str) -> Any:
    header, _, body = text.partition("\nend_header\n")
    header = "\n".join(line for line in header.splitlines() if not line.startswith("comment"))
    vertex = header.partition("element vertex ")[2].partition("element ")[0].splitlines()
    names = [line.split()[-1] for line in vertex[1:] if line.startswith("property")]
    has_colors = "red" in names
    if "fixed-columns" in mistakes:
        names = ["x", "y", "z", "red", "green", "blue"]
    count = len(body.splitlines()) if "other-elements-read" in mistakes else int(vertex[0])
    first = 1 if "first-point-lost" in mistakes else 0
    rows = [[float(word) for word in line.split()] for line in body.splitlines()[first:count]]
    points = np.reshape([[row[names.index(axis)] for axis in "xyz"] for row in rows], (-1, 3))
    if not has_colors:
        return points, None
    channels = ["red", "green", "blue"]
    if "blue-first" in mistakes:
        channels.reverse()
    colors = [row[names.index(name)] for row in rows for name in channels]
    scale = 1 if "colors-to-255" in mistakes else 255
    return points, np.reshape(colors, (-1, 3)) / scale


def _make_text(
    rng: np.random.Generator,
    names: tuple[str, ...],
    *,
    faces: int = 0,
    count: int | None = None,
    comments: tuple[str, ...] = ("a cloud of the lab",),
    kind: str = "float",
    form: str = ".4f",
    gaps: tuple[str, ...] = (" ",),
) -> str:
    count = int(rng.integers(6, 12)) if count is None else count
    kinds = {name: "uchar" if name in ("red", "green", "blue") else kind for name in names}
    header = ["ply", "format ascii 1.0", *(f"comment {words}" for words in comments)]
    header += [f"element vertex {count}", "comment in meters"]
    header += [f"property {kinds[name]} {name}" for name in names]
    if faces:
        header += [f"element face {faces}", "property list uchar int vertex_indices"]
    rows = []
    for _ in range(count):
        row = ""
        for name in names:
            row += str(rng.choice(gaps)) if row else ""
            color = kinds[name] == "uchar"
            row += str(rng.integers(0, 256)) if color else format(rng.uniform(-2, 2), form)
        rows.append(row)
    # Quads with many corners: as many numbers as a point has, so that reading on does not stop.
    corners = [" ".join(map(str, [7, *rng.integers(0, 6, size=7)])) for _ in range(faces)]
    return "\n".join([*header, "end_header", *rows, *corners]) + "\n"


_COLORED = ("x", "y", "z", "red", "green", "blue")
_SHUFFLED = ("red", "green", "blue", "quality", "z", "x", "y")
_NORMALS = ("x", "y", "z", "nx", "ny", "nz")
_MISLEADING = ("element vertex 3", "property float red", "before end_header")


def _make_odd_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    """Make files that the statement allows, and that are not what one expects."""
    wide = (" ", "  ", "   ", "\t")
    texts = {
        "comments with the words of header lines": _make_text(
            rng, ("x", "y", "z"), comments=_MISLEADING
        ),
        "normals, and numbers of type double with exponents": _make_text(
            rng, _NORMALS, kind="double", form=".5e"
        ),
        "several spaces or tabs between numbers": _make_text(rng, _COLORED, gaps=wide),
        "a single point": _make_text(rng, _COLORED, count=1),
        "no point at all": _make_text(rng, _COLORED, count=0),
    }
    return tuple(Case(label, (text,)) for label, text in texts.items())


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(113)
    return (
        Case("points with colors", (_make_text(rng, _COLORED),)),
        Case("points without colors, then faces", (_make_text(rng, ("x", "y", "z"), faces=4),)),
        Case("properties in another order, then faces", (_make_text(rng, _SHUFFLED, faces=3),)),
        *_make_odd_cases(rng),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    order: list[str] = rng.permutation(_SHUFFLED).tolist()
    while order.index("x") < order.index("y") or order[3] == "red":  # as a guess would have it
        order = rng.permutation(_SHUFFLED).tolist()
    return (
        Case("plain", (_make_text(rng, ("x", "y", "z")),)),
        Case("colors", (_make_text(rng, _COLORED, faces=2),)),
        Case("shuffled", (_make_text(rng, tuple(order), faces=3),)),
        *_make_odd_cases(rng),
    )


def _write_plainly(args: dict[str, Any]) -> dict[str, Any]:
    points, colors = parse_ply(args["text"])
    names = ["float x", "float y", "float z"]
    rows = points
    if colors is not None:
        names += ["uchar red", "uchar green", "uchar blue"]
        rows = np.column_stack([points, np.rint(255 * colors)])
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property {name}" for name in names] + ["end_header"]
    lines += [" ".join(f"{number:g}" for number in row) for row in rows]
    return {"text": "\n".join(lines) + "\n"}


EXERCISE = Exercise(
    name="parse_ply",
    title="read a cloud back from its file",
    chapter="step6",
    place=13,
    points=0,
    section="step6-files",
    objectives=("6d",),
    reference=parse_ply,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "plain",
            "the lines of the header stand in the usual order, without others",
            _write_plainly,
        ),
    ),
    parts=(
        Part("points", "cloud", "float", atol=1e-5, unit="m"),
        Part(
            "colors",
            "attached",
            "float",
            atol=1e-3,
            low=0.0,
            high=1.0,
            nullable=True,
            note="None exactly where the file has no colors",
        ),
    ),
    tolerance_reason=(
        "numbers in the files have few digits, which single precision keeps. Colors: a quarter of "
        "a level of 255"
    ),
    misconceptions=(
        Misconception(
            "fixed-columns",
            "you take it for granted that the columns are x, y, z, red, green, blue. The header "
            "names them in their order: look them up.",
        ),
        Misconception(
            "other-elements-read",
            "you read to the end of the file. After the vertices come other elements: stop after "
            "as many lines as the header says.",
        ),
        Misconception(
            "first-point-lost",
            "the first point is missing. The data begin on the line right after end_header.",
        ),
        Misconception(
            "colors-to-255",
            "the file has colors from 0 to 255. In a cloud they go from 0 to 1: divide by 255.",
        ),
        Misconception(
            "blue-first",
            "red and blue are exchanged. A PLY file says which number is red: no BGR here.",
        ),
    ),
    hints=(
        "str.splitlines and list.index find where the header ends. What does it tell you before?",
        "Collect the names of the vertex properties. names.index('x') is the column of x.",
        "How many lines are points? Which lines come after them, and do you need those?",
    ),
    example="""\
some = np.column_stack([points, 255 * colors])[::19].astype(float).round(3)
lines = ["ply", "format ascii 1.0", f"element vertex {len(some)}"]
lines += [f"property float {one}" for one in "x y z red green blue".split()]
lines += ["end_header", *(" ".join(map(str, row)) for row in some.tolist())]
print(*lines[:11], sep="\\n")
show(parse_ply("\\n".join(lines)))""",
    contract=(
        told("write-then-read", "Write, then read back"),
        asked("read", "Read the text of an ASCII PLY file", "every case"),
        asked("header", "Its header says which numbers", "mistake fixed-columns"),
        told("library", "The library's"),
        asked("points-colors", "Read points and colors", "value"),
        asked("end-header", "The header ends with the line", "mistake first-point-lost"),
        asked(
            "element",
            "the first N lines after the header",
            "mistake first-point-lost",
            "mistake other-elements-read",
            "case a single point",
        ),
        asked("no-point", "N may be 0", "case no point at all"),
        asked(
            "numbers",
            "Numbers may have an exponent",
            "case normals, and numbers",
            "case several spaces",
        ),
        asked(
            "any-order",
            "in any order among other properties",
            "mistake fixed-columns",
            "mistake blue-first",
            "case properties in another order",
        ),
        asked(
            "others",
            "There may be",
            "mistake other-elements-read",
            "case points without colors",
            "case comments with the words",
        ),
        given("text", "The whole file"),
        asked("xyz", "x, y, z.", "value of points"),
        asked("colors", "Red, green, blue from 0 to 1", "mistake colors-to-255", "range of colors"),
    ),
    visible=_visible,
    hidden=_hidden,
)
