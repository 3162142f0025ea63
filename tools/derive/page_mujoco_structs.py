"""What the structs of MuJoCo hold: read from the Python package, cut to what the page's engine has.

A field is written as one short text: ``f8 ngeom 3`` is an array of float64 with these sizes, ``f``,
``i``, ``b`` and ``s`` are a float, a whole number, a truth and a text, ``MjOption`` is another
struct, and ``mjtGeom`` an enum.
"""

from __future__ import annotations

import re
from typing import Any

import mujoco
from mujoco.introspect import ast_nodes, enums, structs

#: The structs that a reader may meet, by their names in C.
STRUCTS = (
    "mjModel",
    "mjData",
    "mjOption",
    "mjStatistic",
    "mjVisual",
    "mjContact",
    "mjWarningStat",
    "mjTimerStat",
    "mjSolverStat",
    "mjvCamera",
    "mjvOption",
    "mjvPerturb",
    "mjvGeom",
    "mjvLight",
    "mjvGLCamera",
    "mjvScene",
    "mjsBody",
    "mjsFrame",
    "mjsJoint",
    "mjsGeom",
    "mjsSite",
    "mjsCamera",
    "mjsLight",
    "mjsTexture",
    "mjsMaterial",
    "mjsMesh",
    "mjsActuator",
    "mjsSensor",
    "mjsKey",
    "mjsNumeric",
)
DTYPES = {
    "mjtNum": "f8",
    "double": "f8",
    "float": "f4",
    "int": "i4",
    "mjtByte": "u1",
    "mjtBool": "?",
    "mjtSize": "i8",
    "uintptr_t": "u8",
    "char": "i1",
}
#: Arrays of characters that the package hands out as bytes.
TEXTS = ("names", "paths", "text_data")
#: MuJoCo's types of single numbers; an enum keeps its name.
SCALARS = {
    "mjtNum": "f",
    "double": "f",
    "float": "f",
    "mjtBool": "b",
    "int": "i",
    "mjtByte": "i",
    "mjtSize": "i",
    "size_t": "i",
    "uint64_t": "i",
}
#: Structs without a name of their own, and what the page's engine calls them.
VISUAL_PARTS = {
    name: f"MjVisual{name.title()}"
    for name in ("global", "quality", "headlight", "map", "scale", "rgba")
}

#: What the page's engine has, but tells wrong numbers of.
BROKEN = {"MjModel": {"tex_adr"}}

Interfaces = dict[str, list[str]]


def read_interfaces(declarations: str) -> Interfaces:
    """Read the properties of every class of the page's engine from its TypeScript file."""
    found = {}
    for name, body in re.findall(
        r"^export interface (\w+) extends ClassHandle \{\n(.*?)^\}",
        declarations,
        re.MULTILINE | re.DOTALL,
    ):
        lines = re.findall(r"^  (?:readonly |get )?(\w+)(?:\(\))?: [^(\n]*;$", body, re.MULTILINE)
        found[name] = [line for line in lines if line not in BROKEN.get(name, ())]
    return found


def derive_structs(interfaces: Interfaces) -> dict[str, dict[str, str]]:
    """Return the fields of every struct, by struct and name, in the order of the alphabet."""
    table: dict[str, dict[str, str]] = {}
    for c_name in STRUCTS:
        name = c_name.replace("mj", "Mj", 1)
        owner = getattr(mujoco, name)
        for field in structs.STRUCTS[c_name].fields:
            if isinstance(field.type, ast_nodes.AnonymousStructDecl):
                part = VISUAL_PARTS[field.name]
                table[part] = _describe_all(field.type.fields, interfaces[part], None)
        table[name] = _describe_all(structs.STRUCTS[c_name].fields, interfaces[name], owner)
    return {name: dict(sorted(fields.items())) for name, fields in sorted(table.items())}


def list_absent(interfaces: Interfaces) -> dict[str, list[str]]:
    """List what the Python package has of models and states, and the page's engine has not."""
    absent = {}
    for c_name in ("mjModel", "mjData"):
        name = c_name.replace("mj", "Mj", 1)
        fields = {field.name for field in structs.STRUCTS[c_name].fields}
        absent[name] = sorted((fields & set(dir(getattr(mujoco, name)))) - set(interfaces[name]))
    return absent


def _describe_all(fields: Any, known: list[str], owner: type | None) -> dict[str, str]:
    found = {}
    for field in fields:
        if field.name not in known or not (owner is None or _is_public(owner, field.name)):
            continue
        if text := describe(field):
            found[field.name] = text
    return found


def _is_public(owner: type, name: str) -> bool:
    return hasattr(owner, name) or hasattr(owner, f"{name}_")


def describe(field: Any) -> str:
    """Write a field as one short text; empty for what no reader needs."""
    kind = field.type
    if isinstance(kind, ast_nodes.AnonymousStructDecl):
        return VISUAL_PARTS[field.name]
    if isinstance(kind, ast_nodes.ArrayType):
        is_text = str(kind.inner_type) == "char"
        return "" if is_text else _describe_array(kind.inner_type, kind.extents)
    if isinstance(kind, ast_nodes.PointerType):
        is_text = str(kind.inner_type) == "mjString"
        if is_text:
            return "s"
        text = _describe_array(kind.inner_type, field.array_extent)
        return text.replace("i1", "bytes") if field.name in TEXTS else text
    return _describe_single(kind.name)


def _describe_single(name: str) -> str:
    if name in STRUCTS:
        return name.replace("mj", "Mj", 1)
    return name if name in enums.ENUMS else SCALARS.get(name, "")


def _describe_array(inner: Any, extents: Any) -> str:
    name = str(inner).removeprefix("const ")
    if extents is None:
        return ""
    if name in structs.STRUCTS:
        return f"{name.replace('mj', 'Mj', 1)} *"
    if name not in DTYPES:
        return ""
    return " ".join([DTYPES[name], *(str(_resolve(extent)) for extent in extents)])


def _resolve(extent: Any) -> str | int:
    """Replace the name of a constant by its number; sizes of a model keep their names."""
    text = str(extent)
    if not text.startswith("mj"):
        return text
    if isinstance(number := getattr(mujoco, text, None), int):
        return number
    for enum in enums.ENUMS.values():
        if text in enum.values:
            return int(enum.values[text])
    raise ValueError(f"expected the name of a constant of MuJoCo, got {text}")


def derive_constants(declarations: str) -> dict[str, str]:
    """Return the constants that both have: f for a float, i for a whole number, s for texts."""
    kinds: dict[type, str] = {float: "f", int: "i"}
    theirs = set(re.findall(r"^  (mj[A-Z_]+): ", declarations, re.MULTILINE))
    return {
        name: kinds.get(type(getattr(mujoco, name)), "s")
        for name in sorted(theirs & set(vars(mujoco)))
    }


def derive_enums(declarations: str) -> list[str]:
    """List the enums that both have."""
    theirs = set(re.findall(r"^  (mj[a-z]+[A-Z]\w+): \{", declarations, re.MULTILINE))
    return sorted(theirs & set(vars(mujoco)))
