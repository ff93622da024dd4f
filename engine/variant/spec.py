"""The shape of a variant file, as classes of tables.

One idea: these classes say which keys exist and what each may hold; whether the names in them
fit together is judged afterwards. Invariant: nothing unknown gets through, and no value is
silently converted.
"""

from typing import Annotated, Literal

from engine.variant.fields import (
    Factor,
    Fraction,
    Gap,
    Kilograms,
    Name,
    Rgb,
    Size,
    Stem,
    mistake,
)
from engine.variant.shape import Before, Bounds, Shape, Told, empty
from engine.variant.table_spec import MANY, Point, TableShape


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
    label: Annotated[str, Bounds(max_length=8)] | None = None
    value: Annotated[int | Literal["number"] | None, Before(_worth)] = None
    groups: list[Name] = empty(list)
    spot: Name | None = None
    sliding: Annotated[float, Bounds(gt=0, le=1000)] | None = None
    rolling: Annotated[float, Bounds(gt=0, le=1000)] | None = None
    spin_deceleration: Annotated[float, Bounds(gt=0, le=1000)] | None = None
    restitution: Fraction | None = None
    grip: Factor | None = None


class BallSet(Shape):
    """A set of balls: what all share, and each by its name or range of names."""

    source: str = ""
    diameter: Size
    mass: Kilograms
    contact: Contact
    ball: Annotated[dict[str, BallShape], Bounds(min_length=1, max_length=400)]


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
    friction: Annotated[float, Bounds(gt=0, le=10)] = 0.3
    topples_at: Factor | None = None
    pin: Annotated[dict[Name, PinShape], Bounds(min_length=1, max_length=200)]


class ClothShape(Shape):
    """Friction of the bed, and its restitution."""

    source: str = ""
    colour: Rgb
    sliding: Factor
    rolling: Factor
    spin_deceleration: Factor
    bounce: Annotated[float, Bounds(ge=0, le=0.95)] = 0.5
    threshold: Factor = 1.5


class CueShape(Shape):
    """The cue."""

    source: str = ""
    mass: Kilograms
    tip_restitution: Fraction
    tip_friction: Factor
    end_mass_ratio: Annotated[float, Bounds(gt=0, le=1000)]


class Players(Shape):
    """How many play."""

    fewest: Annotated[int, Bounds(ge=1, le=64)]
    most: Annotated[int, Bounds(ge=1, le=64)]
    usual: Annotated[int, Bounds(ge=1, le=64)]


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
    Before(_value),
    Told({"type": ["boolean", "integer", "string"]}),
]


class SettingShape(Shape):
    """A house rule."""

    default: Value
    choices: list[Value] = empty(list)
    least: int | None = None
    most: int | None = None
    about: str = ""


class Pattern(Shape):
    """Balls in touching rows; see the reference for the words a row may hold."""

    apex: Point
    rows: Annotated[list[str], Bounds(min_length=1, max_length=20)]
    balls: Annotated[list[str], MANY]
    lots: Annotated[dict[Name, list[str]], MANY] = empty(dict)
    gap: Gap = 0.0
    by_lot: bool = True
    apex_row: Annotated[int, Bounds(ge=1, le=20)] = 1


class RackShape(Shape):
    """How balls lie at the start; a ball that is not named is in hand or not in play."""

    pattern: Pattern | None = None
    places: Annotated[dict[Name, Point], MANY] = empty(dict)
    own_spots: list[str] = empty(list)


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

    title: Annotated[str, Bounds(min_length=1, max_length=80)]
    rulebook: Annotated[str, Bounds(min_length=1, max_length=200)]
    rules: Stem | None = None
    table: TableShape
    balls: BallSet
    pins: PinSet | None = None
    cloth: ClothShape
    cue: CueShape
    models: ModelNames = ModelNames()
    players: Annotated[Players, Before(_players), Told(_HOW_MANY)]
    cue_balls: Annotated[list[str], Bounds(min_length=1, max_length=64)]
    rack: RackShape = RackShape()
    same_time: Annotated[float, Bounds(ge=0, le=0.01)] = 1e-9
    settings: Annotated[dict[Name, SettingShape], MANY] = empty(dict)
