"""A picture of disparities, in which NaN says that there is no match: told by share and place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils.checks.kinds.base import round_to_digit
from labutils.checks.kinds.panels import draw_pictures, paint_signs
from labutils.checks.kinds.pictures import Picture

if TYPE_CHECKING:
    from labutils.checks.table import Part
    from labutils.checks.verdict import PanelPicture

#: A place is named where so many of the wrong pixels lie in it, and it is so small a part of all.
_INSIDE, _AREA = 0.75, 0.4


@dataclass(frozen=True, kw_only=True)
class Disparity(Picture):
    """One match per pixel, in pixels; a match may be missing."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell which share is off, where most of that lies, and how it is off."""
        missing = wrong & np.isnan(yours)
        extra = wrong & np.isnan(expected)
        off = wrong & ~missing & ~extra
        texts = [
            f"{_to_share(mask)} {words}"
            for mask, words in ((missing, "missing (NaN)"), (extra, "given where none is due"))
            if mask.any()
        ]
        if off.any():
            texts.append(f"{_to_share(off)} {_describe_sides((yours - expected)[off])}")
        start = f"{_to_share(wrong)} of the pixels of {part.name} are off by more than"
        return f"{start} {part.atol:g} px, {_find_place(expected, wrong)}: {', '.join(texts)}."

    def _find_worst(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> tuple[int, int]:
        """Return (u, v) of the largest difference, of a missing value where there is none."""
        gaps = np.abs(self.get_differences(part, expected, yours))
        known = np.where(np.isfinite(gaps), gaps, 0)
        v, u = np.unravel_index(int(np.argmax(known if known.any() else gaps)), gaps.shape)
        return int(u), int(v)

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        """Draw both, and the difference: blue is too small, red too large, gray missing."""
        if expected.shape != yours.shape or not expected.size:
            return None
        wrong = self.find_wrong(part, expected, yours)
        differences = self.get_differences(part, expected, yours)
        # Of what is missing on one side no difference has a sign.
        signed = np.where(np.isfinite(expected) & np.isfinite(yours), differences, np.nan)
        return draw_pictures(
            part.name,
            self._paint(expected, expected),
            self._paint(yours, expected),
            np.abs(differences),
            wrong,
            difference_bgr=paint_signs(signed, wrong),
        )


def _to_share(mask: np.ndarray) -> str:
    """Write which share of all pixels is marked; a few are never none."""
    percent = 100 * np.count_nonzero(mask) / mask.size
    return "less than 1 %" if percent < 1 else f"{percent:.0f} %"


def _describe_sides(differences: np.ndarray) -> str:
    """Say to which side numbers are off, and by how much typically."""
    larger = np.count_nonzero(differences > 0) / differences.size
    side = "too large" if larger > 0.9 else "too small" if larger < 0.1 else "off to both sides"
    return f"{side}, typically by {round_to_digit(float(np.median(np.abs(differences))))} px"


def _find_place(expected: np.ndarray, wrong: np.ndarray) -> str:
    """Name the place where most wrong pixels lie, if it is a small part of the picture."""
    best, where = 0.0, "all over the picture"
    for words, place in _list_places(expected):
        inside = np.count_nonzero(wrong & place) / np.count_nonzero(wrong)
        area = np.count_nonzero(place) / place.size
        if inside >= _INSIDE and 0 < area <= _AREA and inside / area > best:
            best, where = inside / area, f"most of them {words}"
    return where


def _list_places(expected: np.ndarray) -> list[tuple[str, np.ndarray]]:
    """List the places where matching goes wrong in ways of its own, from the right answer alone."""
    height, width = expected.shape
    rows, columns = np.indices(expected.shape)
    margin = max(1, min(height, width) // 10)
    rim = np.minimum(rows, columns) < margin
    rim |= np.minimum(height - 1 - rows, width - 1 - columns) < margin
    known = np.isfinite(expected)
    middle = np.nanmean([expected[known].min(), expected[known].max()]) if known.any() else 0.0
    filled = np.where(known, expected, middle).astype(np.float32)
    block = np.ones((3, 3), np.uint8)
    jumps = cv2.dilate(filled, block) - cv2.erode(filled, block) > 1
    jumps &= cv2.erode(known.astype(np.uint8), block) > 0
    # As far as windows of the usual size reach.
    beside = cv2.dilate(jumps.astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    return [
        ("in the columns at the left", columns < width // 3),
        ("in the columns at the right", columns >= width - width // 3),
        ("along the edge of the picture", rim),
        ("where something is near", known & (filled > middle)),
        ("where everything is far away", known & (filled < middle)),
        ("beside jumps of the disparity", beside),
    ]


KINDS = (
    Disparity(
        name="disparity",
        ndim=2,
        shape="(H, W), the size of the pictures",
        relations=("numbers", "pictures", "regions"),
    ),
)
