"""What a tree says, without where it stands.

One idea: two trees that mean the same have one text. Invariant: places never count.
"""

from __future__ import annotations

from typing import Any


def plain(node: Any) -> str:
    """Return a tree as text without its places: two trees that mean the same are equal."""
    if isinstance(node, tuple):
        return "(" + ",".join(plain(part) for part in node) + ")"
    names = getattr(type(node), "__dataclass_fields__", None)
    if names is None:
        return repr(node)
    if set(names) == {"line", "column", "start", "end"}:
        return ""
    parts = (getattr(node, name) for name in names if name != "at")
    return type(node).__name__ + plain(tuple(parts))
