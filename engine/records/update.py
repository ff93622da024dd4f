"""Expectations are rewritten to what the referee says; the diff is the review.

One idea: only the values that differ change; comments, order and everything else stay.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import tomlkit

if TYPE_CHECKING:
    from collections.abc import MutableMapping

    from tomlkit.items import Array

    from engine.records.run import Outcome


def update_text(text: str, outcome: Outcome) -> str:
    """Return the record's text with every differing expectation set to what was got.

    A difference without a value (a position nobody knows) leaves its key as it is.
    """
    document = tomlkit.parse(text)
    shots: Any = document["shot"]
    for one in outcome.differences:
        shot = shots[one.shot - 1]
        if one.key == "events":
            shot["events"] = _listed(one.got)
        elif one.key.startswith("after.positions."):
            ball = one.key.removeprefix("after.positions.")
            shot["after"]["positions"][ball] = one.got
        elif one.got is not None:
            _set(shot["expect"], one.key, one.got)
    return tomlkit.dumps(document)


def _set(expect: MutableMapping[str, Any], key: str, got: object) -> None:
    if not isinstance(got, dict):
        expect[key] = got
        return
    for name, value in got.items():
        if value is not None:
            expect[key][name] = value


def _listed(events: object) -> Array:
    array = tomlkit.array()
    array.extend(events if isinstance(events, list) else [])
    return array.multiline(True)  # noqa: FBT003  tomlkit's own signature
