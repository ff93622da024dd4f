"""What only an eye at the table can tell of a shot, told by the players.

One idea: the facts that a script declares are set for the shot played last, and the referee is
asked anew. Invariant: what happened on the table stays; only what the referee says of it changes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from engine.app.session import SHOWING, Mode, Session
from engine.app.timing import timed_on
from engine.app.words import spoken
from engine.game.match import advance, undo
from engine.game.referee import judge_shot

if TYPE_CHECKING:
    from engine.variant.variant import Value, Variant
    from rulelang.program import FactDecl

SEEN = "as it was seen"
"""What stands for a fact that nobody told and that the positions tell."""


@dataclass(frozen=True, slots=True)
class Fact:
    """A fact of a shot as the players set it; None for what nobody told."""

    name: str
    value: Value | None
    choices: tuple[Value | None, ...]

    @property
    def words(self) -> str:
        """The value in words."""
        if self.value is None:
            return SEEN
        if isinstance(self.value, bool):
            return "yes" if self.value else "no"
        return spoken(str(self.value))

    def stepped(self, by: int) -> Fact:
        """Return the fact with the next of its values."""
        if not self.choices:
            now = self.value if isinstance(self.value, int) else 0
            return replace(self, value=max(now + by, 0))
        place = self.choices.index(self.value) if self.value in self.choices else 0
        return replace(self, value=self.choices[(place + by) % len(self.choices)])


def facts_of(session: Session) -> tuple[Fact, ...]:
    """Return what the script lets an eye tell of the shot played last; timers are no such facts."""
    last = session.last
    if last is None or last.shot.is_only_choice:
        return ()
    program, told = session.variant.program, last.shot.facts
    return tuple(
        Fact(name, told.get(name, _usual(fact)), _choices(fact, session))
        for name, fact in program.facts.items()
        if name not in program.timers
    )


def _usual(fact: FactDecl) -> Value | None:
    if fact.predicate is not None:
        return None
    return False if fact.kind == "flag" and fact.default is None else fact.default


def _choices(fact: FactDecl, session: Session) -> tuple[Value | None, ...]:
    seen: tuple[None, ...] = (None,) if fact.predicate is not None or fact.default is None else ()
    match fact.kind:
        case "flag":
            return (False, True)
        case "values":
            return (*seen, *fact.values)
        case "ball":
            return (None, *_balls(session.variant))
        case "player":
            return (*seen, *range(1, session.match.situation.players + 1))
    return ()


def _balls(variant: Variant) -> tuple[str, ...]:
    return tuple(str(kind.id) for kind in variant.balls)


def why_not(session: Session) -> str:
    """Return why nothing can be told of the shot played last; empty where it can."""
    if session.mode in SHOWING:
        return "wait until the balls have come to rest"
    declared = session.variant.program.facts.keys() - session.variant.program.timers.keys()
    if not declared:
        return "the rules of this game leave nothing to an eye"
    if session.last is None:
        return "there is no shot to judge again yet"
    if session.last.shot.is_only_choice:
        return "a choice came after the last shot; take it back first"
    return ""


def judged_again(session: Session, facts: tuple[Fact, ...]) -> Session:
    """Return the session with the shot played last judged by what was told of it.

    Raises what a script in trouble raises.
    """
    last = session.last
    if last is None or why_not(session):
        return session
    timers = {name: v for name, v in last.shot.facts.items() if name in session.timing.clock.timers}
    before = {fact.name: fact.value for fact in facts_of(session)}
    known = set(last.shot.facts)
    told = {
        fact.name: fact.value
        for fact in facts
        if fact.value is not None and (fact.name in known or fact.value != before[fact.name])
    }
    shot = replace(last.shot, facts={**timers, **told})
    if dict(shot.facts) == dict(last.shot.facts):
        return replace(session, note="judged as before")
    verdict = judge_shot(session.variant, last.before, shot)
    match = advance(undo(session.match), shot, verdict)
    end = session.trace.duration if session.trace is not None else 0.0
    return replace(
        session,
        match=match,
        ahead=verdict.after,
        mode=Mode.VERDICT,
        clock=end,
        timing=timed_on(session.timing, match),
        later=(),
        note="judged again by what was seen",
    )
