"""Look through a peer's camera with the library, by hand and with rays, and compare."""

from __future__ import annotations

import copy
import functools
from dataclasses import dataclass

import cv2
import mujoco
import numpy as np

from labutils import (
    get_camera_intrinsics,
    get_clip_planes,
    make_renderer,
    process_depth,
    render_camera,
)
from labutils.cameras import Camera
from labutils.raycast import RaycastRenderer
from labutils.renderers import opengl
from tests.foreign.peers import PeerModel, Said, load
from tests.foreign.views import FREE, HEIGHT, WIDTH, View

_KINDS = {0: "fixed", 1: "tracking", 2: "tracking", 3: "targeting", 4: "targeting"}  # mjtCamLight
_GEOM = mujoco.mjtObj.mjOBJ_GEOM.value
#: What a label of a picture may be besides a geom: the words of `list_omissions` begin with these.
_NO_GEOMS = {
    mujoco.mjtObj.mjOBJ_SITE.value: "site",
    mujoco.mjtObj.mjOBJ_TENDON.value: "tendon",
    mujoco.mjtObj.mjOBJ_SKIN.value: "skin",
    mujoco.mjtObj.mjOBJ_FLEX.value: "flex",
    mujoco.mjtObj.mjOBJ_SENSOR.value: "range-finder line",
}
#: A geom group that nobody draws and no ray of the library hits.
_HIDDEN_GROUP = 5
#: Neighbors further apart than this share of their depth are an edge within one geom.
_JUMP = 0.05


@dataclass(frozen=True)
class Truth:
    """What rays see, and where it can be compared with a picture.

    Attributes
    ----------
    depth : ndarray, float32, shape (H, W)
        Meters, the far plane where a ray meets nothing.
    comparable : ndarray, bool, shape (H, W)
        Off edges, and picture and rays see the same geom.
    nothing : ndarray, bool, shape (H, W)
        Neither sees anything.
    unseen : float
        Share of pixels off edges where rays see something else than the picture: they meet no
        skin, tendon, site or line of a range finder, but do meet a surface from behind.
    """

    depth: np.ndarray
    comparable: np.ndarray
    nothing: np.ndarray
    unseen: float


@dataclass(frozen=True)
class Found:
    """What is found at one camera.

    Attributes
    ----------
    view, kind
        The camera, and what moves it.
    differing_pixels : int
        Pixels whose color or depth is not that of MuJoCo's renderer, in two states together.
    changed : list of str
        Fields of the state that drawing changed and should not.
    unseen : float
        As in `Truth`.
    no_geoms : frozenset of str
        What the picture shows besides geoms: "site", "tendon" and so on.
    depth_mm, depth_single_mm : float
        Median error of our depth against rays, with the model's own number of samples a pixel and
        with one.
    peer_mm, peer_single_mm : float
        Likewise of the peer's depth; with one sample it is read in the peer's way by us.
    sky : float or None
        The peer's depth where nothing is seen, as a share of the far plane; None without sky.
    K_offset_px : ndarray, shape (3, 3), or None
        The peer's intrinsic matrix less ours, None where it has none.
    K_offset_mm : float
        How far sideways that puts a point at the median depth.
    """

    view: View
    kind: str
    differing_pixels: int
    changed: list[str]
    unseen: float
    no_geoms: frozenset[str]
    depth_mm: float
    depth_single_mm: float
    peer_mm: float
    peer_single_mm: float
    sky: float | None
    K_offset_px: np.ndarray | None
    K_offset_mm: float


def draw_by_hand(
    peer: PeerModel, data: mujoco.MjData, camera: Camera, model: mujoco.MjModel | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Draw color, depth and labels by MuJoCo's own renderer, after a forward of a copy."""
    model = peer.model if model is None else model
    data = copy.copy(data)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, HEIGHT, WIDTH) as renderer:
        renderer.update_scene(data, camera, peer.scene_option)
        color = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.disable_depth_rendering()
        renderer.enable_segmentation_rendering()
        return color, depth, renderer.render()


