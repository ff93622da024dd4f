"""Choosing a game: the list, and what is set for the one that is picked.

One idea: the start screen is one value that hears keys; the screen only draws it. Invariant:
whatever is chosen can be started as it stands.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from engine.app.inputs import Input
    from engine.variant.variant import Setting, Value, Variant

LETTERS = frozenset("abcdefghijklmnopqrstuvwxyz0123456789 -")
"""What may be typed to find a game."""
NAME = "name "
"""How the row of a player's name begins; his number follows."""
LONGEST = 20
"""Letters of a name."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A game of the list; `kept` are journals of matches of it to go on with, newest first."""

    name: str
    title: str
    kept: tuple[Path, ...] = ()


@dataclass(frozen=True, slots=True)
class Chosen:
    """The game to be played."""

    name: str
    players: int | None
    settings: dict[str, Value]
    kept: Path | None
    names: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Lobby:
    """The start screen.

    `typed` narrows the list, `picked` is a place in what is left. `row` is what Left and Right
    change: 0 the list itself, then the players, their names, the settings, and the match that is
    gone on with: 0 is a new one, from 1 on those that were kept. A name is typed.
    `card` is the picked game as loaded, None where it is not loaded yet or cannot be;
    `trouble` says why.
    """

    entries: tuple[Entry, ...]
    typed: str = ""
    picked: int = 0
    row: int = 0
    players: int | None = None
    settings: dict[str, Value] = field(default_factory=dict)
    match: int = 0
    names: tuple[str, ...] = ()
    card: Variant | None = None
    trouble: str = ""
    chosen: Chosen | None = None
    left: bool = False

    @property
    def shown(self) -> tuple[Entry, ...]:
        """The games whose name or title holds every word typed; first those that begin so."""
        words = _plain(self.typed).split()
        found = [
            one
            for one in self.entries
            if all(word in _plain(f"{one.title} {one.name}") for word in words)
        ]
        sought = " ".join(words)
        return tuple(sorted(found, key=lambda one: not _plain(one.title).startswith(sought)))

    @property
    def entry(self) -> Entry | None:
        """The game picked."""
        shown = self.shown
        return shown[min(self.picked, len(shown) - 1)] if shown else None

    @property
    def rows(self) -> tuple[str, ...]:
        """What can be changed, by name, in the order of the screen; the list comes first."""
        if self.card is None or self.entry is None:
            return ("",)
        kept = ("match",) if self.entry.kept else ()
        least, most, _ = self.card.players
        many = ("players",) if least < most else ()
        count = int(self.value("players"))
        names = tuple(f"{NAME}{number}" for number in range(1, count + 1))
        return ("", *many, *names, *self.card.settings, *kept)

    @property
    def is_naming(self) -> bool:
        """Whether what is typed is a player's name."""
        return self.rows[min(self.row, len(self.rows) - 1)].startswith(NAME)

    def value(self, row: str) -> Value:
        """Return what a row says now."""
        if row == "match":
            return self.match
        if row.startswith(NAME):
            place = int(row.removeprefix(NAME)) - 1
            return self.names[place] if place < len(self.names) else ""
        if self.card is None:
            return ""
        if row == "players":
            return self.players or self.card.players[2]
        return self.settings.get(row, self.card.settings[row].default)


def _plain(text: str) -> str:
    return text.lower().replace("-", " ")


def hear(lobby: Lobby, hands: Input) -> Lobby:
    """Return the start screen after a frame's keys and wheel."""
    if lobby.is_naming and hands.typed:
        lobby = _named(lobby, f"{lobby.value(lobby.rows[lobby.row])}{hands.typed}")
    for key in hands.pressed:
        lobby = _press(lobby, key, back=hands.shift)
    return pick(lobby, lobby.picked - hands.wheel) if hands.wheel else lobby


def _named(lobby: Lobby, name: str) -> Lobby:
    """Return the start screen with a name for the player of the row that is marked."""
    place = int(lobby.rows[lobby.row].removeprefix(NAME)) - 1
    names = list(lobby.names) + [""] * (place + 1 - len(lobby.names))
    names[place] = "".join(letter for letter in name if letter.isprintable())[:LONGEST]
    return replace(lobby, names=tuple(names))


