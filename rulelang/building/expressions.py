"""Nouns, numbers, conditions and event phrases, built from the parser's trees.

One idea: one small function per construct, found by the name the grammar gives it.
Invariant: every name of the grammar's expressions stands in `_EXPRESSIONS` or among the verbs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import syntax as s
from rulelang.automaton import Tree
from rulelang.building.words import named, span, text

if TYPE_CHECKING:
    from collections.abc import Callable


def expression(node: Any) -> s.Expr:
    """Build one noun, number or condition."""
    built: s.Expr = _EXPRESSIONS[node.data](node)
    return built


def maybe(node: Any) -> s.Expr | None:
    """Build what the grammar leaves open: an expression, or None."""
    return None if node is None else expression(node)


def _fixed(word: str) -> Callable[[Any], s.Expr]:
    return lambda n: s.Happened(span(n), None, s.Verb(span(n), word))


def _fixed_target(word: str) -> Callable[[Any], s.Expr]:
    return lambda n: s.Happened(span(n), None, s.Verb(span(n), word, expression(n.children[0])))


def _arithmetic(n: Any) -> s.Expr:
    return s.Arithmetic(span(n), str(n.data), expression(n.children[0]), expression(n.children[1]))


def _junction(word: str) -> Callable[[Any], s.Expr]:
    return lambda n: s.Junction(span(n), word, tuple(expression(c) for c in n.children))


def _sequence(n: Any) -> s.Expr:
    return s.Sequence(span(n), str(n.data), tuple(expression(c) for c in n.children))


def _quantifier(node: Any) -> tuple[str, int]:
    word = node.data if isinstance(node, Tree) else str(node)
    if word == "quantifier":
        words = text(node).split()
        return " ".join(words[:-1]), int(float(words[-1]))
    return str(word), 0


def _quantified(n: Any) -> s.Expr:
    how, count = _quantifier(n.children[0])
    return s.Quantified(span(n), how, count, expression(n.children[1]))


def _happened(n: Any) -> s.Expr:
    return s.Happened(span(n), expression(n.children[0]), verb(n.children[1]))


def _related(n: Any) -> s.Expr:
    relative = n.children[1]
    at = span(relative)
    if relative.data == "rel_by_player":
        made = s.Verb(at, "touched by player")
    elif relative.data == "rel_touching":
        made = s.Verb(at, "touching", expression(relative.children[0]))
    else:
        word = str(relative.children[0])
        made = s.Verb(at, f"{word} by", expression(relative.children[-1]))
    return s.Happened(span(n), expression(n.children[0]), made)


_TARGET_VERBS = {
    "hit": "hit",
    "pressed": "pressed",
    "jumped": "jumped over",
    "toppled": "toppled",
    "touched": "touched",
    "leaned": "leaned on",
}
_PLACE_VERBS = {
    "pocketed": "pocketed",
    "hit_jaw": "hit jaw",
    "left_zone": "left",
    "left_cushion": "left cushion",
    "entered": "entered",
    "crossed": "crossed",
    "rebounded": "rebounded",
    "settled_in": "settled",
    "started": "started in",
    "stayed": "stayed together in",
    "placed_in": "placed in",
    "placed_outside": "placed outside",
}
_BARE_VERBS = {
    "pocketed_in_called": "pocketed in called pocket",
    "hit_rail": "hit rail",
    "hit_outside": "hit outside",
    "hit_pocketed": "hit pocketed ball",
    "left_table": "left table",
    "toppled_any": "fell",
}
_CUSHION_VERBS = {"hit_cushion": "hit cushion", "pressed_cushion": "pressed cushion"}


def verb(node: Any) -> s.Verb:
    """Build an event phrase."""
    at, word = span(node), node.data
    if word in _TARGET_VERBS:
        return s.Verb(at, _TARGET_VERBS[word], expression(node.children[0]))
    if word in _PLACE_VERBS:
        place = node.children[0]
        at = at if place is None else span(place)
        return s.Verb(at, _PLACE_VERBS[word], None, named(place))
    if word == "pocketed_in_own":
        name, who = node.children
        own = s.NameOf(at, str(name), expression(who))
        return s.Verb(at, "pocketed in own", own, str(name))
    if word in _BARE_VERBS:
        return s.Verb(at, _BARE_VERBS[word])
    return _cushion_verb(at, _CUSHION_VERBS[word], node.children[0])


def _cushion_verb(at: s.Span, word: str, cushion: Any) -> s.Verb:
    if cushion.data == "one_cushion":
        return s.Verb(at, word, None, named(cushion.children[0]))
    how, count = _quantifier(cushion.children[0])
    here = span(cushion)
    target = s.Quantified(here, how, count, s.Noun(here, "cushion"))
    return s.Verb(at, word, target)


def _is(negated: bool) -> Callable[[Any], s.Expr]:  # noqa: FBT001
    return lambda n: s.Is(span(n), expression(n.children[0]), negated, _test(n.children[1]))


def _test(node: Any) -> s.Test:
    at, word = span(node), str(node.data)
    child = node.children[0] if node.children else None
    match word:
        case "state_on_table":
            return s.Test(at, "on table")
        case "state_standing":
            return s.Test(at, "standing")
        case "state_in_hand":
            return s.Test(at, "in hand", place=named(child))
        case "state_in":
            return s.Test(at, "in", place=named(child))
        case "state_together":
            return s.Test(at, "together in", place=named(child))
        case "state_frozen":
            return s.Test(at, "frozen to cushion", place=named(child))
        case "state_touching":
            return s.Test(at, "touching", expression(child))
        case _:
            return s.Test(at, word.replace("_", " "), expression(child))


def _total(n: Any) -> s.Expr:
    return s.Total(span(n), text(n.children[0]), expression(n.children[1]))


def _extreme(n: Any) -> s.Expr:
    base = expression(n.children[1])
    if n.data == "extreme_on_table":
        base = s.OnTable(span(n), base)
    return s.Extreme(span(n), text(n.children[0]), base)


def _called(n: Any) -> s.Expr:
    return s.Called(span(n), str(n.children[0]))


def _item(n: Any) -> s.Expr:
    return expression(n.children[0])


_EXPRESSIONS: dict[str, Callable[[Any], s.Expr]] = {
    "all_of": _junction("and"),
    "either_of": _junction("or"),
    "negation": lambda n: s.Not(span(n), expression(n.children[0])),
    "before": _sequence,
    "after": _sequence,
    "then": _sequence,
    "is_": _is(negated=False),
    "is_not": _is(negated=True),
    "plus": _arithmetic,
    "minus": _arithmetic,
    "times": _arithmetic,
    "total": _total,
    "happened": _happened,
    "related": _related,
    "quantified": _quantified,
    "except_": lambda n: s.Except(span(n), expression(n.children[0]), expression(n.children[1])),
    "on_table": lambda n: s.OnTable(span(n), expression(n.children[0])),
    "standing": lambda n: s.Standing(span(n), expression(n.children[0])),
    "up_to": lambda n: s.UpTo(span(n), expression(n.children[0]), expression(n.children[1])),
    "extreme_of": _extreme,
    "extreme_on_table": _extreme,
    "name_noun": lambda n: s.Name(span(n), str(n.children[0])),
    "word": lambda n: s.Name(span(n), str(n.children[0])),
    "name_of": lambda n: s.NameOf(span(n), str(n.children[0]), expression(n.children[1])),
    "ball_number": lambda n: s.BallNumber(span(n), str(n.children[0]).removesuffix("-ball")),
    "number": lambda n: s.Number(span(n), int(float(text(n.children[0])))),
    "yes": lambda n: s.Flag(span(n), value=True),
    "no_flag": lambda n: s.Flag(span(n), value=False),
    "nothing": lambda n: s.Nothing(span(n)),
    "none": lambda n: s.Name(span(n), "none"),
    "listing": lambda n: s.Listing(span(n), tuple(expression(c) for c in n.children)),
    "item": _item,
    "set_value": _item,
    "start_value": _item,
    "fixed_noun": lambda n: s.Noun(span(n), text(n)),
    "cue_ball_of": lambda n: s.CueBallOf(span(n), expression(n.children[0])),
    "called_name": _called,
    "score_of": lambda n: s.ScoreOf(span(n), expression(n.children[0])),
    "lot_of": lambda n: s.LotOf(
        span(n), expression(n.children[0]), int(float(text(n.children[1])))
    ),
    "score_gap": lambda n: s.ScoreGap(span(n)),
    "score_extreme": lambda n: s.ScoreExtreme(span(n), text(n.children[0])),
    "score_second": lambda n: s.ScoreExtreme(span(n), text(n.children[0]), second=True),
    "who": lambda n: expression(n.children[0]),
    "who_name": lambda n: s.Name(span(n), str(n.children[0])),
    "player": lambda n: s.Player(span(n), text(n)),
    "opponent_of": lambda n: s.OpponentOf(span(n), expression(n.children[0])),
    "partner_of": lambda n: s.PartnerOf(span(n), expression(n.children[0])),
    "tip_again": _fixed_target("tip hit again"),
    "tip_followed": _fixed_target("tip followed"),
    "player_touched": _fixed_target("player touched"),
    "foot_lifted": _fixed("foot left floor"),
    "stroke_played": _fixed("stroke was played"),
    "stroke_omitted": _fixed("stroke was not played"),
    "too_soon": _fixed("stroke was too soon"),
    "time_called": _fixed("time was called"),
    "safety_called": _fixed("safety was called"),
    "safety_not_called": _fixed("safety was not called"),
}


def guard(node: Any) -> s.Expr:
    """Build `CONDITION [unless CONDITION]`."""
    condition, unless = node.children
    if unless is None:
        return expression(condition)
    at = span(node)
    return s.Junction(at, "and", (expression(condition), s.Not(at, expression(unless))))
