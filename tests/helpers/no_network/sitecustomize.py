"""Cut the network: Python loads this at start-up when its folder is on PYTHONPATH.

A chapter that opens a connection to anything but this machine fails with a clear message, so no
cell can come to depend on the network unnoticed.
"""

import ipaddress
import socket
from typing import Any

_connect = socket.socket.connect


def _connect_here(self: socket.socket, address: Any) -> None:
    if self.family in (socket.AF_INET, socket.AF_INET6):
        host = address[0]
        try:
            here = ipaddress.ip_address(host).is_loopback
        except ValueError:
            here = host == "localhost"
        if not here:
            raise OSError(f"network: a chapter must run without it, but connects to {host}")
    return _connect(self, address)


socket.socket.connect = _connect_here  # type: ignore[method-assign,assignment]  # this is the cut