def _press(lobby: Lobby, key: str, *, back: bool) -> Lobby:
    match key:
        case "backspace" if lobby.is_naming:
            return _named(lobby, str(lobby.value(lobby.rows[lobby.row]))[:-1])
        case _ if lobby.is_naming and (key in LETTERS or key == "space"):
            return lobby
        case "up" | "down":
            return pick(lobby, lobby.picked + (1 if key == "down" else -1))
        case "page up" | "page down":
            return pick(lobby, lobby.picked + (8 if key == "page down" else -8))
        case "tab":
            return replace(lobby, row=(lobby.row + (-1 if back else 1)) % len(lobby.rows))
        case "left" | "right":
            return change(lobby, lobby.rows[lobby.row], 1 if key == "right" else -1)
        case "return" | "enter":
            return choose(lobby)
        case "escape":
            return _typed(lobby, "") if lobby.typed else replace(lobby, left=True)
        case "backspace":
            return _typed(lobby, lobby.typed[:-1])
        case "space":
            return _typed(lobby, lobby.typed + " ") if lobby.typed else lobby
        case _ if key in LETTERS:
            return _typed(lobby, lobby.typed + key)
    return lobby


def _typed(lobby: Lobby, text: str) -> Lobby:
    return _fresh(replace(lobby, typed=text, picked=0))


def pick(lobby: Lobby, place: int) -> Lobby:
    """Return the start screen with another game picked."""
    place = min(max(place, 0), max(len(lobby.shown) - 1, 0))
    return lobby if place == lobby.picked else _fresh(replace(lobby, picked=place))


def _fresh(lobby: Lobby) -> Lobby:
    """Return the start screen with nothing set yet for the game picked."""
    return replace(lobby, row=0, players=None, settings={}, match=0, card=None, trouble="")


def change(lobby: Lobby, row: str, by: int) -> Lobby:
    """Return the start screen with a row's value `by` steps further."""
    if lobby.card is None or row not in lobby.rows or not row:
        return lobby
    now = lobby.value(row)
    if row == "match" and lobby.entry is not None:
        return replace(lobby, match=(lobby.match + by) % (len(lobby.entry.kept) + 1))
    if row.startswith(NAME):
        return lobby
    if row == "players":
        least, most, _ = lobby.card.players
        return replace(lobby, players=min(max(int(now) + by, least), most))
    new = _stepped(lobby.card.settings[row], now, by)
    return replace(lobby, settings={**lobby.settings, row: new})


def _stepped(setting: Setting, now: Value, by: int) -> Value:
    if isinstance(setting.default, bool):
        return not now
    if setting.choices:
        place = setting.choices.index(now) if now in setting.choices else 0
        return setting.choices[(place + by) % len(setting.choices)]
    if isinstance(now, int):
        least = 0 if setting.least is None else setting.least
        return (
            max(now + by, least)
            if setting.most is None
            else min(max(now + by, least), setting.most)
        )
    return now


def choose(lobby: Lobby) -> Lobby:
    """Return the start screen with the game picked chosen, where it can be played."""
    if lobby.entry is None or lobby.card is None:
        return lobby
    kept = lobby.entry.kept[lobby.match - 1] if lobby.match else None
    names = tuple(name.strip() for name in lobby.names[: int(lobby.value("players"))])
    chosen = Chosen(lobby.entry.name, lobby.players, dict(lobby.settings), kept, names)
    return replace(lobby, chosen=chosen)


def open_lobby(entries: Iterable[Entry], first: str = "", names: tuple[str, ...] = ()) -> Lobby:
    """Return the start screen at the game named `first`, else at the first of the list.

    `names` are the players', as far as they are known.
    """
    known = tuple(entries)
    place = next((k for k, one in enumerate(known) if one.name == first), 0)
    return Lobby(known, picked=place, names=names)


__all__ = ["Chosen", "Entry", "Lobby", "change", "choose", "hear", "open_lobby", "pick"]
