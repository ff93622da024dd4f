"""From ranges and groups of balls to the balls themselves.

One idea: what is said of a range holds for each of its balls, and what is said later of fewer
balls wins; groups add up.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from engine.physics.world import Ball
from engine.table.furniture import BallId, SpotId
from engine.variant.report import nearest
from engine.variant.spec import BallShape
from engine.variant.variant import BallKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.spec import BallSet

_RANGE = re.compile(r"((?:[a-z0-9]+-)*?)([0-9]{1,3})\.\.((?:[a-z0-9]+-)*?)([0-9]{1,3})")
_HYPHENATED = re.compile(r"[0-9]{1,3}-[0-9]{1,3}")
_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
_MOST = 200


class RangeError(ValueError):
    """A name or range of balls that cannot be read; `code` and `mend` tell why."""

    def __init__(self, code: str, message: str, mend: str) -> None:
        super().__init__(message)
        self.code = code
        self.mend = mend


def names_in(written: str) -> list[str]:
    """Return the names in "disc-1..disc-6", or the one name that is no range."""
    if _HYPHENATED.fullmatch(written):
        message = f"`{written}` is no range of balls"
        raise RangeError("V109", message, f'write "{written.replace("-", "..")}"')
    if ".." not in written:
        if not _NAME.fullmatch(written):
            raise RangeError("V107", f"`{written[:60]}` is not kebab-case", "as in `corner-1`")
        return [written]
    match = _RANGE.fullmatch(written)
    if match is None or match.group(1) != match.group(3):
        message = f"`{written[:60]}` is no range of balls"
        raise RangeError("V109", message, 'write "1..15" or "disc-1..disc-6"')
    first, last = int(match.group(2)), int(match.group(4))
    if not 0 <= last - first < _MOST:
        message = f"`{written}` holds no ball or more than {_MOST}"
        mend = f'write "{match.group(1)}{last}..{match.group(1)}{first}"'
        mend = mend if last < first else f"a set has at most {_MOST} balls"
        raise RangeError("V109", message, mend)
    return [f"{match.group(1)}{number}" for number in range(first, last + 1)]


def expand_balls(spec: BallSet, report: Report) -> dict[str, BallShape]:
    """Return one complete shape per ball, in the order of first mention."""
    balls: dict[str, BallShape] = {}
    for written, said in sorted(spec.ball.items(), key=lambda item: ".." not in item[0]):
        path: KeyPath = ("balls", "ball", written)
        try:
            names = names_in(written)
        except RangeError as error:
            report.add(error.code, path, str(error), error.mend, on_key=True)
            continue
        for name in names:
            balls[name] = _overlay(balls.get(name, BallShape()), said)
    order = {name: rank for rank, name in enumerate(_mentions(spec.ball))}
    if len(balls) > _MOST:
        report.add("V109", ("balls", "ball"), f"a set has at most {_MOST} balls", on_key=True)
    return dict(sorted(balls.items(), key=lambda item: order[item[0]]))


def _mentions(written: Iterable[str]) -> list[str]:
    names: dict[str, None] = {}
    for one in written:
        try:
            names.update(dict.fromkeys(names_in(one)))
        except RangeError:
            continue
    return list(names)


def _overlay(base: BallShape, top: BallShape) -> BallShape:
    said = top.said()
    said["groups"] = [*base.groups, *(name for name in top.groups if name not in base.groups)]
    return base.changed(**said)


def ball_kinds(balls: Mapping[str, BallShape], report: Report) -> tuple[BallKind, ...]:
    """Return the balls as the game knows them; a ball without a colour is a mistake."""
    kinds = []
    for name, shape in balls.items():
        colour = shape.colour
        if colour is None:
            path = place_of(name, report)
            report.add("V306", path, f"ball `{name}` has no colour", 'add colour = "#rrggbb"')
            colour = (255, 255, 255)
        kinds.append(
            BallKind(
                BallId(name),
                colour,
                shape.pattern or "plain",
                _label(name, shape),
                _value(name, shape),
                tuple(shape.groups),
                SpotId(shape.spot) if shape.spot else None,
            )
        )
    return tuple(kinds)


def _number(name: str) -> int:
    digits = name.rpartition("-")[2]
    return int(digits) if digits.isdigit() else 0


def _value(name: str, shape: BallShape) -> int:
    return _number(name) if shape.value == "number" else shape.value or 0


def _label(name: str, shape: BallShape) -> str:
    return str(_number(name)) if shape.label == "number" else shape.label or ""


def bodies(spec: BallSet, balls: Mapping[str, BallShape]) -> tuple[Ball, ...]:
    """Return the balls as the physics knows them."""
    return tuple(
        Ball(
            BallId(name),
            (shape.diameter or spec.diameter) / 2,
            shape.mass or spec.mass,
            sliding=shape.sliding,
            rolling=shape.rolling,
            spin_deceleration=shape.spin_deceleration,
            restitution=shape.restitution,
            grip=1.0 if shape.grip is None else shape.grip,
        )
        for name, shape in balls.items()
    )


def place_of(name: str, report: Report, key: str = "") -> KeyPath:
    """Return the key path of the entry that speaks of a ball, and of `key` if one is asked for.

    The most particular entry wins: the ball's own before a range.
    """
    entries = report.root.find(("balls", "ball"))[0].table
    found: KeyPath = ("balls", "ball")
    for written, node in entries.items():
        try:
            holds = name in names_in(written)
        except RangeError:
            continue
        if holds and (not key or key in node.table):
            path: KeyPath = ("balls", "ball", written)
            if written == name:
                return (*path, key) if key else path
            found = (*path, key) if key else path
    return found


def pick(
    written: Sequence[str], balls: Mapping[str, BallShape], path: KeyPath, report: Report
) -> list[str]:
    """Return the balls meant by names, ranges and groups, in order and once each."""
    groups = group_members(balls)
    picked: dict[str, None] = {}
    for index, one in enumerate(written):
        if one in groups:
            picked.update(dict.fromkeys(groups[one]))
            continue
        try:
            names = names_in(one)
        except RangeError as error:
            report.add(error.code, (*path, index), str(error), error.mend)
            continue
        for name in names:
            if name in balls:
                picked[name] = None
                continue
            mend = nearest(name, [*balls, *groups])
            message = f"there is no ball or group called `{name}`"
            report.add("V302", (*path, index), message, mend)
            break
    return list(picked)


def group_members(balls: Mapping[str, BallShape]) -> dict[str, list[str]]:
    """Return the balls of every group."""
    groups: dict[str, list[str]] = {}
    for name, shape in balls.items():
        for group in shape.groups:
            groups.setdefault(group, []).append(name)
    return groups
