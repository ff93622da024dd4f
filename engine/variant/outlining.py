"""From an outline, posts and holes as written to the bare table: its noses, pockets and bed.

One idea: the table is built before anything is placed on it, so that L, W and what lies on the
bed mean the same for every outline. Each fault is reported at the corner where it stands.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, tau
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.table.build import PocketCut, build_table
from engine.table.furniture import Curve, Cushion, CushionId, Pocket, PocketId, Rubber
from engine.table.outline import Corner, OutlineError, box_of, build_outline
from engine.table.region import distance_to, is_hole, is_inside, on_bed, posts_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.table.furniture import Point, Table
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.table_spec import (
        CornerShape,
        OutlineShape,
        PocketShape,
        PostShape,
        TableShape,
    )

_CUTS = "compare mouth, cut, shelf, jaw_radius and radius with those of a shipped table"
_CODES = MappingProxyType(
    {
        "crossing": "V409",
        "arc": "V410",
        "short": "V411",
        "narrow": "V412",
        "clockwise": "V414",
        "centre": "V415",
        "pocket": "V405",
    }
)
_OUTLINE: KeyPath = ("table", "outline")
_LEAST = 0.05


def bed_size(spec: TableShape, report: Report) -> tuple[float, float]:
    """Return L and W (m): as written, or those of the outline's box."""
    if spec.outline is not None:
        for key in ("length", "width", "pockets"):
            if getattr(spec, key) is not None:
                message = f"a table with an outline has no `{key}` of its own"
                mend = "leave it out; pockets are cut at corners, with [outline.cuts]"
                report.add("V110", ("table", key), message, mend, on_key=True)
        box = box_of(_corners(spec.outline))
        if box is None:
            return 1.0, 1.0
        x0, y0, x1, y1 = box
        return max(2.0 * max(-x0, x1), _LEAST), max(2.0 * max(-y0, y1), _LEAST)
    missing = [key for key in ("length", "width") if getattr(spec, key) is None]
    if missing:
        named = " and ".join(f"`{key}`" for key in missing)
        message = f"{named} {'is' if len(missing) == 1 else 'are'} missing"
        mend = "add " + ", ".join(f"`{key} = ...`" for key in missing)
        report.add("V102", ("table", missing[0]), message, mend + ", or an `outline`")
    return spec.length or 1.0, spec.width or 1.0


def bare_table(
    spec: TableShape, size: tuple[float, float], ball: float, report: Report
) -> Table | None:
    """Return the table without marks; None, and a mistake, where it cannot be built.

    `size` is that of `bed_size`, `ball` the largest ball's radius (m).
    """
    if spec.outline is not None:
        return _outlined(spec, spec.outline, ball, report)
    return _rectangle(spec, size, report)


def plain_table(spec: TableShape, size: tuple[float, float]) -> Table:
    """Return a table of that size without pockets, so that marks can be checked."""
    return build_table(*size, spec.nose_height, None, None, spec.rail_width)


def _rectangle(spec: TableShape, size: tuple[float, float], report: Report) -> Table | None:
    path: KeyPath = ("table", "pockets")
    corner = side = None
    if spec.pockets is not None:
        corner = _cut(spec.pockets.corner, (*path, "corner"), report)
        side = _cut(spec.pockets.side, (*path, "side"), report)
        if corner is None or side is None:
            return None
    try:
        return build_table(*size, spec.nose_height, corner, side, spec.rail_width)
    except ValueError as error:
        report.add("V405", path, str(error), _CUTS, on_key=True)
        return None


def _outlined(spec: TableShape, outline: OutlineShape, ball: float, report: Report) -> Table | None:
    corners = _corners(outline)
    cuts = {
        name: _cut(shape, (*_OUTLINE, "cuts", name), report) for name, shape in outline.cuts.items()
    }
    cut_corners = [
        _with_cut(corner, shape, cuts, (*_OUTLINE, "corners", index), report)
        for index, (corner, shape) in enumerate(zip(corners, outline.corners, strict=True))
    ]
    _check_names(outline, report)
    try:
        return build_outline(cut_corners, spec.nose_height, spec.rail_width, ball)
    except OutlineError as error:
        for fault in error.faults:
            path = _OUTLINE if fault.corner is None else (*_OUTLINE, "corners", fault.corner)
            report.add(_CODES[fault.kind], path, fault.message, fault.mend)
    return None


def _corners(outline: OutlineShape) -> list[Corner]:
    """Return the corners without their pockets."""
    return [
        Corner(
            shape.at,
            CushionId(shape.cushion),
            shape.through,
            shape.radius if shape.through is None else None,
            shape.round,
        )
        for shape in outline.corners
    ]


