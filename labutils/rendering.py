"""Which renderer draws: OpenGL where it works, the ray caster where it does not.

Chooses the OpenGL backend when the library is imported, because MuJoCo reads ``MUJOCO_GL`` once,
at its own import. Taught in: step 1 and the troubleshooting page.
"""

from __future__ import annotations

import ctypes.util
import functools
import importlib
import os
import sys
import warnings
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mujoco

    from labutils.renderers.protocol import Renderer

#: Values of MUJOCO_GL that MuJoCo itself understands as "no OpenGL".
_SWITCHED_OFF = frozenset({"0", "disable", "disabled", "false", "off"})

_USERS_CHOICE = "MUJOCO_GL switches OpenGL off"

#: Why Python in a web page draws by rays: always, so nobody is warned of it.
_IN_A_PAGE = "MuJoCo in a page has no OpenGL"

_INSTALL_HINTS = {
    "linux": "sudo apt-get install libegl1 libgl1-mesa-dri libopengl0",
    "darwin": "no package is missing on macOS: unset MUJOCO_GL and start Python again",
    "win32": "install the driver of your graphics card and unset MUJOCO_GL",
}


class NoOpenGLWarning(UserWarning):
    """OpenGL cannot draw here; the ray caster draws instead."""


def choose_gl_backend() -> str:
    """Pick a value for ``MUJOCO_GL`` where the user has not, and return the one in force.

    Convention
    ----------
    A user's own setting always wins. On Linux without a screen the choice is ``egl``, which draws
    off screen. Where its libraries are not installed the choice is ``disable``: MuJoCo then
    imports cleanly, and `make_renderer` hands out the ray caster.

    Returns
    -------
    str
        The value of ``MUJOCO_GL``; empty where MuJoCo's own default is right (a screen, macOS,
        Windows).
    """
    chosen = os.environ.get("MUJOCO_GL", "").strip().lower()
    has_screen = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    if not chosen and sys.platform.startswith("linux") and not has_screen:
        chosen = "egl"
    missing = _find_missing_libraries() if chosen == "egl" else []
    if missing:
        # With "egl" and without these, `import mujoco` itself stops with an obscure error.
        os.environ["LABUTILS_GL_MISSING"] = f"not installed: {', '.join(missing)}"
        chosen = "disable"
    if chosen:
        os.environ["MUJOCO_GL"] = chosen
        _tell_mujoco()
    return chosen


def _find_missing_libraries() -> list[str]:
    """List the libraries that MuJoCo's EGL backend needs and this machine lacks."""
    found = {name: ctypes.util.find_library(name) for name in ("EGL", "OpenGL", "GLESv2")}
    missing = [] if found["EGL"] else ["libEGL.so.1"]
    if not (found["OpenGL"] or found["GLESv2"]):  # PyOpenGL takes the one that is there
        missing.append("libOpenGL.so.0")
    return missing


def _tell_mujoco() -> None:
    """Let MuJoCo read ``MUJOCO_GL`` again where it was imported before this library.

    MuJoCo reads the variable once, at import, and without it takes GLFW, which needs a screen.
    ``import mujoco`` above ``import labutils`` is the alphabetical order, so this must work.
    """
    module = sys.modules.get("mujoco.rendering.classic.gl_context")
    backend = os.environ["MUJOCO_GL"]
    if module is None or getattr(module, "_MUJOCO_GL", backend) == backend:
        return
    if backend in _SWITCHED_OFF:
        return  # `make_renderer` looks at the variable itself
    import mujoco  # noqa: PLC0415 - it is imported already, or this line is not reached

    importlib.reload(module)
    mujoco.GLContext = module.GLContext  # the copy that mujoco/__init__.py made


def make_renderer(model: mujoco.MjModel, height: int, width: int) -> Renderer:
    """Make a renderer that works on this machine.

    Convention
    ----------
    Argument order is MuJoCo's: height first. Both kinds of renderer have the methods
    ``update_scene``, ``render``, ``enable_depth_rendering``, ``enable_segmentation_rendering``
    (and ``disable_...``) and ``close``, and both work in a ``with`` block.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    height, width : int
        Size of the pictures in pixels.

    Returns
    -------
    mujoco.Renderer or RaycastRenderer
        MuJoCo's renderer where OpenGL works. Elsewhere the ray caster: depth and segmentation of
        geoms are exact, colors are flat-shaded. It leaves out what is no geom (sites, tendons,
        skins, flexes, range-finder lines); its docstring has the list.

    Raises
    ------
    TypeError, ValueError
        If `model` is no model, `height` or `width` is not a positive whole number, or larger than
        the off-screen buffer the model asks for.

    Warns
    -----
    NoOpenGLWarning
        Once per process, with the command that installs OpenGL; not in a web page, which has none.
    NotDrawnWarning
        Once per model, where the ray caster draws, with the list of what it leaves out of it.

    Notes
    -----
    A renderer belongs to the model it was made for, and to the thread: make one in every thread
    that draws. Closing a renderer takes the OpenGL context of its thread away, also from other
    libraries that draw there: the next picture of dm_control is wrong, without an error. Keep the
    renderer open as long as they draw, or let them draw in another thread.
    """
    import mujoco  # noqa: PLC0415 - the backend is chosen first, then MuJoCo reads it

    from labutils._guards import check_image_size  # noqa: PLC0415 - see above
    from labutils._scene_guards import check_model  # noqa: PLC0415 - see above
    from labutils.renderers.rays import RaycastRenderer  # noqa: PLC0415 - see above

    check_model(model)
    width, height = check_image_size(width, height)
    reason = _find_gl_problem()
    if reason is None:
        return mujoco.Renderer(model, height, width)
    if reason != _IN_A_PAGE:
        _warn_once(reason)
    return RaycastRenderer(model, height, width)


def is_gl_available() -> bool:
    """Tell whether OpenGL can draw in this process.

    Returns
    -------
    bool
        False means that `make_renderer` hands out the ray caster.
    """
    return _find_gl_problem() is None


@functools.cache
def _find_gl_problem() -> str | None:
    """Draw one pixel; return what went wrong, or None."""
    if sys.platform == "emscripten":
        return _IN_A_PAGE
    import mujoco  # noqa: PLC0415 - see make_renderer

    if os.environ.get("MUJOCO_GL", "").strip().lower() in _SWITCHED_OFF:
        return os.environ.get("LABUTILS_GL_MISSING", _USERS_CHOICE)
    try:
        model = mujoco.MjModel.from_xml_string("<mujoco/>")
        with mujoco.Renderer(model, 1, 1) as renderer:
            renderer.update_scene(mujoco.MjData(model))
            renderer.render()
    # Drivers fail in many ways (GLError, AttributeError, FatalError, OSError): whichever it is,
    # the ray caster is the answer, and the notice passes the driver's own words on.
    except Exception as error:  # noqa: BLE001
        return f"{type(error).__name__}: {error}".splitlines()[0]
    return None


@functools.cache
def _warn_once(reason: str) -> None:
    hint = _INSTALL_HINTS.get("linux" if sys.platform.startswith("linux") else sys.platform, "")
    if reason == _USERS_CHOICE:
        hint = "unset MUJOCO_GL"
    warnings.warn(
        f"OpenGL cannot draw here ({reason}). The ray caster takes over: depth and labels of "
        f"geoms are exact, colors are flat. To get OpenGL: {hint}",
        NoOpenGLWarning,
        stacklevel=3,
    )
