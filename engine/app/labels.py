"""Numbers and letters on every ball, for players who cannot tell all colours apart.

One idea: a ball keeps the label it has; any other gets the shortest beginning of its name that no
ball of another colour has. Invariant: only the look changes.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from engine.variant.variant import BallKind, Variant

LONGEST = 3
"""Letters that can be read on a ball."""


def labelled(variant: Variant) -> Variant:
    """Return the variant with a label on every ball."""
    told = labels_of(variant)
    return replace(
        variant, balls=tuple(replace(kind, label=told[kind.id]) for kind in variant.balls)
    )


def shown_variant(variant: Variant, *, letters: bool) -> Variant:
    """Return the variant as it is drawn, with `letters` on every ball or its own look."""
    return labelled(variant) if letters else variant


def labels_of(variant: Variant) -> dict[str, str]:
    """Return the label of every ball."""
    bare = [kind for kind in variant.balls if not kind.label]
    taken = {kind.label for kind in variant.balls if kind.label}
    names = {_word(kind): None for kind in bare}
    short = {word: _shortest(word, [one for one in names if one != word], taken) for word in names}
    looks: dict[str, list[object]] = {}
    told = {}
    for kind in variant.balls:
        known = looks.setdefault(_word(kind), [])
        look = kind.colour, kind.pattern
        known += [] if look in known else [look]
        number = known.index(look) + 1
        own = short.get(_word(kind), "")
        told[str(kind.id)] = kind.label or (own if number == 1 else f"{own[: LONGEST - 1]}{number}")
    return told


def _word(kind: BallKind) -> str:
    """Return a ball's name without its number: balls of one kind share a label."""
    word, _, number = kind.id.rpartition("-")
    return word if word and number.isdecimal() else kind.id


def _shortest(word: str, others: list[str], taken: set[str]) -> str:
    for count in range(1, LONGEST):
        label = word[:count].capitalize()
        if label not in taken and not any(one[:count] == word[:count] for one in others):
            return label
    return word[:LONGEST].capitalize()
