"""Challenge of step 1: which pictures of a log still show the pose before."""

from __future__ import annotations

from typing import Any

import numpy as np

from solutions._model import Absorbed, Case, Exercise, Misconception, Part, asked, given, told
from solutions._simpler import Simplification

#: Less is no movement, in radians.
_STILL = 0.001


def find_stale_frames(images: np.ndarray, pans: np.ndarray, noise: int) -> np.ndarray:
    """Find the pictures of a log that still show the pose before.

    A picture is stale if the neck has moved since the picture before (by more than 0.001 rad), but
    no value of the picture has changed by more than the noise. The first picture is never stale.

    Parameters
    ----------
    images : ndarray, uint8, (T, H, W, 3)
        The pictures, oldest first.
    pans : ndarray, float64, (T,)
        Angle of the neck when each picture was taken, radians.
    noise : int
        Largest change of a value from 0 to 255 that is noise.

    Returns
    -------
    ndarray, bool, (T,)
        True where a picture is stale.
    """
    stale = np.zeros(len(images), dtype=bool)
    moved = np.abs(np.diff(pans)) > _STILL
    change = np.abs(np.diff(images.astype(np.int16), axis=0)).max(axis=(1, 2, 3))
    stale[1:] = moved & (change <= noise)
    return stale


def _answer_with(mistakes: frozenset[str], images: np.ndarray, pans: np.ndarray, noise: int) -> Any:
    numbers = images if "bytes-wrap" in mistakes else images.astype(np.int16)
    first = "first-picture" in mistakes
    before = np.repeat(numbers[:1], len(images) - 1, axis=0) if first else numbers[:-1]
    change = np.abs(numbers[1:] - before)
    measure = np.mean if "mean-change" in mistakes else np.max
    same = measure(change, axis=(1, 2, 3)) <= noise
    if "exactly-equal" in mistakes:
        same = (numbers[1:] == before).all(axis=(1, 2, 3))
    turned = np.abs(pans[1:] - (pans[0] if first else pans[:-1])) > _STILL
    if "angle-ignored" in mistakes:
        turned[:] = True
    stale = np.zeros(len(images), dtype=bool)
    stale[slice(None, -1) if "one-early" in mistakes else slice(1, None)] = turned & same
    return stale


def _make_case(rng: np.random.Generator, label: str, noise: int) -> Case:
    """Make a log in which every kind of frame occurs: stale ones, still ones, and honest ones."""
    height, width = int(rng.integers(5, 8)), int(rng.integers(8, 12))
    pictures = [rng.integers(60, 190, size=(height, width, 3))]
    pans = [float(rng.uniform(-0.3, 0.3))]
    kinds = ["stale-equal", "stale-brighter", "stale-noisy", "still", "still-equal", "small"]
    kinds += ["creeping", "slow"]
    for kind in (*rng.permutation(kinds), "return", "stale-noisy", "new", "home", "still"):
        last, step = pictures[-1], float(rng.uniform(0.02, 0.1)) * rng.choice([-1, 1])
        grain = rng.integers(-noise, noise + 1, size=last.shape)
        grain[0, 0] = (-noise, noise, -1)  # noise goes both ways
        picture = last + (grain if kind in ("stale-noisy", "still") else 0)
        if kind == "stale-brighter":
            picture = last + np.abs(grain)
        elif kind == "new":
            picture = rng.integers(60, 190, size=last.shape)
        elif kind == "small":  # little of the picture changes, but that clearly
            picture = last.copy()
            picture[-1, -1] += 4 * noise
        elif kind in ("creeping", "slow"):
            picture = last
        elif kind in ("return", "home"):  # what the first picture showed
            picture = pictures[0] + (np.abs(grain) if kind == "return" else grain)
        pictures.append(np.clip(picture, 20, 235))
        before = pans[0] if kind == "home" else pans[-1]
        # Half of the limit is no movement, one and a half times the limit is one.
        steps = {"still": 0.0, "still-equal": 0.0, "home": 0.0, "creeping": 0.0005, "slow": 0.0015}
        pans.append(before + steps.get(kind, step))
    return Case(label, (np.array(pictures).astype(np.uint8), np.round(pans, 4), noise))


def _make_log(rng: np.random.Generator, label: str, noise: int, pictures: list[Any]) -> Case:
    """Make a log whose neck turns by 0.05 rad and more before every picture."""
    steps = rng.uniform(0.05, 0.1, size=len(pictures))
    pans = rng.uniform(-0.3, 0.0) + np.cumsum(steps)
    return Case(label, (np.array(pictures).astype(np.uint8), np.round(pans, 4), noise))


def _make_faint(rng: np.random.Generator, label: str, noise: int) -> Case:
    """Make a log with two changes that gray values hide, and that go one way only."""
    first = rng.integers(60, 190, size=(3, 4, 3))
    darker, brighter = np.zeros((2, 3, 4, 3), dtype=np.int64)
    darker[2, 1, 2] = noise + 1
    brighter[0, 3, 0] = noise + 1
    grain = rng.integers(-noise, noise + 1, size=first.shape)
    second = first - darker
    return _make_log(rng, label, noise, [first, second, second + grain, second + grain + brighter])


def _make_glaring(rng: np.random.Generator, label: str, noise: int) -> Case:
    """Make a log with the least and the largest value: 255 + 1 is 0 again in a byte."""
    first = rng.integers(60, 190, size=(3, 4, 3))
    first[0, 1], first[2, 2] = 0, 255
    other = first.copy()
    other[0, 1] = 255
    grain = rng.integers(1, noise + 1, size=first.shape)
    repeated = np.where(first > 100, first - grain, first + grain)
    return _make_log(rng, label, noise, [first, repeated, first, other, first, first])