def _with_cut(
    corner: Corner,
    shape: CornerShape,
    cuts: Mapping[str, PocketCut | None],
    path: KeyPath,
    report: Report,
) -> Corner:
    if shape.through is not None and shape.radius is not None:
        mend = "keep one of them"
        report.add("V110", path, "an arc has a radius or goes through a point", mend)
    if shape.pocket is None:
        if shape.cut is not None:
            report.add("V110", path, "a cut belongs to a pocket", 'write pocket = "a-name" too')
        return corner
    if shape.round is not None:
        mend = "leave `round` out; the cut has a jaw_radius"
        report.add("V110", path, "a corner with a pocket is not rounded", mend)
    name = shape.cut or (next(iter(cuts)) if len(cuts) == 1 else "")
    if not name:
        mend = "write [outline.cuts.corner] with mouth, cut, shelf, jaw_radius and radius"
        mend = f"write cut = one of {', '.join(cuts)}" if cuts else mend
        report.add("V307", path, f"how pocket `{shape.pocket}` is cut is not said", mend)
    elif name not in cuts:
        report.unknown("V307", (*path, "cut"), "cut", name, cuts)
    return replace(corner, rounding=None, pocket=PocketId(shape.pocket), cut=cuts.get(name))


def _check_names(outline: OutlineShape, report: Report) -> None:
    """Report names of cushions that stand apart, and of pockets that are given twice."""
    corners = outline.corners
    starts = [
        index for index, one in enumerate(corners) if one.cushion != corners[index - 1].cushion
    ]
    seen: set[str] = set()
    for index in starts:
        name = corners[index].cushion
        if name in seen:
            path = (*_OUTLINE, "corners", index, "cushion")
            message = f"two cushions apart from each other are called `{name}`"
            report.add("V304", path, message, "name one of them anew")
        seen.add(name)
    pockets: set[str] = set()
    for index, corner in enumerate(outline.corners):
        if corner.pocket is not None and corner.pocket in pockets:
            path = (*_OUTLINE, "corners", index, "pocket")
            message = f"two pockets are called `{corner.pocket}`"
            report.add("V304", path, message, "name one of them anew")
        pockets.add(corner.pocket or "")


def _cut(shape: PocketShape, path: KeyPath, report: Report) -> PocketCut | None:
    try:
        return PocketCut(
            shape.mouth,
            shape.cut,
            shape.shelf,
            shape.jaw_radius,
            shape.radius,
            lip=shape.lip,
            rim=shape.rim,
            restitution=shape.restitution,
            friction=shape.friction,
            model=shape.model,
        )
    except ValueError as error:
        report.add("V405", path, str(error), _CUTS, on_key=True)
        return None


def with_bodies(
    table: Table,
    posts: Mapping[str, tuple[Point, float]],
    holes: Mapping[str, tuple[Point, float]],
    shapes: Mapping[str, PostShape],
    report: Report,
) -> Table:
    """Return the table with its posts and holes: names, centres and radii (m).

    `shapes` say what else is written of posts.
    """
    for name, (at, radius) in posts.items():
        path: KeyPath = ("table", "posts", name)
        if _stands_free(table, at, radius, path, report):
            post = _post(CushionId(name), at, radius, shapes[name])
            table = replace(table, cushions=(*table.cushions, post))
    for name, (at, radius) in holes.items():
        path = ("table", "holes", name)
        if _stands_free(table, at, radius, path, report):
            rim = (at[0], at[1] - radius), (at[0], at[1] + radius)
            hole = Pocket(PocketId(name), at, radius, rim)
            table = replace(table, pockets=(*table.pockets, hole))
    return table


def _post(name: CushionId, at: Point, radius: float, shape: PostShape) -> Cushion:
    rubber = Rubber(**shape.rubber.held()) if shape.rubber else None
    circle = Curve(at, radius, 0.0, -tau)
    return Cushion(name, (circle,), rubber, upright=shape.upright)


def _stands_free(table: Table, at: Point, radius: float, path: KeyPath, report: Report) -> bool:
    name = path[-1]
    if name in {c.id for c in table.cushions} | {p.id for p in table.pockets}:
        message = f"`{name}` is a cushion or a pocket already"
        report.add("V304", path, message, "name it anew", on_key=True)
        return False
    taken = in_the_way(table, at, radius)
    if taken:
        message = f"`{name}` {taken}"
        report.add("V413", path, message, "move it, or make it smaller", on_key=True)
    return not taken


def in_the_way(table: Table, at: Point, radius: float) -> str:
    """Return why a round body cannot be there, or nothing."""
    x, y = table.length / 2 - radius, table.width / 2 - radius
    outside = abs(at[0]) > x or abs(at[1]) > y
    if table.outline and not outside:
        outside = not is_inside(table.outline, at) or any(
            distance_to(shape, at) < radius for shape in table.outline
        )
    if outside or not on_bed(table, at):
        return "does not lie on the bed"
    for post in posts_of(table):
        if _away(post.centre, at) < post.radius + radius:
            return f"reaches post `{post.id}`"
    for pocket in table.pockets:
        if _away(pocket.centre, at) < pocket.radius + radius:
            what = "hole" if is_hole(pocket) else "pocket"
            return f"reaches {what} `{pocket.id}`"
    return ""


def _away(a: Point, b: Point) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])
