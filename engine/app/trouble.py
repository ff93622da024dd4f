"""Trouble of a script that shows only while a game is played.

One idea: it is told with the places of its rules, as an author needs it, and the match stays as
it was.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.evaluate import OutOfFuel, RuleClash

if TYPE_CHECKING:
    from engine.variant.variant import Variant

ScriptTrouble = (RuleClash, OutOfFuel)
"""What a judgement may raise where the rules contradict each other or never end."""


def told(trouble: Exception, variant: Variant) -> str:
    """Return in one line what is wrong with a variant's script."""
    return f"the rules of {variant.title} ({variant.script_path.name}): {trouble}"
