"""From a checked shape to the values of a game: world, balls, rack, settings, look.

One idea: everything that needs no rule script is made here, with every check of meaning that the
shape alone cannot make. Invariant: with no new mistakes in the report, the Draft is playable.
"""

from __future__ import annotations

from dataclasses import fields, replace
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.physics.world import MODEL_NAMES, Cloth, Contact, Cue, Models, Rubber, World
from engine.table.furniture import BallId
from engine.variant.ballset import (
    ball_kinds,
    bodies,
    expand_balls,
    group_members,
    place_of,
)
from engine.variant.covering import cover
from engine.variant.furnish import Surveyor, furnish
from engine.variant.pinset import build_pins
from engine.variant.rack import build_rack, check_own_spots
from engine.variant.report import nearest
from engine.variant.variant import Look, Setting
from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from engine.physics.world import Ball
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.spec import BallShape, SettingShape, VariantSpec
    from engine.variant.table_spec import DropShape, TableShape
    from engine.variant.variant import BallKind, PinKind, Rack


@value
class Draft:
    """A variant without its rules."""

    spec: VariantSpec
    world: World
    balls: tuple[BallKind, ...]
    cue_balls: tuple[BallId, ...]
    rack: Rack
    players: tuple[int, int, int]
    settings: Mapping[str, Setting]
    look: Look
    pins: tuple[PinKind, ...] = ()


def assemble(spec: VariantSpec, report: Report) -> Draft | None:
    """Return the draft; None where no table can be built. Mistakes go to the report."""
    balls = expand_balls(spec.balls, report)
    physical = bodies(spec.balls, balls)
    radius = max((body.radius for body in physical), default=spec.balls.diameter / 2)
    surveyor = Surveyor(spec.table, radius, report)
    table = furnish(surveyor)
    pins, pin_kinds = build_pins(spec, balls, surveyor)
    check_own_spots(balls, surveyor)
    rack = build_rack(spec.rack, balls, physical, surveyor)
    kinds = ball_kinds(balls, report)
    _check_names(spec, balls, report)
    _check_sizes(spec, surveyor.bed.width, physical, report)
    cue_balls = _cue_balls(spec, balls, report)
    players = _players(spec, report)
    settings = _settings(spec, report)
    models = _models(spec, report)
    _check_pocket_models(spec.table, report)
    if table is None:
        return None
    table = cover(replace(table, pins=pins), spec.table, _rubber(spec), report)
    world = World(table, physical, _cloth(spec), _contact(spec), _rubber(spec), _cue(spec), models)
    look = Look(
        spec.cloth.colour, spec.table.rail_colour, spec.table.pocket_colour, spec.table.sights
    )
    return Draft(spec, world, kinds, cue_balls, rack, players, settings, look, pin_kinds)


def _check_names(spec: VariantSpec, balls: Mapping[str, BallShape], report: Report) -> None:
    """Report a name that means two things where a script could not tell them apart."""
    for group, members in group_members(balls).items():
        if group in balls:
            path = place_of(members[0], report, "groups")
            report.add("V304", path, f"`{group}` is a ball and a group", "name the group anew")
    marks: dict[str, str] = {}
    for kind, names in (
        ("spot", spec.table.spots),
        ("line", spec.table.lines),
        ("zone", spec.table.zones),
    ):
        for name in names:
            if name in marks:
                where: KeyPath = ("table", f"{kind}s", name)
                message = f"`{name}` is a {marks[name]} and a {kind}"
                report.add("V304", where, message, f"name the {kind} anew", on_key=True)
            marks.setdefault(name, kind)


def _mouths(table: TableShape) -> list[float]:
    """Return what balls must pass (m): mouths as they are cut, and holes."""
    cuts = [table.pockets.corner, table.pockets.side] if table.pockets else []
    cuts += table.outline.cuts.values() if table.outline else []
    return [cut.mouth for cut in cuts] + [2 * hole.radius for hole in table.holes.values()]


def _check_sizes(spec: VariantSpec, width: float, balls: Sequence[Ball], report: Report) -> None:
    """Report balls that fit no pocket or that the noses meet below their middle."""
    told: set[KeyPath] = set()
    mouths = _mouths(spec.table)
    for ball in balls:
        path = place_of(ball.id, report, "diameter")
        if len(path) < 4:
            path = ("balls", "diameter")
        if path in told:
            continue
        told.add(path)
        size = 2 * ball.radius
        if mouths and size >= min(mouths):
            message = f"a ball of {size * 1000:.1f} mm passes no mouth of {min(mouths) * 1000:.1f}"
            report.add("V406", path, message + " mm", "smaller balls or wider mouths")
        elif size > width / 4:
            report.add(
                "V406",
                path,
                "the ball is larger than a quarter of the bed's width",
                'give the diameter with its unit, as in "57.15 mm"',
            )
        elif not ball.radius <= spec.table.nose_height < 2 * ball.radius:
            message = f"a nose {spec.table.nose_height * 1000:.1f} mm high meets this ball "
            message += "below its middle or not at all"
            mend = "the nose stands at 0.62 to 0.7 of the ball's diameter"
            report.add("V406", ("table", "nose_height"), message, mend)
            break


