"""Kinds of pictures: color, color-mapped, depth and mask, told by how many pixels are off."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import cv2
import numpy as np

from labutils.checks.kinds.base import Kind, get_largest_gap, round_to_digit
from labutils.checks.kinds.color_levels import BLACK_LEVEL, to_levels
from labutils.checks.kinds.learned_map import read_with_learned_map
from labutils.checks.kinds.panels import draw_pictures, paint_values

if TYPE_CHECKING:
    from labutils.checks.table import Part
    from labutils.checks.verdict import PanelPicture


@dataclass(frozen=True, kw_only=True)
class Picture(Kind):
    """One value per pixel, or three; drawn as numbers in colors."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell how many pixels are off, then how."""
        off = wrong.any(axis=2) if wrong.ndim == 3 else wrong
        count = int(np.count_nonzero(off))
        difference = self.get_differences(part, expected, yours)[wrong]
        texts = self._describe_differences(part, difference, count)
        start = f"{count} of {off.size} pixels of {part.name} are off"
        return f"{start}{': ' if texts else ''}{'; '.join(texts)}."

    def _describe_differences(self, part: Part, difference: np.ndarray, count: int) -> list[str]:
        """Tell to which side the wrong values are off, and by how much typically."""
        del count
        finite = difference[np.isfinite(difference)]
        lost = np.count_nonzero(~np.isfinite(difference))
        texts = [f"{lost} of them are NaN or infinite on one side only"] if lost else []
        if len(finite) > 1:
            share = np.count_nonzero(finite > 0) / len(finite)
            side = "too large" if share > 0.9 else "too small" if share < 0.1 else "to both sides"
            unit = f" {part.unit}" if part.unit else ""
            typical = round_to_digit(np.median(np.abs(finite)), get_largest_gap(part))
            texts.append(f"{side}, typically by {typical}{unit}")
        return texts

    def describe_worst(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> str:
        """Name the worst pixel; where a pixel is just wrong, none is the worst."""
        if not self.has_sizes or expected.shape != yours.shape:
            return ""
        return f"Worst pixel: (u, v) = {self._find_worst(part, expected, yours)}."

    def _find_worst(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> tuple[int, int]:
        """Return (u, v) of the pixel that is off most."""
        gaps = np.abs(self.get_differences(part, expected, yours))
        if gaps.ndim == 3:
            gaps = gaps.max(axis=2)
        v, u = np.unravel_index(int(np.argmax(gaps)), gaps.shape)
        return int(u), int(v)

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        """Draw the three panels where both pictures have one size."""
        if expected.shape != yours.shape or not expected.size:
            return None
        return draw_pictures(
            part.name,
            self._paint(expected, expected),
            self._paint(yours, expected),
            np.abs(self.get_differences(part, expected, yours)),
            self.find_wrong(part, expected, yours),
        )

    def _paint(self, image: np.ndarray, expected: np.ndarray) -> np.ndarray:
        """Draw one answer as BGR; both panels use the same colors for the same numbers."""
        finite = expected[np.isfinite(expected)]
        low, high = (finite.min(), finite.max()) if finite.size else (0.0, 1.0)
        return paint_values(image, float(low), float(high))


@dataclass(frozen=True, kw_only=True)
class ColorPicture(Picture):
    """A picture of red, green and blue."""

    def _paint(self, image: np.ndarray, expected: np.ndarray) -> np.ndarray:
        del expected
        return cv2.cvtColor(image.astype(np.uint8), cv2.COLOR_RGB2BGR)


def _has_same_levels(due: np.ndarray, yours: np.ndarray) -> bool:
    """Tell whether a listed map reads a picture to the levels that are due."""
    levels, read = to_levels(due), to_levels(yours)
    return levels.shape == read.shape and bool((np.abs(levels - read) <= 1).all())


@dataclass(frozen=True, kw_only=True)
class MappedPicture(Picture):
    """Numbers in the colors of a map, BGR; compared as the numbers, whichever map was used."""

    is_elementwise: ClassVar[bool] = False

    def to_canonical(self, value: np.ndarray) -> np.ndarray:
        """Read the picture back."""
        return to_levels(value)

    def unify(self, dues: list[np.ndarray], yours: list[np.ndarray]) -> list[np.ndarray]:
        """Draw pictures of an unlisted map from blue to red in a listed one.

        The colors of an unlisted map may all lie on a listed one, such as a ramp through the pure
        colors on COLORMAP_JET. So the listed maps only win where they read the right levels.
        """
        if all(map(_has_same_levels, dues, yours)):
            return yours
        return read_with_learned_map(dues, yours) or yours

    def name_value(self, value: float) -> str:
        """Name black, which is on no map."""
        return "black" if value == BLACK_LEVEL else super().name_value(value)

    def get_differences(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
        """Return the differences of the levels; infinite where there are no two to compare.

        That is for colors of no known map, and where one of the two pictures is black: black is no
        level.
        """
        expected, yours = to_levels(expected), to_levels(yours)
        if expected.shape != yours.shape:
            return np.full(yours.shape[:2], np.inf)
        differences = super().get_differences(part, expected, yours).astype(np.float64)
        differences[(expected == BLACK_LEVEL) & (yours != BLACK_LEVEL)] = np.inf
        differences[(expected != BLACK_LEVEL) & (yours == BLACK_LEVEL)] = -np.inf
        return differences

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Say which maps are known where yours is none of them."""
        if to_levels(yours).ndim == 3:
            return (
                f"{part.name}: its colors do not follow the depth along one map that leads from "
                "blue (close) to red (far), the same in all cases."
            )
        return super().describe(part, expected, yours, wrong)

    def _describe_differences(self, part: Part, difference: np.ndarray, count: int) -> list[str]:
        """Tell black pixels apart from wrong levels."""
        colored, black = (np.count_nonzero(difference == end) for end in (np.inf, -np.inf))
        texts = [f"{colored} of them should be black"] if colored else []
        texts += [f"{black} of them should not be black"] if black else []
        levels = difference[np.isfinite(difference)]
        return texts + super()._describe_differences(part, levels, count)

    def _paint(self, image: np.ndarray, expected: np.ndarray) -> np.ndarray:
        del expected
        return image.astype(np.uint8)

    def make_shifted(self, part: Part, value: np.ndarray, amount: float) -> np.ndarray:
        """Return the picture of the levels moved, in COLORMAP_TURBO."""
        del part
        levels = to_levels(value).astype(int)
        black = levels == BLACK_LEVEL
        moved = np.where(levels < 128, levels + round(amount), levels - round(amount))
        picture = cv2.applyColorMap(np.where(black, 0, moved).astype(np.uint8), cv2.COLORMAP_TURBO)
        picture[black] = 0
        return picture


@dataclass(frozen=True, kw_only=True)
class Mask(Picture):
    """A pixel is marked or not: there is no size to it."""

    has_sizes: ClassVar[bool] = False

    def _describe_differences(self, part: Part, difference: np.ndarray, count: int) -> list[str]:
        del part
        extra = np.count_nonzero(difference > 0)
        return [f"{extra} marked that should not be, {count - extra} missing"]

    def _paint(self, image: np.ndarray, expected: np.ndarray) -> np.ndarray:
        del expected
        marked = np.where(image > 0, 255, 0).astype(np.uint8)
        return cv2.cvtColor(marked, cv2.COLOR_GRAY2BGR)


KINDS = (
    ColorPicture(
        name="rgb",
        ndim=3,
        shape="(H, W, 3), the size of the picture",
        relations=("numbers", "pictures", "colors", "regions"),
    ),
    MappedPicture(
        name="mapped",
        ndim=3,
        shape="(H, W, 3), the size of the depth image",
        relations=("numbers", "pictures", "regions"),
    ),
    Picture(
        name="depth",
        ndim=2,
        shape="(H, W), the size of the picture",
        relations=("numbers", "pictures", "regions"),
    ),
    Mask(
        name="mask",
        ndim=2,
        shape="(H, W), the size of the picture",
        relations=("pictures", "masks", "regions"),
    ),
)
