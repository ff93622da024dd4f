"""Actions, compiled: what is to be done, each one decision.

One idea: an action is a function of the watch that returns a plain tuple, its first item the kind
of decision; what the tuples mean is the evaluator's business.
Invariant: an action changes nothing; None stands for no decision.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import leader, opponent
from rulelang.code import Code, Mistake
from rulelang.scope import nearest

if TYPE_CHECKING:
    from rulelang.scope import Scope
    from rulelang.watch import Watch

Decision = tuple[Any, ...]
Act = Callable[["Watch"], Decision | None]


class Reader(Protocol):
    """What compiles the values of an action: it knows the names, and notes what was read."""

    scope: Scope

    def value(self, node: s.Expr, kind: str, domain: str = "") -> Code:
        """Compile `node` as `kind`."""


def _foul(x: Reader, node: s.Foul) -> Act:
    worth = None if node.worth is None else x.value(node.worth, k.NUMBER).run
    name, alone = node.name, node.alone
    if worth is None:
        made = ("foul", name, 0, alone)
        return lambda _c: made
    return lambda c: ("foul", name, worth(c), alone)


def _award(x: Reader, node: s.Award) -> Act:
    amount, who = x.value(node.amount, k.NUMBER).run, x.value(node.who, k.PLAYER).run
    sign = 1 if node.verb == "award" else -1
    return lambda c: ("points", who(c), sign * amount(c))


def _write(x: Reader, node: s.Write) -> Act:
    scope, name = x.scope, node.name
    if name in scope.poisoned:
        raise Mistake("R206", node.at, f'"{name}" cannot be read', silent=True)
    if name not in scope.tracks:
        mend = nearest(name, scope.tracks) or f"declare it: track {name} per game"
        raise Mistake("R206", node.at, f'"{name}" is not tracked', mend)
    track = scope.tracks[name]
    scope.used.add(name)
    if track.per_player and node.who is None:
        raise Mistake(
            "R303", node.at, f'"{name}" is kept for each player', f"say `{name} of shooter`"
        )
    if not track.per_player and node.who is not None:
        raise Mistake("R304", node.at, f'"{name}" is not kept for each player', f"say `{name}`")
    who = (lambda _c: None) if node.who is None else x.value(node.who, k.PLAYER).run
    if node.value is None:
        return lambda c: ("write", "reset", name, who(c), None)
    kind = scope.track_kinds[name]
    if node.verb == "add" and kind != k.NUMBER:
        raise Mistake("R301", node.at, f'"{name}" is not a number', "say `set` instead of `add`")
    value = x.value(node.value, kind, "name" if kind == k.NAME else "").run
    op = "add" if node.verb == "add" else "set"
    return lambda c: ("write", op, name, who(c), value(c))


def _assign(x: Reader, node: s.Write) -> Act:
    if node.verb != "assign":
        return _write(x, node)
    value = node.value
    if not isinstance(value, s.Name) or x.scope.group(value.name) is None:
        at = node.at if value is None else value.at
        raise Mistake("R301", at, "a group of balls is due after `assign`", "name a group")
    return _write(x, node)


def _turn(x: Reader, node: s.Turn) -> Act:
    if node.continues:
        return lambda _c: ("turn", True, None)
    if node.who is None:
        return lambda _c: ("turn", False, None)
    who = x.value(node.who, k.PLAYER).run
    return lambda c: ("turn", False, who(c))


def _go_to_phase(x: Reader, node: s.GoToPhase) -> Act:
    made = ("phase", x.scope.phase(node.phase, node.at))
    x.scope.used.add(f"phase {node.phase}")
    return lambda _c: made


def _spot(x: Reader, node: s.SpotBalls) -> Act:
    balls = x.value(node.balls, k.BALLS).run
    for place in node.places:
        if place.spot is not None:
            x.scope.place("spot", place.spot, place.at)
    places = tuple((place.kind, place.spot, place.toward) for place in node.places)
    return lambda c: ("spot", balls(c), places)


def _remove(x: Reader, node: s.RemoveBalls) -> Act:
    balls = x.value(node.balls, k.BALLS).run
    return lambda c: ("remove", balls(c))


def _set_up(x: Reader, node: s.SetUpPins) -> Act:
    pins = x.value(node.pins, k.BALLS).run
    up = x.scope.pins
    return lambda c: ("set up", pins(c) & up)


def _rerack(x: Reader, node: s.RackAgain) -> Act:
    keeping = (lambda _c: 0) if node.keeping is None else x.value(node.keeping, k.BALLS).run
    return lambda c: ("rerack", keeping(c))


def _give(x: Reader, node: s.GiveInHand) -> Act:
    who = x.value(node.who, k.PLAYER).run
    zone = node.zone
    if zone is not None:
        x.scope.place("zone", zone, node.at)
    elif x.scope.vocabulary.zones:
        raise Mistake(
            "R203",
            node.at,
            "the ball is in hand in no zone",
            f"say `in {x.scope.vocabulary.zones[0]}`",
        )
    return lambda c: ("hand", who(c), zone)


def _require(x: Reader, node: s.Require) -> Act:
    who = x.value(node.who, k.PLAYER).run
    what = node.what if node.verb == "require" else f"may {node.what}"
    return lambda c: ("require", who(c), what)


def _allow_strike(x: Reader, node: s.AllowStrike) -> Act:
    balls = x.value(node.balls, k.BALLS).run
    return lambda c: ("strike", balls(c))


def _win(x: Reader, node: s.Win) -> Act:
    unit = "match" if node.unit == "match" else "game"
    if node.who is None:
        return lambda _c: ("end", unit, 0)
    if isinstance(node.who, s.Player) and node.who.words == "leader":
        return lambda c: ("end", unit, leader(c))
    who = x.value(node.who, k.PLAYER).run
    if node.verb == "wins":
        return lambda c: ("end", unit, who(c))
    return lambda c: ("end", unit, opponent(c, who(c)))


def _seat(x: Reader, node: s.Seat) -> Act:
    who = x.value(node.who, k.PLAYER).run
    out = node.verb == "eliminate"
    return lambda c: ("seat", who(c), out)


def _plays(x: Reader, node: s.Plays) -> Act:
    who = x.value(node.who, k.PLAYER).run
    return lambda c: ("plays", who(c))


ACTIONS: dict[type, Callable[[Reader, Any], Act]] = {
    s.Foul: _foul,
    s.Award: _award,
    s.Write: _assign,
    s.Turn: _turn,
    s.GoToPhase: _go_to_phase,
    s.SpotBalls: _spot,
    s.RemoveBalls: _remove,
    s.SetUpPins: _set_up,
    s.RackAgain: _rerack,
    s.RestoreTable: lambda _x, _n: lambda _c: ("restore",),
    s.GiveInHand: _give,
    s.Require: _require,
    s.AllowStrike: _allow_strike,
    s.Win: _win,
    s.Seat: _seat,
    s.Plays: _plays,
    s.NothingHappens: lambda _x, _n: lambda _c: None,
}
