"""What an expression is compiled to: a kind, and a closure that reads a Watch.

One idea: kinds are checked when the closure is made, so that running never asks.
Invariant: a Code of kind BALLS returns a bit mask, NUMBER and PLAYER an int, FLAG a bool,
NAME a str.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rulelang.signs import UNKNOWN, Signs

if TYPE_CHECKING:
    from rulelang.syntax import Span
    from rulelang.watch import Watch

BALLS, NUMBER, FLAG, PLAYER, NAME, NOTHING = (
    "balls", "number", "flag", "player", "name", "nothing",
)  # fmt: skip
SHOT, SCORES, FOULS = "shot", "scores", "fouls"
CUE_BALL, OBJECT_BALLS = "cue ball", "object balls"
"""What `word` says of a Code that is just this."""

SPOKEN = {
    BALLS: "a set of balls",
    NUMBER: "a number",
    FLAG: "yes or no",
    PLAYER: "a player",
    NAME: "a name",
    NOTHING: "nothing",
    SHOT: "the shot",
    SCORES: "the scores",
    FOULS: "the fouls",
}

Run = Callable[["Watch"], Any]


@dataclass(slots=True)
class Code:
    """A compiled expression.

    `truth` is the closure to use as a condition, where that is not plain non-emptiness;
    `within` the same between two event numbers, `anchor` the number of the first event that
    makes it true (None: it did not happen), `witness` the numbers of all that did.
    `signs` tell what must be the case for it to be true.
    `shown` is what an explanation tells the value of, `beside` what it was compared with.
    `since` is the earliest section that may read it; `staged` that its value changes from
    section to section; `fouls` that it speaks of fouls.
    """

    kind: str
    run: Run
    domain: str = ""
    truth: Run | None = None
    within: Callable[[Watch, int, int], bool] | None = None
    anchor: Callable[[Watch], int | None] | None = None
    witness: Callable[[Watch, int, int], list[int]] | None = None
    since: int = 0
    staged: bool = False
    fouls: bool = False
    constant: Any = None
    parts: tuple[Code, ...] = ()
    word: str = ""
    text: str = ""
    shown: Code | None = None
    beside: Code | None = None
    signs: Signs = UNKNOWN


class Mistake(Exception):  # noqa: N818
    """A mistake of the author, found while compiling; `silent` when already told elsewhere."""

    def __init__(
        self, code: str, at: Span, message: str, mend: str = "", *, silent: bool = False
    ) -> None:
        super().__init__(message)
        self.code = code
        self.at = at
        self.message = message
        self.mend = mend
        self.silent = silent
        self.owner = ""
