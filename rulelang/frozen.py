"""Frozen, slotted values that cost little to define.

One idea: `dataclass(frozen=True, slots=True)` writes and compiles eight functions for every class,
a third of a millisecond each time a process starts; here only the constructor is compiled, when the
first value is made, and all classes share the rest.
Invariant: a value behaves as a frozen slotted dataclass does, in comparing, hashing, printing,
copying and matching; `dataclasses.replace`, `fields` and `asdict` know it.
"""

from __future__ import annotations

from dataclasses import MISSING, FrozenInstanceError, dataclass, field, fields
from operator import attrgetter
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, dataclass_transform

if TYPE_CHECKING:
    from collections.abc import Callable

_Class = TypeVar("_Class")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def value(cls: type[_Class]) -> type[_Class]:
    """Make a class of annotated attributes into a class of values."""
    cls.__doc__ = cls.__doc__ or cls.__name__
    made: Any = dataclass(init=False, repr=False, eq=False, slots=True)(cls)
    made.__parts__ = _parts([one.name for one in fields(made) if one.compare])
    made.__init__ = _first(made)
    for name, shared in _SHARED.items():
        setattr(made, name, shared)
    return made  # type: ignore[no-any-return]


def _first(cls: Any) -> Callable[..., None]:
    """Return a constructor that compiles the true one when the first value is made."""

    def first(self: Any, *said: Any, **named: Any) -> None:
        cls.__init__ = _constructor(cls)
        cls.__init__(self, *said, **named)

    return first


def _constructor(cls: Any) -> Callable[..., None]:
    space: dict[str, Any] = {"_set": object.__setattr__, "_closed": cls, "_open": _twin(cls)}
    heads, lines = ["self"], [" _set(self, '__class__', _open)"]
    for one in fields(cls):
        name, said = one.name, one.name
        if one.default_factory is not MISSING:
            space[f"_make_{name}"] = one.default_factory
            heads.append(f"{name}=_set")
            said = f"_make_{name}() if {name} is _set else {name}"
        elif one.default is not MISSING:
            space[f"_else_{name}"] = one.default
            heads.append(f"{name}=_else_{name}")
        else:
            heads.append(name)
        lines.append(f" self.{name} = {said}")
    lines.append(" self.__class__ = _closed")
    if hasattr(cls, "__post_init__"):
        lines.append(" self.__post_init__()")
    code = f"def __init__({', '.join(heads)}):\n" + "\n".join(lines)
    exec(code, space)  # noqa: S102 - nothing but the names of the attributes is in it
    made: Callable[..., None] = space["__init__"]
    return made


def _twin(cls: Any) -> type:
    """Return a class of the same slots whose attributes may be set.

    A value is one of these while it is made: each attribute costs a third of what it does to set
    it behind the back of a class that forbids it.
    """
    return type(
        cls.__name__, cls.__bases__, {"__slots__": cls.__slots__, "__setattr__": object.__setattr__}
    )


def _parts(names: list[str]) -> Callable[[Any], tuple[Any, ...]]:
    """Return what takes those attributes out of a value that count when it is compared."""
    if len(names) > 1:
        return attrgetter(*names)
    if not names:
        return lambda _one: ()
    only = attrgetter(names[0])
    return lambda one: (only(one),)


def _equal(self: Any, other: object) -> Any:
    parts: Any = self.__class__.__parts__
    if other.__class__ is not self.__class__:
        return NotImplemented
    return parts(self) == parts(other)


def _hash(self: Any) -> int:
    return hash(self.__class__.__parts__(self))


def _repr(self: Any) -> str:
    told = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in fields(self) if f.repr)
    return f"{self.__class__.__qualname__}({told})"


def _never_set(_self: Any, name: str, _value: object) -> NoReturn:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _never_deleted(_self: Any, name: str) -> NoReturn:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: Any) -> list[Any]:
    return [getattr(self, one.name) for one in fields(self)]


def _with_state(self: Any, state: list[Any]) -> None:
    for one, held in zip(fields(self), state, strict=True):
        object.__setattr__(self, one.name, held)


_SHARED: dict[str, Callable[..., Any]] = {
    "__eq__": _equal,
    "__hash__": _hash,
    "__repr__": _repr,
    "__setattr__": _never_set,
    "__delattr__": _never_deleted,
    "__getstate__": _state,
    "__setstate__": _with_state,
}
