"""From Lark's tree to the tree of syntax.py.

One idea: one small function per construct, found by the name the grammar gives it.
Invariant: building never fails on a tree that the grammar accepts.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from lark import Token, Tree

from rulelang import syntax as s

if TYPE_CHECKING:
    from collections.abc import Callable

Node = Tree[Token]


def span(node: Node | Token) -> s.Span:
    """Return the place of a tree or token."""
    if isinstance(node, Token):
        start = node.start_pos or 0
        return s.Span(node.line or 1, node.column or 1, start, node.end_pos or start)
    meta = node.meta
    if meta.empty:
        return s.Span(1, 1, 0, 0)
    return s.Span(meta.line, meta.column, meta.start_pos, meta.end_pos)


def expression(node: Any) -> s.Expr:
    """Build one noun, number or condition."""
    built: s.Expr = _EXPRESSIONS[node.data](node)
    return built


def _text(node: Any) -> str:
    """Return the words of a tree, joined by one blank."""
    if isinstance(node, Token):
        return str(node)
    return " ".join(_text(child) for child in node.children if child is not None)


def _maybe(node: Any) -> s.Expr | None:
    return None if node is None else expression(node)


def _name(node: Any) -> str | None:
    return None if node is None else _text(node)


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
        words = _text(node).split()
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
    if word == "did_not":
        inner = verb(node.children[0])
        return s.Verb(at, inner.word, inner.target, inner.place, negated=True)
    if word in _TARGET_VERBS:
        return s.Verb(at, _TARGET_VERBS[word], expression(node.children[0]))
    if word in _PLACE_VERBS:
        place = node.children[0]
        at = at if place is None else span(place)
        return s.Verb(at, _PLACE_VERBS[word], None, _name(place))
    if word in _BARE_VERBS:
        return s.Verb(at, _BARE_VERBS[word])
    return _cushion_verb(at, _CUSHION_VERBS[word], node.children[0])


def _cushion_verb(at: s.Span, word: str, cushion: Any) -> s.Verb:
    if cushion.data == "one_cushion":
        return s.Verb(at, word, None, _name(cushion.children[0]))
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
        case "state_in_hand":
            return s.Test(at, "in hand", place=_name(child))
        case "state_in":
            return s.Test(at, "in", place=_name(child))
        case "state_frozen":
            return s.Test(at, "frozen to cushion", place=_name(child))
        case "state_touching":
            return s.Test(at, "touching", expression(child))
        case _:
            return s.Test(at, word.replace("_", " "), expression(child))


def _total(n: Any) -> s.Expr:
    return s.Total(span(n), _text(n.children[0]), expression(n.children[1]))


def _extreme(n: Any) -> s.Expr:
    base = expression(n.children[1])
    if n.data == "extreme_on_table":
        base = s.OnTable(span(n), base)
    return s.Extreme(span(n), _text(n.children[0]), base)


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
    "extreme_of": _extreme,
    "extreme_on_table": _extreme,
    "name_noun": lambda n: s.Name(span(n), str(n.children[0])),
    "word": lambda n: s.Name(span(n), str(n.children[0])),
    "name_of": lambda n: s.NameOf(span(n), str(n.children[0]), expression(n.children[1])),
    "ball_number": lambda n: s.BallNumber(span(n), str(n.children[0]).removesuffix("-ball")),
    "number": lambda n: s.Number(span(n), int(float(n.children[0]))),
    "yes": lambda n: s.Flag(span(n), value=True),
    "no_flag": lambda n: s.Flag(span(n), value=False),
    "nothing": lambda n: s.Nothing(span(n)),
    "none": lambda n: s.Name(span(n), "none"),
    "listing": lambda n: s.Listing(span(n), tuple(expression(c) for c in n.children)),
    "item": _item,
    "set_value": _item,
    "start_value": _item,
    "fixed_noun": lambda n: s.Noun(span(n), _text(n)),
    "cue_ball_of": lambda n: s.CueBallOf(span(n), expression(n.children[0])),
    "called_name": _called,
    "score_of": lambda n: s.ScoreOf(span(n), expression(n.children[0])),
    "score_gap": lambda n: s.ScoreGap(span(n)),
    "who": lambda n: expression(n.children[0]),
    "who_name": lambda n: s.Name(span(n), str(n.children[0])),
    "player": lambda n: s.Player(span(n), _text(n)),
    "opponent_of": lambda n: s.OpponentOf(span(n), expression(n.children[0])),
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
    return s.Choice(span(option), _text(option), _maybe(condition), _block(body))


def _place(n: Any) -> s.PlaceAt:
    at, kids = span(n.children[0] if n.children else n), [_text(child) for child in n.children]
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
    return s.Win(span(n), str(n.data), expression(n.children[0]), _text(n.children[1]))


def _require(n: Any) -> s.Statement:
    what = _text(n.children[0])
    return s.Require(span(n), str(n.data), what, expression(n.children[1]))


def _add(n: Any) -> s.Statement:
    value, name, who = n.children
    return s.Write(span(name), "add", _text(name), _maybe(who), expression(value))


def _set(n: Any) -> s.Statement:
    name, who, value = n.children
    return s.Write(span(name), "set", _text(name), _maybe(who), expression(value))


def _seat(n: Any) -> s.Statement:
    return s.Seat(span(n), str(n.data), expression(n.children[0]))


_STATEMENTS: dict[str, Callable[[Any], s.Statement]] = {
    "if_statement": _if,
    "for_each": lambda n: s.ForEach(span(n), expression(n.children[0]), _block(n.children[1])),
    "for_each_player": lambda n: s.ForEach(span(n), None, _block(n.children[0])),
    "offer": _offer,
    "foul": lambda n: s.Foul(
        span(n), _text(n.children[0]), _maybe(n.children[1]), n.children[2] is not None
    ),
    "award": _award,
    "deduct": _award,
    "add": _add,
    "set": _set,
    "reset": lambda n: s.Write(span(n), "reset", _text(n.children[0]), _maybe(n.children[1]), None),
    "assign": lambda n: s.Write(
        span(n), "assign", "group", expression(n.children[1]), expression(n.children[0])
    ),
    "go_to_phase": lambda n: s.GoToPhase(span(n.children[0]), _text(n.children[0])),
    "turn_continues": lambda n: s.Turn(span(n), continues=True, who=None),
    "turn_passes": lambda n: s.Turn(span(n), continues=False, who=_maybe(n.children[0])),
    "spot": _spot,
    "respot": _respot,
    "remove": lambda n: s.RemoveBalls(span(n), expression(n.children[0])),
    "rerack": lambda n: s.RackAgain(span(n), _maybe(n.children[0])),
    "restore": lambda n: s.RestoreTable(span(n)),
    "give": lambda n: s.GiveInHand(span(n), expression(n.children[0]), _name(n.children[1])),
    "require": _require,
    "allow": _require,
    "wins": _win,
    "loses": _win,
    "tie": lambda n: s.Win(span(n), "tie", None, _text(n.children[0])),
    "eliminate": _seat,
    "reinstate": _seat,
    "plays": lambda n: s.Plays(span(n), expression(n.children[0])),
    "nothing_happens": lambda n: s.NothingHappens(span(n)),
}


def _header(n: Any) -> list[s.Declaration]:
    word = str(n.data)
    made: list[s.Declaration] = [s.Header(span(n), word, _unquote(n.children[0]))]
    if word == "game" and n.children[1] is not None:
        made.append(s.Header(span(n), "cites", _unquote(n.children[1])))
    return made


def _unquote(token: Any) -> str:
    return str(token).strip('"')


def _track(n: Any) -> list[s.Declaration]:
    name, *units, start = n.children
    return [s.Track(span(n), _text(name), tuple(_text(u) for u in units), _maybe(start))]


def _fact(n: Any) -> list[s.Declaration]:
    name, *rest = n.children
    kind = ""
    values: tuple[str, ...] = ()
    if isinstance(rest[0], Tree) and rest[0].data in ("fact_values", "fact_kind"):
        first = rest.pop(0)
        kind = "values" if first.data == "fact_values" else _text(first)
        values = tuple(_text(v) for v in first.children) if kind == "values" else ()
    rest = [part for part in rest if part is not None]
    default = predicate = asked = zone = None
    for part in rest:
        if part.data == "start_value":
            default = expression(part)
        elif part.data == "name":
            predicate = _text(part)
        elif part.data == "asked_from":
            zone = _text(part.children[0])
        else:
            asked = expression(part)
    return [s.Fact(span(n), _text(name), kind, values, default, predicate, asked, zone)]


def _define(n: Any) -> list[s.Declaration]:
    name, frozen, *rest = n.children
    cases: list[tuple[s.Expr | None, s.Expr]] = []
    if n.data in ("define_as", "define_when"):
        cases = [(None, expression(rest[0]))]
    else:
        for part in rest:
            if part is None:
                continue
            if part.data == "case":
                cases.append((guard(part.children[0]), expression(part.children[1])))
            else:
                cases.append((None, expression(part.children[0])))
    return [s.Define(span(name), _text(name), frozen is not None, tuple(cases))]


_DECLARATIONS: dict[str, Callable[[Any], list[s.Declaration]]] = {
    "language": _header,
    "game": _header,
    "uses": _header,
    "order": lambda n: [s.Header(span(n), "spotting", _text(n.children[0]))],
    "settled": lambda n: [s.Header(span(n), "settled", _text(n.children[0]))],
    "phases": lambda n: [s.Phases(span(n), tuple((_text(c), span(c)) for c in n.children))],
    "track": _track,
    "fact": _fact,
    "home": lambda n: [s.Home(span(n), expression(n.children[0]), _text(n.children[1]))],
    "define_as": _define,
    "define_when": _define,
    "define_cases": _define,
}


def _rule(n: Any, section: str | None, phases: tuple[str, ...]) -> s.Rule:
    if n.data != "rule":
        return s.Rule(span(n), "", section, phases, (), (), (statement(n),))
    title, cite, overrides, *body = n.children
    cites = () if cite is None else tuple(c.strip() for c in str(cite)[1:-1].split(","))
    over = () if overrides is None else overrides.children
    return s.Rule(
        span(title),
        _unquote(title),
        section,
        phases,
        cites,
        tuple((_unquote(token), span(token)) for token in over),
        tuple(statement(part) for part in body),
    )


def _section(n: Any) -> list[s.Rule]:
    head, where, *body = n.children
    name = _text(head).replace("rack ", "game ").replace("frame ", "game ")
    phases = () if where is None else tuple(_text(c) for c in where.children)
    return [_rule(part, name, phases) for part in body]


def script(tree: Any, file: str, source: str) -> s.Script:
    """Build a whole file."""
    declarations: list[s.Declaration] = []
    rules: list[s.Rule] = []
    for child in tree.children:
        if child.data in _DECLARATIONS:
            declarations.extend(_DECLARATIONS[child.data](child))
        elif child.data == "section":
            rules.extend(_section(child))
        else:
            rules.append(_rule(child, None, ()))
    return s.Script(file, source, tuple(declarations), tuple(rules))
