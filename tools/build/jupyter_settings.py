"""Make JupyterLab open chapters as notebooks and list only what a learner works with.

The settings are the files in ``tools/build/jupyter``. They are copied into an environment, where
every JupyterLab of it reads them; what a user sets in JupyterLab goes before them. ``make`` does it
for ``.venv``, ``binder/postBuild`` for Binder: ``python -m tools.build.jupyter_settings``. Needs
nothing but the standard library.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from tools import ROOT

SOURCE = ROOT / "tools" / "build" / "jupyter"


def list_settings() -> list[Path]:
    """Return the files of settings, in a stable order."""
    return sorted(path for path in SOURCE.rglob("*.json") if path.is_file())


def install_settings(environment: Path) -> list[Path]:
    """Copy the settings into an environment.

    Parameters
    ----------
    environment : Path
        Its folder: what Python calls ``sys.prefix``.

    Returns
    -------
    list of Path
        The files that were written.

    Raises
    ------
    FileNotFoundError
        If there is no such folder.
    """
    if not environment.is_dir():
        raise FileNotFoundError(f"expected the folder of an environment, got {environment}")
    written = []
    for source in list_settings():
        target = environment / "etc" / "jupyter" / source.relative_to(SOURCE)
        target.parent.mkdir(parents=True, exist_ok=True)
        written.append(Path(shutil.copyfile(source, target)))
    return written


if __name__ == "__main__":
    for path in install_settings(Path(sys.prefix)):
        print(path)
