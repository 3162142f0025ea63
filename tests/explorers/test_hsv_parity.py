"""The HSV explorer computes in the browser what OpenCV and labutils compute."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from labutils import (
    HSV_RANGES,
    find_object_centroid,
    segment_by_color,
)
from labutils.explorers import explore_hsv
from labutils.explorers.hsv import FULL_RANGE, MAX_RADIUS
from tests.helpers.node import evaluate, run_node

#: Odd sizes, single rows and columns, and all ways a row can end within a word of 32 pixels.
SIZES = ((1, 1), (1, 40), (45, 1), (7, 31), (9, 32), (5, 33), (20, 64), (37, 100))
#: All there is: hue, saturation and value may be anything.
NOTHING_OUT = [list(limit) for limit in FULL_RANGE]


#: Segments pictures that lie one behind the other in a file; writes the masks in the same way.
SEGMENT = """
import { readFileSync, writeFileSync } from "node:fs";
const [, casesFile, picturesFile, masksFile] = process.argv;
const { makeSegmenter } = await load("_segment");
const pictures = readFileSync(picturesFile);
const masks = [];
const told = [];
let at = 0;
for (const one of JSON.parse(readFileSync(casesFile))) {
  const { width, height, limits, open, close, pixel, truth } = one;
  const data = pictures.subarray(at, (at += width * height * 3));
  const segmenter = makeSegmenter({ width, height, channels: 3, data });
  segmenter.segment([[3, 3, 3], [90, 90, 90]], 1, 1); // what a frame before leaves must not show
  const values = segmenter.segment(limits, open, close);
  const iou = truth && segmenter.findIou(Uint32Array.from(truth), values.count);
  told.push({ ...values, iou, ...segmenter.describePixel(pixel, limits) });
  const mask = segmenter.mask.map((cell) => (cell ? 255 : 0));
  for (let y = 1; y <= height; y++) {
    const row = y * (width + 2) + 1; // the mask has a rim
    masks.push(mask.subarray(row, row + width));
  }
}
writeFileSync(masksFile, Buffer.concat(masks));
console.log(JSON.stringify(told));
"""


def segment_in_node(
    folder: Path, cases: list[tuple[np.ndarray, dict[str, Any]]]
) -> list[tuple[np.ndarray, dict[str, Any]]]:
    """Give pictures and settings to the JavaScript; return masks and values."""
    plain = {"limits": NOTHING_OUT, "open": 0, "close": 0, "pixel": [], "truth": None}
    settings = [
        {**plain, **more, "height": rgb.shape[0], "width": rgb.shape[1]} for rgb, more in cases
    ]
    files = folder / "cases.json", folder / "pictures", folder / "masks"
    files[0].write_text(json.dumps(settings))
    files[1].write_bytes(b"".join(rgb.tobytes() for rgb, _ in cases))
    told = json.loads(run_node(SEGMENT, *map(str, files)))
    flat = np.frombuffer(files[2].read_bytes(), np.uint8)
    ends = np.cumsum([rgb.shape[0] * rgb.shape[1] for rgb, _ in cases])
    masks = np.split(flat, ends[:-1])
    return [
        (mask.reshape(rgb.shape[:2]), values)
        for mask, values, (rgb, _) in zip(masks, told, cases, strict=True)
    ]


def paint(mask: np.ndarray) -> np.ndarray:
    """Make a picture that is white where the mask is, else black."""
    return np.repeat(mask.astype(np.uint8)[..., None] * 255, 3, axis=2)


#: Selects the white pixels.
WHITE = [[0, 0, 255], [179, 255, 255]]


def test_javascript_converts_all_colors_as_opencv_does() -> None:
    code = """
    const { createHash } = await import("node:crypto");
    const { rgbToHsv } = await load("_color");
    const rgb = new Uint8Array(65536 * 3);
    const hashes = [];
    for (let red = 0; red < 256; red++) {
      for (let i = 0; i < 65536; i++) rgb.set([red, i >> 8, i & 255], 3 * i);
      const { h, s, v } = rgbToHsv(rgb, 65536);
      hashes.push(createHash("sha256").update(h).update(s).update(v).digest("hex"));
    }
    console.log(JSON.stringify(hashes));
    """
    expected = []
    green_blue = np.arange(65536)
    for red in range(256):
        colors = [np.full(65536, red), green_blue >> 8, green_blue & 255]
        hsv = cv2.cvtColor(np.stack(colors, axis=1)[None].astype(np.uint8), cv2.COLOR_RGB2HSV)
        expected.append(hashlib.sha256(hsv[0].T.tobytes()).hexdigest())
    assert json.loads(run_node(code)) == expected


def test_javascript_reads_pictures_with_transparency_too() -> None:
    rgba = [200, 20, 20, 255, 20, 20, 30, 255]
    planes = evaluate("_color", "m.rgbToHsv(rgba, 2, 4)", rgba=rgba)
    # a typed array becomes an object in JSON
    assert [list(planes[name].values()) for name in "hsv"] == [[0, 120], [229, 85], [200, 30]]


def test_javascript_keeps_colors_within_limits_as_opencv_does(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    noise = rng.integers(0, 256, (60, 70, 3), np.uint8)
    ranges = [((h0, 40, 30), (h1, 220, 240)) for h0, h1 in ((0, 179), (20, 20), (90, 179), (0, 60))]
    wrapped = [((h0, 40, 30), (h1, 220, 240)) for h0, h1 in ((170, 6), (6, 5), (179, 0), (100, 99))]
    found = segment_in_node(tmp_path, [(noise, {"limits": limits}) for limits in ranges + wrapped])
    hsv = cv2.cvtColor(noise, cv2.COLOR_RGB2HSV)
    expected: np.ndarray
    for (mask, _), (low, high) in zip(found, ranges + wrapped, strict=True):
        if low[0] <= high[0]:
            expected = cv2.inRange(hsv, low, high)
        else:
            upper: np.ndarray = cv2.inRange(hsv, low, (179, *high[1:]))
            expected = upper | cv2.inRange(hsv, (0, *low[1:]), high)
        assert expected.any()
        np.testing.assert_array_equal(mask, expected)


def test_javascript_opens_and_closes_as_opencv_does(tmp_path: Path) -> None:
    rng = np.random.default_rng(2)
    cases = []
    for height, width in SIZES:
        for radius in range(MAX_RADIUS + 1):
            for density in (0.02, 0.5, 0.98):
                mask = rng.random((height, width)) < density
                other = int(rng.integers(0, MAX_RADIUS + 1))
                cases += [
                    (mask, {"open": radius}),
                    (mask, {"close": radius}),
                    (mask, {"open": radius, "close": other}),
                    (mask, {"open": other, "close": radius}),
                ]
    blocks = cv2.resize(rng.integers(0, 2, (12, 17), np.uint8), (170, 96), interpolation=0) > 0
    for radius in range(1, MAX_RADIUS + 1):
        cases += [(blocks, {"open": radius}), (blocks, {"open": radius, "close": radius})]
        cases += [(~blocks, {"open": radius - 1, "close": radius}), (blocks, {"close": radius})]
    settings = [(paint(mask), {**more, "limits": WHITE}) for mask, more in cases]
    changed = 0
    for (mask, more), (found, values) in zip(
        cases, segment_in_node(tmp_path, settings), strict=True
    ):
        expected: np.ndarray = mask.astype(np.uint8) * 255
        for name, operation in (("open", cv2.MORPH_OPEN), ("close", cv2.MORPH_CLOSE)):
            size = 2 * more.get(name, 0) + 1
            expected = cv2.morphologyEx(expected, operation, np.ones((size, size), np.uint8))
        np.testing.assert_array_equal(found, expected, err_msg=f"{mask.shape} {more}")
        assert values["count"] == np.count_nonzero(expected)
        assert (values["centroid"] and tuple(values["centroid"])) == find_object_centroid(expected)
        changed += (expected != mask * 255).any()
    assert changed > len(cases) / 3  # the cases are no trivial ones


def test_javascript_tells_the_values_that_python_computes(rgb: np.ndarray, tmp_path: Path) -> None:
    truth = segment_by_color(rgb, HSV_RANGES["red"]) > 0
    places = np.flatnonzero(truth).tolist()
    settings: list[dict[str, Any]] = []
    for place, hsv_range in enumerate(HSV_RANGES.values()):
        for radius in (0, 2, 6):
            pixel = [(97 * (place + 1) + 31 * radius) % 640, (151 * place + 300) % 480]
            limits = [list(limit) for limit in hsv_range]
            radii = {"open": radius, "close": 6 - radius}
            settings.append({"limits": limits, **radii, "pixel": pixel, "truth": places})
    settings.append({"limits": NOTHING_OUT, "open": 6, "close": 6, "pixel": [], "truth": places})
    explorer = explore_hsv(rgb, truth=truth)
    for (mask, told), one in zip(
        segment_in_node(tmp_path, [(rgb, one) for one in settings]), settings, strict=True
    ):
        low, high = one["limits"]
        explorer.move(
            hue_from=low[0],
            hue_to=high[0],
            saturation_limits=[low[1], high[1]],
            value_limits=[low[2], high[2]],
            open_radius=one["open"],
            close_radius=one["close"],
            pixel=one["pixel"],
        )
        np.testing.assert_array_equal(mask, explorer.mask)
        assert told == explorer.values


def test_javascript_tells_what_opening_removes_and_closing_fills(tmp_path: Path) -> None:
    mask = np.zeros((12, 24), np.uint8)
    mask[4, 3] = 1  # a speck
    mask[2:9, 10:18] = 1
    mask[5, 14] = 0  # a hole
    white = {"limits": WHITE, "open": 1, "close": 1}
    picture = paint(mask)
    explorer = explore_hsv(picture, WHITE, 1, 1)  # type: ignore[arg-type]  # lists do as well
    told = segment_in_node(tmp_path, [(picture, {**white, "pixel": p}) for p in ([3, 4], [14, 5])])
    for (_, values), pixel in zip(told, ([3, 4], [14, 5]), strict=True):
        explorer.move(pixel=pixel)
        assert values == explorer.values
    assert [told[0][1][key] for key in ("pixel_inside", "pixel_selected")] == [True, False]
    assert [told[1][1][key] for key in ("pixel_inside", "pixel_selected")] == [False, True]
