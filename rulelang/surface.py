"""Mistakes of the surface, told as a person would: what stands there, what would be right.

One idea: the parser knows what it expected; a few looks at the line know what was meant.
Invariant: every mistake has a place in the text and at most one mend.
"""

from __future__ import annotations

import re
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

from rulelang.automaton import Unfit
from rulelang.diagnostics import Diagnostic
from rulelang.meant import Meant, meant, meant_by_sign
from rulelang.reading import BadDedent, Unreadable
from rulelang.words import OPENING, PAST

if TYPE_CHECKING:
    from rulelang.automaton import Automaton
    from rulelang.reading import Token

LONGEST = 200_000
MOST_WORDS = 20_000
LONGEST_SENTENCE = 1000
DEEPEST = 24
HEAVIEST = 100
_WORD = re.compile(r"[^\s(),:]+|[(),:]")
_WEIGHTY = re.compile(r"\b(?:not|plus|minus|times|except|of|touching|by)\b")
_PRESENT = {
    "pockets": "pocketed", "hits": "hit", "leaves": "left", "crosses": "crossed",
    "enters": "entered", "jumps": "jumped", "topples": "toppled", "rebounds": "rebounded",
    "potted": "pocketed", "touches": "touched",
}  # fmt: skip
_OPENERS = ("if ", "otherwise", "rule ", "for each", "offer ", "fouls", "points", "ending")


def scan(source: str, file: str) -> list[Diagnostic]:
    """Return what can be seen without parsing: tabs, size, depth, open strings, long numbers."""
    if len(source) > LONGEST:
        message = f"the script has {len(source)} characters; {LONGEST} are the most"
        return [_at("R109", file, 1, 1, message, "split it: uses ...", source)]
    words = len(_WORD.findall(source))
    if words > MOST_WORDS:
        message = f"the script has {words} words and signs; {MOST_WORDS} are the most"
        return [_at("R109", file, 1, 1, message, "split it: uses ...", source)]
    found = []
    opened = weight = words = 0
    for number, line in enumerate(source.split("\n"), 1):
        found.extend(_scan_line(source, file, number, line))
        code = _code(line)
        weight = len(_WEIGHTY.findall(code)) + (weight if opened else 0)
        words = len(_WORD.findall(code)) + (words if opened else 0)
        opened = max(0, opened + code.count("(") - code.count(")"))
        if opened > DEEPEST or weight > HEAVIEST or words > LONGEST_SENTENCE:
            message = "this is nested too deep, or too long for one sentence"
            mend = "use a define for the inner part"
            return [*found, _at("R109", file, number, 1, message, mend, source)]
    return found


def _code(line: str) -> str:
    """Return a line with its strings blanked and its comment dropped."""
    return re.sub(r'"[^"]*"', lambda m: "_" * len(m.group()), line).split("#")[0]


def _scan_line(source: str, file: str, number: int, line: str) -> list[Diagnostic]:
    def one(code: str, column: int, message: str, mend: str) -> list[Diagnostic]:
        return [_at(code, file, number, column, message, mend, source)]

    if "\t" in line:
        column = line.index("\t") + 1
        return one("R105", column, "a tab stands here", "use blanks: four for each step")
    code = _code(line)
    if '"' in code:
        return one("R108", code.index('"') + 1, "the string is not closed", 'close it with "')
    if code.count("[") > code.count("]"):
        return one("R108", code.index("[") + 1, "the cite is not closed", "close it with ]")
    if code.count("(") > DEEPEST or (len(line) - len(line.lstrip())) // 4 > DEEPEST:
        return one("R109", 1, "this is nested too deep", "use a define for the inner part")
    long_number = re.search(r"\d{10,}", code)
    if long_number:
        return one(
            "R109", long_number.start() + 1, "this number is too long", "nine digits at most"
        )
    fraction = re.search(r"(?<![\d.\w-])\d+\.\d+(?! seconds)", _CITES.sub(_blank, code))
    if fraction and not code.startswith("language"):
        told = fraction.group()
        message = f"{told} is no whole number"
        return one("R308", fraction.start() + 1, message, f"say {round(float(told))}")
    return []


_CITES = re.compile(r"\[[^\]]*\]|^\s*rule _+ \([^:]*\)")
"""Cites, also those that stand in the wrong brackets; their numbers are sections."""


def _blank(found: re.Match[str]) -> str:
    return "_" * len(found.group())


def explain(trouble: Any, source: str, file: str, parser: Automaton) -> Diagnostic:
    """Return the mistake that stopped the parser, with its mend."""
    if isinstance(trouble, BadDedent):
        message = "this line goes back to a depth that no line above it has"
        return _at(
            "R104",
            file,
            trouble.line,
            trouble.column,
            message,
            "align it with the line it belongs to",
            source,
        )
    if isinstance(trouble, Unreadable):
        return _sign(file, trouble.line, trouble.column, source)
    if isinstance(trouble, Unfit):
        return _token(trouble, source, file, parser)
    return _at("R101", file, 1, 1, "this is not a script", "", source)


