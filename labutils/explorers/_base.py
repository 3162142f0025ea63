"""What all explorers share: a view that computes in the browser, and controls linked to it.

A view gets everything it needs as traits, so it can be drawn from them alone: in JupyterLab, and
on a built page where no Python runs. Its Python side computes the same values from the same
traits, with `labutils` and OpenCV: `View.compute` is what the JavaScript is tested against.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import anywidget
import cv2
import ipywidgets
import numpy as np
import traitlets

from labutils._guards import check_depth_image, check_pixel, check_rgb_image
from labutils.explorers._goal import Goal

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

#: Depth travels as a 16-bit PNG in steps of this many meters: 0 to 13.1 m, at most 0.1 mm off.
DEPTH_STEP = 0.0002
_MAX_STEPS = 65535


class View(anywidget.AnyWidget):
    """The part of an explorer that draws."""

    #: What a screen reader calls the explorer.
    label = traitlets.Unicode().tag(sync=True)
    #: One line below the picture that says what to do.
    help = traitlets.Unicode().tag(sync=True)
    #: The values that Reset brings back, by the name of the trait.
    start = traitlets.Dict().tag(sync=True)
    #: What is to be reached, as `Goal.to_trait` writes it; empty for nothing.
    goal = traitlets.Dict().tag(sync=True)

    #: Traits a reader changes, by a control or in the picture.
    PARAMETERS: ClassVar[tuple[str, ...]] = ()

    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        self.start = {name: getattr(self, name) for name in self.PARAMETERS}

    def compute(self) -> dict[str, Any]:
        """Compute the values the read-out tells, from the traits as they are now.

        Returns
        -------
        dict
            Numbers, lists and None only; the view reports the same names.
        """
        raise NotImplementedError

    def describe(self) -> str:
        """Say the values in one sentence: shown where no picture can be."""
        raise NotImplementedError

    def draw_poster(self) -> np.ndarray:
        """Draw what the view shows at first: uint8 RGB, for print and for pages without scripts."""
        raise NotImplementedError


class PixelView(View):
    """A view of a picture in which a pixel is picked."""

    #: The trait that holds the picture as PNG.
    PICTURE: ClassVar[str]

    #: The picked pixel [u, v], or [] for none.
    pixel: Any = traitlets.List(traitlets.Int()).tag(sync=True)

    @property
    def picture_size(self) -> tuple[int, int]:
        """Width and height of the picture in pixels."""
        return read_size(getattr(self, self.PICTURE))

    @traitlets.validate("pixel")
    def _check_pixel(self, proposal: dict[str, Any]) -> list[int]:
        if not proposal["value"]:
            return []
        try:
            return list(check_pixel("pixel", proposal["value"], *self.picture_size))
        except ValueError as error:
            raise traitlets.TraitError(str(error)) from None


class Control(NamedTuple):
    """A widget, and the name of its value: selections have an index on the page, and no value."""

    widget: ipywidgets.Widget
    attribute: str = "value"


class Explorer(ipywidgets.VBox):  # type: ignore[misc]  # ipywidgets has no types
    """A view with its controls below.

    Parameters
    ----------
    view : View
        What draws and computes.
    controls : mapping of str to widget or Control
        By the name of the view's trait that each one sets. Links run in the browser, so they also
        hold where there is no Python; with a kernel, Python sees every value.
    """

    def __init__(self, view: View, controls: Mapping[str, ipywidgets.Widget | Control]) -> None:
        self.view = view
        self.controls = {
            name: one if isinstance(one, Control) else Control(one)
            for name, one in controls.items()
        }
        for name, (widget, attribute) in self.controls.items():
            setattr(widget, attribute, getattr(view, name))
        self.links = [
            ipywidgets.jslink((widget, attribute), (view, name))
            for name, (widget, attribute) in self.controls.items()
        ]
        box = ipywidgets.Box([control.widget for control in self.controls.values()])
        box.add_class("explorer-controls")
        super().__init__([view, box])
        self.add_class("explorer-box")

    @property
    def values(self) -> dict[str, Any]:
        """What the read-out tells, computed by labutils from the controls as they are now."""
        return self.view.compute()

    @property
    def goal(self) -> Goal | None:
        """What the reader is to reach; None for nothing. Set it to ask for something else."""
        return Goal.from_trait(self.view.goal)

    @goal.setter
    def goal(self, goal: Goal | None) -> None:
        self.view.goal = {} if goal is None else goal.to_trait()

    @property
    def goal_is_reached(self) -> bool:
        """Whether the values reach the goal as they are now; there has to be one."""
        if self.goal is None:
            raise ValueError("goal: expected one to reach, got None")
        return self.goal.holds(self.values)

    def move(self, **values: Any) -> None:
        """Set controls from Python, as a hand would.

        Raises
        ------
        ValueError
            If there is no such control.
        """
        for name, value in values.items():
            if name not in self.view.PARAMETERS:
                known = ", ".join(self.view.PARAMETERS)
                raise ValueError(f"control: expected one of {known}, got {name!r}")
            setattr(self.view, name, value)
            if name in self.controls:
                widget, attribute = self.controls[name]
                setattr(widget, attribute, value)

    def _repr_mimebundle_(self, **options: Any) -> dict[str, Any]:
        """Add the poster, unless it is excluded: a viewer that knows no widgets shows it."""
        bundle: dict[str, Any] = super()._repr_mimebundle_(**options) or {}
        if "image/png" in (options.get("exclude") or ()):
            return bundle
        return {**bundle, "image/png": encode_rgb(self.view.draw_poster())}

    def __repr__(self) -> str:
        return self.view.describe()


class PixelExplorer(Explorer):
    """An explorer whose view has a picked pixel."""

    view: PixelView

    @property
    def pixel(self) -> tuple[int, int] | None:
        """Column and row of the picked pixel; None where none is picked."""
        return tuple(self.view.pixel) or None


def make_slider(
    description: str, limits: tuple[float, float], step: float, *, unit: str = "", digits: int = 0
) -> ipywidgets.Widget:
    """Make a slider: of whole numbers where the step is one, else of floats."""
    return _make(
        ipywidgets.IntSlider, ipywidgets.FloatSlider, description, limits, step, unit, digits
    )


def make_range_slider(
    description: str, limits: tuple[float, float], step: float, *, unit: str = "", digits: int = 0
) -> ipywidgets.Widget:
    """Make a slider with a low and a high handle."""
    return _make(
        ipywidgets.IntRangeSlider,
        ipywidgets.FloatRangeSlider,
        description,
        limits,
        step,
        unit,
        digits,
    )


def _make(
    whole: type,
    real: type,
    description: str,
    limits: tuple[float, float],
    step: float,
    unit: str,
    digits: int,
) -> ipywidgets.Widget:
    low, high = limits
    name = f"{description} ({unit})" if unit else description
    kind, form = (whole, "d") if isinstance(step, int) else (real, f".{digits}f")
    return kind(min=low, max=high, step=step, description=name, readout_format=form)


def make_choice(description: str, options: Sequence[str]) -> Control:
    """Make a row of buttons of which one is pressed; the view gets its place, from 0."""
    widget = ipywidgets.ToggleButtons(options=list(options), description=description)
    return Control(widget, "index")


def encode_rgb(rgb_image: np.ndarray) -> bytes:
    """Compress a uint8 RGB picture, losing nothing, for a view to read."""
    return _encode(cv2.cvtColor(check_rgb_image("rgb_image", rgb_image), cv2.COLOR_RGB2BGR))


def depth_to_steps(depth_metric: np.ndarray) -> np.ndarray:
    """Count depth in steps of `DEPTH_STEP`: uint16 (H, W), 0 for what is no depth, or beyond."""
    depth = check_depth_image("depth_metric", depth_metric).astype(np.float64)
    steps = np.round(np.where(np.isfinite(depth), depth, 0.0) / DEPTH_STEP)
    steps[(steps < 0) | (steps > _MAX_STEPS)] = 0
    return steps.astype(np.uint16)


def encode_depth(depth_metric: np.ndarray) -> bytes:
    """Compress a depth image, in steps of `DEPTH_STEP`; what is no depth, or beyond, becomes 0."""
    return encode_gray(depth_to_steps(depth_metric))


def decode_depth(png: bytes) -> np.ndarray:
    """Read back what `encode_depth` wrote: float32 (H, W) in meters, 0 where there was none."""
    return (decode_gray(png) * DEPTH_STEP).astype(np.float32)


def decode_rgb(png: bytes) -> np.ndarray:
    """Read back what `encode_rgb` wrote: uint8 (H, W, 3), RGB."""
    return cv2.cvtColor(_decode(png), cv2.COLOR_BGR2RGB)


def encode_gray(gray: np.ndarray) -> bytes:
    """Compress one channel, uint8 or uint16 (H, W), losing nothing."""
    return _encode(gray)


def decode_gray(png: bytes) -> np.ndarray:
    """Read back what `encode_gray` wrote."""
    return _decode(png)


def encode_mask(mask: np.ndarray) -> bytes:
    """Compress a mask, bool (H, W)."""
    return _encode(mask.astype(np.uint8) * 255)


def decode_mask(png: bytes) -> np.ndarray:
    """Read back what `encode_mask` wrote: bool (H, W)."""
    return _decode(png) > 0


def read_size(png: bytes) -> tuple[int, int]:
    """Return width and height of a PNG, from its header alone."""
    if len(png) < 24:
        raise ValueError(f"png: expected the bytes of a PNG file, got {len(png)} others")
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


def _encode(image: np.ndarray) -> bytes:
    done, png = cv2.imencode(".png", image, [cv2.IMWRITE_PNG_COMPRESSION, 9])
    if not done:
        raise ValueError(f"image: expected a picture that PNG can hold, got shape {image.shape}")
    return png.tobytes()


def _decode(png: bytes) -> np.ndarray:
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_UNCHANGED)
    if image is None:
        raise ValueError(f"png: expected the bytes of a PNG file, got {len(png)} others")
    return image
