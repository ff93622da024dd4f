"""The shape of a variant file, as pydantic models.

One idea: these models say which keys exist and what each may hold; whether the names in them
fit together is judged afterwards. Invariant: nothing unknown gets through, and no value is
silently converted.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema

from engine.variant.fields import (
    Coordinate,
    Cut,
    Factor,
    Fraction,
    Gap,
    Kilograms,
    Metres,
    Name,
    Rgb,
    Size,
    Slope,
    Stem,
    mistake,
)

_MANY = Field(max_length=200)
"""No table for people has so many things of one kind, and thousands would take minutes."""


class Shape(BaseModel):
    """What all models share: no unknown keys, no conversion, no change."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


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
    BeforeValidator(_place),
    WithJsonSchema(
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
    BeforeValidator(_names),
    WithJsonSchema({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}),
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
    behind: Names = []
    beyond: Names = []
    left_of: Names = []
    right_of: Names = []
    disc: DiscShape | None = None
    figure: FigureShape | None = None
    places: list[Point] | None = None
    opposite: Annotated[list[Name], Field(min_length=2, max_length=20)] | None = None
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
    frequency_ratio: Annotated[float, Field(gt=0, le=100)] = 1.7


class CushionShape(Shape):
    """How one cushion, or the jaws of one pocket, differ from the table's rubber."""

    restitution: Fraction | None = None
    restitution_slope: Slope | None = None
    restitution_knee: Factor | None = None
    restitution_bend: Slope | None = None
    restitution_least: Fraction | None = None
    friction: Factor | None = None
    friction_slope: Slope | None = None
    frequency_ratio: Annotated[float, Field(gt=0, le=100)] | None = None
    model: str | None = None


def _pair(written: object) -> object:
    if isinstance(written, list) and len(written) == 2:
        return tuple(written)
    if isinstance(written, tuple):
        return written
    mend = 'write ["1.27 m", "-0.635 m"]'
    raise mistake("V110", "a corner of an outline has two lengths, in a list", mend)


Pair = Annotated[tuple[Metres, Metres], BeforeValidator(_pair), WithJsonSchema(_TWO_LENGTHS)]


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

    corners: Annotated[list[CornerShape], Field(min_length=2, max_length=200)]
    cuts: Annotated[dict[Name, PocketShape], _MANY] = {}


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

    value: Annotated[int, Field(ge=-100_000, le=100_000)] = 0


class TableShape(Shape):
    """The furniture; a rectangle has length and width, any other table an outline."""

    source: str = ""
    length: Size | None = None
    width: Size | None = None
    outline: OutlineShape | None = None
    posts: Annotated[dict[Name, PostShape], _MANY] = {}
    holes: Annotated[dict[Name, HoleShape], _MANY] = {}
    cushions: Annotated[dict[Name, CushionShape], _MANY] = {}
    nose_height: Size
    rail_width: Size
    rail_colour: Rgb = (92, 51, 23)
    pocket_colour: Rgb = (12, 12, 12)
    sights: bool = True
    rubber: Rubber
    pockets: Pockets | None = None
    spots: Annotated[dict[Name, Point], _MANY] = {}
    lines: Annotated[dict[Name, Annotated[LineShape, BeforeValidator(_line)]], _MANY] = {}
    zones: Annotated[dict[Name, ZoneShape], _MANY] = {}


class Contact(Shape):
    """Ball on ball; balls within the gap of a cluster take part in one blow."""

    restitution: Fraction
    restitution_slope: Factor = 0.0
    restitution_knee: Factor = 0.0
    friction_floor: Factor
    friction_rise: Factor = 0.0
    friction_decay: Factor = 0.0
    cluster_gap: Gap = 2e-6


def _worth(written: object) -> object:
    if written is None or written == "number":
        return written
    if isinstance(written, int) and not isinstance(written, bool):
        return written
    mend = 'write a whole number without quotes, or "number" for the ball\'s own'
    raise mistake("V103", "this should be a whole number", mend)


class BallShape(Shape):
    """What is said of one ball or of a range of balls; what is left out is the set's own."""

    diameter: Size | None = None
    mass: Kilograms | None = None
    colour: Rgb | None = None
    pattern: Literal["plain", "stripe", "dots"] | None = None
    label: str | None = Field(default=None, max_length=8)
    value: Annotated[int | Literal["number"] | None, BeforeValidator(_worth)] = None
    groups: list[Name] = []
    spot: Name | None = None
    sliding: Annotated[float, Field(gt=0, le=1000)] | None = None
    rolling: Annotated[float, Field(gt=0, le=1000)] | None = None
    spin_deceleration: Annotated[float, Field(gt=0, le=1000)] | None = None
    restitution: Fraction | None = None
    grip: Factor | None = None


class BallSet(Shape):
    """A set of balls: what all share, and each by its name or range of names."""

    source: str = ""
    diameter: Size
    mass: Kilograms
    contact: Contact
    ball: dict[str, BallShape] = Field(min_length=1, max_length=400)


class PinShape(Shape):
    """Where one pin stands, and how it differs from the set; sizes are diameters."""

    at: Point
    height: Size | None = None
    base: Size | None = None
    belly: Size | None = None
    head: Size | None = None
    belly_height: Size | None = None
    mass: Kilograms | None = None
    colour: Rgb | None = None
    topples_at: Factor | None = None


class PinSet(Shape):
    """A set of pins: what all share, and each by its name; sizes are diameters."""

    source: str = ""
    height: Size
    base: Size
    belly: Size
    head: Size | None = None
    belly_height: Size | None = None
    mass: Kilograms
    colour: Rgb = (238, 230, 205)
    restitution: Fraction = 0.5
    friction: Annotated[float, Field(gt=0, le=10)] = 0.3
    topples_at: Factor | None = None
    pin: Annotated[dict[Name, PinShape], _MANY] = Field(min_length=1)


class ClothShape(Shape):
    """Friction of the bed, and its restitution."""

    source: str = ""
    colour: Rgb
    sliding: Factor
    rolling: Factor
    spin_deceleration: Factor
    bounce: Annotated[float, Field(ge=0, le=0.95)] = 0.5
    threshold: Factor = 1.5


class CueShape(Shape):
    """The cue."""

    source: str = ""
    mass: Kilograms
    tip_restitution: Fraction
    tip_friction: Factor
    end_mass_ratio: Annotated[float, Field(gt=0, le=1000)]


class Players(Shape):
    """How many play."""

    fewest: Annotated[int, Field(ge=1, le=64)]
    most: Annotated[int, Field(ge=1, le=64)]
    usual: Annotated[int, Field(ge=1, le=64)]


def _players(written: object) -> object:
    if isinstance(written, int) and not isinstance(written, bool):
        return {"fewest": written, "most": written, "usual": written}
    if not isinstance(written, dict | Players):
        mend = "write 2, or { fewest = 2, most = 4, usual = 2 }"
        raise mistake("V103", "this should be a whole number or a table", mend)
    return written


_HOW_MANY = {
    "anyOf": [
        {"type": "integer", "minimum": 1, "maximum": 64},
        {
            "type": "object",
            "additionalProperties": False,
            "properties": {
                key: {"type": "integer", "minimum": 1, "maximum": 64}
                for key in ("fewest", "most", "usual")
            },
        },
    ],
    "description": "How many play.",
}


def _value(written: object) -> object:
    if isinstance(written, bool | int | str):
        return written
    raise mistake(
        "V103", "expected a whole number, a text, true or false", 'as in 5, "exact" or true'
    )


Value = Annotated[
    bool | int | str,
    BeforeValidator(_value),
    WithJsonSchema({"type": ["boolean", "integer", "string"]}),
]


class SettingShape(Shape):
    """A house rule."""

    default: Value
    choices: list[Value] = []
    least: int | None = None
    most: int | None = None
    about: str = ""


class Pattern(Shape):
    """Balls in touching rows; see the reference for the words a row may hold."""

    apex: Point
    rows: Annotated[list[str], Field(min_length=1, max_length=20)]
    balls: list[str]
    lots: Annotated[dict[Name, list[str]], _MANY] = {}
    gap: Gap = 0.0
    by_lot: bool = True
    apex_row: Annotated[int, Field(ge=1, le=20)] = 1


class RackShape(Shape):
    """How balls lie at the start; a ball that is not named is in hand or not in play."""

    pattern: Pattern | None = None
    places: Annotated[dict[Name, Point], _MANY] = {}
    own_spots: list[str] = []


class ModelNames(Shape):
    """The physical models by name; what is left out is the engine's own choice."""

    solver: str | None = None
    motion: str | None = None
    ball_ball: str | None = None
    ball_cushion: str | None = None
    strike: str | None = None
    pocket: str | None = None
    flight: str | None = None
    cluster: str | None = None


class VariantSpec(Shape):
    """A whole variant file, its parts put in place."""

    title: Annotated[str, Field(min_length=1, max_length=80)]
    rulebook: Annotated[str, Field(min_length=1, max_length=200)]
    rules: Stem | None = None
    table: TableShape
    balls: BallSet
    pins: PinSet | None = None
    cloth: ClothShape
    cue: CueShape
    models: ModelNames = ModelNames()
    players: Annotated[Players, BeforeValidator(_players), WithJsonSchema(_HOW_MANY)]
    cue_balls: Annotated[list[str], Field(min_length=1, max_length=64)]
    rack: RackShape = RackShape()
    settings: Annotated[dict[Name, SettingShape], _MANY] = {}
