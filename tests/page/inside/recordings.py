"""The recorded clip, read in the page: the same pictures, the same noise, the same matches."""

from __future__ import annotations

import hashlib
from typing import Any

from labutils.recordings import load_recording
from labutils.stereo_matching import ssd_disparity


def describe_pairs() -> dict[str, Any]:
    """Return a checksum of every picture; run here and in the page, to be compared."""
    recording = load_recording("room", seed=3)
    found: dict[str, Any] = {"labels": recording.label_names}
    for pair in (*recording.pairs, *recording.baseline_pairs):
        name = f"{pair.view}, {pair.baseline} m"
        pictures = (pair.left, pair.right, pair.depth, pair.depth_right, pair.labels)
        found[name] = [hashlib.sha256(one.tobytes()).hexdigest() for one in pictures]
    return found


def sum_matches() -> list[float]:
    """Return how many disparities were found in a strip, and their sum."""
    pair = load_recording("room").pairs[0]
    found = ssd_disparity(pair.left[200:260], pair.right[200:260], 96, padded=True)
    return [float(found.size), float(found.sum(dtype="float64"))]
