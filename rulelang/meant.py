"""What an author meant: mistakes that the words of one line give away.

One idea: a table of turns of phrase that people write and the language does not have, each with
what to write instead; asked only where the parser has already stopped.
Invariant: a line that parses is never looked at.
"""

from __future__ import annotations

import re
from difflib import get_close_matches

from rulelang.frozen import value
from rulelang.program import SECTIONS

_VERBS = r"(?:pocketed|hit|left|crossed|entered|jumped|toppled|touched|rebounded|settled|pressed)"
_HEADS = r"(?:rule|if|for|otherwise|define|offer|at|track|fact|phases|zones|uses|game|language)\b"
_NOT = "put `not` before the whole event: `not cue ball hit any object ball`"
_PLAYERS = "say `shooter`, `opponent`, `next player` or `breaker`"
_OTHERS = {
    "scoring": "points", "score": "points", "next": "next shot", "start": "at game start",
    "setup": "at game start", "end": "ending", "result": "ending", "balls": "table",
    "spotting": "table", "before": "before shot", "calls": "before shot", "choices": "next shot",
}  # fmt: skip


@value
class Meant:
    """What stands wrong in a line: `column` from 1, how wide, what it is and what it should be."""

    code: str
    column: int
    width: int
    message: str
    mend: str


_WHO = r"(?:shooter|opponent|chooser|breaker|winner|loser|next player|that player)"
_DUE = (
    "foul|award|deduct|spot|respot|give|turn|go|add|set|reset|remove|rerack|require|offer|assign"
    "|eliminate|restore|nothing|shooter|opponent|tie"
)
_WORDS = "one|two|three|four|five|six|seven|eight|nine|ten|twelve|fifteen"
_PHRASES: tuple[tuple[str, str, str, str], ...] = (
    (rf"(?P<x>\b{_WHO} continues)\b", "R101", "the turn goes on, not the player",
     "say `turn continues`"),
    (r"(?P<x>\b(?:subtract|take)) (?P<n>\S+)(?: points?)? from\b", "R101",
     "`{x}` is not a word of the language", "say `deduct {n} from ...`"),
    (r"(?P<x>\bgive) (?P<n>\d+)\b", "R101", "points are awarded", "say `award {n} to ...`"),
    (rf"\bdeduct \S+ (?P<x>{_WHO})\b", "R101", "a word is missing before the player",
     "say `from {x}`"),
    (rf"\baward \S+ (?P<x>{_WHO})\b", "R101", "a word is missing before the player",
     "say `to {x}`"),
    (rf"\bgive {_WHO} (?P<x>ball in hand)\b", "R101", "it is the cue ball that is in hand",
     "say `cue ball in hand`"),
    (rf"\bgive (?P<x>(?:cue )?ball in hand) to (?P<w>{_WHO})\b", "R101",
     "the player comes first", "say `give {w} cue ball in hand`"),
    (r"(?P<x>,) else\b", "R101", "no comma stands before `else`", "leave it out"),
    (r"\brequire [a-z-]+(?P<x>,)", "R101", "what is required is joined by `and` or `or`",
     "write `and` or `or` for the comma"),
    (r"(?P<x>\b(?P<w>shooter|opponent) score)\b", "R101", "the score comes first",
     "say `score of {w}`"),
    (r"(?<!\bis )(?<!\bare )(?<!\bnot )(?P<x>\b(?:at least|at most|more than|fewer than))\b",
     "R101", "a comparison has `is` or `are`", "say `is {x}`"),
    (r"^at (?P<x>(?:the )?(?P<e>start|end) of (?:the )?(?P<u>game|match|rack|frame))\b", "R101",
     "the moment is told the other way round", "say `at {u} {e}:`"),
    (r"(?P<x>\bgoto) \S*", "R101", "`{x}` is two words", "say `go to phase ...`"),
    (r"\bgo to (?P<x>(?!phase\b)(?P<n>[a-z][a-z0-9-]*))", "R101", "a word is missing",
     "say `go to phase {n}`"),
    (r"\bin hand (?P<x>behind|above|below|beyond|from|on|at)\b", "R101", "`{x}` does not fit here",
     "say `in hand in` and the name of a zone"),
    (r"(?P<x>\b(?P<n>legal|foul) shot)\b", "R101", "a shot is said to be so",
     "say `shot is {n}`"),
    (r"^define (?P<n>[a-z][a-z0-9-]*) (?P<x>if)\b", "R101", "`if` does not fit here",
     "say `define {n} when`"),
    (r"^define (?P<n>[a-z][a-z0-9-]*)(?P<x>:) \S", "R101", "a word is missing after the name",
     "say `define {n} when` for a condition, `as` for anything else"),
    (r"\b(?:award|deduct|add|worth) \S+ (?P<x>points?)\b", "R101", "`{x}` is not said",
     "leave it out"),
    (r"\bspot (?:\S+ ){1,2}(?P<x>on (?P<n>(?!table)[a-z][a-z0-9-]*))", "R101",
     "a ball is spotted `at` a spot", "say `at {n}`"),
    (r"(?P<x>\bor) (?:at|near|highest|where|later)\b", "R101",
     "places are tried one after the other", "say `else` for `or`"),
    (rf"\bset (?P<n>\S+) to (?P<v>\S+) (?P<x>(?:for|of) (?P<w>{_WHO}))\b", "R101",
     "the player stands beside the name", "say `set {n} of {w} to {v}`"),
    (r"\b(?:is|are) (?P<x>(?P<n>\d+) or more)\b", "R101", "a comparison comes before its number",
     "say `is at least {n}`"),
    (r"\b(?:is|are) (?P<x>(?P<n>\d+) or (?:less|fewer))\b", "R101",
     "a comparison comes before its number", "say `is at most {n}`"),
    (r"(?P<x>\bcall) (?:ball|pocket|safety)\b", "R101", "what must be called is required",
     "say `require`"),
    (r"^(?P<h>uses|game) (?P<x>(?P<n>[^\"]+?))\s*$", "R101", "this stands in quotes",
     'write `{h} "{n}"`'),
    (r"^phases (?:[a-z0-9-]+, )*(?P<a>[a-z0-9-]+) (?P<x>(?P<b>[a-z0-9-]+))", "R101",
     "a comma is missing", "write `{a}, {b}`"),
    (r"(?::|^)\s*(?P<x>(?P<n>[a-z][a-z0-9-]* of [a-z]+) (?:\+|plus) (?P<d>\d+))", "R101",
     "a value is changed by `add`", "say `add {d} to {n}`"),
    (r"(?P<x>\b(?P<a>[a-z]+) in a row)\b", "R101", "a name is one word",
     "join it by hyphens: `{a}-in-a-row`"),
    (r'\boverrides "[^"]*" (?P<x>and) "', "R101", "the names of rules are joined by commas",
     "write a comma for `and`"),
    (r'^\s*rule "[^"]*" (?P<x>\((?P<n>[^:]*)\))', "R101", "a cite stands in square brackets",
     "write `[{n}]`"),
    (r"^track \S+ (?P<x>(?:for )?(?:each|every)) (?P<w>shot|turn|game|match|player|side)\b", "R101",
     "`{x}` does not fit here", "say `per {w}`"),
    (rf"\b(?:at least|at most|more than|fewer than|exactly) (?P<x>{_WORDS})\b", "R101",
     "a number is written in digits", "write digits for `{x}`"),
    (r"(?P<x>\bsetup) ", "R101", "`{x}` is two words", "say `set up`"),
    (r"(?P<x>\bfoot (?:is )?(?:off|not on)(?: the)? floor)\b", "R101", "this is told as an event",
     "say `foot left floor`"),
    (rf"\boffer (?P<x>to) (?P<w>{_WHO})\b", "R101", "`to` does not fit here",
     "say `offer {w}:`"),
    (r"(?P<x>\bball (?P<n>\d+))\b", "R101", "a ball is called by number and `ball`",
     "write `{n}-ball`"),
    (r"(?P<x>\b(?P<n>\d+)ball)\b", "R101", "the hyphen of a ball is missing", "write `{n}-ball`"),
    (r"(?P<x>\b(?:does|did|do|has|have) not)\b", "R101", "`{x}` is not a word of the language",
     _NOT),
    (rf"(?<!is )(?<!are )(?P<x>\bnot) {_VERBS}\b", "R101", "`not` stands inside an event", _NOT),
    (r"^\s*(?P<x>else|elif|else if|elseif)\b", "R101", "`{x}` is not a word of the language",
     "say `otherwise:`; further cases are an `if` of their own"),
    (r"\bif\s*(?P<x>:)", "R101", "the condition is missing",
     "say what must hold: `if cue ball pocketed:`"),
    (rf"(?P<x>\b(?:was|were|has been|have been|gets|got|has|have)) (?P<v>{_VERBS})\b", "R107",
     "an event is told without `{x}`", "say `... {v}`, without `{x}`"),
    (r'\bfoul (?P<x>"(?P<n>[a-z][a-z0-9-]*)")', "R101", "the name of a foul stands without quotes",
     "write `foul {n}`"),
    (r"(?<!is )\bfoul (?P<x>(?P<a>[a-z][a-z-]*) (?P<b>(?!alone|worth)[a-z][a-z-]*))\s*$", "R101",
     "the name of a foul is one word", "write `foul {a}-{b}`"),
    (r"\bin hand (?P<x>anywhere|everywhere)\b", "R101", "`{x}` is no zone",
     "say `in hand in table`, or another zone of the variant"),
    (r"(?P<x>\bplayer (?:\d+|one|two)\b)", "R101", "a player is not called by a number", _PLAYERS),
    (r"\b(?:to|from|give|of) (?:the )?(?P<x>player)\s*$", "R101",
     "it is not said which player", _PLAYERS),
    (r"\baward \S+(?P<x>)\s*$", "R101", "it is not said who gets the points", "add `to shooter`"),
    (r"\bdeduct \S+(?P<x>)\s*$", "R101", "it is not said who loses the points",
     "add `from shooter`"),
    (r"\b(?P<v>wins|loses)(?P<x>)\s*$", "R101", "it is not said what is won or lost",
     "say `{v} game`"),
    (r"^define (?P<n>[a-z][a-z0-9-]*) (?P<x>\d+)", "R101", "a word is missing after the name",
     "say `define {n} as {x}`"),
    (r"(?P<x>\b(?P<a>[a-z]+) (?P<b>string|line|spot|zone)\b)", "R101", "a name is one word",
     "join it by a hyphen: `{a}-{b}`"),
    (rf"(?P<x>\bthen) (?:{_DUE})\b",
     "R102", "an `if` ends with a colon, not with `then`", "write `:` for `then`"),
    (r"^\s+(?P<x>(?P<a>[a-z][a-z-]*) (?P<b>[a-z][a-z-]*)):", "R101", "an option is one word",
     "join it by a hyphen: `{a}-{b}:`"),
    (r"^\s+(?P<n>[a-z][a-z-]*)(?P<x>)\s*$", "R102", "an option has a colon and a consequence",
     "write `{n}: nothing happens`"),
)  # fmt: skip


