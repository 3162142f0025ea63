"""Files that are there as a whole or not at all."""

from __future__ import annotations

import contextlib
import uuid
from pathlib import Path


def write_in_one_step(path: str | Path, content: bytes) -> Path:
    """Write a file under another name, then give it its own: a failure leaves what was there.

    Returns the path as it came, as a `Path`; raises OSError where the file cannot be written.
    """
    path = Path(path)
    target = path.resolve()  # a link stays one, and what it points to is replaced
    # A name of its own, so that two programs that write one file do not write into one another.
    unfinished = target.with_name(f"{target.name}.{uuid.uuid4().hex}.part")
    try:
        unfinished.write_bytes(content)
        unfinished.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        raise
    return path
