"""Explore a loop: a controller of the reader's own turns the head, and what it does is seen.

Python takes every step as the page asks for it. Where no Python runs, a recorded run stands.
Taught in: following.
"""

from __future__ import annotations

import sys
from statistics import fmean
from typing import TYPE_CHECKING, Any, ClassVar

import cv2
import numpy as np
import traitlets

from labutils._constants import FULL_WIDTH, NEAR_PX
from labutils._guards import check_image_size
from labutils.explorers._base import Explorer, View, make_slider
from labutils.explorers._following_recording import (
    EYE,
    OUTSIDE,
    decode_picture,
    encode_picture,
    record_following,
    to_moments,
)
from labutils.explorers._following_run import (
    FollowingRun,
    FollowingSettings,
    describe_problem,
)
from labutils.explorers._modules import join_modules, join_styles
from labutils.explorers._poster import draw_lines
from labutils.following.loop import DT

if TYPE_CHECKING:
    from labutils.following.loop import Control
    from labutils.following.record import FollowingRecord

#: Which command the recording shows first: the last one, with all that came before.
LAST = -1
#: The view from outside is drawn with every third command: it costs as much as the robot's own.
OUTSIDE_EVERY = 3
#: How near the center is to be located, in mm.
NEAR_MM = 15.0
#: How long the neck takes for the larger part (63 %) of a turn, in ms.
NECK_MS = 50.0
#: Ends of the sliders.
GAINS, DELAYS, NOISES, SPEEDS = (0.0, 2.0), (0, 8), (0.0, 10.0), (0.0, 1.0)
_RECORDED_S = 6.0
_JPEG = (".jpg", [cv2.IMWRITE_JPEG_QUALITY, 85])


class FollowingView(View):
    """The robot's eye, the robot from outside, errors over time, and where the time goes."""

    _esm = join_modules("following")
    _css = join_styles("plot", "following")
    #: Width and height of both pictures in pixels.
    size: traitlets.List[int] = traitlets.List().tag(sync=True)
    #: What was recorded: see `FollowingRecording`.
    moments = traitlets.Dict().tag(sync=True)
    pictures = traitlets.Bytes().tag(sync=True)
    places: traitlets.List[list[int]] = traitlets.List().tag(sync=True)
    problem = traitlets.Dict().tag(sync=True)
    #: The settings it was recorded with.
    recorded = traitlets.Dict().tag(sync=True)
    near_px = traitlets.Float().tag(sync=True)
    near_mm = traitlets.Float(NEAR_MM).tag(sync=True)
    dt = traitlets.Float(DT).tag(sync=True)
    neck_ms = traitlets.Float(NECK_MS).tag(sync=True)
    gain = traitlets.Float(1.0).tag(sync=True)
    delay = traitlets.Int(1).tag(sync=True)
    noise = traitlets.Float(2.0).tag(sync=True)
    speed = traitlets.Float(0.35).tag(sync=True)
    #: Place of the command that is shown, or `LAST`.
    moment = traitlets.Int(LAST).tag(sync=True)

    PARAMETERS: ClassVar = ("gain", "delay", "noise", "speed", "moment")

    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        #: What is told of each command: those of the recording until a live run takes their place.
        self.shown: list[dict[str, Any]] = to_moments(self.moments)
        self._is_live = False

    def follow(self, moments: list[dict[str, Any]]) -> None:
        """Tell of a live run from now on, and of what is added to its list of moments."""
        self.shown = moments
        self._is_live = True

    @property
    def settings(self) -> FollowingSettings:
        """What the reader has set."""
        return FollowingSettings(self.gain, self.delay, self.noise, self.speed)

    def compute(self) -> dict[str, Any]:
        """Compute the errors at the command that is shown, and their means until then.

        Means leave out the first second, the ball behind the board, and a second after it. What is
        not known is None: the error in mm where the controller did not say where the center is.
        `is_current` says whether the sliders stand as they did in the run.
        """
        is_current = self._is_live or self.settings._asdict() == self.recorded
        count = len(self.shown) if self.moment == LAST else self.moment + 1
        until = self.shown[:count]
        if not until:
            names = ("time", "error_px", "error_mm", "is_hidden", "mean_px", "mean_mm")
            return {**dict.fromkeys(names), "is_current": is_current}
        now = until[-1]
        measured = [one for one in until if one["is_measured"]]
        return {
            **{name: now[name] for name in ("time", "error_px", "error_mm", "is_hidden")},
            "mean_px": _get_mean([one["error_px"] for one in measured]),
            "mean_mm": _get_mean([one["error_mm"] for one in measured]),
            "is_current": is_current,
        }

    def describe(self) -> str:
        """Say how far off the ball is, and was."""
        values = self.compute()
        if values["time"] is None:
            return "Following: not begun"
        return (
            f"Following: after {values['time']:.2f} s the ball is "
            f"{_write(values['error_px'], 1, 'px')} from the middle "
            f"(mean {_write(values['mean_px'], 1, 'px')}), its center "
            f"{_write(values['error_mm'], 0, 'mm')} off (mean {_write(values['mean_mm'], 0, 'mm')})"
        )

    def draw_poster(self) -> np.ndarray:
        """Draw both pictures of the last moment, and below them the error over time."""
        pair = np.hstack([self._read_picture(which) for which in (EYE, OUTSIDE)])
        errors = [one["error_px"] for one in self.shown]
        if not any(one is not None for one in errors):
            return pair
        values = np.array([np.nan if one is None else one for one in errors])
        times = np.array([one["time"] for one in self.shown])
        lost = np.where([one["is_hidden"] for one in self.shown], values, np.nan)
        plot = draw_lines(
            times,
            {
                "error": values,
                "ball hidden": lost,
                "bound": np.full(len(times), self.near_px),
            },
            (float(times[-1]), float(np.nan_to_num(values[-1]))),
            labels=("time (s)", "error (px)"),
            title="Distance of the ball from the middle of the picture",
        )
        height = round(plot.shape[1] * pair.shape[0] / pair.shape[1])
        return np.vstack([cv2.resize(pair, (plot.shape[1], height)), plot])

    def _read_picture(self, which: int) -> np.ndarray:
        """Return the last picture of the eye, or from outside; gray where there is none."""
        found = [one for one in self.places if one[1] == which]
        if not found:
            width, height = self.size
            return np.full((height, width, 3), 128, np.uint8)
        _, _, start, length = found[-1]
        return decode_picture(self.pictures[start : start + length])


