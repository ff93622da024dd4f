"""Event phrases and their order, compiled: `A hit B`, `no A ... after B`, `A before B`.

One idea: an event phrase is at once a set (the balls that did it), a condition, and a question
about a stretch of the shot. Invariant: a quantifier of the subject spans the whole timed event.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import account as w
from rulelang import code as k
from rulelang import events_told as t
from rulelang import syntax as s
from rulelang.code import Code, Mistake
from rulelang.signs import CUE, PLACED, Signs, exactly, of_all
from rulelang.watch import BEGIN, END, lie_in, stayed_together, touching

if TYPE_CHECKING:
    from rulelang.events_told import Telling
    from rulelang.expressions import Expressions
    from rulelang.vocabulary import Vocabulary
    from rulelang.watch import Watch


class Happenings:
    """Compiles events for one Expressions."""

    def __init__(self, expressions: Expressions) -> None:
        self.x = expressions

    def happened(self, node: s.Happened) -> Code:
        """Compile `SUBJECT EVENT`."""
        if node.subject is None:
            return self._alone(node)
        verb = node.verb
        if verb.word not in ("touching", "started in"):
            self.x.after_shot(node, verb.word)
        if verb.word in ("placed outside", "placed in"):
            return self._placed(node)
        subject = node.subject
        how, number, base_node = "any", 0, subject
        if isinstance(subject, s.Quantified):
            how, number, base_node = subject.how, subject.count, subject.base
        if isinstance(subject, s.Happened) and isinstance(subject.subject, s.Quantified):
            how, number = subject.subject.how, subject.subject.count
            base_node = s.Happened(subject.at, subject.subject.base, subject.verb)
        base = self.x.want(base_node, k.BALLS)
        telling, parts = self._telling(verb)
        made = self._told(telling, base, how, number)
        for part in (base, *parts):
            made.since = max(made.since, part.since)
            made.staged = made.staged or part.staged
            made.fouls = made.fouls or part.fouls
        return made

    def _told(self, telling: Telling, base: Code, how: str, number: int) -> Code:
        subject, select, find, count = base.run, telling.select, telling.find, t.fits_set

        def within(c: Watch, lo: int, hi: int) -> bool:
            who = subject(c)
            hit = select(c, who, lo, hi)
            if how == "only":
                alike = (c.balls if who & c.balls else 0) | (~c.balls if who & ~c.balls else 0)
                everyone = select(c, alike, lo, hi)
                return hit != 0 and everyone & ~who == 0
            return count(how, number, hit, who)

        def anchor(c: Watch) -> int | None:
            found = find(c, subject(c), BEGIN, END)
            return found[0] if found else None

        def witness(c: Watch, lo: int, hi: int) -> list[int]:
            return find(c, subject(c), lo, hi)

        if how == "only":
            made = Code(k.BALLS, lambda c: select(c, -1, BEGIN, END))
        else:
            made = Code(k.BALLS, lambda c: select(c, subject(c), BEGIN, END))
        made.within, made.anchor, made.witness = within, anchor, witness
        if telling.verb >= 0 and (how in ("any", "only") or (how == "at least" and number > 0)):
            made.signs = self._signs(telling, base, exact=how == "any")
        if made.signs.exact:
            bit = made.signs.exact
            made.truth = lambda c: c.facts & bit != 0
        elif how == "any":
            made.truth = lambda c: select(c, subject(c), BEGIN, END) != 0
        else:
            made.truth = lambda c: within(c, BEGIN, END)
        return made

    def _signs(self, telling: Telling, base: Code, *, exact: bool) -> Signs:
        """Return the signs of somebody's having done something."""
        if base.word == k.CUE_BALL:
            bit = 1 << CUE + telling.verb
        else:
            bit = 1 << telling.verb
            exact = exact and base.constant == self.x.scope.balls and telling.verb not in t.OF_PINS
        return exactly(bit) if exact and telling.whole else Signs(bit)

    def _telling(self, verb: s.Verb) -> tuple[Telling, tuple[Code, ...]]:
        word, target = verb.word, verb.target
        if word in t.BARE_VERBS:
            return t.bare(t.BARE_VERBS[word]), ()
        if word == "pocketed in called pocket":
            return t.matching(w.POCKETED, _called_pocket), ()
        if word == "pocketed in own":
            return self._in_own(verb)
        if word in t.PLACE_VERBS:
            return self._at_place(verb)
        if word == "touching":
            return self._touching(verb)
        if word == "started in":
            zone = self.x.scope.place("zone", verb.place or "", verb.at)
            return t.Telling(
                lambda c, who, _lo, _hi: who & lie_in(c, zone, start=True),
                lambda _c, _who, _lo, _hi: [],
            ), ()
        if word == "stayed together in":
            return self._stayed(verb)
        assert target is not None  # noqa: S101
        return self._on_target(t.TARGET_VERBS[word], target)

    def _stayed(self, verb: s.Verb) -> tuple[Telling, tuple[Code, ...]]:
        zones = self.x.scope.zones(verb.place or "", verb.at)
        self.x.scope.asks.update(zones)
        return t.Telling(
            lambda c, who, _lo, _hi: stayed_together(c, who, zones),
            lambda _c, _who, _lo, _hi: [],
        ), ()

    def _in_own(self, verb: s.Verb) -> tuple[Telling, tuple[Code, ...]]:
        assert verb.target is not None  # noqa: S101
        pocket = self.x.want(verb.target, k.NAME)
        run = pocket.run

        def match(c: Watch) -> Any:
            own = run(c)
            return lambda where: where == own

        return t.matching(w.POCKETED, match), (pocket,)

    def _at_place(self, verb: s.Verb) -> tuple[Telling, tuple[Code, ...]]:
        number, sort = t.PLACE_VERBS[verb.word]
        self.x.scope.asks.update(_asked(self.x.scope.vocabulary, sort, verb.place))
        if isinstance(verb.target, s.Quantified):
            how, count = verb.target.how, verb.target.count
            if how == "any":
                return t.bare(number), ()
            if how == "no":
                return _denied(t.bare(number)), ()
            return t.counted(number, how, count, None), ()
        if verb.place is None or (verb.word == "rebounded" and verb.place == "pocket"):
            return t.bare(number), ()
        place = self.x.scope.place(sort, verb.place, verb.at)
        return t.matching(number, lambda _c: lambda where: where == place), ()

    def _on_target(self, number: int, target: s.Expr) -> tuple[Telling, tuple[Code, ...]]:
        how, count = "any", 0
        if isinstance(target, s.Quantified):
            how, count, target = target.how, target.count, target.base
        balls = self.x.want(target, k.BALLS)
        if how == "any":
            return t.on_balls(number, balls.run, whole=self._is_everything(balls, number)), (balls,)
        if how == "no":
            return _denied(t.on_balls(number, balls.run, whole=False)), (balls,)
        return t.counted(number, how, count, balls.run), (balls,)

    def _is_everything(self, whom: Code, verb: int) -> bool:
        """Tell whether a verb cannot be done to anything else, if not by the ball itself."""
        every = whom.constant == self.x.scope.balls or whom.word == k.OBJECT_BALLS
        return every and verb in t.TO_BALLS

    def _touching(self, verb: s.Verb) -> tuple[Telling, tuple[Code, ...]]:
        assert verb.target is not None  # noqa: S101
        target = verb.target.base if isinstance(verb.target, s.Quantified) else verb.target
        balls = self.x.want(target, k.BALLS)
        run, start = balls.run, self.x.frozen
        return t.Telling(
            lambda c, who, _lo, _hi: who & touching(c, run, start=start),
            lambda _c, _who, _lo, _hi: [],
        ), (balls,)

    def _placed(self, node: s.Happened) -> Code:
        verb = node.verb
        zone = verb.place or ""
        outside = verb.word == "placed outside"
        if not (outside and zone == "zone"):
            self.x.scope.place("zone", zone, verb.at)

        def truth(c: Watch) -> bool:
            placed = None if c.shot is None else c.shot.placed
            if placed is None:
                return False
            wanted = c.situation.in_hand if zone == "zone" else zone
            return wanted is not None and ((wanted not in placed) == outside)

        return Code(k.FLAG, truth, truth=truth, signs=Signs(PLACED))

    def _alone(self, node: s.Happened) -> Code:
        word = node.verb.word
        self.x.after_shot(node, word)
        if word in t.FLAGS:
            return self._told(t.bare(t.FLAGS[word]), _one(), "any", 0)
        if word == "stroke was played":
            played = _flag(lambda c: c.stroke)
            played.signs = Signs(none=1 << w.OMITTED)
            return played
        if word == "safety was called":
            return _flag(lambda c: c.call is not None and c.call.safety)
        if word == "safety was not called":
            return _flag(lambda c: c.call is None or not c.call.safety)
        target = node.verb.target
        assert target is not None  # noqa: S101
        how, count = "any", 0
        if isinstance(target, s.Quantified):
            how, count, target = target.how, target.count, target.base
        balls = self.x.want(target, k.BALLS)
        made = self._told(t.bare(t.ALONE[word]), balls, how, count)
        made.kind = k.FLAG
        made.run = made.truth  # type: ignore[assignment]
        return made

    def sequence(self, node: s.Sequence) -> Code:
        """Compile `A before B`, `A after B`, `A then B [then C]`."""
        parts = [self.x.event(part) for part in node.parts]
        for part, written in zip(parts, node.parts, strict=True):
            if part.within is None or (part.anchor is None and written is not node.parts[0]):
                raise Mistake(
                    "R301", written.at, f"`{part.text}` is no event", "put an event on each side"
                )
        made = self._then(parts) if node.word == "then" else self._timed(node.word, *parts)
        for part in parts:
            made.since = max(made.since, part.since)
            made.staged = made.staged or part.staged
        made.truth = made.run
        return made

    def _timed(self, word: str, first: Code, second: Code) -> Code:
        within, anchor, witness = first.within, second.anchor, first.witness
        assert within is not None  # noqa: S101
        assert anchor is not None  # noqa: S101

        def window(c: Watch) -> tuple[int, int]:
            moment = anchor(c)
            if moment is None:
                return (END, END)
            return (BEGIN, moment) if word == "before" else (moment, END)

        made = Code(k.FLAG, lambda c: within(c, *window(c)))
        made.signs = of_all([first.signs])
        if witness is not None:
            made.witness = lambda c, _lo, _hi: witness(c, *window(c))
        return made

    def _then(self, parts: list[Code]) -> Code:
        def follow(c: Watch) -> list[int]:
            moment, path = BEGIN, []
            for part in parts:
                assert part.witness is not None  # noqa: S101
                later = [n for n in part.witness(c, moment, END) if n > moment]
                if not later:
                    return []
                moment = later[0]
                path.append(moment)
            return path

        made = Code(k.FLAG, lambda c: bool(follow(c)))
        made.witness = lambda c, _lo, _hi: follow(c)
        return made


def _denied(telling: Telling) -> Telling:
    select, find = telling.select, telling.find
    return t.Telling(lambda c, who, lo, hi: who & ~select(c, who, lo, hi), find)


def _called_pocket(c: Watch) -> Any:
    wanted = None if c.call is None else c.call.pocket
    return lambda pocket: wanted is not None and pocket == wanted


def _one() -> Code:
    return Code(k.BALLS, lambda _c: 1)


def _flag(truth: k.Run) -> Code:
    return Code(k.FLAG, truth, truth=truth)


def _asked(words: Vocabulary, sort: str, place: str | None) -> tuple[str, ...]:
    """Return the lines or zones that an event phrase asks about; without a name, all of them."""
    known = {"line": words.lines, "zone": words.zones}.get(sort, ())
    return known if place is None else tuple(name for name in known if name == place)
