"""The events of a shot record as text: `cue hits 8`, `8 pocketed foot-left at 1.2 s`.

One idea: one table of sentence patterns reads and writes every event.
Invariant: format and parse are each other's inverse; one space between words.
"""

from __future__ import annotations

import re
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

from rulelang.events import (
    BallsHit,
    CushionHit,
    CushionLeft,
    Event,
    FootLifted,
    JawHit,
    JumpedOver,
    LeftTable,
    LineCrossed,
    OutsideHit,
    PinLeaned,
    PinToppled,
    PinTouched,
    PlayedTooSoon,
    PlayerTouched,
    Pocketed,
    Rebounded,
    Settled,
    StrokeOmitted,
    TimeCalled,
    TipFollowed,
    TipHitAgain,
    ZoneEntered,
    ZoneLeft,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from rulelang.vocabulary import Vocabulary

NAME = r"[a-z0-9]+(?:-[a-z0-9]+)*"
NUMBER = r"[0-9]+(?:\.[0-9]+)?"

# The order decides: words of the language come before names that might look like them.
SENTENCES: tuple[tuple[type[Event], str], ...] = (
    (FootLifted, "foot off floor"),
    (PlayedTooSoon, "balls moving"),
    (StrokeOmitted, "no stroke"),
    (TimeCalled, "time called"),
    (TipHitAgain, "tip hits {ball} again"),
    (TipFollowed, "tip follows {ball}"),
    (PlayerTouched, "player touches {ball}"),
    (CushionHit, "{ball} hits cushion {cushion}"),
    (JawHit, "{ball} hits jaw {pocket}"),
    (OutsideHit, "{ball} hits outside"),
    (CushionLeft, "{ball} leaves cushion {cushion}"),
    (LeftTable, "{ball} leaves table"),
    (Pocketed, "{ball} pocketed {pocket}"),
    (Rebounded, "{ball} rebounds from {pocket}"),
    (Settled, "{ball} settles {pocket} after {delay} s"),
    (LineCrossed, "{ball} crosses {line}"),
    (ZoneEntered, "{ball} enters {zone}"),
    (ZoneLeft, "{ball} leaves {zone}"),
    (JumpedOver, "{ball} jumps over {other}"),
    (PinToppled, "{bodies} topple {pin}"),
    (PinToppled, "{bodies} topples {pin}"),
    (PinTouched, "{body} touches {pin}"),
    (PinLeaned, "{pin} leans on {ball}"),
    (BallsHit, "{ball} hits {others}"),
)
RESERVED = frozenset({"cushion", "jaw", "outside", "table", "tip", "player", "none"})

_PATTERN = {
    "bodies": rf"(?P<bodies>{NAME}(?: and {NAME})*)",
    "others": rf"(?P<others>{NAME}(?: and {NAME})*)",
    "delay": rf"(?P<delay>{NUMBER})",
}


def _compiled(sentence: str) -> re.Pattern[str]:
    pattern = re.sub(
        r"\{(\w+)\}",
        lambda gap: _PATTERN.get(gap[1], rf"(?P<{gap[1]}>{NAME})"),
        sentence,
    )
    return re.compile(rf"{pattern}(?: at (?P<time>{NUMBER}) s)?")


_READERS = tuple((kind, _compiled(sentence)) for kind, sentence in SENTENCES)


class PhraseError(ValueError):
    """A text that is no event of this table; `mend` says what would be."""

    def __init__(self, message: str, mend: str = "") -> None:
        super().__init__(message)
        self.mend = mend


def parse_event(text: str, vocabulary: Vocabulary | None = None) -> Event:
    """Return the event that `text` tells; with a vocabulary, every name must be in it.

    Raises PhraseError for a text that is no event.
    """
    problem: PhraseError | None = None
    for kind, reader in _READERS:
        match = reader.fullmatch(text)
        if match is None or _names_a_word(match):
            continue
        event = kind(**_arguments(match))
        unknown = _unknown_name(event, vocabulary) if vocabulary else None
        if unknown is None:
            return event
        problem = problem or unknown
    raise problem or PhraseError(
        f'"{text}" is no event of a shot record',
        'write it like "cue hits 8" or "8 pocketed foot-left at 1.25 s", one space between words',
    )


def _names_a_word(match: re.Match[str]) -> bool:
    values = match.groupdict()
    gaps = (value for key, value in values.items() if key not in {"time", "delay"} and value)
    return any(name in RESERVED for value in gaps for name in value.split(" and "))


def _arguments(match: re.Match[str]) -> dict[str, Any]:
    arguments: dict[str, Any] = {}
    for key, value in match.groupdict().items():
        if key in {"time", "delay"}:
            arguments[key] = None if value is None else float(value)
        elif key in {"others", "bodies"}:
            arguments[key] = tuple(value.split(" and "))
        else:
            arguments[key] = value
    return arguments


_KINDS: Mapping[str, Callable[[Vocabulary], tuple[str, ...]]] = {
    "ball": lambda words: tuple(ball.name for ball in words.balls),
    "cushion": lambda words: words.cushions,
    "pocket": lambda words: words.pockets,
    "line": lambda words: words.lines,
    "zone": lambda words: words.zones,
    "pin": lambda words: words.pins,
    "body": lambda words: (*(ball.name for ball in words.balls), *words.pins),
}
_KIND_OF = {"other": "ball", "others": "ball", "bodies": "body"}


def _unknown_name(event: Event, vocabulary: Vocabulary) -> PhraseError | None:
    for one in fields(event):
        if one.name in {"time", "delay"}:
            continue
        kind = _KIND_OF.get(one.name, one.name)
        known = _KINDS[kind](vocabulary)
        value = getattr(event, one.name)
        for name in value if isinstance(value, tuple) else (value,):
            if name not in known:
                return PhraseError(
                    f"there is no {kind} {name} here", f"one of: {', '.join(known) or 'none'}"
                )
    return None


def format_event(event: Event) -> str:
    """Return the event as a record writes it, with its time where it has one."""
    words = {one.name: getattr(event, one.name) for one in fields(event)}
    time = words.pop("time")
    words = {
        key: " and ".join(value) if isinstance(value, tuple) else _plain(value)
        for key, value in words.items()
    }
    text = _sentence_of(event).format(**words)
    return text if time is None else f"{text} at {_plain(round(time, 6))} s"


def _sentence_of(event: Event) -> str:
    if isinstance(event, PinToppled) and len(event.bodies) == 1:
        return "{bodies} topples {pin}"
    return next(sentence for kind, sentence in SENTENCES if isinstance(event, kind))


def _plain(value: object) -> str:
    if not isinstance(value, float):
        return str(value)
    text = f"{value:.6f}".rstrip("0")
    return text + "0" if text.endswith(".") else text


def without_time(event: Event) -> Event:
    """Return the event as if nobody had measured its time."""
    return replace(event, time=None)
