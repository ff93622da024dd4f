"""The mistakes a record can hold: one code each, with what it means.

One idea: the table below is the single list; the reference in the docs is made from it.
Mistakes of form have the codes of variant files.
"""

from __future__ import annotations

from types import MappingProxyType

CODES = MappingProxyType(
    {
        "T001": "no such file or folder, or a folder without records",
        "T201": "a variant that cannot be loaded",
        "T301": "a ball that the variant does not have",
        "T302": "a setting that the variant does not have, or a value it does not take",
        "T303": "a phase that the script does not have",
        "T304": "a player, or a number of players, that the game does not have",
        "T305": "a range of balls that cannot be read",
        "T306": "a zone that the table does not have",
        "T307": "a contact that cannot be read",
        "T308": "a cushion that the table does not have",
        "T309": "a tracked value that the script does not have",
        "T310": "one value where there is one per player, or the other way round",
        "T311": "an option that the script never offers",
        "T312": "a shot without events, strike or choice",
        "T313": "a pocket that the table does not have",
        "T314": "a group that no ball belongs to",
        "T315": "a fact that the script does not declare",
        "T316": "a text that is no event, or an event with an unknown name",
        "T317": "times that are missing for some events, or go back",
        "T318": "a spot that the table does not have",
        "T319": "a foul that the script never calls",
        "T320": "a spotted ball that cannot be read",
        "T321": "zones, contacts or taken spots that are not what the positions tell",
        "T401": "a shot that cannot be judged: the game is over, a choice is missing, or a stroke "
        "cannot be played because positions are not known, or two rules of the script clash",
    }
)
