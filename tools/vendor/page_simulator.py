"""Collect what the simulator of the pages consists of: MuJoCo's engine, a package, a scene.

The engine is MuJoCo's own WebAssembly build, from npm (see ``npm.py``). The package ``mujoco`` that
Python in the page imports is ``book/_page_mujoco``. It has to know what the real package looks
like: a build fails where that was derived from other versions (``tools/derive/page_mujoco.py``).

``tools/vendor/pack_python.py`` calls this, and makes of it what the pages load.
"""

from __future__ import annotations

import importlib.metadata

from tools import ROOT
from tools.derive import page_mujoco
from tools.derive.page_mujoco_scene import make_page_scene
from tools.stable_zip import make_zip
from tools.vendor import npm

SOURCES = ROOT / "book" / "_page_mujoco"
SCENE = ROOT / "assets" / "humanoid-camera.xml"
TEXTURES = ROOT / "assets" / "textures"
ENGINE = ("mujoco.js", "mujoco.wasm")

LICENSES = "mujoco-licenses.txt"
NOTICE = f"""MuJoCo {{version}}, built for WebAssembly: Apache License 2.0
    Its text is {LICENSES} beside this file. Unchanged; its source is at https://github.com/google-deepmind/mujoco/tree/{{version}}
"""


def make_simulator_assets() -> dict[str, bytes]:
    """Return the content of every asset of the simulator, by its name.

    Returns
    -------
    dict
        ``vendor/mujoco.js`` and ``vendor/mujoco.wasm``, the engine; ``simulator.js``, which starts
        it; ``simulator.zip``, to be unpacked where Python in the page looks for packages.

    Raises
    ------
    tools.vendor.npm.VendorError
        If the engine is not there and npm cannot be reached, or what was derived no longer holds.
    """
    npm.install()
    if problem := page_mujoco.find_difference():
        raise npm.VendorError(problem)
    folder = npm.get_package(page_mujoco.PACKAGE)
    engine = {f"vendor/{name}": (folder / name).read_bytes() for name in ENGINE}
    script = (SOURCES / "bridge.js").read_bytes()
    return {**engine, "simulator.js": script, "simulator.zip": make_zip(list_package())}


def list_package() -> list[tuple[str, bytes]]:
    """List the files of the package and of the scene, by their places beside ``labutils``."""
    package = SOURCES / "mujoco"
    paths = [*package.rglob("*.py"), *package.glob("*.json")]
    files = {path.relative_to(SOURCES).as_posix(): path.read_bytes() for path in paths}
    files |= {f"assets/textures/{one.name}": one.read_bytes() for one in TEXTURES.glob("*.png")}
    files[f"assets/{SCENE.name}"] = make_page_scene(SCENE).encode()
    return sorted(files.items())


def make_notice() -> str:
    """Return the lines about the engine for the notices of the site."""
    return NOTICE.format(version=read_version())


def read_version() -> str:
    """Return the version of the engine."""
    version: str = npm.read_lock()[f"node_modules/{page_mujoco.PACKAGE}"]["version"]
    return version


def read_licenses() -> str:
    """Join the license of MuJoCo and those of what it contains: npm's package brings no text."""
    files = importlib.metadata.files("mujoco") or []
    texts = [file for file in files if file.parent.name == "licenses"]
    return "\n".join(
        f"{file.name}\n{'=' * len(file.name)}\n{file.read_text().strip()}\n"
        for file in sorted(texts)
    )
