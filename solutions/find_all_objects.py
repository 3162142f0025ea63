"""Challenge of step 4: find every object with its color name, area and box."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from solutions._cases import hsv_to_rgb
from solutions._model import Case, Exercise, Misconception, Part, asked, given

Range = tuple[str, tuple[int, int, int], tuple[int, int, int]]

#: Red wraps, so it is found on both sides of hue 0.
_RANGES: tuple[Range, ...] = (
    ("red", (170, 110, 80), (6, 255, 255)),
    ("yellow", (22, 110, 80), (34, 255, 255)),
    ("green", (50, 110, 80), (72, 255, 255)),
    ("blue", (108, 110, 80), (128, 255, 255)),
)


def find_all_objects(
    rgb_image: np.ndarray, color_ranges: tuple[Range, ...], min_area: int
) -> tuple[list[str], list[int], list[tuple[int, int, int, int]]]:
    """Find all objects of several colors.

    An object is a connected region (eight neighbors) of pixels whose HSV values lie in a range,
    limits included. No object has holes.

    Parameters
    ----------
    rgb_image : ndarray, uint8, (H, W, 3)
        The picture.
    color_ranges : tuple of (name, low, high)
        Name of a color, and its limits (h, s, v) in OpenCV's units. A hue range whose low limit
        is above the high one wraps through red.
    min_area : int
        Regions with fewer pixels are no objects.

    Returns
    -------
    names : list of str, N
        Color name per object, largest object first.
    areas : list of int, N
        Number of pixels, in the same order.
    boxes : list of (left, top, width, height), N
        Smallest upright box around all pixels of the object: its first column and row, and how
        many columns and rows it has.
    """
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        if low[0] <= high[0]:
            mask = cv2.inRange(hsv, low, high)
        else:
            up_to_the_seam = cv2.inRange(hsv, low, (179, *high[1:]))
            mask = cv2.bitwise_or(up_to_the_seam, cv2.inRange(hsv, (0, *low[1:]), high))
        _, _, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
        found += [
            (int(area), name, (int(left), int(top), int(width), int(height)))
            for left, top, width, height, area in stats[1:]
            if area >= min_area
        ]
    found.sort(reverse=True)
    return (
        [name for _, name, _ in found],
        [area for area, _, _ in found],
        [box for _, _, box in found],
    )


def _answer_with(
    mistakes: frozenset[str],
    rgb_image: np.ndarray,
    color_ranges: tuple[Range, ...],
    min_area: int,
) -> Any:
    code = cv2.COLOR_BGR2HSV if "bgr" in mistakes else cv2.COLOR_RGB2HSV
    hsv = cv2.cvtColor(rgb_image, code)
    found = []
    for name, low, high in color_ranges:
        inside = (hsv[..., 1:] >= low[1:]).all(axis=2) & (hsv[..., 1:] <= high[1:]).all(axis=2)
        above, below = hsv[..., 0] >= low[0], hsv[..., 0] <= high[0]
        wraps = low[0] > high[0] and "no-wrap" not in mistakes
        mask = (inside & (above | below if wraps else above & below)).astype(np.uint8)
        count, labels = cv2.connectedComponents(
            mask, connectivity=4 if "four-neighbors" in mistakes else 8
        )
        regions = []
        for label in range(1, count):
            region = (labels == label).astype(np.uint8)
            left, top, width, height = cv2.boundingRect(region)
            area = cv2.countNonZero(region)
            if area < min_area and "specks-kept" not in mistakes:
                continue
            if "outline-area" in mistakes:
                outlines, _ = cv2.findContours(region, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
                area = int(cv2.contourArea(outlines[0]))
            corners = (left, top, left + width, top + height)
            box = corners if "box-corners" in mistakes else (left, top, width, height)
            regions.append((area, name, box))
        regions.sort(reverse=True)
        found += regions[:1] if "one-per-color" in mistakes else regions
    found.sort(reverse="smallest-first" not in mistakes)
    names = [name for _, name, _ in found]
    return names, [area for area, *_ in found], [box for *_, box in found]


def _make_case(rng: np.random.Generator, label: str) -> Case:
    """Make objects of three colors, two of them red, with specks of those and of a fourth color."""
    height, width = int(rng.integers(60, 75)), int(rng.integers(80, 110))
    hsv = np.empty((height, width, 3), dtype=np.uint8)
    hsv[:] = (30, 40, 150)
    places = rng.permutation([(row, column) for row in range(2) for column in range(3)])
    hues = (0, 179, 60, 118, 66)  # red on both sides of the seam
    sides = rng.permutation(np.arange(8, 8 + 3 * len(hues), 3))
    # The first is so pale that only its saturation's own limit lets it in.
    tops = (150, 250, 250, 250, 250)
    colors = [
        (hue, int(rng.integers(115, top)), int(rng.integers(90, 240)))
        for hue, top in zip(hues, tops, strict=True)
    ]
    for color, side, (row, column) in zip(colors, sides, places, strict=False):
        x, y = round((column + 0.5) * width / 3), round((row + 0.5) * height / 2)
        half = (int(side) // 2, int(side) * int(rng.integers(3, 6)) // 10)
        if rng.random() < 0.5:
            half = half[::-1]
        half = (min(half[0], width // 6 - 3), min(half[1], height // 4 - 4))
        if side % 2:
            cv2.ellipse(hsv, (x, y), half, 0, 0, 360, color, -1)
        else:
            top, left = y - half[1], x - half[0]
            hsv[top : y + half[1], left : x + half[0]] = color
            # A tail that touches the corner of the object only.
            hsv[[top - 1, top - 2], [left - 1, left - 2]] = color
    # Specks on the borders of the grid, where no object is; yellow occurs as specks only.
    specks = [colors[0], colors[2], (28, 220, 200), (28, 220, 200)]
    for number, color in enumerate(specks):
        x, y = round((number % 2 + 1) * width / 3), 1 + (number // 2) * (height - 5)
        size = 2 + number % 2
        hsv[y : y + 2, x : x + size] = color
    rgb = hsv_to_rgb(hsv)
    _, areas, _ = find_all_objects(rgb, _RANGES, 12)
    return Case(label, (rgb, _RANGES, min(areas)))  # the smallest has just enough pixels


def _is_clear(case: Case) -> bool:
    """Tell whether the order is certain: no two areas alike, however they are measured."""
    for mistakes in (frozenset(), frozenset({"outline-area"})):
        names, areas, _ = _answer_with(mistakes, *case.args)
        if len(names) != 5 or len(set(areas)) != 5:
            return False
    return True


def _make_clear_case(rng: np.random.Generator, label: str) -> Case:
    while not _is_clear(case := _make_case(rng, label)):
        pass
    return case


def _make_touching(rng: np.random.Generator, label: str) -> Case:
    """Make a red object across the seam, a blue one at its side, and a green one of one color."""
    hsv = np.full((24, 42, 3), (30, 40, 150), dtype=np.uint8)
    bottom = int(rng.integers(11, 15))
    seam, border, right, end = np.cumsum(rng.integers((8, 6, 7, 7), (12, 9, 10, 9))).tolist()
    strong, dark = map(int, rng.integers((150, 130), (250, 240)))
    hsv[3:bottom, 3:seam] = (176, strong, dark)
    hsv[3:bottom, seam:border] = (3, strong, dark)
    hsv[4 : bottom - 1, border:right] = (118, strong, dark)
    hsv[18:22, right:end] = (60, 255, 255)
    rgb = hsv_to_rgb(hsv)
    exact = ("green", (60, 255, 255), (60, 255, 255))
    ranges = tuple(exact if one[0] == "green" else one for one in _RANGES)
    return Case(label, (rgb, ranges, 4 * (end - right)))


def _make_specks(rng: np.random.Generator, label: str) -> Case:
    hsv = np.full((12, 16, 3), (30, 40, 150), dtype=np.uint8)
    for row, hue in zip((2, 5, 9), (179, 62, 118), strict=True):
        left = int(rng.integers(1, 10))
        hsv[row, left : left + 5] = (hue, 200, 200)
    return Case(label, (hsv_to_rgb(hsv), _RANGES, 6))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(106)
    return (
        _make_clear_case(rng, "five objects of three colors, and specks"),
        _make_clear_case(rng, "five other objects"),
        _make_touching(rng, "red on both sides of hue 0 touches blue, green is exactly its limits"),
        _make_specks(rng, "specks only, so there is no object"),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    return (
        *(_make_clear_case(rng, f"scene {number}") for number in range(3)),
        _make_touching(rng, "touching"),
        _make_specks(rng, "no object"),
    )


EXERCISE = Exercise(
    name="find_all_objects",
    title="find every object with color, area and box",
    chapter="step4",
    place=11,
    points=0,
    section="step4-clean",
    objectives=("4b", "4c", "4d"),
    reference=find_all_objects,
    answer_with=_answer_with,
    parts=(
        Part("names", "names", "str"),
        Part("areas", "list", "int", unit="px"),
        Part("boxes", "boxes", "int", unit="px"),
    ),
    tolerance_reason="none: pixels are counted, and every object has a single color",
    misconceptions=(
        Misconception(
            "one-per-color",
            "you keep one object per color. Two things may have the same color: keep every region "
            "that is large enough.",
        ),
        Misconception(
            "no-wrap",
            "nothing red is found. A hue range whose low limit is above the high one goes through "
            "179 and 0: join two ranges.",
            section="step4-red-wrap",
        ),
        Misconception(
            "box-corners",
            "your boxes end with the last corner. Due are width and height: how many columns and "
            "rows.",
        ),
        Misconception(
            "outline-area",
            "cv2.contourArea measures inside the line through the pixel centers. Count the pixels "
            "of the region instead.",
        ),
        Misconception(
            "specks-kept",
            "you keep regions with fewer pixels than min_area. They are noise, not objects.",
        ),
        Misconception(
            "four-neighbors",
            "pixels that touch at a corner only belong to one object. Count eight neighbors, not "
            "four.",
        ),
        Misconception(
            "smallest-first",
            "your order is smallest first. The largest object comes first: sort in reverse.",
        ),
        Misconception(
            "bgr",
            "red and blue are exchanged. The picture is RGB: convert it with cv2.COLOR_RGB2HSV.",
            section="step4-hsv",
        ),
    ),
    hints=(
        "One mask per color, as in segment_by_color. Then take the regions of the mask apart.",
        "cv2.connectedComponentsWithStats counts pixels and measures boxes; row 0 is the ground.",
        "Collect (area, name, box) of all colors in one list. Sorting it puts them in order.",
    ),
    example="""\
