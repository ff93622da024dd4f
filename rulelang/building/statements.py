"""What a rule does, built from the parser's trees.

One idea: one small function per statement, found by the name the grammar gives it.
Invariant: a statement is built whole; those inside it are built by the same table.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import syntax as s
from rulelang.building.expressions import expression, guard, maybe
from rulelang.building.words import named, span, text

if TYPE_CHECKING:
    from collections.abc import Callable


def statement(node: Any) -> s.Statement:
    """Build one statement."""
    built: s.Statement = _STATEMENTS[node.data](node)
    return built


def _block(node: Any) -> tuple[s.Statement, ...]:
    return tuple(statement(child) for child in node.children)


def _if(n: Any) -> s.Statement:
    first, body, *rest = n.children
    branches = [(guard(first), _block(body))]
    otherwise: tuple[s.Statement, ...] = ()
    for part in rest:
        if part is None:
            continue
        if part.data == "else_if":
            branches.append((guard(part.children[0]), _block(part.children[1])))
        else:
            otherwise = _block(part.children[0])
    return s.If(span(n), tuple(branches), otherwise)


def _offer(n: Any) -> s.Statement:
    who, *choices = n.children
    return s.OfferChoices(span(n), expression(who), tuple(_choice(c) for c in choices))


def _choice(n: Any) -> s.Choice:
    option, condition, body = n.children
    return s.Choice(span(option), text(option), maybe(condition), _block(body))


def _place(n: Any) -> s.PlaceAt:
    at, kids = span(n.children[0] if n.children else n), [text(child) for child in n.children]
    match n.data:
        case "at_spot":
            return s.PlaceAt(at, "at", kids[0])
        case "near":
            return s.PlaceAt(at, "near", kids[0], kids[1])
        case "near_own":
            return s.PlaceAt(at, "near-own", None, kids[0])
        case word:
            kind = {
                "at_home": "home",
                "at_occupant": "occupant",
                "at_own": "own",
                "where_it_lay": "lay",
                "later": "later",
            }
            return s.PlaceAt(at, kind.get(word, "highest-free"))


def _spot(n: Any) -> s.Statement:
    balls, *places = n.children
    return s.SpotBalls(span(n), expression(balls), tuple(_place(p) for p in places))


def _respot(n: Any) -> s.Statement:
    at = span(n)
    places = (s.PlaceAt(at, "own"), s.PlaceAt(at, "near-own", None, "foot"))
    return s.SpotBalls(at, expression(n.children[0]), places)


def _award(n: Any) -> s.Statement:
    return s.Award(span(n), str(n.data), expression(n.children[0]), expression(n.children[1]))


def _win(n: Any) -> s.Statement:
    return s.Win(span(n), str(n.data), expression(n.children[0]), text(n.children[1]))


def _require(n: Any) -> s.Statement:
    what = text(n.children[0])
    return s.Require(span(n), str(n.data), what, expression(n.children[1]))


def _add(n: Any) -> s.Statement:
    value, name, who = n.children
    return s.Write(span(name), "add", text(name), maybe(who), expression(value))


def _set(n: Any) -> s.Statement:
    name, who, value = n.children
    return s.Write(span(name), "set", text(name), maybe(who), expression(value))


def _seat(n: Any) -> s.Statement:
    return s.Seat(span(n), str(n.data), expression(n.children[0]))


_STATEMENTS: dict[str, Callable[[Any], s.Statement]] = {
    "if_statement": _if,
    "for_each": lambda n: s.ForEach(span(n), expression(n.children[0]), _block(n.children[1])),
    "for_each_player": lambda n: s.ForEach(span(n), None, _block(n.children[0])),
    "offer": _offer,
    "foul": lambda n: s.Foul(
        span(n), text(n.children[0]), maybe(n.children[1]), n.children[2] is not None
    ),
    "award": _award,
    "deduct": _award,
    "add": _add,
    "set": _set,
    "reset": lambda n: s.Write(span(n), "reset", text(n.children[0]), maybe(n.children[1]), None),
    "assign": lambda n: s.Write(
        span(n), "assign", "group", expression(n.children[1]), expression(n.children[0])
    ),
    "go_to_phase": lambda n: s.GoToPhase(span(n.children[0]), text(n.children[0])),
    "turn_continues": lambda n: s.Turn(span(n), continues=True, who=None),
    "turn_passes": lambda n: s.Turn(span(n), continues=False, who=maybe(n.children[0])),
    "spot": _spot,
    "respot": _respot,
    "remove": lambda n: s.RemoveBalls(span(n), expression(n.children[0])),
    "set_up": lambda n: s.SetUpPins(span(n), expression(n.children[0])),
    "rerack": lambda n: s.RackAgain(span(n), maybe(n.children[0])),
    "restore": lambda n: s.RestoreTable(span(n)),
    "give": lambda n: s.GiveInHand(span(n), expression(n.children[0]), named(n.children[1])),
    "require": _require,
    "allow": _require,
    "allow_strike": lambda n: s.AllowStrike(span(n), expression(n.children[0])),
    "wins": _win,
    "loses": _win,
    "tie": lambda n: s.Win(span(n), "tie", None, text(n.children[0])),
    "eliminate": _seat,
    "reinstate": _seat,
    "plays": lambda n: s.Plays(span(n), expression(n.children[0])),
    "nothing_happens": lambda n: s.NothingHappens(span(n)),
}