def draw(
    peer: PeerModel, data: mujoco.MjData, camera: Camera, model: mujoco.MjModel | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Draw color and depth by the library; `data` as it comes."""
    model = peer.model if model is None else model
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        return render_camera(model, data, renderer, camera, scene_option=peer.scene_option)


def read_raw(peer: PeerModel, data: mujoco.MjData, camera: Camera, samples: int) -> np.ndarray:
    """Read meters as the peers do, by the bare depth buffer, with so many samples a pixel."""
    model = with_samples(peer.model, samples)
    with mujoco.Renderer(model, HEIGHT, WIDTH) as renderer:
        renderer.update_scene(data, camera, peer.scene_option)
        return process_depth(opengl.read_raw_depth(model, renderer), *get_clip_planes(model))


def with_samples(model: mujoco.MjModel, samples: int) -> mujoco.MjModel:
    """Copy a model whose pictures have so many samples a pixel; 0 is one, in its middle."""
    model = copy.copy(model)
    model.vis.quality.offsamples = samples
    return model


def cast(peer: PeerModel, data: mujoco.MjData, camera: Camera, labels: np.ndarray) -> Truth:
    """Cast the rays of a camera; `labels` says what a picture shows there."""
    depth, ids = _cast_rays(peer.model, peer, data, camera)
    other = (labels[..., 0] != ids) | ((labels[..., 1] != _GEOM) & (labels[..., 1] >= 0))
    unseen = float((other & ~_find_edges(ids, labels)).mean())
    # A camera inside a geom: OpenGL draws no surface from behind, a ray stops at each. Without the
    # geoms of which the picture shows nothing, rays see the rest, and it can be compared.
    model = copy.copy(peer.model)
    drawn = labels[labels[..., 1] == _GEOM, 0]
    while (behind := np.setdiff1d(ids[ids >= 0], drawn)).size:
        model.geom_group[behind] = _HIDDEN_GROUP
        depth, ids = _cast_rays(model, peer, data, camera)
    edges = _find_edges(ids, labels) | _find_jumps(depth)
    return Truth(
        depth=depth,
        comparable=~edges & (labels[..., 1] == _GEOM) & (labels[..., 0] == ids),
        nothing=~edges & (ids < 0) & (labels[..., 1] < 0),
        unseen=unseen,
    )


def _cast_rays(
    model: mujoco.MjModel, peer: PeerModel, data: mujoco.MjData, camera: Camera
) -> tuple[np.ndarray, np.ndarray]:
    """Return depth, far where nothing is hit, and ids of geoms, -1 there; both (H, W)."""
    with RaycastRenderer(model, HEIGHT, WIDTH) as renderer:
        renderer.update_scene(data, camera, peer.scene_option)
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.disable_depth_rendering()
        renderer.enable_segmentation_rendering()
        return depth, renderer.render()[..., 0]


def _find_edges(ids: np.ndarray, labels: np.ndarray) -> np.ndarray:
    """Mark pixels with a neighbor, of eight, on another object of the rays or of the picture."""
    codes = (ids, labels[..., 0] * 100 + labels[..., 1])
    return np.any([_get_range(code) > 0 for code in codes], axis=0)


def _find_jumps(depth: np.ndarray) -> np.ndarray:
    return _get_range(np.log(depth)) > np.log1p(_JUMP)


def _get_range(image: np.ndarray) -> np.ndarray:
    """Return by how much the pixels of each 3x3 neighborhood differ."""
    values, window = image.astype(np.float64), np.ones((3, 3), np.uint8)
    return cv2.dilate(values, window) - cv2.erode(values, window)


@functools.cache
def measure(view: View) -> Found:
    """Measure everything at one camera, once."""
    peer = load(view.peer, view.model)
    said = peer.said[view.camera]
    differing, changed = 0, []
    for data in (peer.make_stepped_data(), peer.make_data()):
        by_hand = draw_by_hand(peer, data, said.camera)
        before = copy.copy(data)
        color, depth = draw(peer, data, said.camera)
        changed += find_changes(before, data)
        differing += int(((color != by_hand[0]).any(axis=2) | (depth != by_hand[1])).sum())
    mujoco.mj_forward(peer.model, data)
    truth = cast(peer, data, said.camera, by_hand[2])
    single = draw(peer, data, said.camera, with_samples(peer.model, 0))[1]
    raw = read_raw(peer, data, said.camera, 0)
    offset, sideways = _compare_intrinsics(peer, said, float(np.median(depth[truth.comparable])))
    sky = said.depth[truth.nothing] / get_clip_planes(peer.model)[1]
    return Found(
        view=view,
        kind=get_kind(peer.model, view),
        differing_pixels=differing,
        changed=changed,
        unseen=truth.unseen,
        no_geoms=frozenset(
            _NO_GEOMS[kind] for kind in np.unique(by_hand[2][..., 1]) if kind not in (-1, _GEOM)
        ),
        depth_mm=_get_median_mm(depth, truth),
        depth_single_mm=_get_median_mm(single, truth),
        peer_mm=_get_median_mm(said.depth, truth),
        peer_single_mm=_get_median_mm(raw, truth),
        sky=float(np.median(sky)) if sky.size else None,
        K_offset_px=offset,
        K_offset_mm=sideways,
    )


def get_kind(model: mujoco.MjModel, view: View) -> str:
    """Say what moves a camera: its body, a body it follows or looks at, or the user."""
    return (
        FREE if view.camera == FREE else _KINDS[int(model.cam_mode[model.camera(view.camera).id])]
    )


def find_changes(before: mujoco.MjData, after: mujoco.MjData) -> list[str]:
    """Name the fields of a state that a picture has no business with, and that changed."""
    return [
        name
        for name in _FIELDS
        if not np.array_equal(getattr(before, name), getattr(after, name), equal_nan=True)
    ]


#: State, inputs and what dynamics computed; poses of bodies and the like do follow qpos.
_FIELDS = (
    *("time", "qpos", "qvel", "act", "qacc", "ctrl", "qfrc_applied", "xfrc_applied"),
    *("mocap_pos", "mocap_quat", "userdata", "qacc_warmstart", "sensordata", "energy"),
    *("qfrc_actuator", "qfrc_passive", "qfrc_constraint", "actuator_force", "ncon", "nefc"),
)


def _get_median_mm(depth: np.ndarray, truth: Truth) -> float:
    return float(np.median(1000 * np.abs(depth - truth.depth)[truth.comparable]))


def _compare_intrinsics(
    peer: PeerModel, said: Said, depth: float
) -> tuple[np.ndarray | None, float]:
    """Return the peer's K less ours, and how far sideways in millimeters that puts a point."""
    if said.K is None:
        return None, np.nan
    K, _ = get_camera_intrinsics(peer.model, said.camera, WIDTH, HEIGHT)
    offset = said.K - K
    return offset, float(1000 * depth * np.hypot(*offset[:2, 2] / np.diag(K)[:2]))
