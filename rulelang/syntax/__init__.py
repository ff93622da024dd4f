"""The tree of a script: what was written, before anybody asks whether it makes sense.

One idea: one class per construct, each with the place it was written at; kinds and names are
checked later. Invariant: a tree holds no name resolved and no value computed.
"""

from rulelang.syntax.declarations import (
    Declaration,
    Define,
    Fact,
    Header,
    Home,
    Phases,
    Rule,
    Script,
    SpottingOrder,
    Track,
    Zones,
)
from rulelang.syntax.expressions import (
    Arithmetic,
    BallNumber,
    Called,
    CueBallOf,
    Except,
    Expr,
    Extreme,
    Flag,
    Happened,
    Is,
    Junction,
    Listing,
    Name,
    NameOf,
    Not,
    Nothing,
    Noun,
    Number,
    OnTable,
    OpponentOf,
    Player,
    Quantified,
    ScoreGap,
    ScoreOf,
    Sequence,
    Test,
    Total,
    Verb,
)
from rulelang.syntax.places import (
    Span,
)
from rulelang.syntax.statements import (
    Action,
    AllowStrike,
    Award,
    Choice,
    ForEach,
    Foul,
    GiveInHand,
    GoToPhase,
    If,
    NothingHappens,
    OfferChoices,
    PlaceAt,
    Plays,
    RackAgain,
    RemoveBalls,
    Require,
    RestoreTable,
    Seat,
    SpotBalls,
    Statement,
    Turn,
    Win,
    Write,
    walk,
)

__all__ = [
    "Action", "AllowStrike", "Arithmetic", "Award", "BallNumber", "Called", "Choice", "CueBallOf",
    "Declaration", "Define", "Except", "Expr", "Extreme", "Fact", "Flag", "ForEach", "Foul",
    "GiveInHand", "GoToPhase", "Happened", "Header", "Home", "If", "Is", "Junction", "Listing",
    "Name", "NameOf", "Not", "Nothing", "NothingHappens", "Noun", "Number", "OfferChoices",
    "OnTable", "OpponentOf", "Phases", "PlaceAt", "Player", "Plays", "Quantified", "RackAgain",
    "RemoveBalls", "Require", "RestoreTable", "Rule", "ScoreGap", "ScoreOf", "Script", "Seat",
    "Sequence", "Span", "SpotBalls", "SpottingOrder", "Statement", "Test", "Total", "Track", "Turn",
    "Verb", "Win", "Write", "Zones", "walk",
]  # fmt: skip
