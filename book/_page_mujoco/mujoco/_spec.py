"""``mujoco.MjSpec``: a scene before it is compiled."""

from __future__ import annotations


class MjSpec:
    """To be written."""