def _sign(file: str, line: int, column: int, source: str) -> Diagnostic:
    told = meant_by_sign(source.split("\n")[line - 1], column)
    return _at(told.code, file, line, told.column, told.message, told.mend, source, told.width)


def _token(trouble: Unfit, source: str, file: str, parser: Automaton) -> Diagnostic:
    token = trouble.token
    lines = source.split("\n")
    line, column = token.line or len(lines), token.column or 1
    text = token.text
    expected = _spoken(trouble.fitting, parser)
    row = lines[line - 1] if line <= len(lines) else ""
    if token.kind in ("_NL", "$END", "_DEDENT"):
        end = _end_of(token, lines, line)
        known = meant(lines[end - 1], len(lines[end - 1].split("#")[0].rstrip()) + 1)
        if known is not None:
            return _known(known, file, end, source)
        return _line_end(token, lines, line, expected, file, source)
    if token.kind == "_INDENT":
        return _indent(token, lines, file, source)
    before = row[: column - 1].split()
    last = before[-1] if before else ""
    width = max(1, len(text))

    def made(code: str, message: str, mend: str) -> Diagnostic:
        return _at(code, file, line, column, message, mend, source, width)

    known = meant(row, column)
    if known is not None:
        return _known(known, file, line, source)
    special = _special(text, last, row, column, expected)
    if special is not None:
        return made(*special)
    if text in ("and", "or") and re.search(rf"\b{'or' if text == 'and' else 'and'}\b", row):
        return made("R103", "`and` and `or` are mixed", "put brackets around one of them")
    if text in PAST and last in ("is", "are", "was", "were", "has", "have", "been"):
        return made(
            "R107", f"an event is told without `{last}`", f"say `... {text}`, without `{last}`"
        )
    if text in _PRESENT:
        return made("R101", f"`{text}` is not a word of the language", f"say `{_PRESENT[text]}`")
    if last in _PRESENT:
        column = row[: column - 1].rstrip().rfind(last) + 1
        width = len(last)
        return made("R101", f"`{last}` is not a word of the language", f"say `{_PRESENT[last]}`")
    if "`:`" in expected and text in OPENING:
        return made("R102", f"a colon is missing before `{text}`", f"write `: {text}`")
    mend = _close(text, trouble.fitting, parser)
    previous = _close(last, None, parser) if token.kind == "NAME" or last else ""
    if not mend and last and previous and last not in _words(parser):
        column = row[: column - 1].rstrip().rfind(last) + 1
        return _at(
            "R101", file, line, column, f"`{last}` does not fit here", previous, source, len(last)
        )
    only_name = "a name" in expected and "`cue ball`" not in expected and "`it`" not in expected
    if only_name and text in _words(parser) and not mend:
        return made("R101", f"`{text}` is a word of the language", "choose another name")
    told = f"; expected {_listed(expected)}" if expected else ""
    return made("R101", f"`{text}` does not fit here{told}", mend)


def _known(told: Meant, file: str, line: int, source: str) -> Diagnostic:
    return _at(told.code, file, line, told.column, told.message, told.mend, source, told.width)


def _special(
    text: str, last: str, row: str, column: int, expected: list[str]
) -> tuple[str, str, str] | None:
    """Return code, message and mend of a mistake that a look at the line gives away."""
    before = row[: column - 1]
    if text == ":" and before.count("(") > before.count(")"):
        return "R108", "the bracket is not closed", "close it with `)` before the colon"
    opened = before.rpartition("(")[2]
    if _lists(before) and "`,`" in expected and not _SAYS.search(opened) and text[:1].isalnum():
        return "R101", "the members of a list are parted by commas", f"write `, {text}`"
    if text == "not" and "`is`" in expected:
        return "R101", "`not` stands without `is`", "say `is not`"
    if last == "foul" and before.split()[-2:-1] != ["is"] and _in_condition(before):
        return "R101", f"`foul {text}` is an action, not a condition", f"say `foul is {text}`"
    declares = before.split()[:1] in (["define"], ["track"], ["fact"])
    if last in ("a", "an", "the") and declares:
        return "R101", f"`{last}` is an article and is passed over", "give it a longer name"
    players = {"`shooter`", "`opponent`", "`chooser`"} <= set(expected)
    if text == "otherwise":
        return "R101", "this `otherwise` has no `if` above it", "align it with its `if`"
    if players and not {"`cue`", "`if`"} & set(expected):
        mend = "say `shooter`, `opponent` or `next player`"
        return "R101", f"a player is due here, not `{text}`", mend
    if declares and _is_name(text) and _is_name(last) and len(before.split()) < 4:
        return "R101", f"a name is one word, but `{text}` follows", f"say `{last}-{text}`"
    return None


