"""Explorers: move a slider, see what follows.

Each works in a notebook, where Python reads its values, and on the built page, where no Python
runs. ``ipywidgets`` make the controls, one ``anywidget`` view draws.
"""

from __future__ import annotations

from labutils.explorers.cloud import CloudExplorer, explore_cloud
from labutils.explorers.fov import FovExplorer, explore_fov
from labutils.explorers.hsv import HsvExplorer, explore_hsv

__all__ = ["CloudExplorer", "FovExplorer", "HsvExplorer", "explore_cloud", "explore_fov", "explore_hsv"]
