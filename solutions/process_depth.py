"""Step 3: from window depth to meters."""

from __future__ import annotations

from typing import Any

import numpy as np

import labutils
from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, told
from solutions._simpler import Simplification
from solutions.completions.process_depth import COMPLETION


def _answer_with(
    mistakes: frozenset[str], depth_raw: np.ndarray, near: float, far: float
) -> np.ndarray:
    if "left-as-it-is" in mistakes:
        return depth_raw
    raw = depth_raw.astype(np.float64)
    if "fixed-planes" in mistakes:
        near, far = 0.01, 10.0
    if "nan-lost" in mistakes:
        raw = np.nan_to_num(raw, nan=0.0)
    if "reversed" in mistakes:
        raw = 1 - raw
    if "not-clipped" not in mistakes:
        raw = np.clip(raw, 0, 1)
    if "linear" in mistakes:
        depth = near + raw * (far - near)
    elif "ndc" in mistakes:
        depth = 2 * near * far / (far + near - raw * (far - near))
    else:
        depth = near * far / (far - raw * (far - near))
    return depth.astype(depth_raw.dtype)


def _make_raw(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    raw = rng.uniform(0.0, 1.0, size=(height, width))
    raw[height // 2 :] = 1 - 0.2 * raw[height // 2 :] ** 2  # most surfaces read close to 1
    places = rng.choice(raw.size, size=9, replace=False)
    raw.ravel()[places] = [0, 1, 0, 1, np.nan, np.nan, -0.02, 1.001, -0.3]
    return np.round(raw, 6).astype(np.float32)


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(31)
    ramp = np.linspace(0, 1, 24 * 32).reshape(24, 32).astype(np.float32)
    return (
        Case("an even ramp from 0 to 1", (ramp, 0.1, 4.0)),
        Case(
            "values of a real buffer, with NaN and values outside 0-1",
            (_make_raw(rng, 18, 26), 0.02, 12.0),
        ),
        Case("other clip planes", (_make_raw(rng, 11, 15), 0.5, 3.4)),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    cases = []
    for number in range(4):
        near = round(float(rng.uniform(0.02, 0.4)), 4)
        far = round(float(rng.uniform(3, 15)), 3)
        size = rng.integers(12, 40, size=2)
        cases.append(Case(f"buffer {number + 1}", (_make_raw(rng, *map(int, size)), near, far)))
    return tuple(cases)


_ONE_FORMULA = "a pixel is converted by one formula only"
_NOTHING_DONE = "nothing is computed, so nothing else can go wrong"


def _keep_inside(args: dict[str, Any]) -> dict[str, Any]:
    raw = args["depth_raw"]
    outside = (raw <= 0) | (raw >= 1)
    return {"depth_raw": np.where(outside, np.float32(0.5), raw)}


EXERCISE = Exercise(
    name="process_depth",
    title="turn window depth into meters",
    chapter="step3",
    place=1,
    points=12,
    section="step3-raw",
    objectives=("3a",),
    reference=labutils.process_depth,
    answer_with=_answer_with,
    simpler=(
        Simplification("inside", "every value lies inside 0 to 1", _keep_inside),
        Simplification(
            "known",
            "no value is NaN",
            lambda a: {"depth_raw": np.nan_to_num(a["depth_raw"], nan=0.5)},
        ),
    ),
    parts=(Part("depth", "depth", "float", atol=1e-3, unit="m", low="near", high="far"),),
    tolerance_reason=(
        "one millimeter: far from the near plane, float32 arithmetic on a hyperbola loses about "
        "0.1 mm per 10 m; every mistake is off by centimeters somewhere"
    ),
    misconceptions=(
        Misconception(
            "linear",
            "your meters grow evenly with the buffer. Window depth is hyperbolic: half of its "
            "range is used up a little behind the near plane.",
        ),
        Misconception(
            "not-clipped",
            "values a little outside 0-1 run away, far behind the camera or beyond the far plane. "
            "Clip the raw value before you convert it.",
        ),
        Misconception(
            "reversed",
            "near and far are exchanged. In this buffer 0 is the near plane and 1 is the far one; "
            "reversed z is what MuJoCo uses inside.",
            section="step3-reversed-z",
        ),
        Misconception(
            "ndc",
            "this formula is for depth from -1 to 1. The buffer holds 0 to 1: shift it first "
            "(2 d - 1), or use the formula for 0 to 1.",
        ),
        Misconception(
            "fixed-planes",
            "the result does not depend on near and far: 0.01 and 10 are written in. Every model "
            "has clip planes of its own; use the arguments.",
        ),
        Misconception(
            "nan-lost",
            "pixels without a reading come out as the near plane. NaN says that nothing is known "
            "there: let it stay NaN.",
        ),
        Misconception(
            "left-as-it-is",
            "the values come back unchanged. mujoco.Renderer gives meters already, but this "
            "function gets the raw buffer, 0 to 1.",
        ),
    ),
    hints=(
        (
            "Put in d = 0 and d = 1: which depth in meters has to come out of each? A straight "
            "line is not the only curve through these two points."
        ),
        (
            "Depth appears as 1/z in the buffer. The raw value is even in 1/z: 1/near at d = 0, "
            "1/far at d = 1."
        ),
        "Clip the raw value to 0-1 first. np.clip leaves NaN alone, and that is what you want.",
    ),
    example="""\
depth_raw = lab.render_raw_depth(model, data, renderer, "head_camera")
print(f"The buffer holds {depth_raw.min():.3f} to {depth_raw.max():.3f}.")
near, far = lab.get_clip_planes(model)
show(process_depth(depth_raw, near, far), "meters along the optical axis")""",
    contract=(
        asked(
            "form",
            "A graphics card stores depth in the form",
            "mistake linear",
            "mistake reversed",
            "mistake ndc",
        ),
        asked("to-meters", "Turn such a buffer into meters", "every case", "mistake left-as-it-is"),
        asked("clip", "come from rounding", "mistake not-clipped"),
        asked("nan-stays", "it has to stay", "mistake nan-lost"),
        asked("turn", "Turn window-space depth", "value"),
        asked("hyperbolic", "hyperbolic in between", "mistake linear", "case an even ramp"),
        told("reversed-z", "MuJoCo draws with *reversed* z"),
        told("done-already", "has done this step already"),
        asked("outside", "values outside [0, 1] are clipped", "case values of a real buffer"),
        asked(
            "planes",
            "Clip planes in meters",
            "mistake fixed-planes",
            "case other clip planes",
            "range",
        ),
        asked("unit", "Meters along the optical axis.", "value"),
        asked("example", "array([[1. , 1.5, 3. ]])", "value"),
    ),
    visible=_visible,
    hidden=_hidden,
    asks={
        "depth_raw": (
            "ndarray, float32, shape (H, W)\n"
            "Window depth; values outside [0, 1] are clipped, NaN stays NaN."
        ),
        "Returns": "ndarray, float, shape (H, W)\n    Meters along the optical axis.",
        "Raises": "",
        "Examples": (
            ">>> process_depth(np.array([[0.0, 0.5, 1.0]]), near=1.0, far=3.0)\n"
            "array([[1. , 1.5, 3. ]])"
        ),
    },
    absorbed=(
        Absorbed("linear", "ndc", _ONE_FORMULA),
        *(
            Absorbed("left-as-it-is", other, _NOTHING_DONE)
            for other in ("linear", "not-clipped", "reversed", "ndc", "fixed-planes", "nan-lost")
        ),
    ),
    completion=COMPLETION,
)
