"""What made a rule fire or stay silent, in words: which condition, with its values, for whom.

One idea: beside its closure every rule keeps an outline of its branches and loops; the outline is
walked again over what the rule saw, and the words are found then. Nothing of it runs while a shot
is judged. Invariant: telling twice tells the same, and the watch is left as it was.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang import code as k
from rulelang.closures import singles
from rulelang.code import Code
from rulelang.frozen import value
from rulelang.watch import BEGIN, END

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from rulelang.watch import Watch

DEEPEST = 2
"""So many defines are opened up inside each other."""
WIDEST = 8
"""So many balls are named of a set; of the rest it is told how many they are."""
ASKED = "in phase"
KINDS = 3
"""So many reasons are told of a loop; of the rest, for how many they held."""


@value
class Branches:
    """An `if` with what stands under each condition, and under `otherwise`."""

    cases: tuple[tuple[Code, Outline], ...]
    otherwise: Outline | None


@value
class Loop:
    """A `for each`, `over` a set of balls or, where that is None, every player."""

    over: Code | None
    body: Outline


@value
class Deed:
    """Actions that are done whenever they are come to; `amount` what is awarded, if anything."""

    amount: Code | None = None


Outline = tuple["Branches | Loop | Deed", ...]


def in_phases(phases: tuple[str, ...], outline: Outline) -> Outline:
    """Return the outline of what is asked in some phases only; without any, as it is."""
    if not phases:
        return outline
    phase = Code(k.NAME, lambda c: c.phase, text="phase")
    asked = Code(k.FLAG, lambda c: c.phase in phases, shown=phase, word=ASKED)
    asked.truth, asked.text = asked.run, f"in phase {', '.join(phases)}"
    return (Branches(((asked, outline),), None),)


@value
class Reason:
    """Why a part of a rule did something, or nothing; `events` are numbers of events."""

    did: bool
    text: str
    events: tuple[int, ...] = ()


def why(outline: Outline, c: Watch, *, fired: bool) -> tuple[str, tuple[int, ...]]:
    """Return why a rule fired, or why it did not, and the numbers of the events that count."""
    reasons = [one for one in _Teller(c).walk(outline) if one.did is fired]
    texts = list(dict.fromkeys(one.text for one in reasons if one.text))
    events = sorted({number for one in reasons for number in one.events})
    text = "; ".join(texts)
    if fired:
        return text or "always", tuple(events)
    return text or "nothing to do", ()


class _Teller:
    """Walks one outline; what a name stands for is told where it is met first."""

    def __init__(self, c: Watch) -> None:
        self.c = c
        self.opened: set[str] = set()

    def walk(self, outline: Outline) -> Iterator[Reason]:
        for node in outline:
            if isinstance(node, Branches):
                yield from self.branches(node)
            elif isinstance(node, Loop):
                yield from self.loop(node)
            else:
                yield self.deed(node)

    def deed(self, node: Deed) -> Reason:
        amount = node.amount
        if amount is None:
            return Reason(did=True, text="")
        nothing = amount.run(self.c) == 0
        known = not nothing and amount.kind == k.BALLS
        return Reason(did=not nothing, text="" if known else valued(amount, self.c))

    def branches(self, node: Branches) -> Iterator[Reason]:
        failed = []
        for condition, body in node.cases:
            if holds(condition, self.c):
                events = tuple(witnessed(condition, self.c))
                here = Reason(did=True, text=self.told(condition, held=True), events=events)
                yield from _under(here, self.walk(body))
                return
            failed.append(self.told(condition, held=False))
        text = "; ".join(dict.fromkeys(failed))
        if node.otherwise is None:
            yield Reason(did=False, text=text)
            return
        yield from _under(Reason(did=True, text=f"otherwise ({text})"), self.walk(node.otherwise))

    def loop(self, node: Loop) -> Iterator[Reason]:
        """Yield each reason once, with those for whom it held."""
        c, over = self.c, node.over
        it, player = c.it, c.player
        turns = list(range(1, c.players + 1)) if over is None else singles(over.run(c))
        found: dict[tuple[bool, str], tuple[list[int], list[int]]] = {}
        for one in turns:
            if over is None:
                c.player = one
            else:
                c.it = one
            before = set(self.opened)
            for reason in self.walk(node.body):
                whom, events = found.setdefault((reason.did, reason.text), ([], []))
                whom += [one] if one not in whom else []
                events += reason.events
            self.opened = before if one != turns[-1] else self.opened
        c.it, c.player = it, player
        if over is None:
            yield from _gathered(found, _players)
        elif turns:
            yield from _gathered(found, lambda who: f"{balls(c, sum(who))} of {over.text}")
        else:
            yield Reason(did=False, text=f"{over.text}: nothing")

    def told(self, code: Code, *, held: bool, depth: int = 0) -> str:
        """Tell the parts that made a condition true, or those that made it false, with values."""
        if code.word == "not":
            return self.told(code.parts[0], held=not held, depth=depth)
        if code.word in ("and", "or"):
            parts = [part for part in code.parts if holds(part, self.c) is held]
            parts = parts if (code.word == "and") is held else parts[:1]
            return "; ".join(
                dict.fromkeys(self.told(part, held=held, depth=depth) for part in parts)
            )
        if code.word == ASKED and held:
            return code.text
        yes = "yes" if held else "no"
        if code.word == "define" and code.shown is not None:
            inside = self.inside(code, code.shown, held=held, depth=depth)
            return f"{code.text}: {yes}" + (f" ({inside})" if inside else "")
        if code.word in ("shot", "fouls"):
            fouls = ", ".join(foul.name for foul in self.c.fouls)
            return f"{code.text}: {yes}" + (f" ({fouls})" if fouls else "")
        values = ", ".join(valued(part, self.c) for part in _shown(code))
        return f"{code.text}: {values or yes}"

    def inside(self, code: Code, inner: Code, *, held: bool, depth: int) -> str:
        """Tell what a define stands for, where it was not told before and is worth telling."""
        if depth >= DEEPEST or code.text in self.opened:
            return ""
        self.opened.add(code.text)
        if code.kind == k.BALLS:
            found = code.run(self.c)
            return balls(self.c, found) if held and found != self.c.cue else ""
        return "" if inner.truth is None else self.told(inner, held=held, depth=depth + 1)


def _under(above: Reason, inner: Iterable[Reason]) -> Iterator[Reason]:
    """Yield the reasons of a body: what was done is done for the condition above it, too."""
    for one in inner:
        if not one.did:
            yield one
            continue
        text = "; ".join(part for part in (above.text, one.text) if part)
        yield Reason(did=True, text=text, events=above.events + one.events)


def _gathered(
    found: dict[tuple[bool, str], tuple[list[int], list[int]]], names: Callable[[list[int]], str]
) -> Iterator[Reason]:
    for told_of in (True, False):
        mine = [(text, *rest) for (did, text), rest in found.items() if did is told_of]
        for text, whom, events in mine[:KINDS]:
            words = f"for {names(whom)}" + (f": {text}" if text else "")
            yield Reason(did=told_of, text=words, events=tuple(events))
        rest = mine[KINDS:]
        if rest:
            many = sum(len(whom) for _, whom, _ in rest)
            yield Reason(did=told_of, text=f"and for {many} more")


def holds(code: Code, c: Watch) -> bool:
    """Tell whether a condition holds."""
    return code.truth is not None and bool(code.truth(c))


def _shown(code: Code) -> list[Code]:
    """Return the sides of a comparison whose values are not in the text already."""
    if code.shown is None:
        return []
    sides = [code.shown, *([code.beside] if code.beside is not None else [])]
    return [one for one in sides if one.constant is None and one.text not in ("it", "that player")]


def valued(code: Code, c: Watch) -> str:
    """Tell what an expression was."""
    return f"{code.text} was {spoken(code, c)}"


def spoken(code: Code, c: Watch) -> str:
    """Return the value of an expression in words."""
    found = code.run(c)
    if code.kind == k.BALLS:
        return balls(c, found) or "nothing"
    if code.kind == k.FLAG:
        return "yes" if found else "no"
    if code.kind == k.PLAYER:
        return f"player {found}"
    return str(found)


def balls(c: Watch, mask: int) -> str:
    """Return the balls of a set in the order of the variant; of a large one the first few."""
    names = [c.names[bit] for bit in singles(mask)]
    few = names if len(names) <= WIDEST + 1 else names[:WIDEST]
    more = len(names) - len(few)
    return ", ".join(few) + (f" and {more} more" if more else "")


def _players(numbers: list[int]) -> str:
    return ("player " if len(numbers) == 1 else "players ") + ", ".join(map(str, numbers))


def witnessed(code: Code, c: Watch) -> list[int]:
    """Return the numbers of the events that made a condition true."""
    if code.witness is not None:
        return [number for number in code.witness(c, BEGIN, END) if 0 <= number < END]
    if code.word == "not":
        return []
    parts = [*code.parts, *([code.shown] if code.shown is not None else [])]
    return [
        number
        for part in parts
        if holds(part, c) or part.truth is None
        for number in witnessed(part, c)
    ]
