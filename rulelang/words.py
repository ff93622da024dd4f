"""The words of the language, each with its part of speech.

One idea: one table from which the highlighting of editors and the messages about mistakes are
made. Invariant: the words are those of the grammar, each in one class.
"""

from __future__ import annotations

from types import MappingProxyType

HEADS = "head"
SECTION = "section"
CONTROL = "control"
LOGIC = "logic"
ACTION = "action"
EVENT = "event"
QUANTITY = "quantity"
NOUN = "noun"
PLAYER = "player"
UNIT = "unit"
PARTICLE = "particle"

WORDS = MappingProxyType(
    {
        HEADS: (
            "language", "game", "cites", "uses", "phases", "zones", "track", "fact", "define",
            "timer", "players", "settled", "rule", "overrides", "starting", "default", "supplied",
            "lasts", "spotting", "order",
        ),
        SECTION: ("before", "fouls", "points", "turn", "table", "next", "ending", "expires"),
        CONTROL: ("if", "otherwise", "unless", "for", "each", "offer", "when", "else"),
        LOGIC: ("and", "or", "not", "then", "after", "is", "are"),
        ACTION: (
            "foul", "award", "deduct", "add", "set", "up", "reset", "assign", "go", "continues",
            "passes", "spot", "respot", "remove", "rerack", "keeping", "restore", "give",
            "require", "allow", "wins", "loses", "tie", "eliminate", "reinstate", "plays",
            "happens", "alone",
        ),
        EVENT: (
            "pocketed", "hit", "pressed", "left", "entered", "crossed", "jumped", "rebounded",
            "started", "stayed", "placed", "toppled", "touched", "leaned", "followed", "played",
            "called", "again", "was", "touching", "frozen",
            "standing", "together",
        ),
        QUANTITY: (
            "any", "every", "no", "none", "only", "exactly", "at", "least", "most", "more",
            "fewer", "than", "one", "number", "value", "worth", "highest", "lowest", "first",
            "second", "third", "last", "plus", "minus", "times", "count", "difference",
            "among",
        ),
        NOUN: (
            "ball", "balls", "cue", "object", "struck", "chosen", "pin", "pins", "it", "phase",
            "shot", "score", "scores", "cushion", "cushions", "rail", "jaw", "pocket", "tip",
            "stroke", "floor", "foot", "time", "safety", "hand", "home", "occupant", "yes",
            "nothing",
        ),
        PLAYER: (
            "shooter", "opponent", "chooser", "breaker", "leader", "player", "waiting", "that",
            "lot", "winner", "loser", "partner",
        ),
        UNIT: ("match", "rack", "frame", "side", "seconds", "per", "start", "end"),
        PARTICLE: (
            "as", "by", "except", "free", "from", "in", "later", "lay", "near", "of", "on",
            "outside", "over", "own", "soon", "to", "too", "toward", "where", "within",
        ),
    }
)  # fmt: skip
"""Every word of the grammar by its class; articles are passed over and have none."""

ARTICLES = ("a", "an", "the")
PAST = frozenset(
    {
        "pocketed", "hit", "left", "crossed", "entered", "jumped", "toppled", "rebounded",
        "settled", "pressed", "started", "leaned",
    }
)  # fmt: skip
"""Verbs of events that people put `is` or `are` before."""
OPENING = frozenset(
    {
        "foul", "award", "deduct", "add", "set", "reset", "assign", "go", "turn", "spot", "respot",
        "remove", "rerack", "restore", "give", "require", "allow", "shooter", "opponent", "leader",
        "tie", "eliminate", "reinstate", "nothing", "offer", "if", "for", "winner",
    }
)  # fmt: skip
"""Words that a statement begins with."""
