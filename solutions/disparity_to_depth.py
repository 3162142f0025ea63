"""Stereo: from disparities to meters."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, told
from solutions._simpler import Simplification


def _answer_with(
    mistakes: frozenset[str], disparity: np.ndarray, K: np.ndarray, baseline: float
) -> np.ndarray:
    pixels = disparity.astype(np.float64)
    if "nan-lost" in mistakes:
        pixels = np.nan_to_num(pixels, nan=0.0)
    if "negative-depth" not in mistakes:
        pixels = np.where(pixels < 0, np.nan, pixels)
    if "sixteenths" in mistakes:
        pixels = pixels * 16
    if "centimeters" in mistakes:
        baseline = baseline * 100
    focal = K[1, 1] if "other-focal" in mistakes else K[0, 0]
    with np.errstate(all="ignore"):
        depth = focal * baseline / pixels
        if "upside-down" in mistakes:
            depth = pixels / (focal * baseline)
    if "zero-lost" in mistakes:
        depth[pixels == 0] = np.nan
    if "ray-length" in mistakes:
        depth = depth * _get_stretch(K, *depth.shape)
    return depth.astype(np.float32)


def _get_stretch(K: np.ndarray, height: int, width: int) -> np.ndarray:
    """Return how much longer than its depth the way to a point is, per pixel."""
    v, u = np.mgrid[:height, :width]
    x, y = (u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1]
    return np.asarray(np.sqrt(1 + x**2 + y**2))


def _make_case(rng: np.random.Generator, label: str, height: int, width: int) -> Case:
    """Make disparities of a tilted wall and a box, with zeros, negative ones and NaN among them.

    Pixels are wider than high by a third: an angle of view applied to the wrong side makes such a
    mistake.
    """
    focal = round(float(rng.uniform(60, 120)), 2)
    center = np.round(rng.uniform(0.35, 0.6, 2) * [width, height], 2)
    K = np.array([[focal, 0, center[0]], [0, focal * 4 / 3, center[1]], [0, 0, 1]])
    baseline = round(float(rng.uniform(0.05, 0.3)), 4)
    v, u = np.mgrid[:height, :width]
    disparity = rng.uniform(2, 4) + 0.04 * u + 0.03 * v
    top, left = int(rng.integers(1, height // 2)), int(rng.integers(1, width // 2))
    disparity[top : top + height // 3, left : left + width // 3] = rng.uniform(9, 14)
    disparity += rng.uniform(-0.3, 0.3, size=disparity.shape)
    places = rng.choice(disparity.size, size=disparity.size // 8, replace=False)
    disparity.ravel()[places] = np.resize([0.0, np.nan, -1.5, -0.125], len(places))
    return Case(label, (np.round(disparity, 3).astype(np.float32), K, baseline))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(84)
    return (
        _make_case(rng, "a box before a tilted wall", 18, 26),
        _make_case(rng, "another camera, a higher picture", 23, 15),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    sizes = rng.integers(12, 30, size=(3, 2))
    return tuple(_make_case(rng, f"pair {n + 1}", int(h), int(w)) for n, (h, w) in enumerate(sizes))


def _keep_positive(args: dict[str, Any]) -> dict[str, Any]:
    disparity = args["disparity"]
    return {"disparity": np.where(disparity > 0, disparity, np.float32(3.0))}


def _fill_unknown(args: dict[str, Any]) -> dict[str, Any]:
    return {"disparity": np.nan_to_num(args["disparity"], nan=3.0)}


EXERCISE = Exercise(
    name="disparity_to_depth",
    title="turn disparities into meters",
    chapter="stereo",
    place=4,
    points=0,
    section="stereo-error",
    objectives=("8c",),
    reference=labutils.disparity_to_depth,
    answer_with=_answer_with,
    parts=(Part("depth", "depth", "float", atol=1e-3, unit="m"),),
    tolerance_reason=(
        "one millimeter: single precision loses a thousandth of that at these distances; every "
        "mistake is off by centimeters somewhere"
    ),
    misconceptions=(
        Misconception(
            "sixteenths",
            "your depths are 16 times too small, as if the disparities were the int16 numbers of "
            "OpenCV's matchers. They are pixels already.",
        ),
        Misconception(
            "centimeters",
            "your depths are 100 times too large: the baseline stands in centimeters. It comes in "
            "meters; leave it so.",
        ),
        Misconception(
            "other-focal",
            "your depths are too large by one factor: you use the focal length of the rows. "
            "Disparity runs along a row: its pixels are counted with K[0, 0].",
        ),
        Misconception(
            "ray-length",
            "you return the length of the ray, which grows toward the corners. Depth is measured "
            "along the optical axis: f b / d is that already.",
        ),
        Misconception(
            "upside-down",
            "far and near are exchanged: you divide the disparity by f b. The larger the "
            "disparity, the nearer the point.",
        ),
        Misconception(
            "zero-lost",
            "where the disparity is 0 you answer NaN. Both cameras see such a point in the same "
            "column: it is infinitely far away.",
        ),
        Misconception(
            "negative-depth",
            "some depths are negative. No point in front of both cameras has a negative "
            "disparity: answer NaN.",
        ),
        Misconception(
            "nan-lost",
            "pixels without a match come out as infinitely far. NaN says that nothing is known "
            "there: let it stay NaN.",
        ),
    ),
    hints=(
        (
            "A point at depth Z is seen f b / Z columns apart by two cameras b meters apart. "
            "Which of these do you look for?"
        ),
        "Which entry of K counts columns? And what does NumPy give for a number divided by 0?",
        (
            "Make negative disparities NaN first, with np.where. Then divide K[0, 0] times the "
            "baseline by the rest, inside np.errstate(divide='ignore')."
        ),
    ),
    example="""\
