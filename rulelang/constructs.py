"""Every construct of an expression and what compiles it.

One idea: the compilers know an Expressions, and only this table knows the compilers, so that none
imports another in a circle. Invariant: every class of `Expr` but a bare name is a key.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang import code as k
from rulelang import counting, names, nouns
from rulelang import syntax as s
from rulelang.code import Code
from rulelang.conditions import Conditions
from rulelang.expressions import Constructs, Expressions
from rulelang.happenings import Happenings

if TYPE_CHECKING:
    from rulelang.scope import Scope

CONSTRUCTS = Constructs(
    names.name,
    {
        s.Number: counting.number,
        s.Flag: counting.flag,
        s.Nothing: lambda _x, _n: Code(k.NOTHING, lambda _c: 0),
        s.NameOf: names.name_of,
        s.BallNumber: names.ball_number,
        s.Noun: nouns.noun,
        s.Called: names.called,
        s.Player: nouns.player,
        s.OpponentOf: nouns.opponent_of,
        s.PartnerOf: nouns.partner_of,
        s.CueBallOf: nouns.cue_ball_of,
        s.ScoreOf: counting.score_of,
        s.LotOf: counting.lot_of,
        s.ScoreGap: counting.gap,
        s.ScoreExtreme: counting.extreme_score,
        s.Listing: nouns.listing,
        s.OnTable: nouns.narrowed,
        s.Standing: nouns.standing,
        s.UpTo: nouns.up_to,
        s.Extreme: nouns.extreme,
        s.Except: nouns.except_,
        s.Quantified: nouns.quantified,
        s.Happened: lambda x, n: Happenings(x).happened(n),
        s.Sequence: lambda x, n: Happenings(x).sequence(n),
        s.Total: counting.total,
        s.Arithmetic: counting.arithmetic,
        s.Is: lambda x, n: Conditions(x).compare(n),
        s.Junction: lambda x, n: Conditions(x).junction(n),
        s.Not: lambda x, n: Conditions(x).negation(n),
    },
)


def expressions_in(scope: Scope, source: str, *, frozen: bool = False) -> Expressions:
    """Return the compiler of what is written in `source`."""
    return Expressions(scope, source, CONSTRUCTS, frozen=frozen)