ranges = tuple((name, *limits) for name, limits in lab.HSV_RANGES.items())
picture = rgb.copy()
for name, area, box in zip(*find_all_objects(rgb, ranges, 200)):
    print(f"{name:7} {area:5} pixels, box {tuple(map(int, box))}")
    cv2.rectangle(picture, tuple(map(int, box)), (255, 255, 255), 2)
show(picture)""",
    contract=(
        asked("all", "*all* things, of all colors", "mistake one-per-color", "every case"),
        asked("largest-first", "The largest comes first", "mistake smallest-first"),
        asked("noise", "is noise", "mistake specks-kept"),
        asked("find", "Find all objects of several colors", "value of names"),
        asked(
            "region",
            "An object is a connected region",
            "mistake four-neighbors",
            "case red on both sides",
        ),
        given("no-holes", "No object has holes"),
        asked("picture", "The picture.", "mistake bgr"),
        given("limits", "Name of a color, and its limits"),
        asked("wraps", "wraps through red", "mistake no-wrap"),
        asked("fewer", "Regions with fewer pixels", "mistake specks-kept", "case specks only"),
        asked("names", "Color name per object", "value of names"),
        asked(
            "areas", "Number of pixels, in the same order", "mistake outline-area", "value of areas"
        ),
        asked("boxes", "Smallest upright box", "mistake box-corners", "value of boxes"),
    ),
    visible=_visible,
    hidden=_hidden,
    imports=("import cv2", "import numpy as np"),
)
