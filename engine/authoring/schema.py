"""JSON Schemas of variant files and of the parts they share, for editors that complete and check.

One idea: the schema is made from the pydantic models that read the files, with what only files
have put in: a part may be a name, may `use` another, and a file that extends another may leave out
anything. Invariant: a file that loads is valid; not every valid file loads.
"""

from __future__ import annotations

from typing import Any

from engine.variant.library import PARTS
from engine.variant.spec import VariantSpec

KINDS = ("variant", *PARTS)
_DRAFT = "https://json-schema.org/draft/2020-12/schema"
_STEM = {"type": "string", "pattern": "^[a-z0-9]+([-_][a-z0-9]+)*$", "maxLength": 60}


def schema_of(kind: str) -> dict[str, Any]:
    """Return the schema of one of KINDS: of a `variant` file, or of a file of a shared part."""
    whole = VariantSpec.model_json_schema()
    parts = {part: _references(whole["properties"][part])[0] for part in PARTS}
    shapes = {name: _plain(shape) for name, shape in whole.pop("$defs").items()}
    for shape in shapes.values():
        shape.pop("required", None)
    for name in parts.values():
        shapes[name]["properties"]["use"] = {**_STEM, "description": "The part this one changes."}
    if kind != "variant":
        return _file(f"A shared {kind}", shapes[parts[kind]], shapes)
    variant = _plain(whole)
    needed = variant.pop("required")
    places = variant["properties"]
    for part, shape in parts.items():
        places[part] = {
            "description": f"A file of `{part}` by name, or what differs from one.",
            "anyOf": [_STEM, {"$ref": f"#/$defs/{shape}"}],
        }
    places["extends"] = {**_STEM, "description": "The variant this one changes."}
    variant["anyOf"] = [{"required": ["extends"]}, {"required": needed}]
    return _file("A variant of Headstring", variant, shapes)


def _file(title: str, shape: dict[str, Any], shapes: dict[str, Any]) -> dict[str, Any]:
    return {"$schema": _DRAFT, **shape, "title": title, "$defs": _reached(shape, shapes)}


def _reached(shape: dict[str, Any], shapes: dict[str, Any]) -> dict[str, Any]:
    """Return the shapes that `shape` refers to, and those that they refer to."""
    found: dict[str, Any] = {}
    waiting = _references(shape)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = shapes[name]
            waiting += _references(shapes[name])
    return dict(sorted(found.items()))


def _references(node: Any) -> list[str]:
    if isinstance(node, list):
        return [name for one in node for name in _references(one)]
    if not isinstance(node, dict):
        return []
    mine = [str(node["$ref"]).rsplit("/", 1)[1]] if "$ref" in node else []
    return mine + [name for one in node.values() for name in _references(one)]


def _plain(node: Any) -> Any:
    """Return a schema without what TOML cannot say, and without titles that say nothing."""
    if isinstance(node, list):
        return [_plain(one) for one in node]
    if not isinstance(node, dict):
        return node
    some = node.get("anyOf")
    if isinstance(some, list) and {"type": "null"} in some:
        some = [one for one in some if one != {"type": "null"}]
        rest = {key: value for key, value in node.items() if key != "anyOf"}
        node = {**rest, **some[0]} if len(some) == 1 else {**rest, "anyOf": some}
    return {
        key: _properties(value) if key == "properties" else _plain(value)
        for key, value in node.items()
        if key != "title" and not (key == "default" and value in (None, "", [], {}))
    }


def _properties(properties: dict[str, Any]) -> dict[str, Any]:
    return {key: _plain(value) for key, value in properties.items()}
