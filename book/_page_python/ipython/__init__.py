"""As much of IPython as widgets and readers ask for where no IPython runs: in the page.

The packer of the widgets calls this folder ``IPython``, a name that it may not have here: it would
hide the real one.
"""

from __future__ import annotations

from ._shell import Shell, get_ipython
from .display import display

__all__ = ["Shell", "display", "get_ipython"]
