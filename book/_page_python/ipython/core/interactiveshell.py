"""The name under which ipywidgets asks for the shell."""

from __future__ import annotations

from .._shell import Shell as InteractiveShell  # noqa: TID252 - the package has another name here

__all__ = ["InteractiveShell"]
