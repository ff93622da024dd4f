"""What the rules decide about one shot: values out.

One idea: decisions are plain statements that the host carries out; nothing here moves a ball.
Invariant: players are numbers from 1, balls, spots and zones are names, all resolved.
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rulelang.vocabulary import Tracked


@value
class Foul:
    """A foul with its worth in penalty points and the rule that found it."""

    name: str
    worth: int
    rule: str
    cites: tuple[str, ...]


@value
class Place:
    """One place that a spotted ball may go to, tried in order until one is free.

    `kind` is "at" (on `spot`), "highest-free" (the free own spot of highest value), "occupant"
    (the home of the ball that covers the place tried before; homes in Decisions.homes), "near"
    (as near `spot` as possible on the line toward `toward`, "head" or "foot", without touching),
    "lay" (where the ball lay when all balls had stopped), "later" (it stays off the table).
    """

    kind: str
    spot: str | None = None
    toward: str = "foot"


@value
class Spot:
    """Put `ball` back at the first of `places` that is free."""

    ball: str
    places: tuple[Place, ...]


@value
class Remove:
    """Take `ball` off the table for good."""

    ball: str


@value
class Rerack:
    """Rack all balls anew, but leave `keeping` where they lie."""

    keeping: tuple[str, ...] = ()


@value
class Restore:
    """Put the whole position back as it was before the stroke."""


@value
class SetUp:
    """Set pins up again; one whose place a ball takes waits until it is set up the next time."""

    pins: tuple[str, ...]


TableAction = Spot | Remove | SetUp | Rerack | Restore


@value
class InHand:
    """The cue ball of the next shot is in hand in `zone`; None: it is played where it lies."""

    player: int
    zone: str | None


@value
class Offer:
    """`player` may choose `option`; `key` finds its consequences in the Program."""

    player: int
    option: str
    key: int


@value
class Ending:
    """`unit` ("game" or "match") is over; `winner` 0 is a draw."""

    unit: str
    winner: int


@value
class RuleOutcome:
    """How one rule fared: "fired", "silent" (its condition was false) or "overridden".

    `because` tells, for a fired rule, the condition with its values; for a silent one the part
    that was false; for an overridden one, the rule that overrode it, or the one that ended the
    game, by which it is void. `events` are indexes of the shot's events that made it so. `said`
    lists what the rule decided, in the script's words.
    """

    rule: str
    section: str
    cites: tuple[str, ...]
    outcome: str
    because: str
    events: tuple[int, ...] = ()
    said: tuple[str, ...] = ()
    line: int = 0
    file: str = ""


@value
class Required:
    """What the player must announce before the shot: "ball", "pocket", "ball-or-safety" ..."""

    player: int
    what: str


@value
class Admission:
    """What binds and what is open before a shot.

    `on` are the balls on, for the display; `strikable` the balls that the tip may strike, none
    where it is the shooter's cue ball alone.
    """

    required: tuple[Required, ...] = ()
    offers: tuple[Offer, ...] = ()
    on: frozenset[str] = frozenset()
    strikable: frozenset[str] = frozenset()


@value
class Decisions:
    """Everything decided, ready to be carried out.

    `points` has the change of each player's score; `state` the tracked values after the shot;
    `next_player` who comes to the table; `continues` that it is the same turn. `table` is in
    the order in which it is to be done. `homes` maps a ball to its home spot, where the script
    declares one.
    """

    fouls: tuple[Foul, ...] = ()
    points: tuple[int, ...] = ()
    state: Mapping[str, Tracked] = field(default_factory=dict)
    phase: str = ""
    next_player: int = 1
    continues: bool = False
    table: tuple[TableAction, ...] = ()
    in_hand: InHand | None = None
    offers: tuple[Offer, ...] = ()
    endings: tuple[Ending, ...] = ()
    eliminated: frozenset[int] = frozenset()
    homes: Mapping[str, str] = field(default_factory=dict)
    explanation: tuple[RuleOutcome, ...] = ()
