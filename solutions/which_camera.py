"""Challenge of step 2: which of several cameras took the picture."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification


def which_camera(
    points: np.ndarray, pixels: np.ndarray, fovs: np.ndarray, width: int, height: int
) -> tuple[int, float]:
    """Tell from known points which camera took a picture.

    Parameters
    ----------
    points : ndarray, float64, (N, 3)
        Points in the camera frame (x right, y down, z forward), meters, all in front.
    pixels : ndarray, float64, (N, 2)
        Where the points were found in the picture, (u, v), with a little noise.
    fovs : ndarray, float64, (C,)
        Vertical fields of view of the C cameras in question, radians; pixels are square and the
        principal point is the middle of the picture.
    width, height : int
        Size of the picture, pixels.

    Returns
    -------
    camera : int
        Number of the camera that explains the pixels best, counted from 0.
    error_px : float
        For that camera, the mean distance between projected and found pixels.
    """
    center = np.array([(width - 1) / 2, (height - 1) / 2])
    slopes = points[:, :2] / points[:, 2:]
    focals_px = height / (2 * np.tan(np.asarray(fovs) / 2))
    errors = [np.linalg.norm(f * slopes + center - pixels, axis=1).mean() for f in focals_px]
    return int(np.argmin(errors)), float(min(errors))


def _answer_with(
    mistakes: frozenset[str],
    points: np.ndarray,
    pixels: np.ndarray,
    fovs: np.ndarray,
    width: int,
    height: int,
) -> Any:
    corner = 0 if "half-pixel" in mistakes else 1
    center = np.array([(width - corner) / 2, (height - corner) / 2])
    slopes = points[:, :2] / points[:, 2:]
    angles = np.radians(fovs) if "radians-again" in mistakes else np.asarray(fovs)
    half = angles if "whole-angle" in mistakes else angles / 2
    side = width if "width-for-height" in mistakes else height
    errors = []
    for focal_px in side / (2 * np.tan(half)):
        projected = focal_px * slopes + center
        if "row-column" in mistakes:
            projected = projected[:, ::-1]
        gaps = projected - pixels
        error = np.linalg.norm(gaps, axis=1).mean()
        if "errors-cancel" in mistakes:
            error = np.linalg.norm(gaps.mean(axis=0))
        errors.append(error)
    return int(np.argmin(errors)), float(min(errors))


def _make_case(rng: np.random.Generator, label: str, count: int) -> Case:
    # 6 degrees apart at least, in no order: the first or the widest is no better guess.
    fovs = rng.permutation(np.arange(40, 88, 8))[:count] + rng.uniform(-1, 1, count)
    return _take_picture(rng, label, np.radians(fovs), int(rng.integers(count)))


def _make_alike(rng: np.random.Generator, label: str) -> Case:
    """Make two cameras of which the first is off by 1 to 4 pixels, the second by the noise."""
    first = rng.uniform(50, 70)
    second = first + rng.uniform(1.5, 2.5) * rng.choice([-1, 1])
    return _take_picture(rng, label, np.radians([first, second]), 1)


def _take_picture(rng: np.random.Generator, label: str, fovs: np.ndarray, camera: int) -> Case:
    height, width = int(rng.integers(90, 140)), int(rng.integers(160, 240))
    focal_px = height / (2 * np.tan(fovs[camera] / 2))
    center = np.array([(width - 1) / 2, (height - 1) / 2])
    found = rng.uniform([0, 0], [width - 1, height - 1], size=(9, 2))
    z = rng.uniform(0.8, 2.5, size=(9, 1))
    points = np.hstack([(found - center) / focal_px * z, z])
    noisy = found + rng.uniform(-0.4, 0.4, size=found.shape)
    return Case(label, (np.round(points, 4), np.round(noisy, 2), np.round(fovs, 4), width, height))


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(104)
    return (
        _make_case(rng, "two cameras", 2),
        _make_case(rng, "two cameras, another picture", 2),
        _make_case(rng, "five cameras", 5),
        _make_alike(rng, "two cameras with nearly the same field of view"),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    cases = tuple(_make_case(rng, f"{count} cameras", count) for count in (2, 3, 4, 6))
    return (*cases, _make_alike(rng, "two that are nearly alike"))


def _find_exactly(args: dict[str, Any]) -> dict[str, Any]:
    camera, _ = which_camera(**args)
    f = args["height"] / 2 / np.tan(args["fovs"][camera] / 2)
    middle = (np.array([args["width"], args["height"]]) - 1) / 2
    points = args["points"]
    return {"pixels": f * points[:, :2] / points[:, 2:] + middle}


EXERCISE = Exercise(
    name="which_camera",
    title="tell which camera took the picture",
    chapter="step2",
    place=11,
    points=0,
    section="step2-focal",
    objectives=("2a", "2b", "2e"),
    reference=which_camera,
    answer_with=_answer_with,
    simpler=(
        Simplification("no-noise", "the pixels are found without noise", _find_exactly),
        Simplification(
            "sorted", "the fields of view are sorted", lambda a: {"fovs": np.sort(a["fovs"])}
        ),
    ),
    parts=(
        Part("camera", "choice", "int"),
        Part("error_px", "number", "float", atol=5e-3, unit="px"),
    ),
    tolerance_reason=(
        "a hundredth of the half pixel that separates the two conventions; single precision stays "
        "below a thousandth of a pixel"
    ),
    misconceptions=(
        Misconception(
            "half-pixel",
            "your principal point is half a pixel off. Pixel centers are whole numbers, so the "
            "middle is at (W - 1) / 2 and (H - 1) / 2.",
            section="step2-center",
        ),
        Misconception(
            "radians-again",
            "the fields of view are in radians already. Do not convert them once more.",
        ),
        Misconception(
            "whole-angle",
            "the right triangle has half the field of view and half the height: take the tangent "
            "of fov / 2.",
        ),
        Misconception(
            "width-for-height",
            "the fields of view are vertical: they belong to the height of the picture, not to "
            "its width.",
        ),
        Misconception(
            "row-column",
            "your pixels are (row, column). Here they are (u, v): the column comes first, and u "
            "belongs to x.",
        ),
        Misconception(
            "errors-cancel",
            "you average signed errors: left and right cancel. Take the distance of every point "
            "first, then the mean.",
        ),
    ),
    hints=(
        "With a camera matrix, a point gives a pixel. Which camera puts them where they were seen?",
        "The focal length is height / (2 tan(fov_y / 2)). Where is the principal point?",
        "np.argmin tells which of several errors is smallest. One error per camera, as a distance.",
    ),
    example="""\
