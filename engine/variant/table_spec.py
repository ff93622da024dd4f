"""What the table of a variant file may hold: outline, cushions, pockets, marks and zones.

One idea: each table of the file is one model, and a value is read in the units that people write.
"""

from typing import Annotated, Literal

from engine.variant.fields import (
    Coordinate,
    Cut,
    Factor,
    Fraction,
    Gap,
    Metres,
    Name,
    Rgb,
    Size,
    Slope,
    mistake,
)
from engine.variant.shape import Before, Bounds, Shape, Told, empty

MANY = Bounds(max_length=200)
"""No table for people has so many things of one kind, and thousands would take minutes."""


class Place(Shape):
    """A point: `x` and `y`, or a spot's name and how far from it."""

    spot: Name | None = None
    x: Coordinate | None = None
    y: Coordinate | None = None
    dx: Coordinate | None = None
    dy: Coordinate | None = None


_RECKONED = ("L", "W", "R", "L/", "W/", "R/", "L ", "W ", "R ")
"""How a text begins that is a coordinate and no spot's name."""


def _place(written: object) -> object:
    if isinstance(written, str):
        if written.lstrip("-+(")[:2] in _RECKONED or (written[:1].isdigit() and " " in written):
            mend = f'write ["{written}", 0]'
            raise mistake("V110", "a point has two coordinates, in a list", mend)
        return {"spot": written}
    if isinstance(written, list):
        if len(written) != 2:
            raise mistake("V110", "a point has two coordinates", 'write ["-L/4", 0]')
        return {"x": written[0], "y": written[1]}
    if isinstance(written, dict):
        keys = set(written)
        if not (keys >= {"x", "y"} and "spot" not in keys) and "spot" not in keys:
            raise mistake(
                "V110",
                "a place is a spot's name, two coordinates, or a spot and a way from it",
                'write "foot-spot", ["-L/4", 0] or { spot = "foot-spot", dx = "2 R" }',
            )
        return written
    raise mistake(
        "V110", "a place is a spot's name or two coordinates", 'write "foot-spot" or ["-L/4", 0]'
    )


_TWO_LENGTHS = {
    "type": "array",
    "minItems": 2,
    "maxItems": 2,
    "items": {"type": ["number", "string"]},
}
_WAYS = {
    "type": "object",
    "additionalProperties": False,
    "properties": {
        key: {"type": ["string"] if key == "spot" else ["number", "string"]}
        for key in ("spot", "x", "y", "dx", "dy")
    },
    "anyOf": [{"required": ["spot"]}, {"required": ["x", "y"]}],
}
Point = Annotated[
    Place,
    Before(_place),
    Told(
        {
            "anyOf": [{"type": "string"}, _TWO_LENGTHS, _WAYS],
            "description": "A spot's name, two coordinates, or a spot and a way from it.",
        }
    ),
]


class DropShape(Shape):
    """What a ball meets in a pocket: round of its lip, height of its rim, and its own model."""

    lip: Gap = 0.0
    rim: Gap = 0.0
    restitution: Fraction = 0.2
    friction: Factor = 0.2
    model: str | None = None


class PocketShape(DropShape):
    """One kind of pocket: mouth from tip to tip, cut angle, shelf, round of the jaw, drop."""

    rim: Gap = 0.05

    mouth: Size
    cut: Cut
    shelf: Metres = 0.0
    jaw_radius: Size
    radius: Size


class Pockets(Shape):
    """The six pockets of a table."""

    corner: PocketShape
    side: PocketShape


class LineShape(Shape):
    """A line across the bed (`x`), along it (`y`), or between two points."""

    x: Coordinate | None = None
    y: Coordinate | None = None
    start: Point | None = None
    end: Point | None = None
    drawn: bool = True


def _line(written: object) -> object:
    if isinstance(written, dict | LineShape):
        return written
    shown = f'"{written}"' if isinstance(written, str) else written
    mend = "write { x = " + (f"{shown}" if isinstance(shown, str | int | float) else "0") + " }"
    raise mistake("V110", "a line has one of x, y, or start and end", mend)


def _names(written: object) -> object:
    return [written] if isinstance(written, str) else written


Names = Annotated[
    list[Name],
    Before(_names),
    Told({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}),
]


