"""Scripts made up at random from the grammar: well-formed, and otherwise without any sense.

One idea: the grammar's own rules are walked, and a rule that leads to an end soon is taken where
the walk is deep. Invariant: what comes out can be parsed.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from rulelang.making import lark_of

if TYPE_CHECKING:
    from random import Random

NAMES = ("red", "kitchen", "group", "good", "black-spot", "x1", "foot-left", "scratch", "yellow")
SAMPLES = {
    "NAME": NAMES,
    "NUMBER": ("0", "1", "3", "40", "007"),
    "BALLNO": ("8-ball", "9-ball", "15-ball"),
    "STRING": ('"A"', '"No # comment"', '"Wrong (ball) first"'),
    "CITE": ("[3.1]", "[4.8(c),5.1]", "[ S3 R2 ]"),
}
_DEEP = 14


@cache
def _rules() -> tuple[dict[str, list[list[Any]]], dict[str, int], dict[str, str]]:
    """Return the expansions of each symbol, its least depth, and the text of each word."""
    parser = lark_of()
    rules: dict[str, list[list[Any]]] = {}
    for rule in parser.rules:
        rules.setdefault(rule.origin.name, []).append(list(rule.expansion))
    depths: dict[str, int] = {}
    changed = True
    while changed:
        changed = False
        for name, expansions in rules.items():
            least = min(_depth(expansion, depths) for expansion in expansions)
            if least < depths.get(name, 1000):
                depths[name] = least
                changed = True
    words = {t.name: t.pattern.value for t in parser.terminals if t.pattern.type == "str"}
    return rules, depths, words


def _depth(expansion: list[Any], depths: dict[str, int]) -> int:
    return 1 + max((0 if s.is_term else depths.get(s.name, 1000) for s in expansion), default=0)


def random_script(random: Random, size: int = 6) -> str:
    """Return a script of about `size` pieces."""
    tokens = [token for _ in range(size) for token in _walk(random, _piece(random), 0)]
    return _written(random, tokens)


def _piece(random: Random) -> str:
    return random.choice(("_header", "_declaration", "section", "section", "rule", "_statement"))


def _walk(random: Random, symbol: str, depth: int) -> list[str]:
    rules, depths, _ = _rules()
    expansions = rules[symbol]
    if depth > _DEEP:
        least = min(_depth(one, depths) for one in expansions)
        expansions = [one for one in expansions if _depth(one, depths) == least]
    tokens: list[str] = []
    for part in random.choice(expansions):
        if part.is_term:
            tokens.append(part.name)
        else:
            tokens.extend(_walk(random, part.name, depth + 1))
    return tokens


def _written(random: Random, tokens: list[str]) -> str:
    words = _rules()[2]
    text, level, fresh = "", 0, True
    for symbol in tokens:
        if symbol == "_NL":
            text += "\n"
            fresh = True
        elif symbol in ("_INDENT", "_DEDENT"):
            level += 1 if symbol == "_INDENT" else -1
        else:
            word = words[symbol] if symbol in words else random.choice(SAMPLES[symbol])
            text += "    " * level + word if fresh else f" {word}"
            fresh = False
    return text