def _make_round(rng: np.random.Generator, label: str, noise: int) -> Case:
    first, second = rng.integers(60, 190, size=(2, 3, 4, 3))
    return _make_log(rng, label, noise, [first, second, second, first])


def _visible() -> tuple[Case, ...]:
    rng = np.random.default_rng(101)
    return (
        _make_case(rng, "a log of fourteen pictures", 3),
        _make_case(rng, "another log, with more noise", 5),
        _make_faint(rng, "one color of one pixel changes by one more than the noise", 4),
        _make_glaring(rng, "black and white pixels", 3),
        _make_round(rng, "at another angle the last picture equals the first", 2),
    )


def _hidden(rng: np.random.Generator) -> tuple[Case, ...]:
    def draw_noise() -> int:
        return int(rng.integers(2, 7))

    return (
        *(_make_case(rng, f"log {number}", draw_noise()) for number in range(4)),
        _make_faint(rng, "a faint change", draw_noise()),
        _make_glaring(rng, "black and white", draw_noise()),
        _make_round(rng, "back again", draw_noise()),
    )


def _turn_far(pans: np.ndarray) -> np.ndarray:
    steps = np.diff(pans, prepend=pans[:1])
    return np.cumsum(np.where(np.abs(steps) > 0.001, steps + 0.1 * np.sign(steps), 0.0))


EXERCISE = Exercise(
    name="find_stale_frames",
    title="find the pictures that show the pose before",
    chapter="step1",
    place=11,
    points=0,
    section="step1-stale",
    objectives=("1c",),
    reference=find_stale_frames,
    answer_with=_answer_with,
    simpler=(
        Simplification(
            "large-turns",
            "the neck turns by 0.1 rad and more, or not at all",
            lambda a: {"pans": _turn_far(a["pans"])},
        ),
        Simplification(
            "to-one-side",
            "the neck turns to its left only",
            lambda a: {"pans": np.cumsum(np.abs(np.diff(a["pans"], prepend=a["pans"][:1])))},
        ),
        Simplification(
            "turns-always",
            "the neck turns before every picture",
            lambda a: {"pans": 0.2 * np.arange(len(a["pans"]))},
        ),
    ),
    parts=(Part("stale", "flags", "bool"),),
    tolerance_reason="none: a picture is stale or it is not",
    misconceptions=(
        Misconception(
            "angle-ignored",
            "you mark pictures that rightly look the same, because the neck stood still. Ask for "
            "both: the angle has changed and the picture has not.",
        ),
        Misconception(
            "bytes-wrap",
            "you subtract uint8 from uint8: 3 - 5 is 254 there, so noise looks like a large "
            "change. Convert to a signed type first.",
        ),
        Misconception(
            "exactly-equal",
            "you ask for equal pictures. A camera has noise, so compare the change with the "
            "argument noise.",
        ),
        Misconception(
            "mean-change",
            "you take the mean change. Where little of the picture changes, the mean stays small: "
            "take the largest change.",
        ),
        Misconception(
            "one-early",
            "you mark the picture before. A stale picture repeats the one before it: np.diff "
            "starts at the second picture.",
        ),
        Misconception(
            "first-picture",
            "you compare with the first picture of the log. Compare each with the one before it.",
        ),
    ),
    hints=(
        "A picture is stale when two things hold. One is about the angles, one about the pictures.",
        "np.diff gives what changes from each entry to the next. What does it do to uint8?",
        "There are T pictures, but T - 1 changes. To which picture does the first change belong?",
    ),
    example="""\
data.joint("neck_pan").qpos = 0.2  # turn the head, look, turn it back
turned, _ = lab.render_camera(model, data, renderer, "head_camera")
data.joint("neck_pan").qpos = 0.0
images = np.array([rgb, rgb, turned])  # the second shows the pose before
show({"0.0 rad": rgb, "0.1 rad?": rgb, "0.2 rad": turned})
show(find_stale_frames(images, np.array([0.0, 0.1, 0.2]), 3), "stale")""",
    contract=(
        told("log", "A log holds pictures"),
        asked(
            "angle-changed", "the angle has changed, the picture has not", "mistake angle-ignored"
        ),
        asked("find-them", "Find those pictures", "every case"),
        asked(
            "not-equal", "a repeated picture is not equal to the last byte", "mistake exactly-equal"
        ),
        asked("stands-still", "a neck that stands still", "mistake angle-ignored"),
        asked("pose-before", "still show the pose before", "mistake one-early"),
        asked(
            "rule",
            "no value of the picture has changed",
            "mistake mean-change",
            "mistake bytes-wrap",
            "case another log, with more noise",
            "case one color of one pixel",
        ),
        asked(
            "first",
            "The first picture is never stale",
            "mistake first-picture",
            "case at another angle the last picture",
        ),
        given("order", "The pictures, oldest first"),
        given("angle", "when each picture was taken"),
        asked(
            "noise",
            "Largest change of a value",
            "mistake bytes-wrap",
            "case black and white pixels",
        ),
        asked("true-where", "True where a picture is stale.", "value"),
    ),
    visible=_visible,
    hidden=_hidden,
    absorbed=(
        Absorbed("exactly-equal", "mean-change", "who asks for equality measures no change"),
        Absorbed("exactly-equal", "bytes-wrap", "equal bytes are equal in any type"),
    ),
)
