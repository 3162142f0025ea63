"""Challenge of step 5: find the table in a cloud and level the cloud with it."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification

#: Points this close to the plane belong to the table, in meters.
_TABLE = 0.01


def level_cloud(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Find the table top in a cloud and turn the cloud so that the table is the plane z = 0.

    The table holds more points than any other plane. Its points lie within 2 mm of it, all others
    at least 30 mm away. Fit the plane to *all* points of the table by least squares (distances
    perpendicular to the plane): three points alone are not accurate enough. RANSAC finds which
    points those are; start its random generator from a fixed seed, so that it answers the same
    every time.

    Parameters
    ----------
    points : ndarray, float64, (N, 3)
        Points in the camera frame, meters; the camera is at the origin and above the table.

    Returns
    -------
    plane : ndarray, float, (4,)
        (a, b, c, d) with a unit normal n = (a, b, c) and n . p + d = 0 on the table. The sign is
        such that d > 0: the normal points to the side of the camera.
    leveled : ndarray, float, (N, 3)
        R p + (0, 0, d) for every point p, in the order of the input. R is the smallest rotation
        that turns n into (0, 0, 1): its axis is the cross product of n and (0, 0, 1). So z is the
        height above the table.
    """
    rng = np.random.default_rng(0)
    best = np.zeros(len(points), dtype=bool)
    for _ in range(100):
        a, b, c = points[rng.choice(len(points), 3, replace=False)]
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal)
        if length < 1e-9:
            continue  # three points on a line
        inliers = np.abs((points - a) @ normal) < _TABLE * length
        if inliers.sum() > best.sum():
            best = inliers
    for _ in range(3):  # a fit to the first inliers finds those that their plane missed
        center = points[best].mean(axis=0)
        normal = np.linalg.svd(points[best] - center)[2][2]
        best = np.abs((points - center) @ normal) < _TABLE
    offset = -normal @ center
    if offset < 0:
        normal, offset = -normal, -offset
    x, y, z = normal
    turn = np.array([[0, 0, -x], [0, 0, -y], [x, y, 0]])
    rotation = np.eye(3) + turn + turn @ turn / (1 + z)
    return np.append(normal, offset), points @ rotation.T + [0, 0, offset]


def _answer_with(mistakes: frozenset[str], points: np.ndarray) -> Any:
    if "all-points" in mistakes:
        center = points.mean(axis=0)
        _, vectors = np.linalg.eigh(np.cov((points - center).T))
        normal = vectors[:, 0]
        normal = normal * -np.sign(normal @ center)
    else:
        plane, _ = level_cloud(points)
        normal, center = plane[:3], -plane[3] * plane[:3]
    offset = -normal @ center
    if "normal-down" in mistakes:
        normal, offset = -normal, -offset
    up = np.array([0.0, 1, 0] if "to-the-y-axis" in mistakes else [0, 0, 1])
    cross = np.cross(normal, up)
    turn = np.array([[0, -cross[2], cross[1]], [cross[2], 0, -cross[0]], [-cross[1], cross[0], 0]])
    rotation = np.eye(3) + turn + turn @ turn / (1 + normal @ up)
    if "turned-back" in mistakes:
        rotation = rotation.T
    shift = 0 * up if "not-shifted" in mistakes else offset * up
    return np.append(normal, offset), points @ rotation.T + shift


#: What is special about a camera, the angle by which it looks down, and its roll, in degrees.
_CAMERAS = (
    ("a camera that looks steeply down", (55, 62), (5, 20)),
    ("a level camera: its optical axis is parallel to the table", (0, 0), (35, 60)),
    ("a camera that is rolled far to the side and looks up a little", (-14, -8), (115, 150)),
)


def _make_case(
    rng: np.random.Generator, label: str, downs: tuple[int, int], rolls: tuple[int, int]
) -> Case:
    """Make a table with things on it and a floor below, all of it before the camera.

    The table's normal stays away from the axes z and y, where the smallest rotation is not unique.
    """
    table = rng.uniform([-0.6, -0.4, -0.0002], [0.6, 0.4, 0.0002], size=(60, 3))
    # Some lie higher: the median of their heights is not the mean.
    table[:, 2] += np.where(rng.random(60) < 0.3, 0.0014, 0)
    things = rng.uniform([-0.3, -0.2, 0.033], [0.1, 0.3, 0.3], size=(30, 3))
    floor = rng.uniform([-0.6, -1, -0.72], [1.5, 1, -0.68], size=(20, 3))
    points = rng.permutation(np.concatenate([table, things, floor]))
    down, roll = np.deg2rad(rng.uniform(*downs)), np.deg2rad(rng.uniform(*rolls))
    roll *= rng.choice([-1, 1])
    # Rows are the axes of the camera in the frame of the table: x right, y down, z forward.
    axes = np.array(
        [[0, -1, 0], [-np.sin(down), 0, -np.cos(down)], [np.cos(down), 0, -np.sin(down)]]
    )
    turn = [[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1]]
    camera = rng.uniform([-1.1, -0.3, 0.5], [-0.9, 0.3, 0.9])
    return Case(label, (np.round((points - camera) @ (turn @ axes).T, 6),))


