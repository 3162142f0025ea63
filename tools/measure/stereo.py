"""Match many pairs of both rooms by several methods, and score them against the exact truth.

Every view is rendered once; every seed adds another noise to it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np
from tqdm import tqdm

from labutils import get_camera_intrinsics, make_renderer, render_camera
from labutils.recordings import NOISE, add_noise
from labutils.room import make_room, set_baseline, set_pose
from labutils.room.recorder import BASELINES, VIEWS, list_labels, render_labels
from labutils.room.scene import BASELINE, LEFT, PLAIN, POLE, RIGHT, WALLPAPER
from labutils.stereo import depth_to_disparity, disparity_to_depth
from labutils.stereo_matching import (
    cost_to_disparity,
    lr_check,
    make_right_cost,
    matching_cost,
    ssd_disparity,
    subpixel,
)
from labutils.stereo_truth import (
    DisparityScore,
    find_disparity_edges,
    find_occluded,
    score_disparity,
    score_regions,
)

if TYPE_CHECKING:
    import mujoco

WIDTH, HEIGHT = 640, 480
SEEDS = (0, 1, 2, 3, 4)
DISPARITIES, WINDOW = 96, 9
#: Nearest depth that is searched for when the baseline changes, in meters.
NEAREST = 0.45
#: Depths in meters between which theory and measurement are compared.
COMPARED = (1.5, 2.5)

#: The region that numbers of a whole picture are about.
SEEN = "seen by both eyes"

Matcher = Callable[[np.ndarray, np.ndarray, int], np.ndarray]
#: Scores of every seed: a value by its seed.
BySeed = dict[int, float]


@dataclass(frozen=True)
class View:
    """One view with one baseline: what was rendered, and the truth.

    Parameters
    ----------
    name : str
        Name of the view.
    left, right : ndarray, uint8, shape (H, W)
        Gray pictures without noise.
    depth, truth : ndarray, float, shape (H, W)
        Depth of the left picture in meters, and its disparity in pixels.
    regions : dict of str to ndarray, bool, shape (H, W)
        The pixels of each region.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix.
    baseline : float
        Meters.
    """

    name: str
    left: np.ndarray
    right: np.ndarray
    depth: np.ndarray
    truth: np.ndarray
    regions: dict[str, np.ndarray]
    K: np.ndarray
    baseline: float

    def make_pair(self, seed: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the two pictures as noisy cameras take them."""
        name = self.name.encode()
        left = add_noise(self.left, NOISE, [seed, 0, *name])
        return left, add_noise(self.right, NOISE, [seed, round(1000 * self.baseline), *name])


def match_ssd(left: np.ndarray, right: np.ndarray, count: int) -> np.ndarray:
    """Compare windows by hand; the best one wins."""
    return ssd_disparity(left, right, count, WINDOW, padded=True)


def match_refined(left: np.ndarray, right: np.ndarray, count: int) -> np.ndarray:
    """Compare windows by hand; refine by a parabola, keep what the right picture confirms."""
    cost = matching_cost(left, right, count, WINDOW, padded=True)
    whole = cost_to_disparity(cost)
    kept = lr_check(whole, cost_to_disparity(make_right_cost(cost)))
    return np.where(kept, subpixel(cost, whole), np.nan).astype(np.float32)


def match_bm(left: np.ndarray, right: np.ndarray, count: int) -> np.ndarray:
    """Let OpenCV compare windows, the pictures widened on the left."""
    matcher = cv2.StereoBM.create(count, 15)
    return _match_widened(matcher.compute, left, right, count)


def match_sgbm(left: np.ndarray, right: np.ndarray, count: int) -> np.ndarray:
    """Let OpenCV match semi-globally, the pictures widened on the left."""
    return _match_widened(_make_sgbm(count).compute, left, right, count)


def match_sgbm_narrow(left: np.ndarray, right: np.ndarray, count: int) -> np.ndarray:
    """Let OpenCV match the pictures as they are: the leftmost columns are lost."""
    return _read_fixed_point(_make_sgbm(count).compute(left, right))


METHODS: dict[str, Matcher] = {
    "SSD 9x9, winner takes all": match_ssd,
    "SSD 9x9, parabola, left-right check": match_refined,
    "`cv2.StereoBM`, 15x15": match_bm,
    "`cv2.StereoSGBM`, 5x5": match_sgbm,
    "`cv2.StereoSGBM`, 5x5, left side not padded": match_sgbm_narrow,
}
SSD, SGBM = list(METHODS)[1], list(METHODS)[3]


def render_views(name: str, baselines: Iterable[float] = (BASELINE,)) -> list[View]:
    """Render every view of a room with every baseline."""
    model, data = make_room(name)
    K, _ = get_camera_intrinsics(model, LEFT, WIDTH, HEIGHT)
    views = []
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        for view, joints in VIEWS.items():
            set_pose(model, data, **joints)
            rgb, depth = render_camera(model, data, renderer, LEFT)
            labels = render_labels(model, data, renderer)
            for baseline in baselines:
                set_baseline(model, baseline)
                other, depth_right = render_camera(model, data, renderer, RIGHT)
                truth = depth_to_disparity(depth, K, baseline)
                hidden = find_occluded(depth, depth_right, K, baseline)
                regions = find_regions(model, labels, truth, hidden)
                left, right = (cv2.cvtColor(one, cv2.COLOR_RGB2GRAY) for one in (rgb, other))
                views.append(View(view, left, right, depth, truth, regions, K, baseline))
            set_baseline(model, BASELINE)
    return views


