"""Record a walk once, and read it from the disk from then on."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

import mujoco
import numpy as np

from labutils.recordings import NOISE, Recording, load_recording
from labutils.room.recorder import Recorder
from labutils.room.scene import make_room

#: Where walks are kept, beside the package in the repository.
CACHE = Path(__file__).resolve().parents[2] / "_build" / "recordings"


def record_once(
    name: str = "room",
    *,
    frames_per_second: float = 10.0,
    width: int = 640,
    noise: float = NOISE,
    seed: int = 0,
    progress: bool = True,
    cache: Path = CACHE,
) -> Recording:
    """Record the walk through a room, with a progress bar, or read what was recorded before.

    Parameters
    ----------
    name : str
        ``"room"`` or ``"held_out"``.
    frames_per_second : float
        Keyframes per second.
    width : int
        Of the pictures in pixels; their sides are 4 to 3.
    noise, seed
        As in `load_recording`; they change nothing on the disk.
    progress : bool
        Show progress bars.
    cache : Path
        Folder that holds all walks. It may be deleted at any time.

    Returns
    -------
    Recording
        Keyframes with their truth, and the inertial sensor; no stereo pairs.

    Raises
    ------
    ValueError
        If there is no room of that name.
    """
    settings = f"{name}-{frames_per_second:g}fps-{width}px-{_hash_sources()}"
    folder = cache / settings
    if not folder.is_dir():
        model, data = make_room(name)
        # Under another name until all of it is there: what was interrupted is never read.
        unfinished = folder.with_name(f"{settings}.part")
        shutil.rmtree(unfinished, ignore_errors=True)
        unfinished.parent.mkdir(parents=True, exist_ok=True)
        recorder = Recorder(model, data, unfinished, progress=progress)
        recorder.record_walk(frames_per_second=frames_per_second, width=width)
        recorder.finish()
        unfinished.rename(folder)
    return load_recording(folder, noise=noise, seed=seed)


def _hash_sources() -> str:
    """Name the code that records and the versions it stands on: other code, another recording."""
    digest = hashlib.sha256(f"{mujoco.__version__} {np.__version__}".encode())
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:12]
