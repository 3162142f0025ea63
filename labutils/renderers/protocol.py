"""What the library and a page may expect of a renderer, however it draws.

`mujoco.Renderer` has all of this. Only what is listed here may be relied on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, Self, runtime_checkable

if TYPE_CHECKING:
    import mujoco
    import numpy as np

    from labutils.cameras import Camera


@runtime_checkable
class Renderer(Protocol):
    """Draws a scene: color at first, depth or segmentation while that is switched on."""

    @property
    def model(self) -> mujoco.MjModel:
        """The model it was made for, the only one it can draw."""
        ...

    @property
    def height(self) -> int:
        """Rows of every picture."""
        ...

    @property
    def width(self) -> int:
        """Columns of every picture."""
        ...

    def update_scene(
        self,
        data: mujoco.MjData,
        camera: Camera = -1,
        scene_option: mujoco.MjvOption | None = None,
    ) -> None:
        """Take over the state to draw, the camera to draw it from, and what to draw of it."""
        ...

    def render(self, *, out: np.ndarray | None = None) -> np.ndarray:
        """Draw.

        Color is uint8 (H, W, 3). Depth is float32 (H, W), in meters along the optical axis, the
        far plane where nothing is seen. Segmentation is int32 (H, W, 2): object id and type, -1
        where nothing is seen. Written into `out` where there is one of that shape.
        """
        ...

    def enable_depth_rendering(self) -> None:
        """Make `render` return depth."""
        ...

    def disable_depth_rendering(self) -> None:
        """Make `render` return color again."""
        ...

    def enable_segmentation_rendering(self) -> None:
        """Make `render` return segmentation."""
        ...

    def disable_segmentation_rendering(self) -> None:
        """Make `render` return color again."""
        ...

    def close(self) -> None:
        """Free what drawing took; the end of a ``with`` block does it too."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(self, *exc_info: object) -> None: ...
