"""Write an archive whose bytes depend on its content only."""

from __future__ import annotations

import io
import zipfile
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

#: The time of every member: the earliest that the format knows.
OLDEST = (1980, 1, 1, 0, 0, 0)
_UNIX = 3  # the same on every system
_READABLE = 0o644 << 16


def make_zip(members: Iterable[tuple[str, bytes]]) -> bytes:
    """Join files in the order given.

    Nothing is compressed: what compression gives differs between versions of zlib.

    Parameters
    ----------
    members : iterable of (str, bytes)
        Path within the archive, and content.

    Returns
    -------
    bytes
        The archive: no times, no owner, one mode.
    """
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as archive:
        for name, content in members:
            member = zipfile.ZipInfo(name, OLDEST)
            member.create_system = _UNIX
            member.external_attr = _READABLE
            archive.writestr(member, content)
    return buffer.getvalue()