class DiscShape(Shape):
    """A round area."""

    centre: Point
    radius: Size


class FigureShape(Shape):
    """A figure of straight sides without a dent, and all that is nearer to it than `margin`."""

    corners: list[Point]
    margin: Gap = 0.0


class ZoneShape(Shape):
    """An area bounded by lines and discs, a figure, the whole bed, places, or one of several.

    `behind` is towards the head, `beyond` towards the foot, left and right as seen from the head.
    """

    bed: Literal[True] | None = None
    behind: Names = empty(list)
    beyond: Names = empty(list)
    left_of: Names = empty(list)
    right_of: Names = empty(list)
    disc: DiscShape | None = None
    figure: FigureShape | None = None
    places: list[Point] | None = None
    opposite: Annotated[list[Name], Bounds(min_length=2, max_length=20)] | None = None
    with_line: bool = False


class Rubber(Shape):
    """Ball on cushion: restitution by speed, friction by the angle of incidence."""

    restitution: Fraction
    restitution_slope: Slope = 0.0
    restitution_knee: Factor = 0.0
    restitution_bend: Slope = 0.0
    restitution_least: Fraction = 0.0
    friction: Factor
    friction_slope: Slope = 0.0
    frequency_ratio: Annotated[float, Bounds(gt=0, le=100)] = 1.7


class CushionShape(Shape):
    """How one cushion, or the jaws of one pocket, differ from the table's rubber."""

    restitution: Fraction | None = None
    restitution_slope: Slope | None = None
    restitution_knee: Factor | None = None
    restitution_bend: Slope | None = None
    restitution_least: Fraction | None = None
    friction: Factor | None = None
    friction_slope: Slope | None = None
    frequency_ratio: Annotated[float, Bounds(gt=0, le=100)] | None = None
    model: str | None = None


def _pair(written: object) -> object:
    if isinstance(written, list) and len(written) == 2:
        return tuple(written)
    if isinstance(written, tuple):
        return written
    mend = 'write ["1.27 m", "-0.635 m"]'
    raise mistake("V110", "a corner of an outline has two lengths, in a list", mend)


Pair = Annotated[tuple[Metres, Metres], Before(_pair), Told(_TWO_LENGTHS)]


class CornerShape(Shape):
    """A corner of an outline and the cushion from here to the next: straight, or an arc."""

    at: Pair
    cushion: Name
    through: Pair | None = None
    radius: Size | None = None
    round: Gap | None = None
    pocket: Name | None = None
    cut: Name | None = None


class OutlineShape(Shape):
    """A closed chain of cushions, and the ways in which pockets are cut into it."""

    corners: Annotated[list[CornerShape], Bounds(min_length=2, max_length=200)]
    cuts: Annotated[dict[Name, PocketShape], MANY] = empty(dict)


class RoundShape(Shape):
    """A post that stands on the bed, or a hole in it."""

    at: Point
    radius: Size


class PostShape(RoundShape):
    """A post; its rubber, where it has one of its own, and whether its side is upright."""

    rubber: Rubber | None = None
    upright: bool = False


class HoleShape(RoundShape, DropShape):
    """A hole in the bed, and what a ball in it counts."""

    value: Annotated[int, Bounds(ge=-100_000, le=100_000)] = 0


class TableShape(Shape):
    """The furniture; a rectangle has length and width, any other table an outline."""

    source: str = ""
    length: Size | None = None
    width: Size | None = None
    outline: OutlineShape | None = None
    posts: Annotated[dict[Name, PostShape], MANY] = empty(dict)
    holes: Annotated[dict[Name, HoleShape], MANY] = empty(dict)
    cushions: Annotated[dict[Name, CushionShape], MANY] = empty(dict)
    nose_height: Size
    rail_width: Size
    rail_colour: Rgb = (92, 51, 23)
    pocket_colour: Rgb = (12, 12, 12)
    sights: bool = True
    rubber: Rubber
    pockets: Pockets | None = None
    spots: Annotated[dict[Name, Point], MANY] = empty(dict)
    lines: Annotated[dict[Name, Annotated[LineShape, Before(_line)]], MANY] = empty(dict)
    zones: Annotated[dict[Name, ZoneShape], MANY] = empty(dict)