def _is_upside_down(points: np.ndarray) -> bool:
    """Tell whether the decomposition gives the normal of the table that points away."""
    plane, _ = level_cloud(points)
    table = points[np.abs(points @ plane[:3] + plane[3]) < _TABLE]
    center = table.mean(axis=0)
    return bool(np.linalg.svd(table - center)[2][2] @ center > 0)


def _make_cases(rng: np.random.Generator) -> tuple[Case, ...]:
    """Make cases of which every second needs its normal turned around, as a fit may give either."""
    cases: list[Case] = []
    while len(cases) < len(_CAMERAS):
        case = _make_case(rng, *_CAMERAS[len(cases)])
        if _is_upside_down(*case.args) == bool(len(cases) % 2):
            cases.append(case)
    return tuple(cases)


def _visible() -> tuple[Case, ...]:
    return _make_cases(np.random.default_rng(110))


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    return (*_make_cases(rng), *_make_cases(rng))


def _keep_table(args: dict[str, Any]) -> dict[str, Any]:
    _, leveled = level_cloud(args["points"])
    return {"points": args["points"][np.abs(leveled[:, 2]) < 0.01]}


def _keep_far(args: dict[str, Any]) -> dict[str, Any]:
    _, leveled = level_cloud(args["points"])
    height = np.abs(leveled[:, 2])
    return {"points": args["points"][(height < 0.01) | (height > 0.06)]}


def _flatten(args: dict[str, Any]) -> dict[str, Any]:
    plane, leveled = level_cloud(args["points"])
    # Only the table's: the others stay where they are.
    height = np.where(np.abs(leveled[:, 2]) > 0.01, 0, leveled[:, 2])
    return {"points": args["points"] - height[:, None] * plane[:3]}


EXERCISE = Exercise(
    name="level_cloud",
    title="find the table and level the cloud",
    chapter="step5",
    place=13,
    points=0,
    section="step5-world",
    objectives=("5c", "5d"),
    reference=level_cloud,
    answer_with=_answer_with,
    simpler=(
        Simplification("table-only", "there are no points but the table's", _keep_table),
        Simplification("flat", "the table is perfectly flat", _flatten),
        Simplification("no-clutter", "nothing lies less than 60 mm above the table", _keep_far),
    ),
    parts=(
        Part("plane", "vector", "float", atol=2e-4),
        Part("leveled", "rows", "float", atol=2e-4, unit="m"),
    ),
    tolerance_reason=(
        "whoever fits all points of the table gets the same plane, whatever the random choice; a "
        "plane through three of them is off by a millimeter"
    ),
    misconceptions=(
        Misconception(
            "all-points",
            "you fit one plane to all points: things on the table and the floor tilt it. Find the "
            "points of the table first.",
        ),
        Misconception(
            "normal-down",
            "the normal points away from the camera, so heights are negative. Where d is not "
            "positive, change the sign of all four numbers.",
        ),
        Misconception(
            "turned-back",
            "you apply the inverse rotation. For points in rows, R p for every p is points @ R.T.",
        ),
        Misconception(
            "not-shifted",
            "the cloud is turned, but the table is not at zero. Add d to the coordinate along the "
            "normal.",
        ),
        Misconception(
            "to-the-y-axis",
            "you turn the normal to the y axis. In a leveled frame z points up: turn it to "
            "(0, 0, 1).",
        ),
    ),
    hints=(
        (
            "RANSAC: draw three points, make a plane, count points near it. Do this a hundred "
            "times and keep the plane with most."
        ),
        (
            "Refit: the normal is the direction in which the table's points vary least, the last "
            "row of Vt in np.linalg.svd of the centered points."
        ),
        (
            "With v = n x (0, 0, 1), c = n . (0, 0, 1) and V the matrix with V p = v x p: "
            "R = I + V + V V / (1 + c)."
        ),
    ),
    example="""\
some, its_colors = points[::37], colors[::37]  # fewer, the same table
plane, leveled = level_cloud(some)
print(f"The camera is {plane[3]:.3f} m above the table.")
show((leveled, its_colors), frame="world")""",
    contract=(
        told("tilted", "Nobody told you"),
        asked("find-plane", "in spite of the things on it", "every case", "mistake all-points"),
        told("ransac", "RANSAC is the classic way"),
        asked("fit-again", "Then fit again", "value of plane"),
        told("signs", "The signs are stated"),
        asked("find", "Find the table top", "value"),
        given("most-points", "The table holds more points"),
        given("within", "Its points lie within 2 mm"),
        asked("least-squares", "by least squares", "value of plane"),
        asked("same-every-time", "so that it answers the same every time", "value"),
        given("origin", "the camera is at the origin"),
        asked("unit-normal", "with a unit normal", "value of plane"),
        asked("sign", "The sign is such that", "mistake normal-down"),
        asked(
            "turned",
            "R p + (0, 0, d)",
            "mistake not-shifted",
            "mistake turned-back",
            "value of leveled",
        ),
        asked("smallest", "R is the smallest rotation", "mistake to-the-y-axis"),
        asked("height", "So z is the height", "mistake not-shifted"),
    ),
    visible=_visible,
    hidden=_hidden,
)