def find_regions(
    model: mujoco.MjModel, labels: np.ndarray, truth: np.ndarray, hidden: np.ndarray
) -> dict[str, np.ndarray]:
    """Divide a picture by what makes it easy or hard; the first region is all that both see."""
    numbers = list_labels(model)
    edges = find_disparity_edges(truth)
    plain, paper, pole = (labels == numbers[one] for one in (PLAIN, WALLPAPER, POLE))
    flat = ~hidden & ~edges
    return {
        SEEN: ~hidden,
        "textured, no edge near": flat & ~plain & ~paper & ~pole,
        "no texture (panel)": flat & plain,
        "repeated texture (wallpaper)": flat & paper,
        "thin pole": ~hidden & pole,
        "near edges": ~hidden & edges & ~pole,
        "hidden from the right eye": hidden,
    }


@dataclass(frozen=True)
class MethodScores:
    """How good one method is, by seed.

    Parameters
    ----------
    regions : dict of str to dict of int to DisparityScore
        In every region, over all views together.
    views : dict of str to dict of int to float
        In every view, the share of what both eyes see that is not correct.
    """

    regions: dict[str, dict[int, DisparityScore]]
    views: dict[str, BySeed]


def score_methods(views: list[View], seeds: Iterable[int] = SEEDS) -> dict[str, MethodScores]:
    """Score every method in every region and every view, by seed."""
    found = {name: MethodScores(defaultdict(dict), defaultdict(dict)) for name in METHODS}
    for seed in tqdm(list(seeds), "seeds"):
        pairs = [view.make_pair(seed) for view in views]
        for name, match in METHODS.items():
            maps = [match(*pair, DISPARITIES) for pair in pairs]
            for region, score in _score_all(maps, views).items():
                found[name].regions[region][seed] = score
            for disparity, view in zip(maps, views, strict=True):
                score = score_disparity(disparity, view.truth, view.regions[SEEN])
                found[name].views[view.name][seed] = score.not_correct
    return found


@dataclass(frozen=True)
class BaselineScore:
    """How semi-global matching does with one baseline, by seed.

    Parameters
    ----------
    baseline, seen : float
        Meters; share of the left picture that the right eye sees.
    not_correct, rmse, theory : dict of int to float
        Share of pixels; root mean square of the depth error, measured and by z^2 sd / (f B), both
        over the same pixels, in meters.
    """

    baseline: float
    seen: float
    not_correct: BySeed
    rmse: BySeed
    theory: BySeed


def score_baselines(
    name: str, baselines: Iterable[float] = BASELINES, seeds: Iterable[int] = SEEDS
) -> list[BaselineScore]:
    """Compare the depth error with its theory, for several baselines."""
    rows = []
    for baseline in tqdm(list(baselines), "baselines"):
        views = render_views(name, (baseline,))
        count = count_disparities(float(views[0].K[0, 0]), baseline)
        scores = {seed: _score_depth(views, count, seed) for seed in seeds}
        seen = float(np.mean([view.regions[SEEN].mean() for view in views]))
        columns = ({seed: one[place] for seed, one in scores.items()} for place in range(3))
        rows.append(BaselineScore(baseline, seen, *columns))
    return rows


def count_disparities(focal: float, baseline: float) -> int:
    """Return how many disparities reach from infinity to `NEAREST`: a multiple of 16."""
    return int(np.ceil(focal * baseline / NEAREST / 16)) * 16


def _score_depth(views: list[View], count: int, seed: int) -> tuple[float, float, float]:
    """Return the share that is not correct, the depth error and what theory says it is."""
    maps = [match_sgbm(*view.make_pair(seed), count) for view in views]
    whole = _score_all(maps, views)[SEEN]
    errors, expected = [], []
    for disparity, view in zip(maps, views, strict=True):
        near, far = COMPARED
        chosen = view.regions[SEEN] & (np.abs(disparity - view.truth) < 1)
        chosen &= (view.depth > near) & (view.depth < far)
        depth = view.depth[chosen].astype(np.float64)
        errors.append(disparity_to_depth(disparity[chosen], view.K, view.baseline) - depth)
        expected.append(depth**2 * whole.sd / (view.K[0, 0] * view.baseline))
    return whole.not_correct, _get_rms(errors), _get_rms(expected)


def _score_all(maps: list[np.ndarray], views: list[View]) -> dict[str, DisparityScore]:
    """Score the maps of all views as if they were one large picture."""
    regions = {
        name: np.concatenate([view.regions[name] for view in views]) for name in views[0].regions
    }
    truth = np.concatenate([view.truth for view in views])
    return score_regions(np.concatenate(maps), truth, regions)


def _get_rms(parts: list[np.ndarray]) -> float:
    return float(np.sqrt((np.concatenate(parts) ** 2).mean()))


def _make_sgbm(count: int) -> cv2.StereoSGBM:
    """Make OpenCV's matcher with the penalties that its documentation advises."""
    block = 5
    return cv2.StereoSGBM.create(
        minDisparity=0,
        numDisparities=count,
        blockSize=block,
        P1=8 * block**2,
        P2=32 * block**2,
        disp12MaxDiff=1,
        preFilterCap=31,
        uniquenessRatio=10,
        speckleWindowSize=100,
        speckleRange=2,
    )


def _match_widened(
    compute: Callable[[np.ndarray, np.ndarray], np.ndarray],
    left: np.ndarray,
    right: np.ndarray,
    count: int,
) -> np.ndarray:
    """Match with as many more columns on the left as OpenCV leaves out there."""
    wide = (cv2.copyMakeBorder(one, 0, 0, count, 0, cv2.BORDER_REPLICATE) for one in (left, right))
    return _read_fixed_point(compute(*wide))[:, count:]


def _read_fixed_point(disparity: np.ndarray) -> np.ndarray:
    """Turn sixteenths of a pixel into pixels, and what is missing into NaN."""
    pixels = disparity.astype(np.float32) / 16
    return np.where(pixels > 0, pixels, np.nan)
