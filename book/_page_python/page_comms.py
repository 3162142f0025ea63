"""Let widgets of Python and of the page hear each other: comms, as Jupyter calls them.

The worker of the page calls `connect` once, with what posts a message, and `deliver` for every
message that comes. It needs nothing of the browser, so tests run it anywhere. A message is JSON,
with its binary buffers beside it::

    {"type": "comm_open" | "comm_msg" | "comm_close", "comm_id", "target_name", "data", "metadata"}

Two more go to the page only: ``comm_said`` has in its data the outputs of a callback, and
``comm_done`` the ``id`` of a message that has been dealt with; until it comes, the page holds back
what would only be overwritten.
"""

from __future__ import annotations

import json
import numbers
import os
from collections.abc import Iterable
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any

# There is one page: it need not hear its own changes again. Read when ipywidgets is imported.
os.environ["JUPYTER_WIDGETS_ECHO"] = "0"

import comm
from comm.base_comm import BaseComm, CommManager

from page_outputs import CellOutputs, redirect

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from types import TracebackType

    Buffers = Sequence[bytes | bytearray | memoryview]
    Post = Callable[[str, list[bytes]], object]

_manager = CommManager()
_posts: list[Post] = []


def connect(post: Post) -> None:
    """Make all widgets of Python talk to the page from now on.

    Parameters
    ----------
    post : callable
        Takes a message as JSON and a list of its buffers.
    """
    _posts[:] = [post]
    comm.create_comm = PageComm
    comm.get_comm_manager = lambda: _manager
    import ipywidgets  # noqa: PLC0415 - after the comms are ours

    ipywidgets.Output.__enter__ = _enter
    ipywidgets.Output.__exit__ = _exit


def deliver(message: str, buffers: Any = ()) -> None:
    """Hand a message of the page to the widget that it is for.

    What its callbacks print, show or raise goes back to the page as ``comm_said``.
    """
    content = json.loads(message)
    told = {
        "content": content,
        "metadata": content.get("metadata", {}),
        "buffers": [_from_page(one) for one in _from_page(buffers)],
    }
    handlers = {
        "comm_open": _manager.comm_open,
        "comm_msg": _manager.comm_msg,
        "comm_close": _manager.comm_close,
    }
    said = CellOutputs()
    try:
        if content["type"] == "comm_open" or content["comm_id"] in _manager.comms:
            with redirect(said):
                handlers[content["type"]](None, "", told)  # type: ignore[arg-type]  # no stream
        if said.outputs:
            _post({**_head(content, "comm_said"), "data": {"outputs": said.outputs}})
    finally:
        _post({**_head(content, "comm_done"), "data": {"id": content.get("id")}})


def _from_page(thing: Any) -> Any:
    """Return what Pyodide hands over of JavaScript, arrays and buffers, as Python's own."""
    return thing.to_py() if hasattr(thing, "to_py") else thing


class PageComm(BaseComm):
    """One end of a comm; the other is in the page."""

    def publish_msg(
        self,
        msg_type: str,
        data: dict[str, Any] | None = None,
        metadata: dict[str, Any] | None = None,
        buffers: Any = None,
        **keys: Any,
    ) -> None:
        """Post one message."""
        message = {
            "type": msg_type,
            "comm_id": self.comm_id,
            "data": data or {},
            "metadata": metadata or {},
        }
        if msg_type == "comm_open":
            message["target_name"] = keys["target_name"]
        _post(message, buffers or ())


def _head(content: dict[str, Any], kind: str) -> dict[str, Any]:
    return {"type": kind, "comm_id": content["comm_id"]}


def _post(message: dict[str, Any], buffers: Buffers = ()) -> None:
    text = json.dumps(message, default=_make_plain, allow_nan=False)
    for post in _posts:
        post(text, [bytes(buffer) for buffer in buffers])


def _make_plain(value: Any) -> Any:
    """Make of NumPy's numbers and arrays what JSON knows."""
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        return float(value)
    if isinstance(value, Iterable):
        return list(value)
    raise TypeError(f"a widget's value: expected what JSON can hold, got {type(value).__name__}")


# Output widgets. In Jupyter the page catches what belongs to one; here Python can do it itself.

_entered: list[tuple[ExitStack, CellOutputs]] = []


def _enter(widget: Any) -> None:
    kept = CellOutputs(widget.outputs)
    stack = ExitStack()
    stack.enter_context(redirect(kept))
    _entered.append((stack, kept))


def _exit(
    widget: Any,
    _kind: type[BaseException] | None,
    error: BaseException | None,
    _trace: TracebackType | None,
) -> bool:
    """Show what was caught; an error is shown too, and ends there, as in Jupyter."""
    from IPython import get_ipython  # noqa: PLC0415 - the page's, see ipython/

    stack, kept = _entered.pop()
    with stack:
        if error is not None:
            get_ipython().showtraceback((type(error), error, error.__traceback__))
    widget.outputs = tuple(kept.outputs)
    return isinstance(error, Exception)
