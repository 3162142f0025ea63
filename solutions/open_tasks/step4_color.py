"""Step 4: a mask that is nearly perfect and leads to the wrong place; a lamp that is dimmed."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import mujoco
import numpy as np

import labutils as lab
from labutils.figures import plot_images
from solutions._open_answers import Finding

CAMERA, WIDTH, HEIGHT = "head_camera", 640, 480
KERNEL = np.ones((5, 5), np.uint8)


@dataclass(frozen=True)
class _Look:
    """One picture, its mask of red, and the true pixels of box and ball."""

    rgb: np.ndarray
    mask: np.ndarray
    box: np.ndarray
    ball: np.ndarray

    @property
    def iou(self) -> float:
        """How well the mask agrees with the truth."""
        red = self.box | self.ball
        return float(np.sum((self.mask > 0) & red) / np.sum((self.mask > 0) | red))

    @property
    def off_px(self) -> float:
        """How far the centroid of the largest region is from the middle of the true box."""
        found = lab.find_object_centroid(self.mask)
        middle = np.argwhere(self.box).mean(axis=0)[::-1]
        return float("nan") if found is None else float(np.linalg.norm(middle - found))

    @property
    def gap_px(self) -> float:
        """How far the ball is from the box, in the picture."""
        distance = cv2.distanceTransform((~self.box).astype(np.uint8), cv2.DIST_L2, 5)
        return float(distance[self.ball].min())


def measure_strong() -> Finding:
    """Roll the ball toward the box until both become one region; leave closing out as a control."""
    apart, touching = _look(ball_y=0.36), _look(ball_y=0.355)
    opened = cv2.morphologyEx(_threshold(touching.rgb), cv2.MORPH_OPEN, KERNEL)
    control = _Look(touching.rgb, opened, touching.box, touching.ball)
    middle = lab.find_object_centroid(touching.mask)
    return Finding(
        {
            "gap_apart_px": apart.gap_px,
            "off_apart_px": apart.off_px,
            "gap_px": touching.gap_px,
            "iou": touching.iou,
            "off_px": touching.off_px,
            "off_control_px": control.off_px,
            "times_the_box": float(np.sum(touching.mask > 0) / np.sum(touching.box)),
        },
        plot_images(
            {
                "gap of 4 px": lab.visualize_detection(touching.rgb, middle, touching.mask),
                "without closing": lab.visualize_detection(
                    touching.rgb, lab.find_object_centroid(opened), opened
                ),
            }
        ),
    )


def measure_typical() -> Finding:
    """Dim all lamps, and say how far the overlap falls."""
    bright, dim, dark = _look(), _look(light=0.3), _look(light=0.2)
    return Finding(
        {"iou_bright": bright.iou, "iou_dim": dim.iou, "iou_dark": dark.iou},
        plot_images({"picture": dark.rgb, "mask": dark.mask}),
    )


def _look(*, ball_y: float | None = None, light: float = 1.0) -> _Look:
    model, data = lab.make_scene()
    for lamp in (model.light_diffuse, model.vis.headlight.diffuse, model.vis.headlight.ambient):
        lamp[:] = light * np.array(lamp)
    if ball_y is not None:
        data.mocap_pos[0] = 0.82, ball_y, 0.905
        mujoco.mj_forward(model, data)
    with lab.make_renderer(model, HEIGHT, WIDTH) as renderer:
        rgb, _ = lab.render_camera(model, data, renderer, CAMERA)
        bodies = lab.render_segmentation(model, data, renderer, CAMERA)
    box, ball = (bodies == model.body(name).id for name in ("red_box", "red_ball"))
    return _Look(rgb, lab.segment_by_color(rgb, lab.HSV_RANGES["red"]), box, ball)


def _threshold(rgb: np.ndarray) -> np.ndarray:
    """Mark what is red, without cleaning."""
    (low_hue, *low), (high_hue, *high) = lab.HSV_RANGES["red"]
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    above = cv2.inRange(hsv, (low_hue, *low), (179, *high))
    below = cv2.inRange(hsv, (0, *low), (high_hue, *high))
    return cv2.bitwise_or(above, below)
