"""The parser's tables, and a walk through them from tokens to a tree.

One idea: the tables are plain numbers and words, so that they can be kept in a file and read again
without the tool that made them; a row of them is unpacked when a text first leads there.
Invariant: trees, places and mistakes are those that Lark makes of the same grammar; a test
compares them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.frozen import value
from rulelang.reading import Token, tokens_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

Place = tuple[int, int, int, int]
"""Line and column from 1, and the range of characters."""

Step = int | tuple[int, str, str, bool, tuple[tuple[int, bool, int], ...] | None, int]
"""What to do at a token: go to a state, or make a node of what lies on top; see Recipe.made."""


@value
class Recipe:
    """How a rule of the grammar makes a node of its `size` parts.

    `name` is the rule's, `data` what its node is called. With `single` an only child stands for
    itself. `picks` are the parts that are kept (None: all), each with whether its own children are
    taken in its place, and with how many absent ones before it; `absent` more are put at the end.
    """

    size: int
    name: str
    data: str
    single: bool
    picks: tuple[tuple[int, bool, int], ...] | None
    absent: int

    def step(self) -> Step:
        """Return the recipe as a walk takes it, faster to unpack."""
        return (self.size, self.name, self.data, self.single, self.picks, self.absent)


class Tree:
    """A node of the parser's tree: what the grammar calls it, its children, where it stands.

    `outer` is its place with the brackets that have been dropped around it. A node without any
    text has no place.
    """

    __slots__ = ("children", "data", "outer", "place")

    def __init__(self, data: str, children: list[Any], place: Place | None) -> None:
        self.data = data
        self.children = children
        self.place = place
        self.outer = place


class Unfit(Exception):  # noqa: N818 - it names the mistake, as the codes do
    """A token that cannot stand where it does, and the kinds of those that could."""

    def __init__(self, token: Token, fitting: frozenset[str]) -> None:
        super().__init__(f"{token.text!r} in line {token.line}")
        self.token = token
        self.line = token.line
        self.fitting = fitting


class _Rows(dict[int, dict[str, Step]]):
    """The steps of each state by the kind of token or the name of a node, unpacked when asked."""

    def __init__(
        self, packed: Sequence[str], names: Sequence[str], recipes: Sequence[Step]
    ) -> None:
        self.packed = packed
        self.names = names
        self.recipes = recipes

    def __missing__(self, state: int) -> dict[str, Step]:
        numbers = [int(part) for part in self.packed[state].split()]
        names, recipes = self.names, self.recipes
        row = {
            names[name]: step if step >= 0 else recipes[-1 - step]
            for name, step in zip(numbers[::2], numbers[1::2], strict=True)
        }
        self[state] = row
        return row


class Automaton:
    """A grammar's tables: `words` has the kind of each keyword and sign.

    `rows` has for each state a text of numbers in pairs: a place in `names`, and the state to go to
    or, below zero, which recipe to follow.
    """

    __slots__ = ("end", "rows", "start", "words")

    def __init__(
        self,
        start: int,
        end: int,
        words: Mapping[str, str],
        names: Sequence[str],
        recipes: Sequence[Recipe],
        rows: Sequence[str],
    ) -> None:
        self.start = start
        self.end = end
        self.words = words
        self.rows = _Rows(rows, names, [one.step() for one in recipes])

    def parse(self, text: str) -> Tree:
        """Return the tree of a text; raises Unfit, Unreadable or BadDedent."""
        rows, end = self.rows, self.end
        states, values = [self.start], list[Any]()
        for token in tokens_of(text, self.words):
            kind = token.kind
            while True:
                step = rows[states[-1]].get(kind)
                if type(step) is int:
                    states.append(step)
                    values.append(token)
                    break
                if step is None:
                    raise Unfit(token, self.fitting(states))
                size, name, data, single, picks, absent = step  # type: ignore[misc]
                if size:
                    parts = values[-size:]
                    del states[-size:], values[-size:]
                else:
                    parts = []
                if single and size == 1 and picks is None:
                    made = parts[0]
                else:
                    made = _made(parts, data, single, picks, absent)
                after = rows[states[-1]][name]
                states.append(after)  # type: ignore[arg-type]
                values.append(made)
                if after == end and kind == "$END":
                    tree: Tree = made
                    return tree
        raise AssertionError("a text ends with $END")

    def fitting(self, states: Sequence[int]) -> frozenset[str]:
        """Return the kinds of token that can stand where a walk has come to."""
        row = self.rows[states[-1]]
        return frozenset(kind for kind in row if kind.isupper() and self._takes(states, kind))

    def _takes(self, states: Sequence[int], kind: str) -> bool:
        """Tell whether a token of that kind can be passed from here."""
        walk = list(states)
        while True:
            step = self.rows[walk[-1]].get(kind)
            if step is None:
                return False
            if isinstance(step, int):
                return True
            if step[0]:
                del walk[-step[0] :]
            walk.append(self.rows[walk[-1]][step[1]])  # type: ignore[arg-type]
            if walk[-1] == self.end and kind == "$END":
                return True


def _made(
    parts: list[Any],
    data: str,
    single: bool,  # noqa: FBT001 - a recipe, unpacked
    picks: tuple[tuple[int, bool, int], ...] | None,
    absent: int,
) -> Any:
    """Return what a recipe makes of `parts`."""
    if picks is None:
        children = parts
    else:
        children = []
        for number, spread, before in picks:
            if before:
                children += [None] * before
            if not spread:
                children.append(parts[number])
            elif children:
                children += parts[number].children
            else:
                children = parts[number].children
        if absent:
            children += [None] * absent
    place = _place(parts)
    if not single or len(children) != 1:
        return Tree(data, children, place)
    only = children[0]
    if type(only) is Tree and place is not None:
        if only.place is None:
            only.place = place
        only.outer = place
    return only


def _place(parts: list[Any]) -> Place | None:
    """Return from where the first of `parts` that stands anywhere begins to the last one's end."""
    for part in parts:
        if type(part) is Token:
            line, column, start = part.line, part.column, part.start
            break
        if type(part) is Tree and part.outer is not None:
            line, column, start, _ = part.outer
            break
    else:
        return None
    for part in reversed(parts):
        if type(part) is Token:
            return line, column, start, part.end
        if type(part) is Tree and part.outer is not None:
            return line, column, start, part.outer[3]
    return None