def meant(row: str, column: int) -> Meant | None:
    """Return what was meant in `row`, where the parser stopped at `column`; None: not known."""
    row = row.split("#", maxsplit=1)[0]
    section = _section(row)
    if section is not None:
        return section
    for pattern, code, message, mend in _PHRASES:
        for match in re.finditer(pattern, row):
            if match.start() + 1 <= column <= max(match.end(), match.end("x")) + 1:
                if message == "an option is one word" and re.match(rf"\s*{_HEADS}", row):
                    continue
                words = match.groupdict()
                width = max(1, len(words["x"]))
                at = match.start("x") + 1
                return Meant(code, at, width, message.format(**words), mend.format(**words))
    return None


def _section(row: str) -> Meant | None:
    """Return what section was meant by a line that opens one that there is not."""
    match = re.fullmatch(rf"(?!{_HEADS})([a-z][a-z ]*?)\s*:\s*", row)
    if match is None or match.group(1) in SECTIONS:
        return None
    name = match.group(1)[:_LONGEST]
    close = get_close_matches(name, SECTIONS, 1, 0.6)
    other = _OTHERS.get(name) or (close[0] if close else "")
    mend = f"say `{other}:`" if other else f"the sections are {', '.join(SECTIONS)}"
    return Meant("R101", 1, len(name), f"there is no section `{name}:`", mend)


