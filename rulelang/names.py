"""Names, compiled: balls, groups, the author's own, settings of the match, none.

One idea: what a bare word stands for is decided here, once, in one order of precedence.
Invariant: a name that is not known is told with the nearest that is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import constant_name
from rulelang.code import Code, Mistake
from rulelang.defines import defined
from rulelang.scope import nearest
from rulelang.stated import fact, tracked

if TYPE_CHECKING:
    from rulelang.expressions import Expressions


def name(x: Expressions, node: s.Name, domain: str) -> Code:
    """Compile a bare word; `domain` is the sort of name to prefer."""
    name, scope = node.name, x.scope
    if domain == "phase":
        return constant_name(scope.phase(name, node.at))
    if domain == "foul":
        scope.used.add(f"foul {name}")
        return constant_name(name)
    if name in scope.poisoned:
        raise Mistake("R201", node.at, "", silent=True)
    if name in scope.defines:
        return defined(x, name, node.at)
    if name in scope.tracks:
        return tracked(x, name, None, node.at)
    if name in scope.facts:
        return fact(x, name, node.at)
    if name in scope.vocabulary.settings:
        return _setting(name, scope.vocabulary.settings[name])
    if domain:
        return constant_name(name)
    if name in scope.bits:
        mask = scope.bits[name]
        return Code(k.BALLS, lambda _c: mask, constant=mask)
    group = scope.group(name)
    if group is not None:
        return Code(k.BALLS, lambda _c: group, constant=group)
    if name == "none":
        return constant_name(name)
    raise Mistake("R201", node.at, f'"{name}" is not known here', _mend(x, name))


_OTHERWISE = {
    "true": "yes", "false": "no", "on": "yes", "off": "no", "cueball": "cue ball",
    "cue-ball": "cue ball", "object-ball": "object ball", "object-balls": "object balls",
    "any-ball": "any ball", "next-player": "next player", "nobody": "none",
}  # fmt: skip
_NUMBERS = (
    "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
    "twelve", "thirteen", "fourteen", "fifteen",
)  # fmt: skip
"""Number words, from one; a script writes digits."""


def _mend(x: Expressions, name: str) -> str:
    known = x.scope.known()
    if name in _OTHERWISE:
        return f"say `{_OTHERWISE[name]}`"
    word = name.removesuffix("-ball")
    if word in _NUMBERS:
        number = str(_NUMBERS.index(word) + 1)
        return f"write `{number}-ball`" if word != name else f"write {number}"
    if name.isdigit() and name in x.scope.bits:
        return f"did you mean `{name}-ball`?"
    return nearest(name, known) or "define it, track it, or use a name of the variant"


def _setting(name: str, value: Any) -> Code:
    kind = k.FLAG if isinstance(value, bool) else k.NUMBER if isinstance(value, int) else k.NAME
    return Code(kind, lambda c: c.situation.settings.get(name, value), domain=f"setting {name}")


def name_of(x: Expressions, node: s.NameOf) -> Code:
    """Compile `NAME of PLAYER`: a tracked value of one player."""
    if node.name in x.scope.tracks:
        return tracked(x, node.name, node.who, node.at)
    if node.name in x.scope.poisoned:
        raise Mistake("R206", node.at, f'"{node.name}" cannot be read', silent=True)
    mend = (
        nearest(node.name, x.scope.tracks) or f"declare it: track {node.name} per game per player"
    )
    raise Mistake("R206", node.at, f'"{node.name}" is not tracked', mend)


def ball_number(x: Expressions, node: s.BallNumber) -> Code:
    """Compile `9-ball`."""
    if node.name not in x.scope.bits:
        numbers = [f"{name}-ball" for name in x.scope.bits if name.isdigit()]
        mend = nearest(f"{node.name}-ball", numbers) or "there is no such ball on this table"
        raise Mistake("R201", node.at, f"there is no {node.name}-ball", mend)
    mask = x.scope.bits[node.name]
    return Code(k.BALLS, lambda _c: mask, constant=mask)


def called(x: Expressions, node: s.Called) -> Code:
    """Compile `called group`."""
    if node.what != "group":
        raise Mistake("R201", node.at, f'nobody can call a "{node.what}"', "say `called group`")
    groups = x.scope.groups
    return Code(k.BALLS, lambda c: groups.get((c.call and c.call.group) or "", 0))
