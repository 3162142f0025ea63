"""Render the cover of the book: one picture that shows all six steps at once.

At the bottom lies what the head camera sees, split down the middle: color on the
left, depth on the right. Above it floats the point cloud made from that very picture,
and dotted lines join pixels with the points they become.

Nothing is drawn by hand: the picture, the depth and the cloud come from the scene and
the library, so that running this script again gives the same cover.

Run it as ``python -m tools.draw.cover``.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from labutils import (
    camera_to_world,
    find_valid_depth,
    get_camera_intrinsics,
    get_clip_planes,
    make_renderer,
    make_scene,
    pixels_to_points,
    render_camera,
)
from tools import ROOT

COVER = ROOT / "book" / "_static" / "cover.png"
WIDTH, HEIGHT = 1280, 640
#: Everything is drawn this many times larger and then reduced: smooth edges and dots.
SCALE = 2
CAMERA_NAME = "head_camera"
PICTURE_WIDTH, PICTURE_HEIGHT = 1280, 960
#: Depth in meters that turbo shows as blue and as red.
DEPTH_COLORS = (0.55, 2.1)
#: This many pixels become dots of the cloud; every n-th, both ways, becomes a dotted line.
CLOUD_DOTS = 300_000
LINE_STRIDE = 80
GROUND_TOP_BGR = (46, 33, 25)
GROUND_BOTTOM_BGR = (24, 17, 13)


@dataclass(frozen=True)
class View:
    """A pinhole camera that looks from one world point at another."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    fov_y: float

    def project(self, points_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return pixels (N, 2) on the enlarged canvas and depths (N,) of world points (N, 3)."""
        forward = np.subtract(self.target, self.eye)
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        down = np.cross(forward, right)
        local = (points_world - np.array(self.eye)) @ np.stack([right, down, forward], axis=1)
        focal_px = HEIGHT * SCALE / (2 * np.tan(self.fov_y / 2))
        center = (np.array([WIDTH, HEIGHT]) * SCALE - 1) / 2
        return local[:, :2] / local[:, 2:] * focal_px + center, local[:, 2]


@dataclass(frozen=True)
class Sheet:
    """The picture as a sheet of paper in the world, tilted toward the reader."""

    center: tuple[float, float, float]
    width: float
    tilt: float
    yaw: float

    def place(self, pixels: np.ndarray) -> np.ndarray:
        """Return the world points (N, 3) where the pixels (N, 2) of the picture lie."""
        u = (pixels[:, 0] / (PICTURE_WIDTH - 1) - 0.5) * self.width
        v = (pixels[:, 1] / (PICTURE_HEIGHT - 1) - 0.5) * self.width * 0.75
        ahead = np.array([np.cos(self.yaw), np.sin(self.yaw), 0.0])
        right = np.array([np.sin(self.yaw), -np.cos(self.yaw), 0.0])
        up = np.cos(self.tilt) * ahead + np.sin(self.tilt) * np.array([0.0, 0.0, 1.0])
        return np.array(self.center) + u[:, None] * right - v[:, None] * up


VIEW = View(eye=(-1.0, -1.35, 2.15), target=(0.80, 0.17, 0.72), fov_y=np.radians(38))
SHEET = Sheet(center=(0.10, 0.66, 0.53), width=1.3, tilt=np.radians(25), yaw=np.radians(33))


def render_split_picture() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Render the split picture and turn it into points.

    Returns
    -------
    picture_bgr : ndarray, uint8, shape (H, W, 3)
        Color on the left, depth on the right.
    pixels : ndarray, int, shape (N, 2)
        The pixels (u, v) that see something.
    points_world : ndarray, float, shape (N, 3)
        Their points.
    """
    model, data = make_scene()
    renderer = make_renderer(model, PICTURE_HEIGHT, PICTURE_WIDTH)
    rgb, depth = render_camera(model, data, renderer, CAMERA_NAME)
    K, _ = get_camera_intrinsics(model, CAMERA_NAME, PICTURE_WIDTH, PICTURE_HEIGHT)

    near, far = get_clip_planes(model)
    valid = find_valid_depth(depth, near, far * 0.99)
    picture_bgr = cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR)
    half = PICTURE_WIDTH // 2
    picture_bgr[:, half:] = color_depth(depth, valid)[:, half:]

    rows, columns = np.nonzero(valid)
    pixels = np.stack([columns, rows], axis=-1)
    points_cam = pixels_to_points(pixels, depth[valid], K)
    camera = data.camera(CAMERA_NAME)
    points_world = camera_to_world(points_cam, camera.xpos, camera.xmat)
    return picture_bgr, pixels, points_world


