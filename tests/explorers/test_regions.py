"""The middle of the largest region, found in the browser, is the one that labutils finds."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from labutils import find_object_centroid
from tests.helpers.node import run_node

#: Finds the centroids of masks of one size that lie one behind the other in a file.
CENTROIDS = """
import { readFileSync } from "node:fs";
const [, file, height, width] = process.argv;
const { makeRegionFinder } = await load("_regions");
const { countWords } = await load("_morphology");
const masks = readFileSync(file);
const finder = makeRegionFinder(+width, +height);
const bits = new Uint32Array(countWords(width) * height);
const found = [];
for (let at = 0; at < masks.length; ) {
  bits.fill(0);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (masks[at++]) bits[y * countWords(width) + (x >> 5)] |= 1 << (x & 31);
    }
  }
  finder.load(bits);
  found.push(finder.findCentroid());
}
console.log(JSON.stringify(found));
"""


def compare_centroids(folder: Path, masks: np.ndarray) -> list[tuple[int, int] | None]:
    """Assert that JavaScript and labutils agree on every mask; return what they agree on."""
    file = folder / "masks"
    file.write_bytes(masks.astype(np.uint8).tobytes())
    told = run_node(CENTROIDS, str(file), *map(str, masks.shape[1:]))
    found = [one and tuple(one) for one in json.loads(told)]
    expected = [find_object_centroid(mask) for mask in masks]
    wrong = [place for place, one in enumerate(expected) if found[place] != one]
    assert not wrong, f"{masks[wrong[0]].astype(int)}: {found[wrong[0]]}, {expected[wrong[0]]}"
    return expected


def test_javascript_finds_the_centroid_of_every_mask_of_four_by_four_pixels(tmp_path: Path) -> None:
    bits = (np.arange(2**16)[:, None] >> np.arange(16) & 1).astype(bool)
    found = compare_centroids(tmp_path, bits.reshape(-1, 4, 4))
    assert found.count(None) > 100  # dots and lines
    assert len(set(found)) > 9


@pytest.mark.parametrize("density", [0.2, 0.35, 0.5, 0.65, 0.8])
def test_javascript_finds_the_centroid_in_noise(tmp_path: Path, density: float) -> None:
    rng = np.random.default_rng(int(100 * density))
    compare_centroids(tmp_path, rng.random((400, 13, 35)) < density)
    compare_centroids(tmp_path, rng.random((3, 240, 320)) < density)


def test_javascript_finds_the_centroid_of_shapes_within_shapes(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    masks = np.zeros((300, 90, 110), np.uint8)
    for mask in masks:
        # rings and islands in their holes, and now and then a line: drawn over, and cut out
        for _ in range(int(rng.integers(1, 14))):
            center = tuple(int(one) for one in rng.integers(-5, 110, 2))
            size = tuple(int(one) for one in rng.integers(0, 40, 2))
            ink, thick = int(rng.integers(0, 2)), int(rng.choice([-1, 1, 2, 5]))
            if rng.random() < 0.5:
                cv2.ellipse(mask, center, size, float(rng.uniform(0, 90)), 0, 360, ink, thick)
            else:
                corner = (center[0] + size[0], center[1] + size[1])
                cv2.rectangle(mask, center, corner, ink, thick)
    assert sum(one is not None for one in compare_centroids(tmp_path, masks)) > 250


def test_javascript_takes_the_same_of_equal_regions_as_opencv(tmp_path: Path) -> None:
    masks = np.zeros((60, 24, 40), np.uint8)
    rng = np.random.default_rng(4)
    for mask in masks:
        for row in range(0, 24, 8):
            for column in range(0, 40, 8):
                if rng.random() < 0.5:
                    mask[row : row + 5, column : column + 5] = 1
    places = compare_centroids(tmp_path, masks)
    assert len(set(places)) > 3
