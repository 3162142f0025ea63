"""Explorers: move a slider, see what follows.

Each works in a notebook, where Python reads its values, and on the built page, where no Python
runs. ``ipywidgets`` make the controls, one ``anywidget`` view draws.
"""

from __future__ import annotations

from labutils.explorers.cloud import CloudExplorer, explore_cloud
from labutils.explorers.depth_convention import DepthConventionExplorer, explore_depth_convention
from labutils.explorers.depth_range import DepthRangeExplorer, explore_depth_range
from labutils.explorers.following import FollowingExplorer, explore_following
from labutils.explorers.fov import FovExplorer, explore_fov
from labutils.explorers.hsv import HsvExplorer, explore_hsv
from labutils.explorers.matching import MatchingExplorer, explore_matching
from labutils.explorers.scene import SceneExplorer, explore_scene
from labutils.explorers.stereo import StereoExplorer, explore_stereo

__all__ = [
    "CloudExplorer",
    "DepthConventionExplorer",
    "DepthRangeExplorer",
    "FollowingExplorer",
    "FovExplorer",
    "HsvExplorer",
    "MatchingExplorer",
    "SceneExplorer",
    "StereoExplorer",
    "explore_cloud",
    "explore_depth_convention",
    "explore_depth_range",
    "explore_following",
    "explore_fov",
    "explore_hsv",
    "explore_matching",
    "explore_scene",
    "explore_stereo",
]