def _cue_balls(
    spec: VariantSpec, balls: Mapping[str, BallShape], report: Report
) -> tuple[BallId, ...]:
    seen: set[str] = set()
    for index, name in enumerate(spec.cue_balls):
        if name not in balls:
            report.unknown("V302", ("cue_balls", index), "ball", name, balls)
        if name in seen:
            report.add(
                "V304",
                ("cue_balls", index),
                f"cue ball `{name}` is named twice",
                "name it once; a single one serves all players",
            )
        seen.add(name)
    count = len(spec.cue_balls)
    if count > 1 and not spec.players.fewest == spec.players.most == count:
        message = f"{count} cue balls for {spec.players.fewest} to {spec.players.most} players"
        report.add("V503", ("cue_balls",), message, "name one for all, or one for each player")
    return tuple(BallId(name) for name in spec.cue_balls)


def _players(spec: VariantSpec, report: Report) -> tuple[int, int, int]:
    players = spec.players
    if not players.fewest <= players.usual <= players.most:
        message = f"fewest {players.fewest}, usual {players.usual}, most {players.most}"
        report.add("V501", ("players",), message, "write them so that fewest <= usual <= most")
    return players.fewest, players.most, players.usual


def _settings(spec: VariantSpec, report: Report) -> Mapping[str, Setting]:
    found = {}
    for name, shape in spec.settings.items():
        path: KeyPath = ("settings", name)
        kinds = {type(choice) for choice in (shape.default, *shape.choices)}
        if len(kinds) > 1:
            message = "default and choices are of different kinds"
            mend = "write all as numbers, all as texts, or all as true and false"
            alike = len({type(choice) for choice in shape.choices}) == 1
            where = "default" if alike else "choices"
            report.add("V502", (*path, where), message, mend)
        elif shape.choices and shape.default not in shape.choices:
            shown = ", ".join(str(choice) for choice in shape.choices)
            message = f"the default {_shown(shape.default)} is not among the choices"
            report.add("V502", (*path, "default"), message, f"choose one of {shown}")
        elif not _within(shape):
            message = f"the default {_shown(shape.default)} is not a number from least to most"
            mend = f"write a whole number without quotes{_bounds(shape)}"
            report.add("V502", (*path, "default"), message, mend)
        found[name] = Setting(
            name, shape.default, tuple(shape.choices), shape.about, shape.least, shape.most
        )
    return MappingProxyType(found)


def _bounds(shape: SettingShape) -> str:
    least = "" if shape.least is None else f", {shape.least} or more"
    return least + ("" if shape.most is None else f", {shape.most} or less")


def _shown(value: object) -> str:
    """Return a value as TOML writes it."""
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)


def _within(shape: SettingShape) -> bool:
    if shape.least is None and shape.most is None:
        return True
    if isinstance(shape.default, bool) or not isinstance(shape.default, int):
        return False
    low = shape.default if shape.least is None else shape.least
    high = shape.default if shape.most is None else shape.most
    return low <= shape.default <= high


def _models(spec: VariantSpec, report: Report) -> Models:
    models = Models()
    for field in fields(Models):
        name = getattr(spec.models, field.name)
        if name is None:
            continue
        known = MODEL_NAMES[field.name]
        if name not in known:
            _unknown_model(field.name, name, ("models", field.name), report)
        else:
            models = replace(models, **{field.name: name})
    return models


def _unknown_model(field: str, name: str, path: KeyPath, report: Report) -> None:
    message = f"there is no {field} model called `{name}`"
    report.add("V106", path, message, nearest(name, MODEL_NAMES[field]))


def _check_pocket_models(table: TableShape, report: Report) -> None:
    """Report pockets, or kinds of pockets, with a model that is none."""
    drops: dict[KeyPath, DropShape] = {}
    if table.pockets:
        drops["table", "pockets", "corner"] = table.pockets.corner
        drops["table", "pockets", "side"] = table.pockets.side
    if table.outline:
        drops |= {("table", "outline", "cuts", n): cut for n, cut in table.outline.cuts.items()}
    drops |= {("table", "holes", name): hole for name, hole in table.holes.items()}
    for path, drop in drops.items():
        if drop.model is not None and drop.model not in MODEL_NAMES["pocket"]:
            _unknown_model("pocket", drop.model, (*path, "model"), report)


def _cloth(spec: VariantSpec) -> Cloth:
    cloth = spec.cloth
    return Cloth(
        sliding=cloth.sliding,
        rolling=cloth.rolling,
        spin_deceleration=cloth.spin_deceleration,
        threshold=cloth.threshold,
        bounce=cloth.bounce,
    )


def _contact(spec: VariantSpec) -> Contact:
    one = spec.balls.contact
    return Contact(
        restitution=one.restitution,
        friction_floor=one.friction_floor,
        friction_rise=one.friction_rise,
        friction_decay=one.friction_decay,
        cluster_gap=one.cluster_gap,
        restitution_slope=one.restitution_slope,
        restitution_knee=one.restitution_knee,
    )


def _rubber(spec: VariantSpec) -> Rubber:
    one = spec.table.rubber
    return Rubber(
        restitution=one.restitution,
        restitution_slope=one.restitution_slope,
        restitution_knee=one.restitution_knee,
        friction=one.friction,
        restitution_bend=one.restitution_bend,
        restitution_least=one.restitution_least,
        friction_slope=one.friction_slope,
        frequency_ratio=one.frequency_ratio,
    )


def _cue(spec: VariantSpec) -> Cue:
    cue = spec.cue
    return Cue(cue.mass, cue.tip_restitution, cue.tip_friction, cue.end_mass_ratio)
