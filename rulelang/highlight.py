"""Highlighting of scripts in editors: the patterns, made from the table of words.

One idea: a list of (kind, pattern) tried in order at each place is all that Pygments and TextMate
need; both are made from it. Invariant: every word of the table is in exactly one pattern.
"""

from __future__ import annotations

from typing import Any

from rulelang import words as w

COMMENT, STRING, CITE, BALL, NUMBER, NAME, ARTICLE, FOUL, HEADING, SIGN = (
    "comment", "string", "cite", "ball", "number", "name", "article", "foul", "heading", "sign",
)  # fmt: skip
_END = r"(?![a-z0-9-])"
_BEGIN = r"(?<![a-z0-9-])"
_HEADINGS = (
    r"^(?:before shot|fouls|points|turn|table|next shot|ending|at [a-z]+ (?:start|end)"
    r"|when [a-z][a-z0-9-]* expires)(?=(?: in phase [^:\n]*)?:)"
)


def patterns() -> list[tuple[str, str]]:
    """Return kinds with regular expressions that Python and Oniguruma read alike, in order."""
    return [
        (COMMENT, r"#.*"),
        (STRING, r'"[^"\n]*"'),
        (CITE, r"\[[^\]\n]*\]"),
        (HEADING, _HEADINGS),
        (BALL, rf"{_BEGIN}[0-9]+-ball{_END}"),
        (FOUL, rf"(?<=\bfoul )(?!is\b)[a-z][a-z0-9]*(?:-[a-z0-9]+)*{_END}"),
        (ARTICLE, _any(w.ARTICLES)),
        *((kind, _any(found)) for kind, found in w.WORDS.items()),
        (NAME, rf"{_BEGIN}[a-z][a-z0-9]*(?:-[a-z0-9]+)*"),
        (NUMBER, r"[0-9]+(?:\.[0-9]+)?"),
        (SIGN, r"[(),:]"),
    ]


def _any(found: tuple[str, ...]) -> str:
    return rf"{_BEGIN}(?:{'|'.join(sorted(found, key=len, reverse=True))}){_END}"


_SCOPES = {
    COMMENT: "comment.line.number-sign",
    STRING: "string.quoted.double",
    CITE: "markup.underline.link",
    HEADING: "entity.name.section",
    BALL: "constant.other.ball",
    FOUL: "entity.name.type.foul",
    ARTICLE: "comment.block.article",
    NAME: "variable.other",
    NUMBER: "constant.numeric",
    SIGN: "punctuation.separator",
    w.HEADS: "keyword.other.declaration",
    w.SECTION: "keyword.other.section",
    w.CONTROL: "keyword.control",
    w.LOGIC: "keyword.operator.logical",
    w.ACTION: "support.function",
    w.EVENT: "keyword.other.event",
    w.QUANTITY: "keyword.operator.quantity",
    w.NOUN: "support.type",
    w.PLAYER: "variable.language.player",
    w.UNIT: "storage.type.unit",
    w.PARTICLE: "keyword.other.particle",
}


def textmate() -> dict[str, Any]:
    """Return the TextMate grammar of rule scripts."""
    return {
        "name": "Headstring rules",
        "scopeName": "source.headstring-rules",
        "fileTypes": ["rules"],
        "patterns": [
            {"name": f"{_SCOPES[kind]}.headstring-rules", "match": match}
            for kind, match in patterns()
        ],
    }