from labutils.recordings import load_recording

pair = load_recording("room").pairs[0]
found = lab.ssd_disparity(pair.left, pair.right, max_disparity=96)
measured = disparity_to_depth(found, pair.K, pair.baseline)
show(np.minimum(measured, 5), "meters, 5 and more in one color")""",
    contract=(
        told("same-point", "Both cameras see the same point"),
        asked(
            "meters",
            "Compute its depth in meters",
            "mistake ray-length",
            "mistake upside-down",
            "mistake other-focal",
        ),
        told("columns", "Disparity counts columns"),
        told("three-kinds", "Three kinds of numbers"),
        told("text-says", "The text of the function says"),
        asked("compute", "Compute the depth that a disparity stands for", "value"),
        asked(
            "pixels",
            "Pixels, positive where the right camera",
            "mistake sixteenths",
            "every case",
        ),
        told("intrinsic", "Intrinsic matrix of both cameras"),
        asked("baseline", "Distance between the cameras in meters", "mistake centimeters"),
        asked(
            "special",
            "infinite where the disparity is 0",
            "mistake zero-lost",
            "mistake nan-lost",
            "mistake negative-depth",
        ),
    ),
    asks={
        "disparity": (
            "ndarray, float32, shape (H, W)\n"
            "Pixels, positive where the right camera sees the point farther left."
        ),
        "K": "ndarray, float64, shape (3, 3)\nIntrinsic matrix of both cameras.",
        "Returns": (
            "depth : ndarray, float, shape (H, W)\n"
            "    Meters; infinite where the disparity is 0, NaN where it is NaN or negative."
        ),
        "Raises": "",
    },
    simpler=(
        Simplification("positive", "every disparity is above 0", _keep_positive),
        Simplification("known", "no disparity is NaN", _fill_unknown),
    ),
    absorbed=(
        Absorbed("zero-lost", "nan-lost", "what was NaN becomes 0 first, and then NaN again"),
    ),
    visible=_visible,
    hidden=_hidden,
)