_LONGEST = 60
_CURLY = "\u201c\u201d\u201e\u2018\u2019\u00ab\u00bb"
_SIGNS = {
    "==": "say `is`", ">=": "say `is at least`", "=>": "say `is at least`",
    "<=": "say `is at most`", "=<": "say `is at most`", "!=": "say `is not`",
    "//": "a comment begins with `#`", "/*": "a comment begins with `#`", "&&": "say `and`",
    "||": "say `or`",
    "=": "say `is`", "<": "say `is fewer than`", ">": "say `is more than`", "+": "say `plus`",
    "*": "say `times`", "&": "say `and`", "|": "say `or`", "!": "say `not`", "'": 'use "',
    "-": "say `minus`; a name has letters on both sides of its hyphen",
}  # fmt: skip


def meant_by_sign(row: str, column: int) -> Meant:
    """Return what was meant by a character that the language does not have."""
    at = column - 1
    sign = row[at : at + 1]
    for signs in (row[at : at + 2], sign):
        if signs == "=" and (word := re.search(r"\b(set|define)\b[^=:]*$", row[:at])):
            mend = "say `to`" if word[1] == "set" else "say `as`, or `when` for a condition"
            return Meant("R106", column, 1, "`=` has no meaning here", mend)
        if signs in _SIGNS:
            return Meant(
                "R106", column, len(signs), f"`{signs}` has no meaning here", _SIGNS[signs]
            )
    told = f"`{sign}` has no meaning here"
    if sign in _CURLY:
        return Meant("R106", column, 1, told, 'write straight quotes: "')
    if sign == "_":
        return _underscore(row, at)
    if not sign.isupper():
        return Meant("R106", column, 1, told, "leave it out")
    word = re.match(r"[\w-]+", row[at:])
    text = word.group() if word else sign
    if row[:at].rstrip().endswith("rule"):
        title = row[at:].split(":", maxsplit=1)[0].split("[", maxsplit=1)[0].strip()
        return Meant("R106", column, len(title), "the name of a rule stands in quotes",
                     f'write `rule "{title}"`')  # fmt: skip
    mend = f"names and words are lower case: `{text.lower()}`"
    return Meant("R106", column, len(text), told, mend)


def _underscore(row: str, at: int) -> Meant:
    start = len(row[:at]) - len(re.search(r"[\w-]*$", row[:at]).group())  # type: ignore[union-attr]
    word = re.match(r"[\w-]+", row[start:])
    text = word.group() if word else "_"
    mend = f"names are joined by hyphens: `{text.replace('_', '-').strip('-') or 'my-name'}`"
    return Meant("R106", start + 1, len(text), "`_` has no meaning here", mend)
