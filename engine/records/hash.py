"""The hash that ties a played record to the physics it was played with.

One idea: everything a stroke depends on is in the World, and a World is plain values.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from hashlib import sha256
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.physics.world import World


def physics_hash(world: World) -> str:
    """Return 16 hex digits made of table, cloth, balls and models; marks on the cloth apart."""
    digest = sha256()
    for piece in _spell(world):
        digest.update(piece.encode())
    return digest.hexdigest()[:16]


def _unset(value: object) -> set[str]:
    """Return the parts that a table without them does not mention."""
    return {"pins"} if getattr(value, "pins", None) == () else set()


def _spell(value: object) -> Iterator[str]:
    if is_dataclass(value):
        yield type(value).__name__
        for one in fields(value):
            if one.name not in {"spots", "lines", "zones", "rail_width", "value"} | _unset(value):
                yield one.name
                yield from _spell(getattr(value, one.name))
    elif isinstance(value, tuple):
        yield f"({len(value)}"
        for child in value:
            yield from _spell(child)
    else:
        yield f"{value!r};"
