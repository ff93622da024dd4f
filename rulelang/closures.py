"""Small closures and sets: what the compilers of expressions build with.

One idea: a Code is put together from parts, and says of itself what its parts say.
Invariant: nothing here knows the syntax.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang.code import Code

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.watch import Watch

_UNSET: Any = object()
KIND_MENDS = {
    (k.NUMBER, k.BALLS): "say `number of ...` or `value of ...`",
    (
        k.BALLS,
        k.PLAYER,
    ): "name a ball, such as `cue ball of shooter`; a hand is `player touched ...`",
    (k.PLAYER, k.BALLS): "say `shooter`, `opponent` or `next player`",
}


_AS_WRITTEN = {
    k.NUMBER: "write a number, as in 1",
    k.FLAG: "write yes or no",
    k.PLAYER: "say `shooter`, `opponent` or `next player`",
    k.BALLS: "name a ball or a group",
}


def kind_mend(kind: str, made: Code) -> str:
    """Return what to write where a value of `kind` is due and `made` stands."""
    if kind == k.BALLS and made.kind == k.NUMBER and made.text.isdigit():
        return f"write `{made.text}-ball`"
    return KIND_MENDS.get((kind, made.kind), "") or _AS_WRITTEN.get(kind, "")


def names_of(watch: Watch, mask: int) -> frozenset[str]:
    """Return the names of the balls in a mask."""
    names = watch.names
    return frozenset([names[bit] for bit in singles(mask)])


def singles(mask: int) -> list[int]:
    """Return the single bits of a mask, lowest first."""
    found = []
    while mask:
        one = mask & -mask
        found.append(one)
        mask ^= one
    return found


def derive(made: Code, kind: str, run: k.Run, **changes: Any) -> Code:
    """Return a Code like `made` with another kind and closure."""
    new = Code(
        kind, run, since=made.since, staged=made.staged, fouls=made.fouls, text=made.text,
        word=made.word, shown=made.shown, beside=made.beside, parts=made.parts,
    )  # fmt: skip
    for name, value in changes.items():
        setattr(new, name, value)
    return new


def joined(made: Code, *parts: Code) -> Code:
    """Give `made` what its parts say about when it may be read."""
    made.since = max([made.since, *(p.since for p in parts)])
    made.staged = made.staged or any(p.staged for p in parts)
    made.fouls = made.fouls or any(p.fouls for p in parts)
    return made


def remembered(slot: int, run: k.Run, *, staged: bool) -> k.Run:
    """Return a closure that runs once for a shot, or where `staged`, once for a section."""

    def lasting(c: Watch) -> Any:
        memo = c.memo
        found = memo[slot]
        if found is _UNSET:
            found = memo[slot] = run(c)
        return found

    def passing(c: Watch) -> Any:
        memo = c.passing
        found = memo[slot]
        if found is _UNSET:
            found = memo[slot] = run(c)
        return found

    return passing if staged else lasting


def fresh(size: int) -> list[Any]:
    """Return an empty memory of `size` slots."""
    return [_UNSET] * size


def forget(c: Watch) -> None:
    """Forget what may change from section to section."""
    c.passing = fresh(len(c.passing))


def of_set(base: Code, of: Callable[[int], int]) -> k.Run:
    """Return a closure for what follows from the balls of a set alone."""
    run = base.run
    if base.constant is None:
        return lambda c: of(run(c))
    always = of(base.constant)
    return lambda _c: always


def chain(pairs: list[tuple[k.Run | None, k.Run]], default: Any) -> k.Run:
    """Return a closure that takes the first case whose condition holds."""
    if len(pairs) == 1 and pairs[0][0] is None:
        return pairs[0][1]

    def read(c: Watch) -> Any:
        for test, run in pairs:
            if test is None or test(c):
                return run(c)
        return default

    return read


def opponent(watch: Watch, player: int) -> int:
    """Return the player who comes after `player` and is still in."""
    out = watch.situation.eliminated
    for step in range(1, watch.players + 1):
        other = (player - 1 + step) % watch.players + 1
        if other not in out:
            return other
    return player


def player_before(watch: Watch, player: int) -> int:
    """Return the player whose opponent `player` is."""
    others = range(player - 2, player - 2 - watch.players, -1)
    return next(
        (n for k in others if opponent(watch, n := k % watch.players + 1) == player), player
    )


def leader(watch: Watch) -> int:
    """Return the player, or the first of the side, with the highest score; 0 where it is shared."""
    best = max(watch.scores)
    mates = max(1, watch.mates)
    return watch.scores.index(best) + 1 if watch.scores.count(best) == mates else 0


def common_kind(values: list[Code]) -> str | None:
    """Return the kind that all cases of a define share, None where they have none."""
    kinds = {value.kind for value in values} - {k.NOTHING}
    if len(kinds) <= 1:
        return kinds.pop() if kinds else k.BALLS
    return k.BALLS if kinds == {k.BALLS, k.NAME} else None


def constant_name(name: str) -> Code:
    """Return the Code of a name that never changes."""
    return Code(k.NAME, lambda _c: name, constant=name)
