"""The mistakes a variant file can hold: one code each, with what it means.

One idea: the table below is the single list; the reference in the docs is checked against it.
"""

from __future__ import annotations

from types import MappingProxyType

CODES = MappingProxyType(
    {
        "V001": "the file cannot be found or read",
        "V002": "the file is not UTF-8 text",
        "V003": "the file is too large, too deep or has too long a line",
        "V004": "the text is not TOML",
        "V005": "a key or a table is given twice",
        "V101": "a key that is not known here",
        "V102": "a key that is required is missing",
        "V103": "a value of the wrong kind",
        "V104": "a length, mass or angle that cannot be read",
        "V105": "a number outside its range",
        "V106": "a choice that does not exist",
        "V107": "a name that is not kebab-case",
        "V108": "a colour that cannot be read",
        "V109": "a range of balls that cannot be read",
        "V110": "a form that fits none of those allowed here",
        "V201": "a shared part that does not exist",
        "V202": "files that extend or use each other in a circle",
        "V203": "a variant to extend that does not exist",
        "V204": "a rule script that does not exist",
        "V301": "a spot that the table does not have",
        "V302": "a ball or group that the set does not have",
        "V303": "a line that the table does not have",
        "V304": "one name for two things",
        "V305": "a ball that is put in two places",
        "V306": "a ball without a colour",
        "V307": "a cut that the outline does not have",
        "V308": "a zone that the table does not have",
        "V401": "a spot outside the bed",
        "V402": "balls of the rack that overlap",
        "V403": "a ball of the rack that does not lie on the bed",
        "V404": "a line outside the bed or without length",
        "V405": "pockets that cannot be cut like this",
        "V406": "a ball that is too large for a pocket or its table",
        "V407": "places and balls of the rack that do not match in number",
        "V408": "a zone that holds no place on the bed",
        "V409": "an outline that crosses itself",
        "V410": "an arc or a round that cannot be drawn",
        "V411": "a cushion shorter than a ball",
        "V412": "a corner or curve too narrow for a ball",
        "V413": "a post or hole that has no room on the bed",
        "V414": "an outline that runs clockwise",
        "V415": "an outline whose middle is not the origin",
        "V416": "a pin that has no room where it stands",
        "V417": "a pin whose belly is not between foot and head",
        "V501": "numbers of players that contradict each other",
        "V502": "a setting whose default is not among its choices or outside its bounds",
        "V503": "cue balls that do not fit the number of players",
    }
)
