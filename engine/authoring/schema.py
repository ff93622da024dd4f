"""JSON Schemas of variant files and of the parts they share, for editors that complete and check.

One idea: the schema is made from the classes that read the files, with what only files have put in:
a part may be a name, may `use` another, and a file that extends another may leave out anything.
Invariant: a file that loads is valid; not every valid file loads.
"""

from __future__ import annotations

import types
import typing
from inspect import cleandoc
from typing import Annotated, Any, Literal

from engine.variant.library import PARTS
from engine.variant.shape import Bounds, Key, Shape, Told
from engine.variant.spec import VariantSpec

KINDS = ("variant", *PARTS)
_DRAFT = "https://json-schema.org/draft/2020-12/schema"
_STEM = {"type": "string", "pattern": "^[a-z0-9]+([-_][a-z0-9]+)*$", "maxLength": 60}


def schema_of(kind: str) -> dict[str, Any]:
    """Return the schema of one of KINDS: of a `variant` file, or of a file of a shared part."""
    shapes: dict[str, Any] = {}
    _told(VariantSpec, shapes)
    variant = shapes.pop(VariantSpec.__name__)
    parts = {part: _references(variant["properties"][part])[0] for part in PARTS}
    for shape in shapes.values():
        shape.pop("required", None)
    for name in parts.values():
        shapes[name]["properties"]["use"] = {**_STEM, "description": "The part this one changes."}
    if kind != "variant":
        return _file(f"A shared {kind}", shapes[parts[kind]], shapes)
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


_WORDS = {bool: "boolean", int: "integer", float: "number", str: "string"}
_BOUNDS = {"ge": "minimum", "gt": "exclusiveMinimum", "le": "maximum"}
_LENGTHS = {"string": "Length", "array": "Items", "object": "Properties"}


def _told(annotation: Any, shapes: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of an annotation; the shapes that it holds are put among `shapes`."""
    if annotation in _WORDS:
        return {"type": _WORDS[annotation]}
    origin, inner = typing.get_origin(annotation), typing.get_args(annotation)
    if origin is Annotated:
        return _told_with_marks(inner[0], inner[1:], shapes)
    if origin in (typing.Union, types.UnionType):
        some = [_told(one, shapes) for one in inner if one is not types.NoneType]
        return some[0] if len(some) == 1 else {"anyOf": some}
    if origin is Literal:
        kind = {"type": _WORDS[type(inner[0])]}
        return {"const": inner[0], **kind} if len(inner) == 1 else {"enum": list(inner), **kind}
    if origin is list:
        return {"items": _told(inner[0], shapes), "type": "array"}
    if origin is dict:
        name, kept = (_told(one, shapes) for one in inner)
        names = {"propertyNames": name} if name != {"type": "string"} else {}
        return {"additionalProperties": kept, **names, "type": "object"}
    return _told_shape(annotation, shapes)


def _told_with_marks(
    annotation: Any, marks: tuple[object, ...], shapes: dict[str, Any]
) -> dict[str, Any]:
    own = [dict(mark.schema) for mark in marks if isinstance(mark, Told)]
    schema = own[-1] if own else _told(annotation, shapes)
    for mark in marks:
        for bound, value in mark.given().items() if isinstance(mark, Bounds) else ():
            key = _BOUNDS.get(bound) or bound[:3] + _LENGTHS[schema["type"]]
            schema = {**schema, key: value}
    return schema


def _told_shape(shape: type[Shape], shapes: dict[str, Any]) -> dict[str, Any]:
    reference = {"$ref": f"#/$defs/{shape.__name__}"}
    if shape.__name__ not in shapes:
        shapes[shape.__name__] = {}
        keys = shape.model_fields.items()
        shapes[shape.__name__] |= {
            "additionalProperties": False,
            "description": cleandoc(shape.__doc__ or ""),
            "properties": {name: _told_key(key, shapes) for name, key in keys},
            "required": [name for name, key in keys if key.required],
            "type": "object",
        }
    return reference


def _told_key(key: Key, shapes: dict[str, Any]) -> dict[str, Any]:
    schema = _told(key.annotation, shapes)
    if key.required or isinstance(key.default, Shape) or key.default in (None, "", [], {}):
        return schema
    default = list(key.default) if isinstance(key.default, tuple) else key.default
    return {**schema, "default": default}
