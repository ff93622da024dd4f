"""Every code of a diagnostic with one sentence: the table that the reference prints.

One idea: R1 is the surface, R2 names, R3 kinds, R4 meaning. Invariant: a code is never reused.
"""

from __future__ import annotations

CODES = {
    "R101": "A word stands where the language expects something else.",
    "R102": "The colon that opens a body is missing.",
    "R103": "`and` and `or` are mixed without brackets.",
    "R104": "The indentation fits no line above it, or a body is missing.",
    "R105": "A tab stands where blanks indent.",
    "R106": "A character has no meaning in the language.",
    "R107": "An event is told with `is` or `are`: events are past-tense verbs without it.",
    "R108": "A string, cite or bracket is not closed.",
    "R109": "The script is too large, too deep, or a number too long.",
    "R110": "The version of the language is not known.",
    "R201": "A name is not known.",
    "R202": "A phase is not declared.",
    "R203": "A name of the wrong sort stands here: a zone, line, spot, pocket or cushion is due.",
    "R204": "A script named by `uses` cannot be found.",
    "R205": "A name is given twice.",
    "R206": "A tracked value is not declared.",
    "R207": "A timer is not declared.",
    "R301": "The kind of a value does not fit where it stands.",
    "R302": "The two sides of `is` are of kinds that cannot be equal.",
    "R303": "A value is kept for each player: say whose.",
    "R304": "A value is not kept for each player: `of` does not fit.",
    "R305": "An action does not belong to the section it stands in.",
    "R306": "A value is not one that the fact or setting can have.",
    "R307": "A number is out of reason here.",
    "R308": "A number with a fraction stands where only whole ones count.",
    "R401": "Two rules decide one thing differently under one condition.",
    "R402": "A rule reads what a later section, or its own, decides.",
    "R403": "A rule overrides a rule that does not exist.",
    "R404": "Rules override each other in a circle.",
    "R405": "A define reads itself.",
    "R406": "No rule leads to a phase.",
    "R407": "A name is defined and never used.",
    "R408": "A rule of a game that cites its rulebook has no cite.",
    "R409": "A frozen define reads what only the shot decides.",
    "R410": "Two rules of one name: an override could not tell them apart.",
    "R411": "A phase has no way out: no rule leads on from it, or ends the game in it.",
    "R412": "A ball is to go to a spot of its own, or home, and has none.",
    "R413": "A call is required that nobody can make on this table.",
    "R414": "Players go out of the game, and no rule ends it.",
}
