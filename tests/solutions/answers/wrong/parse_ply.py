"""Wrong answers to parse_ply, as strangers wrote them."""
import io
import re
import numpy as np


def _right(text):
    lines = text.splitlines()
    end = next(i for i, l in enumerate(lines) if l.strip() == "end_header")
    names, n, inside = [], 0, False
    for line in lines[:end]:
        w = line.split()
        if not w or w[0] == "comment":
            continue
        if w[0] == "element":
            inside = w[1] == "vertex"
            if inside:
                n = int(w[2])
        elif w[0] == "property" and inside:
            names.append(w[-1])
    rows = [l.split() for l in lines[end + 1:end + 1 + n]]
    data = np.array(rows, dtype=np.float64).reshape(n, len(names))
    points = data[:, [names.index(k) for k in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(k) for k in ("red", "green", "blue")]] / 255


def _header(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    names, n, inside = [], 0, False
    for line in lines[:end]:
        w = line.split()
        if w[:1] == ["element"]:
            inside = w[1] == "vertex"
            n = int(w[2]) if inside else n
        elif w[:1] == ["property"] and inside:
            names.append(w[-1])
    return names, n, lines[end + 1:]


def w_first_three_columns(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    colors = None
    if "red" in names:
        r = names.index("red")
        colors = data[:, [r, names.index("green"), names.index("blue")]] / 255
    return data[:, :3], colors


def w_colors_in_columns_three_to_five(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    colors = data[:, 3:6] / 255 if "red" in names else None
    return points, colors


def w_six_columns_mean_colors(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if data.shape[1] < 6:
        return points, None
    return points, data[:, -3:] / 255


def w_colors_to_255(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]]


def w_divided_by_largest(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    colors = data[:, [names.index(c) for c in ("red", "green", "blue")]]
    return points, colors / colors.max(initial=1)


def w_divided_by_256(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 256


def w_whole_colors(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    colors = data[:, [names.index(c) for c in ("red", "green", "blue")]].astype(np.uint8)
    return points, (colors // 255).astype(float)


def w_reads_to_the_end(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body if line.strip()], float)
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_all_properties(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    names = [l.split()[-1] for l in lines[:end] if l.startswith("property")]
    n = int([l for l in lines[:end] if l.startswith("element vertex")][0].split()[2])
    data = np.array([l.split() for l in lines[end + 1:end + 1 + n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_count_from_last_element(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    names, n, inside = [], 0, False
    for line in lines[:end]:
        w = line.split()
        if w[0] == "element":
            n = int(w[2])
            inside = w[1] == "vertex"
        elif w[0] == "property" and inside:
            names.append(w[-1])
    data = np.array([l.split() for l in lines[end + 1:end + 1 + n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_fixed_line_of_count(text):
    lines = text.splitlines()
    n = int(lines[2].split()[-1])
    names, _, body = _header(text)
    data = np.array([l.split() for l in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_comment_taken_for_element(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    n = None
    for line in lines[:end]:
        if "element vertex" in line and n is None:
            n = int(line.split("element vertex")[1].split()[0])
    names, _, body = _header(text)
    data = np.array([l.split() for l in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_splits_at_word(text):
    header, body = text.split("end_header", 1)
    names, n, inside = [], 0, False
    for line in header.splitlines():
        w = line.split()
        if w[:1] == ["element"]:
            inside = w[1] == "vertex"
            n = int(w[2]) if inside else n
        elif w[:1] == ["property"] and inside:
            names.append(w[-1])
    rows = body.strip().splitlines()[:n]
    data = np.array([r.split() for r in rows], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_last_letter(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    _, n, body = _header(text)
    column, i, inside = {}, 0, False
    for line in lines[:end]:
        if line.startswith("element"):
            inside = line.startswith("element vertex")
        elif line.startswith("property") and inside:
            for key in ("x", "y", "z", "red", "green", "blue"):
                if line.endswith(key):
                    column[key] = i
            i += 1
    data = np.array([l.split() for l in body[:n]], float).reshape(n, i)
    points = data[:, [column[c] for c in "xyz"]]
    if "red" not in column:
        return points, None
    return points, data[:, [column[c] for c in ("red", "green", "blue")]] / 255


def w_floats_only(text):
    lines = text.splitlines()
    end = lines.index("end_header")
    names = []
    n = 0
    for line in lines[:end]:
        if line.startswith("element vertex"):
            n = int(line.split()[2])
        elif line.startswith("property float") or line.startswith("property uchar"):
            names.append(line.split()[2])
    data = np.array([l.split()[:len(names)] for l in lines[end + 1:end + 1 + n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_file_order_of_colors(text):
    names, n, body = _header(text)
    data = np.array([l.split() for l in body[:n]], float).reshape(n, len(names))
    points = data[:, [i for i, k in enumerate(names) if k in ("x", "y", "z")]]
    which = [i for i, k in enumerate(names) if k in ("red", "green", "blue")]
    return points, data[:, which] / 255 if which else None


def w_zeros_for_none(text):
    names, n, body = _header(text)
    data = np.array([l.split() for l in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    colors = np.zeros((n, 3))
    if "red" in names:
        colors = data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255
    return points, colors


def w_needs_colors(text):
    names, n, body = _header(text)
    data = np.array([l.split() for l in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    colors = data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255
    return points, colors


def w_float32(text):
    names, n, body = _header(text)
    data = np.array([l.split() for l in body[:n]], np.float32).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_loadtxt_one_row(text):
    names, n, body = _header(text)
    data = np.loadtxt(io.StringIO("\n".join(body[:n])))
    points = data[..., [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[..., [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_empty_shape(text):
    names, n, body = _header(text)
    points, colors = [], []
    for line in body[:n]:
        row = dict(zip(names, map(float, line.split())))
        points.append([row["x"], row["y"], row["z"]])
        if "red" in row:
            colors.append([row["red"], row["green"], row["blue"]])
    return np.array(points, float), np.array(colors, float) / 255 if colors else None


def w_number_pattern(text):
    names, n, body = _header(text)
    rows = [re.findall(r"-?\d+\.\d+|-?\d+", line) for line in body[:n]]
    data = np.array([r[:len(names)] for r in rows], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_single_spaces(text):
    names, n, body = _header(text)
    data = np.array([line.split(" ") for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_file_name(text):
    with open(text) as f:
        text = f.read()
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_one_line_late(text):
    lines = text.splitlines()
    names, n, body = _header(text)
    start = lines.index("end_header") + 2
    data = np.array([line.split() for line in lines[start:start + n]][:n], float)
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_red_anywhere(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in text:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


def w_bgr(text):
    names, n, body = _header(text)
    data = np.array([line.split() for line in body[:n]], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("blue", "green", "red")]] / 255


def w_fixed_header_length(text):
    lines = text.splitlines()
    names, n, _ = _header(text)
    rows = lines[10:10 + n]  # ply, format, element, 6 properties, end_header
    data = np.array([line.split() for line in rows], float).reshape(n, len(names))
    points = data[:, [names.index(c) for c in "xyz"]]
    if "red" not in names:
        return points, None
    return points, data[:, [names.index(c) for c in ("red", "green", "blue")]] / 255


WRONG = [
    (w_first_three_columns, "takes the first three columns for x, y, z; other properties or another order before them"),
    (w_colors_in_columns_three_to_five, "takes columns 3 to 5 for the colors; normals before the colors, another order"),
    (w_six_columns_mean_colors, "takes the last three of six or more columns for colors; normals without colors, alpha after the colors"),
    (w_colors_to_255, "colors not divided by 255; files with colors"),
    (w_divided_by_largest, "divided by the largest color instead of 255; files without a 255"),
    (w_divided_by_256, "divided by 256; files with colors"),
    (w_whole_colors, "integer division: only 0 and 1; files with colors"),
    (w_reads_to_the_end, "reads all lines after the header; files with faces after the vertices"),
    (w_all_properties, "counts the properties of all elements; files with faces"),
    (w_count_from_last_element, "takes the count of the last element; files with faces"),
    (w_fixed_line_of_count, "takes the third line for the count; a comment before it"),
    (w_comment_taken_for_element, "finds `element vertex` in a comment; such a comment before the real line"),
    (w_splits_at_word, "splits at the first `end_header`, also in a comment; such a comment"),
    (w_last_letter, "endswith('x') also matches nx; normals after the position"),
    (w_floats_only, "knows only float and uchar; properties of type double or int"),
    (w_file_order_of_colors, "columns in the file's order, not x, y, z and red, green, blue; another order in the file"),
    (w_zeros_for_none, "zeros instead of None; files without colors"),
    (w_needs_colors, "ValueError without colors; files without colors"),
    (w_float32, "float32; every file"),
    (w_loadtxt_one_row, "loadtxt makes a flat array of one line; N = 1"),
    (w_empty_shape, "shape (0,) and None for colors where no point is; N = 0"),
    (w_number_pattern, "pattern for numbers misses exponents; 1e-3"),
    (w_single_spaces, "split(' ') makes empty words; two spaces, trailing space or tab"),
    (w_file_name, "takes the text for a file name; every file"),
    (w_one_line_late, "starts one line late; every file"),
    (w_red_anywhere, "looks for red in the whole text; a comment with the word in a file without colors"),
    (w_bgr, "blue, green, red; files with colors"),
    (w_fixed_header_length, "header of ten lines; any other header"),
]

_PLAIN = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
end_header
0.1 -0.2 1.5 255 0 10
1 2 3 20 30 40
0 0 0.25 100 200 50
"""
_MESH = """ply
format ascii 1.0
comment element vertex 9, says the old end_header
comment made by hand
element vertex 4
property double nx
property double z
property float confidence
property double y
property double x
property uchar blue
property uchar red
property uchar green
property uchar alpha
element face 2
property list uchar int vertex_indices
end_header
0.5 1 0.9 2 3 10 20 30 255
0.5 1.25 0.9 2.5 1e-3 11 21 31 0
0.5 -1 0.9 -2 -3 12 22 32 1
0.5 4 0.9 5 6 13 23 33 128
3 0 1 2
3 1 2 3
"""
_NORMALS = """ply
format ascii 1.0
comment no red, only points
element vertex 2
property float x
property float y
property float z
property float nx
property float ny
property float nz
end_header
1 2 3 0 0 1
4  5 6 0 1 0
"""
_ONE = """ply
format ascii 1.0
element vertex 1
property float x
property float y
property float z
end_header
1.5 2.5 3.5
"""
_NONE = """ply
format ascii 1.0
element vertex 0
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
end_header
"""
_DARK = """ply
format ascii 1.0
element vertex 2
property double x
property double y
property double z
property int red
property int green
property int blue
property float nx
property float ny
property float nz
end_header
1 2 3 10 20 30 0.1 0.2 0.3
4 5 6 40 50 60 0.4 0.5 0.6
"""


def _cases():
    return [lambda t=t: (t,) for t in (_PLAIN, _MESH, _NORMALS, _ONE, _NONE, _DARK)]
