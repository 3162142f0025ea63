"""A page that holds the view of one explorer and nothing else: no controls, no Python."""

from __future__ import annotations

import base64
import json
from pathlib import Path

from labutils.explorers._base import View

#: A host as small as can be: it holds the traits, and counts what a kernel would be told.
_PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>view</title>
<style>body {{ margin: 10px; background: #fff; min-height: 3000px }}
{style}</style></head>
<body><main></main><script type="module">
const traits = {traits};
const images = {images};
for (const [name, text] of Object.entries(images)) {{
  traits[name] = new DataView(Uint8Array.from(atob(text), (one) => one.charCodeAt(0)).buffer);
}}
const heard = [];
window.host = {{
  saves: 0,
  traits: () => {{
    const pictures = Object.keys(images).map((name) => [name, traits[name].byteLength]);
    return {{ ...traits, ...Object.fromEntries(pictures) }};
  }},
  get: (name) => traits[name],
  set(name, value) {{
    traits[name] = value;
    for (const [event, call] of [...heard]) if (event === `change:${{name}}`) call();
  }},
  on: (event, call) => heard.push([event, call]),
  off(event, call) {{
    const place = heard.findIndex(([name, one]) => name === event && one === call);
    if (place >= 0) heard.splice(place, 1);
  }},
  save_changes() {{ this.saves += 1; }},
  countListeners: () => heard.length,
}};
const module = new Blob([{module}], {{ type: "text/javascript" }});
const view = (await import(URL.createObjectURL(module))).default;
window.cleanUp = await view.render({{ model: host, el: document.querySelector("main") }});
</script></body></html>"""

_NOT_OURS = ("_", "layout", "comm", "tabbable", "tooltip")


def write_view_page(view: View, path: Path) -> None:
    """Write the page; scripts reach the traits as ``window.host``."""
    state = {
        name: getattr(view, name)
        for name in view.traits(sync=True)
        if not name.startswith(_NOT_OURS)
    }
    images = {name: base64.b64encode(v).decode() for name, v in state.items() if type(v) is bytes}
    others = {name: value for name, value in state.items() if name not in images}
    # "</" would end the script
    parts = {"traits": others, "images": images, "module": view._esm}
    texts = {name: json.dumps(value).replace("</", "<\\/") for name, value in parts.items()}
    path.write_text(_PAGE.format(style=view._css, **texts), encoding="utf-8")
