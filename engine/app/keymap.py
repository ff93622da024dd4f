"""The keys as the player has them: the table of keys with what his settings say instead.

One idea: a keymap answers which key does what; the rest of the game asks by an action's name.
Invariant: no key does two things at once in one mode, and every action has a key.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from difflib import get_close_matches
from string import ascii_lowercase, digits
from typing import TYPE_CHECKING

from engine.app.keys import ALWAYS, BINDINGS, SHIFTED, Binding

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

KEYS = (
    *ascii_lowercase,
    *digits,
    *",.;'/\\-=[]`",
    *("left", "right", "up", "down", "space", "return", "enter", "tab", "backspace", "escape"),
    *("page up", "page down", "home", "end", "insert", "delete"),
    *(f"f{number}" for number in range(1, 13)),
)
"""Every key that can be given to an action, as SDL names it."""
NAMES = {"page up": "PgUp", "page down": "PgDn", "return": "Enter", "escape": "Esc", "=": "+"}


class KeyTroubleError(ValueError):
    """Keys that cannot be used as they were given for `action`; the message says what would do."""

    def __init__(self, action: str, message: str) -> None:
        super().__init__(message)
        self.action = action


@dataclass(frozen=True, slots=True)
class Keymap:
    """Which key does what."""

    bindings: tuple[Binding, ...] = BINDINGS

    def binding(self, action: str) -> Binding:
        """Return an action's binding; raises KeyError for an action that does not exist."""
        for one in self.bindings:
            if one.action == action:
                return one
        raise KeyError(action)

    def has(self, action: str, key: str) -> bool:
        """Whether a key asks for an action."""
        return key in self.binding(action).keys

    def place(self, action: str, key: str) -> int | None:
        """Return which of an action's keys this is, from 0; None where it is none of them."""
        keys = self.binding(action).keys
        return keys.index(key) if key in keys else None

    def actions(self, key: str) -> Iterator[str]:
        """Yield the names of the actions that a key asks for, in whatever mode."""
        return (one.action for one in self.bindings if key in one.keys)

    def shown(self, action: str) -> str:
        """Return an action's first key as it is printed on the keyboard."""
        return named(self.binding(action).keys[0])


def named(key: str) -> str:
    """Return a key's name as it is printed on the keyboard."""
    return NAMES.get(key) or (key.upper() if len(key) == 1 else key.capitalize())


def keymap_of(given: Mapping[str, str | Sequence[str]]) -> Keymap:
    """Return the keymap with the player's own keys, by action.

    Raises KeyTroubleError for an action or a key that does not exist, for the wrong number of
    keys, and for a key that would do two things at once.
    """
    found = {one.action: one for one in BINDINGS}
    for action, keys in given.items():
        if action not in found:
            raise KeyTroubleError(action, f"there is no action {action}{_like(action, found)}")
        wanted = (keys,) if isinstance(keys, str) else tuple(keys)
        found[action] = _changed(found[action], tuple(key.lower() for key in wanted))
    _refuse_clashes(found, given)
    return Keymap(tuple(found.values()))


def _changed(one: Binding, keys: tuple[str, ...]) -> Binding:
    for key in keys:
        if key not in KEYS:
            raise KeyTroubleError(one.action, f"there is no key {key!r}{_like(key, KEYS)}")
    if one.ordered and len(keys) != len(one.keys):
        example = ", ".join(f'"{key}"' for key in one.keys)
        raise KeyTroubleError(one.action, f"{len(one.keys)} keys are needed, such as [{example}]")
    if not keys:
        raise KeyTroubleError(one.action, "at least one key is needed")
    shown = (" / " if one.ordered else ", ").join(map(named, keys))
    return replace(one, keys=keys, shown=f"Shift + {shown}" if one.when == SHIFTED else shown)


def _refuse_clashes(found: Mapping[str, Binding], given: Mapping[str, object]) -> None:
    for action in given:
        one = found[action]
        if len(set(one.keys)) < len(one.keys):
            raise KeyTroubleError(action, "one key stands here twice")
        for other in found.values():
            both = [key for key in one.keys if key in other.keys]
            if other is not one and both and _at_once(one, other):
                mend = f"give {other.action} another key too, or take another one here"
                raise KeyTroubleError(action, f"{both[0]!r} is already {other.action}; {mend}")


def _at_once(one: Binding, other: Binding) -> bool:
    """Whether two actions are listened for in one mode."""
    if SHIFTED in (one.when, other.when):
        return one.when == other.when
    return one.when == other.when or ALWAYS in (one.when, other.when)


def _like(word: str, known: Mapping[str, object] | Sequence[str]) -> str:
    close = get_close_matches(word, list(known), n=1)
    return f"; did you mean {close[0]!r}?" if close else f"; there are {', '.join(known)}"