_SAYS = re.compile(r"\b(?:is|are|and|or|not|when)\b")


def _lists(before: str) -> bool:
    """Tell whether a list in brackets is open at the end of a text."""
    return before.count("(") > before.count(")")


def _in_condition(before: str) -> bool:
    """Return whether the text before a place is still the condition of an `if`."""
    return "if " in before and ":" not in before.rsplit("if ", 1)[1]


def _is_name(text: str) -> bool:
    return re.fullmatch(r"[a-z][a-z0-9-]*", text) is not None and text not in ("per", "when", "as")


def _end_of(token: Token, lines: list[str], line: int) -> int:
    """Return the line that ended too early: the last with text, where a blank one is told."""
    if token.kind == "_NL":
        return line
    return max((n for n, text in enumerate(lines, 1) if text.strip() and n <= line), default=1)


def _line_end(
    token: Token, lines: list[str], line: int, expected: list[str], file: str, source: str
) -> Diagnostic:
    line = _end_of(token, lines, line)
    row = lines[line - 1].split("#")[0].rstrip()
    column = len(row) + 1
    if row.endswith(":"):
        return _at(
            "R104",
            file,
            line,
            column,
            "a body is missing after the colon",
            "indent what belongs to it below",
            source,
        )
    if "`:`" in expected or (row.lstrip().startswith(_OPENERS) and ":" not in row):
        return _at(
            "R102", file, line, column, "the colon is missing", "end the line with `:`", source
        )
    if row.count("(") > row.count(")"):
        return _at(
            "R108", file, line, column, "the bracket is not closed", "close it with `)`", source
        )
    last = row.split()[-1] if row.split() else ""
    if last in ("a", "an", "the"):
        message, mend = f"`{last}` is an article and is passed over", "give it a longer name"
        return _at("R101", file, line, column - len(last), message, mend, source, len(last))
    told = f"; expected {_listed(expected)}" if expected else ""
    return _at(
        "R101", file, line, column, f"the line ends too early{told}", "finish the line", source
    )


def _indent(token: Token, lines: list[str], file: str, source: str) -> Diagnostic:
    line = token.end_line or 1
    above = lines[(token.line or 1) - 1].split("#")[0].rstrip()
    column = len(lines[line - 1]) - len(lines[line - 1].lstrip()) + 1
    if above.lstrip().startswith(_OPENERS) and ":" in _code(above) and not above.endswith(":"):
        message = "this line is indented below one that has its action already"
        mend = (
            f"align it with line {token.line}, or put the action of that line on a line of its own"
        )
        return _at("R104", file, line, column, message, mend, source)
    if above.lstrip().startswith(_OPENERS) and not above.endswith(":"):
        code, message = "R102", "the colon is missing"
        return _at(code, file, token.line, len(above) + 1, message, "end the line with `:`", source)
    mend = "align it with the line above"
    return _at("R104", file, line, column, "this line is indented without reason", mend, source)


def _words(parser: Automaton) -> list[str]:
    return list(parser.words)


def _spoken(names: Any, parser: Automaton) -> list[str]:
    patterns = {kind: word for word, kind in parser.words.items()}
    plain = {
        "NAME": "a name", "NUMBER": "a number", "STRING": "a text in quotes", "BALLNO": "a ball",
        "_NL": "the end of the line", "CITE": "a cite", "_INDENT": "an indented body",
        "_DEDENT": "the end of the body", "$END": "the end", "COLON": "`:`",
    }  # fmt: skip
    found = []
    for name in names:
        if name in plain:
            found.append(plain[name])
        elif name in patterns:
            found.append(f"`{patterns[name]}`")
    return sorted(set(found))


def _listed(expected: list[str]) -> str:
    some = expected[:6]
    more = " ..." if len(expected) > len(some) else ""
    return ", ".join(some) + more


def _close(text: str, names: Any, parser: Automaton) -> str:
    words = [word for word, kind in parser.words.items() if names is None or kind in names]
    close = get_close_matches(text, [w for w in words if w.isalpha()], 1, 0.65)
    return f"did you mean `{close[0]}`?" if close else ""


def _at(
    code: str,
    file: str,
    line: int,
    column: int,
    message: str,
    mend: str,
    source: str,
    width: int = 1,
) -> Diagnostic:
    lines = source.split("\n")
    snippet = lines[line - 1] if 0 < line <= len(lines) else ""
    return Diagnostic(code, file, line, column, message, mend, snippet, width)