def color_depth(depth: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Return depth as turbo colors (BGR), blue close and red far, invalid pixels dark."""
    nearest, farthest = DEPTH_COLORS
    share = np.clip((depth - nearest) / (farthest - nearest), 0.0, 1.0)
    # The ends of turbo are almost black: stay a little inside.
    levels = np.round(255 * (0.06 + 0.88 * share)).astype(np.uint8)
    colored_bgr = cv2.applyColorMap(levels, cv2.COLORMAP_TURBO)
    colored_bgr[~valid] = GROUND_TOP_BGR
    return colored_bgr


def choose_dots(count: int) -> np.ndarray:
    """Return a random mask of the pixels that become dots.

    A regular grid of pixels would draw false stripes on slanted surfaces.
    """
    rng = np.random.default_rng(4)
    return rng.random(count) < CLOUD_DOTS / count


def draw_ground() -> np.ndarray:
    """Return the dark ground of the cover, a soft vertical ramp (BGR floats)."""
    ramp = np.linspace(0.0, 1.0, HEIGHT * SCALE)[:, None, None]
    ground = (1 - ramp) * np.array(GROUND_TOP_BGR) + ramp * np.array(GROUND_BOTTOM_BGR)
    return np.repeat(ground, WIDTH * SCALE, axis=1)


def draw_sheet(canvas: np.ndarray, picture_bgr: np.ndarray) -> None:
    """Draw the picture as a sheet with a thin pale seam between its halves."""
    picture_bgr = picture_bgr.copy()
    half = PICTURE_WIDTH // 2
    picture_bgr[:, half - 2 : half + 2] = 245
    corners = np.array(
        [
            [0, 0],
            [PICTURE_WIDTH - 1, 0],
            [PICTURE_WIDTH - 1, PICTURE_HEIGHT - 1],
            [0, PICTURE_HEIGHT - 1],
        ]
    )
    placed, _ = VIEW.project(SHEET.place(corners))
    size = (canvas.shape[1], canvas.shape[0])
    homography, _ = cv2.findHomography(corners.astype(float), placed)
    warped = cv2.warpPerspective(picture_bgr, homography, size, flags=cv2.INTER_AREA)
    covered = np.zeros(canvas.shape[:2], np.uint8)
    cv2.fillConvexPoly(covered, np.round(placed).astype(np.int32), 255, cv2.LINE_AA)
    share = covered[..., None] / 255.0
    canvas[:] = (1 - share) * canvas + share * warped


def draw_dots(
    canvas: np.ndarray,
    points_world: np.ndarray,
    colors_bgr: np.ndarray,
    radius: float,
    strength: float | np.ndarray = 1.0,
) -> None:
    """Draw round dots, far ones first, so that near dots cover them."""
    pixels, depth = VIEW.project(points_world)
    order = np.argsort(-depth, kind="stable")
    centers = np.round(pixels[order]).astype(int)
    colors = colors_bgr[order].astype(float)
    weights = np.broadcast_to(strength, depth.shape)[order][:, None]
    reach = int(np.ceil(radius))
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dx * dx + dy * dy > radius * radius:
                continue
            x, y = centers[:, 0] + dx, centers[:, 1] + dy
            inside = (x >= 0) & (x < canvas.shape[1]) & (y >= 0) & (y < canvas.shape[0])
            # With repeated indices the last write wins: that is the nearest dot.
            old = canvas[y[inside], x[inside]]
            blended = old + weights[inside] * (colors[inside] - old)
            canvas[y[inside], x[inside]] = blended


def draw_lines(
    canvas: np.ndarray, starts: np.ndarray, ends: np.ndarray, colors: np.ndarray
) -> None:
    """Draw dotted lines from pixels on the sheet to their points, fading in on the way up."""
    pale = colors + 0.30 * (255.0 - colors)
    for step in np.linspace(0.03, 0.97, 48):
        draw_dots(canvas, (1 - step) * starts + step * ends, pale, 1.6, 0.9 * step)


def make_cover() -> np.ndarray:
    """Return the finished cover, uint8 BGR, HEIGHT x WIDTH."""
    picture_bgr, pixels, points_world = render_split_picture()
    colors_bgr = picture_bgr[pixels[:, 1], pixels[:, 0]]
    canvas = draw_ground()
    draw_sheet(canvas, picture_bgr)
    on_line = np.all((pixels - LINE_STRIDE // 2) % LINE_STRIDE == 0, axis=1)
    draw_lines(canvas, SHEET.place(pixels[on_line]), points_world[on_line], colors_bgr[on_line])
    in_cloud = choose_dots(len(pixels))
    draw_dots(canvas, points_world[in_cloud], colors_bgr[in_cloud], 1.5)
    small = cv2.resize(canvas, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    return np.round(np.clip(small, 0, 255)).astype(np.uint8)


def main() -> None:
    """Write the cover."""
    COVER.parent.mkdir(parents=True, exist_ok=True)
    if not cv2.imwrite(str(COVER), make_cover(), [cv2.IMWRITE_PNG_COMPRESSION, 9]):
        raise OSError(f"cannot write {COVER}")
    print(f"{COVER.name}: {WIDTH} x {HEIGHT}, {COVER.stat().st_size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