u, v = np.array([[60, 90], [520, 140], [330, 300], [110, 400]]).T
points = lab.pixels_to_points(np.column_stack([u, v]), depth[v, u], K)
pixels = np.column_stack([u + 0.3, v - 0.4])  # found half a pixel off
fovs = np.radians([30, 45, 60])
camera, error_px = which_camera(points, pixels, fovs, 640, 480)
print(f"Camera {camera} of {len(fovs)}, which is {error_px:.2f} px off.")""",
    contract=(
        told("mixed-up", "Somebody mixed up the files"),
        given("known", "You know a few points"),
        asked("which", "Which camera took it?", "every case"),
        asked("every-point", "puts every point where it was seen", "mistake errors-cancel"),
        asked("both-numbers", "Return its number and how far off", "value"),
        asked("tell", "Tell from known points", "case five cameras"),
        given("frame", "x right, y down, z forward"),
        asked("found", "Where the points were found", "mistake row-column"),
        asked(
            "fields-of-view",
            "Vertical fields of view",
            "mistake half-pixel",
            "mistake radians-again",
            "mistake whole-angle",
            "mistake width-for-height",
        ),
        given("size", "Size of the picture, pixels"),
        asked(
            "counted",
            "explains the pixels best, counted",
            "value of camera",
            "case two cameras with",
        ),
        asked("mean-distance", "the mean distance", "value of error_px", "mistake errors-cancel"),
    ),
    visible=_visible,
    hidden=_hidden,
)
