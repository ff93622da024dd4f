# ruff: noqa: ISC004 - the rows of a table run over several lines
"""The phrases of the language: how each is written, what it means, and an example.

One idea: the reference is made from this table, and a test compiles every example of it.
Invariant: every word of the grammar is used by some example.
"""

from __future__ import annotations

from dataclasses import dataclass

DECLARING, DECIDING, PLACING, EVENTS, TESTS, NOUNS, COUNTS, PLAYERS = (
    "Declarations", "Actions", "Places", "More about events", "Tests", "Nouns", "Numbers",
    "Players",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Phrase:
    """One phrase. In `spelling`, words in capitals stand for something else.

    The example is a line or two of a script for a table with the balls `cue` and `1` to `15`;
    `needs` is what has to be declared for it to stand alone.
    """

    group: str
    spelling: str
    meaning: str
    example: str
    needs: str = ""


def _rows(group: str, *rows: tuple[str, ...]) -> tuple[Phrase, ...]:
    return tuple(Phrase(group, *row) for row in rows)


_PHASES = "phases break, open\nif 8-ball pocketed: go to phase open\n"
_TRACK = "track misses per game per player\n"

PHRASES: tuple[Phrase, ...] = (
    *_rows(
        DECLARING,
        ("language N", "the version of the language", "language 1"),
        ('game "TITLE" [cites "BOOK"]', "the title, and the rulebook that rules cite",
         'game "Eight-ball" cites "WPA 2025"\nrule "A" [3]: if foot left floor: foul foot-up'),
        ('cites "BOOK"', "in a shared script, whose sections its rules cite: in a game that cites"
         " another book they are told with this one's name",
         'cites "WPA 2025"\nrule "A" [3]: if foot left floor: foul foot-up'),
        ('uses "NAME"', "takes the declarations and rules of another script, from `rules/` or"
         " from beside this one; a rule of it may be overridden by name, a name of it not be given"
         " again", 'uses "shared"'),
        ("phases NAME, NAME", "the phases of a game; the first is the one at the start",
         "phases break, open", "if 8-ball pocketed: go to phase open\n"),
        ("zones NAME are (ZONE, ZONE)", "one name for several zones, any of which balls may lie in"
         " together", "zones ends are (kitchen, foot-end)",
         "if object balls are together in ends: foul x\n"),
        ("players per side N", "players are partners: with four players and 2 to a side, 1 and 3"
         " play against 2 and 4; a side has one score", "players per side 2"),
        ("track NAME per SCOPE [per player | per side] [starting VALUE]",
         "a value that is kept; scopes `shot`, `turn`, `game` (`rack`, `frame`), `match`; it goes"
         " back to its start by itself: after the shot, when the turn passes, with a new game,"
         " never", "track fouls-in-a-row per game per player starting 0",
         "if cue ball pocketed: add 1 to fouls-in-a-row of shooter\n"),
        ("fact NAME [one of (A, B) | ball | number] [default VALUE]",
         "what only an eye at the table can tell",
         "fact deliberate default no\nfact moved ball", "if deliberate: foul x\n"
         "if moved is 8-ball: foul y\n"),
        ("fact NAME ... supplied by PREDICATE on SET [from ZONE]",
         "what positions tell, where they are known; a cue ball off the bed is played from the"
         " zone", "fact path one of (full, none) supplied by path on object balls from kitchen",
         "if path is full: foul x\n"),
        ("timer NAME lasts N seconds [per shot | turn | game | match]",
         "time that runs; that it ran out is told to the rules like a fact",
         "timer shot-clock lasts 35 seconds", "when shot-clock expires: foul slow\n"),
        ("define NAME as VALUE", "a name for a set of balls, a number, a player or a condition",
         "define ball-on as lowest object ball on table", "if ball-on pocketed: foul x\n"),
        ("define NAME when CONDITION", "the same, for a condition",
         "define contact when cue ball hit any object ball", "if not contact: foul x\n"),
        ("define NAME:", "one of several values: that of the first case that holds",
         "define worth-of-shot:\n    if 8-ball pocketed: 2\n    otherwise: 1",
         "if worth-of-shot is 2: foul x\n"),
        ("define NAME before shot ...", "frozen when the shot starts",
         "define last-one before shot when number of object balls on table is 1",
         "if last-one: foul x\n"),
        ("spotting order highest | lowest value", "who is spotted first; without it, balls whose"
         " own spot is free, then the order of the variant", "spotting order highest value"),
        ("spotting order (SET, SET)", "the same by sets, the balls of the first set first",
         "spotting order (8-ball, stripes)"),
        ("settled balls count within N seconds",
         "a ball that falls that late still counts as pocketed",
         "settled balls count within 5 seconds"),
        ("home of SET is SPOT", "where `spot ... at home` puts a ball",
         "home of 8-ball is foot-spot"),
        ('rule "NAME" [SECTION, SECTION] overrides "NAME":',
         "names a rule, cites the rulebook, withdraws another rule where both fire",
         'rule "A": if cue ball pocketed: foul x\n'
         'rule "B" [3.1, 3.2] overrides "A": if 8-ball pocketed: foul y'),
    ),
    *_rows(
        DECIDING,
        ("foul NAME [worth N] [alone]", "finds a foul; `alone` withdraws all that are not",
         "if cue ball pocketed: foul scratch worth highest of (4, value of first ball hit) alone"),
        ("award N to WHO", "points", "if 8-ball pocketed: award 1 to shooter"),
        ("deduct N from WHO", "points off; a score may fall below zero",
         "if cue ball pocketed: deduct 1 from shooter"),
        ("add N to NAME [of WHO]", "adds to a tracked number",
         "if cue ball pocketed: add 1 to misses of shooter", _TRACK),
        ("set NAME [of WHO] to VALUE", "sets a tracked value",
         "if cue ball pocketed: set misses of opponent to 3", _TRACK),
        ("reset NAME [of WHO]", "sets it back to its start",
         "if 8-ball pocketed: reset misses of shooter", _TRACK),
        ("assign GROUP to WHO", "sets the tracked value `group` of a player",
         "if any stripe pocketed: assign stripes to shooter",
         "track group per game per player starting none\n"),
        ("turn continues", "the shooter plays on", "if 8-ball pocketed: turn continues"),
        ("turn passes [to WHO]", "somebody else plays; without a name, who comes next",
         "if cue ball pocketed: turn passes to opponent of opponent"),
        ("go to phase NAME", "the phase of the next shot",
         "if 8-ball pocketed: go to phase open", "phases break, open\n"),
        ("spot SET PLACE [else PLACE]", "puts balls back; places are tried in order",
         "if 8-ball pocketed: spot 8-ball at foot-spot else near foot-spot toward foot"),
        ("respot SET", "puts balls on their own spots, or near them", "respot cue"),
        ("remove SET [from table]", "takes balls off the table",
         "for each of object balls hit outside: remove it"),
        ("set up PINS", "stands pins up again", "if left-pin toppled: set up pins"),
        ("rerack [keeping SET]", "racks the balls again; those kept leave places empty",
         "if no object ball is on table: rerack keeping cue"),
        ("restore table", "positions, phase and ball in hand as before the last stroke",
         "offer opponent: replace: restore table"),
        ("give WHO cue ball in hand [in ZONE]", "the next shot is played from the hand",
         "if cue ball pocketed: give opponent cue ball in hand in kitchen"),
        ("require CALL [and | or CALL] from WHO",
         "before the shot: what must be called (`ball`, `pocket`, `safety`, `group`)",
         "before shot: require ball and pocket or safety from shooter"),
        ("allow CALL from WHO", "what may be called", "before shot: allow group from shooter"),
        ("allow SET as cue ball", "other balls that may be struck",
         "before shot: allow stripes as cue ball"),
        ("offer WHO: NAME [if CONDITION]: ...",
         "a choice before the next shot, or in `before shot:` before this one",
         "if cue ball pocketed:\n    offer opponent:\n        play: nothing happens\n"
         "        in-hand if 8-ball is on table: give chooser cue ball in hand in kitchen"),
        ("WHO plays", "in the consequences of an option: who is at the table",
         "offer opponent: pass-back: opponent of chooser plays"),
        ("nothing happens", "a consequence, or a rule that only overrides",
         "offer opponent: play: nothing happens"),
        ("WHO wins | loses game | match", "an end; `rack` and `frame` are spellings of `game`",
         "if 9-ball pocketed: shooter wins rack\nif 8-ball pocketed: shooter loses match"),
        ("tie game | match", "an end without a winner", "if 8-ball pocketed: tie frame"),
        ("eliminate WHO, reinstate WHO", "puts a player out of the game, or in again",
         "if cue ball pocketed: eliminate shooter\nif 8-ball pocketed: reinstate opponent\n"
         "if 9-ball pocketed: leader wins game"),
        ("if CONDITION [unless CONDITION]: ... otherwise if ...: ... otherwise: ...", "branches",
         "if 8-ball pocketed unless cue ball pocketed: turn continues\n"
         "otherwise if 9-ball pocketed: turn continues\notherwise: turn passes"),
        ("for each [of] SET: ...", "once for each ball, which is `it`",
         "for each of stripes pocketed: spot it at foot-spot"),
        ("for each player: ...", "once for each player, who is `that player`",
         "if 8-ball pocketed:\n    for each player: add 1 to misses of that player", _TRACK),
    ),
    *_rows(
        PLACING,
        ("at SPOT", "on a spot that is free", "spot 8-ball at foot-spot"),
        ("at own spot", "on the ball's own spot, as the variant gives it",
         "spot 8-ball at own spot else near own spot toward foot"),
        ("at home", "on the spot that `home of` gives", "spot 8-ball at home",
         "home of 8-ball is foot-spot\n"),
        ("at home of occupant", "where the ball lives that covers the place tried before",
         "spot 8-ball at foot-spot else at home of occupant", "home of balls is foot-spot\n"),
        ("highest free spot", "the free spot of the ball of highest value",
         "spot 8-ball highest free spot"),
        ("near SPOT toward foot | head", "as near to the spot as can be, on the line to that end",
         "spot 8-ball near foot-spot toward foot else near own spot toward head"),
        ("where it lay", "where the ball was before it fell",
         "for each of object balls settled: spot it where it lay"),
        ("later", "after the next shot or later, when there is room",
         "spot 8-ball at foot-spot else later"),
    ),
    *_rows(
        EVENTS,
        ("X hit rail", "a cushion or a jaw", "if no ball hit rail: foul x"),
        ("X hit at least N cushions", "counts contacts with cushions; also `at most`, `exactly`",
         "if cue ball hit at least 3 cushions before cue ball hit 9-ball: foul x"),
        ("X pressed cushion [NAME]", "played into a cushion that it was frozen to: no `hit`",
         "if cue ball pressed cushion head: foul x"),
        ("X pressed Y", "the cue ball played into a ball that it touched",
         "if cue ball pressed 8-ball: foul x"),
        ("X hit pocketed ball", "touched a ball that had fallen before",
         "if cue ball hit pocketed ball: foul x"),
        ("X pocketed in called pocket", "in the pocket that was called",
         "if called ball pocketed in called pocket: turn continues"),
        ("X pocketed in NAME of WHO", "in the pocket that a tracked value of a player names",
         "if any object ball pocketed in goal of shooter: turn continues",
         "track goal per game per player starting none\n"
         "if cue ball pocketed: set goal of shooter to foot-left\n"),
        ("X started in ZONE", "where it lay before the shot",
         "if 8-ball started in kitchen: foul x"),
        ("X stayed together in ZONE", "all began in it and none left it, not even to come back",
         "if object balls stayed together in kitchen: foul x"),
        ("X placed in ZONE, X placed outside ZONE", "where a ball in hand was put; `zone` is"
         " that it had to lie in", "if cue ball placed outside zone: foul x\n"
         "if cue ball placed in kitchen: foul y"),
        ("PIN toppled", "fell, by whatever", "if left-pin toppled: foul x"),
        ("not EVENT", "the negative of the whole event",
         "if not cue ball hit any object ball: foul x"),
        ("A before B, A after B", "A in the stretch before (after) the first time that B happens;"
         " where B never happens there is no such stretch",
         "if no ball hit rail after cue ball hit any object ball: foul x"),
        ("A then B then C", "in this order",
         "if cue ball hit 8-ball then cue ball hit cushion then cue ball hit 9-ball: foul x"),
        ("stroke was played", "the tip struck a ball",
         "if stroke was played and 8-ball is on table: foul x"),
        ("safety was called, safety was not called", "what was announced",
         "if safety was called: turn passes\n"
         "if safety was not called and 8-ball pocketed: turn continues"),
    ),
    *_rows(
        TESTS,
        ("A is B, A is not B", "the same number, name, player or set; for sets, some member of"
         " both", "if first ball hit is not 8-ball: foul x"),
        ("A is one of (B, C)", "any member of A is one of them",
         "if first ball hit is not one of (8-ball, stripes): foul x"),
        ("N is at least M, at most M, more than M, fewer than M", "compares numbers",
         "if number of stripes pocketed is at least 2: foul x\n"
         "if score of shooter is more than 7: foul y\nif score of shooter is fewer than 2: foul z\n"
         "if score of opponent is at most 3: foul w"),
        ("X is on table", "lies on the bed", "if every stripe is on table: foul x"),
        ("PIN is standing", "stands on the bed", "if left-pin is standing: foul x"),
        ("X is in ZONE, X are together in ZONE", "lies there",
         "if 8-ball is in kitchen: foul x\nif object balls are together in kitchen: foul y"),
        ("cue ball is in hand [in ZONE]", "the shot is played from the hand",
         "if cue ball is in hand in kitchen: foul x"),
        ("X is touching Y", "balls that lie against each other",
         "if cue ball is touching any of stripes: foul x"),
        ("X is frozen to cushion [NAME]", "lies against a cushion",
         "if 8-ball is frozen to cushion foot: foul x"),
        ("shot is legal, shot is foul", "whether any foul was found",
         "points: if shot is legal: award 1 to shooter"),
        ("foul is NAME", "whether that foul was found",
         "fouls: if cue ball pocketed: foul scratch\n"
         "points: if foul is scratch: award 1 to opponent"),
        ("scores are level", "all players have the same score",
         "ending: if scores are level: tie game"),
        ("phase is NAME, next phase is NAME", "this shot's phase, and the next one's",
         "table: if next phase is open and phase is not open: rerack", _PHASES),
        ("X is nothing", "an empty set", "if called ball is nothing: foul x"),
        ("A and B, A or B, not A", "`and` and `or` do not mix without brackets",
         "if 8-ball pocketed and (cue ball pocketed or not 9-ball pocketed): foul x"),
    ),
    *_rows(
        NOUNS,
        ("cue ball, struck ball", "the ball that the tip struck",
         "if struck ball is not cue ball of shooter: foul x"),
        ("cue ball of WHO", "a player's own", "if cue ball of opponent pocketed: foul x"),
        ("N-ball, NAME", "a ball: by its number, or by its name", "if 9-ball pocketed: respot cue"),
        ("GROUP", "the balls of a group; `any stripe` is any of `stripes`",
         "if any stripe pocketed: turn continues"),
        ("object balls, balls, pins", "all but the cue ball; all; all pins",
         "if any object ball left table: foul x\nif any pin toppled by cue ball: foul y"),
        ("called ball, called pocket, called group", "what was announced",
         "if called ball is 8-ball and called group is nothing: foul x"),
        ("chosen ball", "the ball that was named with a choice",
         "offer opponent: remove-ball: remove chosen ball"),
        ("it", "the ball of `for each`", "for each of stripes pocketed: remove it"),
        ("first | second | third | last ball hit", "what the cue ball touched, in order; all that"
         " were touched at once", "if second object ball is 8-ball: foul x\n"
         "if third ball hit is 9-ball: foul y"),
        ("first | last ball pocketed", "in the order of falling",
         "if last ball pocketed is 8-ball: foul x"),
        ("highest X, lowest X", "the members of highest or lowest value",
         "if first ball hit is not lowest object ball on table: foul x\n"
         "if highest stripes pocketed: foul y"),
        ("X on table, PINS standing", "the members that lie, or stand, there",
         "if number of stripes on table is 0: foul x\nif number of pins standing is 0: foul y"),
        ("up to N among X", "the first N members in the order of the variant; N is a number or a"
         " name", "for each of up to 2 among stripes: remove it"),
        ("X except Y", "without", "if any of stripes except 9-ball pocketed: foul x"),
        ("(X, Y)", "together", "if any of (stripes, 8-ball) pocketed: foul x"),
        ("X pocketed, X left table ...", "the members to which it happened",
         "for each of (stripes pocketed, balls left table): remove it"),
        ("X hit by Y, pressed by Y, touched by Y, toppled by Y",
         "the members to which Y did it",
         "if any of object balls hit by cue ball is 8-ball: foul x\n"
         "if any of pins touched by cue ball is left-pin: foul y\n"
         "if any of pins toppled by cue ball is left-pin: foul z\n"
         "if any of balls pressed by cue ball is 8-ball: foul w"),
        ("balls touched by player", "other than by the tip in the stroke",
         "if any of balls touched by player is 8-ball: foul x"),
        ("X touching Y", "the members that lie against it",
         "if any of stripes touching cue ball is 9-ball: foul x"),
        ("any, every, no, none of, only, at least N, at most N, more than N, fewer than N,"
         " exactly N", "how many members an event or a test asks for",
         "if only stripes pocketed: foul x\nif exactly 2 stripes pocketed: foul y\n"
         "if none of stripes pocketed: foul z\nif more than 2 balls left table: foul w\n"
         "if fewer than 4 balls hit cushion: foul v"),
        ("nothing, none, yes, no", "the empty set, no name, and flags",
         "if cue ball pocketed: set warned to yes",
         "track warned per shot\nif warned is no: foul x\n"),
    ),
    *_rows(
        COUNTS,
        ("number of X", "how many", "if number of object balls pocketed is 2: foul x"),
        ("value of X, highest value of X, lowest value of X", "points that the balls are worth",
         "if 8-ball pocketed: award value of balls pocketed to shooter\n"
         "if 9-ball pocketed: award highest value of balls pocketed to shooter"),
        ("highest of (A, B), lowest of (A, B)", "of several numbers",
         "if 8-ball pocketed: award highest of (4, value of first ball hit) to shooter"),
        ("highest worth of fouls, number of fouls", "of the shot",
         "points: if shot is foul: award highest worth of fouls to opponent"),
        ("pocket value of X", "what the pockets are worth that balls of X went into",
         "if any ball pocketed: award pocket value of balls pocketed to shooter"),
        ("number of players", "how many are still in",
         "if number of players is 2: turn passes"),
        ("score of WHO, difference of scores", "points so far",
         "ending: if score of shooter is at least 5 and difference of scores is 2: tie game"),
        ("[second] highest score, [second] lowest score", "of all players; the second may be as"
         " good as the first",
         "ending: if lowest score is 0 and second highest score is 5: tie game"),
        ("lot of WHO up to N", "a number from 1 to N drawn by lot, none twice: hidden numbers, the"
         " order of players", "at game start:\n    for each player: set secret of that player to"
         " lot of that player up to 15",
         "track secret per game per player\n"
         "ending: if any of 8-ball pocketed and secret of shooter is 8: shooter wins game\n"),
        ("NAME [of WHO]", "a tracked value, or a setting",
         "if misses of shooter is at least 3: foul x", _TRACK),
        ("A plus B, A minus B, A times B", "arithmetic; `times` binds before the others",
         "if 8-ball pocketed: award 2 times value of 8-ball plus 3 minus 1 to shooter"),
    ),
    *_rows(
        PLAYERS,
        ("shooter, opponent, opponent of WHO", "who plays, and who comes after him",
         "if 8-ball pocketed: award 1 to opponent of opponent"),
        ("NAME", "a define that is a player", "if 8-ball pocketed: award 1 to third-player",
         "define third-player as opponent of opponent\n"),
        ("partner of WHO", "the next player of the same side",
         "if 8-ball pocketed: turn passes to partner of shooter", "players per side 2\n"),
        ("breaker", "who began the game",
         "at game start: give breaker cue ball in hand in kitchen"),
        ("leader", "who has the highest score alone",
         "ending: if 8-ball pocketed: leader wins game"),
        ("next player, waiting player", "who plays next, and who comes after him",
         "next shot: if cue ball pocketed: give next player cue ball in hand in kitchen\n"
         "table: if 8-ball is on table and waiting player is shooter: respot cue"),
        ("chooser", "who chooses an option",
         "offer opponent: in-hand: give chooser cue ball in hand in kitchen"),
        ("winner, loser", "of the game that ended: in `at game end:` and in `at game start:` of"
         " the next one",
         "at game end: add 1 to misses of loser\nat game start: turn passes to winner",
         "track misses per match per player\n"),
        ("player by lot", "one of them, from the match's seed",
         "if 8-ball pocketed: turn passes to player by lot"),
        ("that player", "the player of `for each player`",
         "if 8-ball pocketed:\n    for each player: add 1 to misses of that player", _TRACK),
    ),
)  # fmt: skip
"""Every phrase, in the order of the reference."""

EVENT_PHRASES = (
    ("cue hits 8", "cue ball hit 8-ball"),
    ("cue hits 8 and 9", "cue ball hit every (8-ball, 9-ball)"),
    ("8 hits cushion foot", "8-ball hit cushion foot"),
    ("8 hits jaw foot-left", "8-ball hit jaw of foot-left"),
    ("cue leaves cushion head", "cue ball left cushion head"),
    ("8 pocketed foot-left", "8-ball pocketed in foot-left"),
    ("8 rebounds from foot-left", "8-ball rebounded from foot-left"),
    ("8 settles foot-left after 9 s", "8-ball settled in foot-left"),
    ("8 leaves table", "8-ball left table"),
    ("8 hits outside", "8-ball hit outside"),
    ("cue crosses head-string", "cue ball crossed head-string"),
    ("cue enters kitchen", "cue ball entered kitchen"),
    ("cue leaves kitchen", "cue ball left kitchen"),
    ("cue jumps over 8", "cue ball jumped over 8-ball"),
    ("8 topples left-pin", "8-ball toppled left-pin"),
    ("8 and 9 topple left-pin", "left-pin toppled by 9-ball"),
    ("8 touches left-pin", "8-ball touched left-pin"),
    ("left-pin leans on 8", "left-pin leaned on 8-ball"),
    ("tip hits cue again", "tip hit cue ball again"),
    ("tip follows cue", "tip followed cue ball"),
    ("player touches 8", "player touched 8-ball"),
    ("foot off floor", "foot left floor"),
    ("balls moving", "stroke was too soon"),
    ("no stroke", "stroke was not played"),
    ("time called", "time was called"),
)
"""Each event of a shot record with the phrase that asks for it."""
