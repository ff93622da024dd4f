"""Rule scripts in colour, for Pygments; the only module that needs it.

One idea: the patterns of `rulelang.highlight` as a lexer of one state.
Invariant: every script that parses is free of error tokens.
"""

from __future__ import annotations

import re
from typing import ClassVar

from pygments.lexer import RegexLexer
from pygments.token import (
    Comment,
    Generic,
    Keyword,
    Literal,
    Name,
    Number,
    Operator,
    Punctuation,
    String,
    Whitespace,
)

from rulelang import highlight as h
from rulelang import words as w

_TOKENS = {
    h.COMMENT: Comment.Single,
    h.STRING: String.Double,
    h.CITE: Literal,
    h.HEADING: Generic.Heading,
    h.BALL: Name.Constant,
    h.FOUL: Name.Exception,
    h.ARTICLE: Comment,
    h.NAME: Name.Variable,
    h.NUMBER: Number,
    h.SIGN: Punctuation,
    w.HEADS: Keyword.Declaration,
    w.SECTION: Keyword.Namespace,
    w.CONTROL: Keyword,
    w.LOGIC: Operator.Word,
    w.ACTION: Name.Function,
    w.EVENT: Keyword.Reserved,
    w.QUANTITY: Operator.Word,
    w.NOUN: Keyword.Type,
    w.PLAYER: Name.Builtin.Pseudo,
    w.UNIT: Keyword.Constant,
    w.PARTICLE: Keyword.Pseudo,
}


class RulesLexer(RegexLexer):
    """Lexer of Headstring's rule scripts."""

    name = "Headstring rules"
    aliases: ClassVar = ["headstring-rules"]
    filenames: ClassVar = ["*.rules"]
    url = ""
    flags = re.MULTILINE
    tokens: ClassVar = {
        "root": [
            (r"\s+", Whitespace),
            *((pattern, _TOKENS[kind]) for kind, pattern in h.patterns()),
        ]
    }
