"""Expectations are rewritten to what the referee says; the diff is the review.

One idea: only the values that differ change; comments, order and everything else stay.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import tomlkit

if TYPE_CHECKING:
    from engine.records.run import Outcome


def update_text(text: str, outcome: Outcome) -> str:
    """Return the record's text with every differing expectation set to what was got.

    A difference without a value (a position nobody knows) leaves its key as it is.
    """
    document = tomlkit.parse(text)
    shots = document["shot"]
    for one in outcome.differences:
        shot = shots[one.shot - 1]  # type: ignore[index]
        if one.key == "events":
            shot["events"] = _listed(one.got)
        elif one.key.startswith("after.positions."):
            ball = one.key.removeprefix("after.positions.")
            shot["after"]["positions"][ball] = one.got
        elif one.got is not None:
            _set(shot["expect"], one.key, one.got)
    return tomlkit.dumps(document)


def _set(expect: object, key: str, got: object) -> None:
    table = expect[key] if isinstance(got, dict) else None  # type: ignore[index]
    if table is None:
        expect[key] = got  # type: ignore[index]
        return
    for name, value in got.items():  # type: ignore[union-attr]
        if value is not None:
            table[name] = value


def _listed(events: object) -> tomlkit.items.Array:
    array = tomlkit.array()
    array.extend(events)  # type: ignore[arg-type]
    return array.multiline(True)  # noqa: FBT003  tomlkit's own signature