class FollowingExplorer(Explorer):
    """What `explore_following` returns: the run, and what it shows of it."""

    view: FollowingView

    def __init__(self, view: FollowingView, run: FollowingRun) -> None:
        controls = {
            "gain": make_slider("gain", GAINS, 0.05, digits=2),
            "delay": make_slider("delay", DELAYS, 1, unit="commands"),
            "noise": make_slider("noise", NOISES, 0.5, unit="levels", digits=1),
            "speed": make_slider("ball", SPEEDS, 0.05, unit="m/s", digits=2),
        }
        self._run = run
        super().__init__(view, controls)
        view.on_msg(self._answer)

    @property
    def control(self) -> Control:
        """The controller; another one takes over with the next command."""
        return self._run.control

    @control.setter
    def control(self, control: Control) -> None:
        self._run.control = control

    @property
    def record(self) -> FollowingRecord:
        """What has happened in the live run until now."""
        return self._run.loop.record

    def step(self, count: int = 1) -> None:
        """Give so many commands, as the button does.

        Raises
        ------
        Exception
            What the controller raises.
        """
        self.view.follow(self._run.moments)
        for _ in range(count):
            self._run.settings = self.view.settings
            self._run.step()

    def _answer(self, _view: FollowingView, content: dict[str, Any], _buffers: Any) -> None:
        """Do what the page asks for. It asks anew only when it has got an answer."""
        kind = content.get("kind")
        if kind == "restart":
            self._run.start_again()
        if kind in ("hello", "restart"):
            self.view.follow(self._run.moments)
            told = {"kind": "ready", "id": content["id"]}
            self._show_page(told, self._run.draw_eye(), self._run.draw_outside())
        elif kind == "step":
            self._step_for_page(content)

    def _step_for_page(self, content: dict[str, Any]) -> None:
        if content.get("hide"):
            self._run.hide()
        told: dict[str, Any] = {"kind": "stepped", "id": content["id"]}
        is_due = len(self._run.moments) % OUTSIDE_EVERY == 0
        outside = [self._run.draw_outside()] if is_due else []  # of the same moment as the eye's
        try:
            self.step()
        except Exception as error:  # noqa: BLE001 - the reader's own code may raise anything
            problem = describe_problem(error, self.control, self._run.loop.time)
            self._show_page({**told, "problem": problem})
        else:
            told |= {"moment": self._run.moments[-1]}
            self._show_page(told, self._run.draw_eye(), *outside)

    def _show_page(self, told: dict[str, Any], *pictures: np.ndarray) -> None:
        self.view.send(told, [encode_picture(one, *_JPEG) for one in pictures])


def explore_following(
    control: Control,
    *,
    seed: int = 0,
    width: int = 160,
    height: int = 120,
    recorded_s: float | None = None,
) -> FollowingExplorer:
    """Let a controller of your own turn the head, step by step, and see how well it follows.

    Every picture is computed by Python, by one ray per pixel, with one command after the other:
    the ball waits for your code. Where no Python runs, a recorded run stands.

    Parameters
    ----------
    control : callable
        ``control(rgb, depth, K, state)`` returns pan and tilt in radians; `state` is a
        `labutils.following.FollowingState`. An exception in it is told in the view.
    seed : int
        Chooses the path of the ball and the noise.
    width, height : int
        Picture size in pixels. The time of a command grows with their product.
    recorded_s : float, optional
        How long the recorded run is, in seconds; without it 6, and on a page, where Python
        answers by itself, 0: nothing is recorded.

    Returns
    -------
    FollowingExplorer
        Shows itself as the last line of a cell; has `record`, `control` and `step`.

    Raises
    ------
    TypeError, ValueError
        If `control` cannot be called, or the size is no positive whole numbers.
    """
    width, height = check_image_size(width, height)
    if recorded_s is None:
        recorded_s = 0.0 if sys.platform == "emscripten" else _RECORDED_S
    options: dict[str, Any] = {"seed": seed, "width": width, "height": height}
    view = FollowingView(
        label="Following explorer",
        help="Run your control, hide the ball, change a slider on the way.",
        size=[width, height],
        near_px=NEAR_PX * width / FULL_WIDTH,
    )
    run = FollowingRun(control, view.settings, **options)
    view.recorded = view.settings._asdict()
    kept = record_following(control, view.settings, recorded_s, **options)
    view.moments, view.pictures, view.places, view.problem = kept
    view.shown = to_moments(view.moments)
    return FollowingExplorer(view, run)


def _get_mean(values: list[float | None]) -> float | None:
    known = [one for one in values if one is not None]
    return fmean(known) if known else None


def _write(value: float | None, digits: int, unit: str) -> str:
    return "unknown" if value is None else f"{value:.{digits}f} {unit}"
