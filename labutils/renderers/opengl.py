"""Draw with OpenGL: the renderer is MuJoCo's own; its raw depth buffer is read here."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils.renderers.rays import RaycastRenderer

if TYPE_CHECKING:
    from labutils.renderers.protocol import Renderer

_EGL_BAD_ACCESS = 0x3002


def is_used_by(renderer: Renderer) -> bool:
    """Tell whether a renderer draws with OpenGL, and so fills a depth buffer."""
    # where everything is drawn by rays, `mujoco.Renderer` is the ray caster itself
    return isinstance(renderer, mujoco.Renderer) and not isinstance(renderer, RaycastRenderer)


def is_wrong_thread(error: BaseException) -> bool:
    """Tell whether OpenGL refused because another thread holds the renderer.

    EGL says ``EGL_BAD_ACCESS`` (0x3002); its binding may hand that out as a number or as a name.
    """
    code = getattr(error, "err", None)
    return str(code) == "EGL_BAD_ACCESS" or code == _EGL_BAD_ACCESS


def read_raw_depth(model: mujoco.MjModel, renderer: mujoco.Renderer) -> np.ndarray:
    """Draw the scene of a renderer into a buffer of its own and read its depth, unconverted.

    It is read the way a beginner reads it: MuJoCo's default depth map and multisampling on.

    Parameters
    ----------
    model : mujoco.MjModel
        The scene.
    renderer : mujoco.Renderer
        With its scene up to date; its own buffers are left alone.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Window depth, 0 at the near plane, 1 at the far plane.
    """
    raw = np.empty((renderer.height, renderer.width), dtype=np.float32)
    gl_context = mujoco.GLContext(renderer.width, renderer.height)
    try:
        gl_context.make_current()
        context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, context)
        rect = mujoco.MjrRect(0, 0, renderer.width, renderer.height)
        mujoco.mjr_render(rect, renderer.scene, context)
        mujoco.mjr_readPixels(None, raw, rect, context)
        context.free()
    finally:
        gl_context.free()
    return np.flipud(raw).copy()  # OpenGL's first row is the bottom one
