"""Tables of a file as plain classes, and the schema by which pydantic's core reads them.

One idea: a class says by its annotations which keys a table has; the schema is made from them when
a first file is read. Pydantic's own models take four times as long to set up as the longest file
takes to check, and a check is a process of its own.
Invariant: nothing unknown gets through, no value is silently converted, nothing read ever changes.
"""

from __future__ import annotations

import types
import typing
from dataclasses import dataclass
from functools import cache
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Literal,
    Self,
    TypeVar,
    dataclass_transform,
)

from pydantic_core import SchemaValidator

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

_Kind = TypeVar("_Kind")


@dataclass(frozen=True, slots=True, eq=False)
class Before:
    """A function that sees a value as it is written, and returns what is read instead."""

    function: Callable[[object], object]


@dataclass(frozen=True, slots=True, eq=False)
class After:
    """A function that sees a value once it has the right type, and returns what is kept."""

    function: Callable[[Any], object]


@dataclass(frozen=True, slots=True, eq=False)
class Bounds:
    """The bounds of a number, or of the length of a text, a list or a table."""

    ge: float | None = None
    gt: float | None = None
    le: float | None = None
    min_length: int | None = None
    max_length: int | None = None

    def given(self) -> dict[str, float]:
        """Return those bounds that there are, by name."""
        every = {key: getattr(self, key) for key in self.__slots__}
        return {key: value for key, value in every.items() if value is not None}


@dataclass(frozen=True, slots=True, eq=False)
class Told:
    """What an editor is told of a value, as JSON Schema; nobody else reads it."""

    schema: Mapping[str, Any]


@dataclass(frozen=True, slots=True, eq=False)
class Key:
    """A key of a table: what it may hold, and what is taken where it is left out."""

    annotation: Any
    required: bool
    default: Any = None


@dataclass_transform(frozen_default=True, kw_only_default=True)
class Shape:
    """A table of a file; what it holds are the attributes that its class annotates."""

    __slots__ = (
        "__dict__",
        "__pydantic_extra__",
        "__pydantic_fields_set__",
        "__pydantic_private__",
    )
    __pydantic_fields_set__: set[str]
    model_fields: ClassVar[dict[str, Key]] = {}

    def __init_subclass__(cls) -> None:
        keys: dict[str, Key] = {}
        for base in reversed(cls.__bases__):
            keys |= getattr(base, "model_fields", {})
        for name, annotation in cls.__annotations__.items():
            required = name not in cls.__dict__
            keys[name] = Key(annotation, required, cls.__dict__.get(name))
        cls.model_fields = keys

    def __init__(self, **said: Any) -> None:
        keys = type(self).model_fields
        missing = [name for name, key in keys.items() if key.required and name not in said]
        if missing or not said.keys() <= keys.keys():
            raise TypeError(f"{type(self).__name__} is made of {list(keys)}, not of {list(said)}")
        held = {name: said.get(name, key.default) for name, key in keys.items()}
        object.__setattr__(self, "__dict__", held)
        object.__setattr__(self, "__pydantic_fields_set__", set(said))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__}.{name} never changes")

    def __repr__(self) -> str:
        held = ", ".join(f"{key}={value!r}" for key, value in self.held().items())
        return f"{type(self).__name__}({held})"

    def held(self) -> dict[str, Any]:
        """Return all values by key."""
        return dict(self.__dict__)

    def said(self) -> dict[str, Any]:
        """Return the values of those keys that the file holds."""
        return {key: self.__dict__[key] for key in self.__pydantic_fields_set__}

    def changed(self, **said: Any) -> Self:
        """Return this with other values, unread."""
        return type(self)(**(self.said() | said))

    @classmethod
    def read(cls, plain: object) -> Self:
        """Return what a plain tree holds; raises pydantic_core.ValidationError."""
        shape: Any = cls
        read: Self = _validator(shape).validate_python(plain)
        return read


def empty(kind: Callable[[], _Kind]) -> _Kind:
    """Return the list or table that is taken where none is written."""
    return kind()


@cache
def _validator(shape: Any) -> SchemaValidator:
    return SchemaValidator(_of_shape(shape))


_STRICT: Any = {"strict": True, "extra_fields_behavior": "forbid", "frozen": True}


def _of_shape(shape: type[Shape]) -> Any:
    fields = {name: _of_key(key) for name, key in shape.model_fields.items()}
    inner = {"type": "model-fields", "fields": fields, "model_name": shape.__name__}
    return {"type": "model", "cls": shape, "schema": inner, "config": _STRICT}


def _of_key(key: Key) -> Any:
    schema = _of(key.annotation)
    if not key.required:
        schema = {"type": "default", "schema": schema, "default": key.default}
    return {"type": "model-field", "schema": schema}


_PLAIN: dict[object, str] = {bool: "bool", int: "int", float: "float", str: "str"}


def _of(annotation: Any) -> Any:
    """Return the core's schema of an annotation."""
    if annotation in _PLAIN:
        return {"type": _PLAIN[annotation]}
    origin, inner = typing.get_origin(annotation), typing.get_args(annotation)
    if origin is Annotated:
        schema = _of(inner[0])
        for mark in inner[1:]:
            schema = _marked(schema, mark)
        return schema
    if origin in (typing.Union, types.UnionType):
        return _of_union(inner)
    if origin is Literal:
        return {"type": "literal", "expected": list(inner)}
    if origin is list:
        return {"type": "list", "items_schema": _of(inner[0])}
    if origin is dict:
        return {"type": "dict", "keys_schema": _of(inner[0]), "values_schema": _of(inner[1])}
    if origin is tuple:
        return {"type": "tuple", "items_schema": [_of(one) for one in inner]}
    if issubclass(annotation, Shape):
        return _of_shape(annotation)
    return {"type": "is-instance", "cls": annotation}


def _of_union(inner: tuple[Any, ...]) -> Any:
    some = [_of(one) for one in inner if one is not types.NoneType]
    schema = some[0] if len(some) == 1 else {"type": "union", "choices": some}
    return {"type": "nullable", "schema": schema} if types.NoneType in inner else schema


def _marked(schema: Any, mark: object) -> Any:
    """Return a schema with what a mark on its annotation asks for."""
    match mark:
        case Before(function):
            kind, call = "function-before", function
        case After(function):
            kind, call = "function-after", function
        case Bounds():
            return schema | mark.given()
        case _:
            return schema
    return {"type": kind, "function": {"type": "no-info", "function": call}, "schema": schema}
