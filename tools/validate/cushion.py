"""Group E: a ball and a nose; the frame has X along the nose, Y into it, Z up."""

from __future__ import annotations

import re
from dataclasses import replace
from math import atan2, cos, degrees, radians, sin, sqrt, tan
from typing import TYPE_CHECKING

from engine.physics.pack import nose_reach
from engine.physics.world import Cloth, Rubber
from engine.table.build import build_table
from tools.validate.check import NotApplicableError
from tools.validate.invariants import KINDS as INVARIANTS
from tools.validate.lab import OPEN, RADIUS, cloth_of, radius_of, rebound, world_of
from tools.validate.prose import NUMBER, length_told, motion_of, need, need_or, spoken, told

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.physics.world import World
    from tools.validate.check import Check, Wanted

SIDE = 0.5
"""Running or reverse side spin times radius, over the speed, where a check does not say."""

MODELS = {"han": "han-2005", "mathavan": "mathavan-2010", "stronge": "stronge"}


def _model(check: Check) -> str:
    """Return the model of the check: the field `model`, else the name in its words."""
    if check.has("model"):
        return check.text("model")
    found = re.search("|".join(MODELS), check.description, re.IGNORECASE)
    if found:
        return MODELS[found[0].lower()]
    if check.has("mu_s") and check.has("mu_w"):
        return MODELS["mathavan"]  # no other model asks for the cloth
    raise NotApplicableError("input only in prose: model")


def _rising(check: Check, wanted: Wanted) -> tuple[float, float]:
    """Return radius and nose height (m) from the quantity's name, else from the fields."""
    radius = length_told(wanted.quantity, "R", None)
    if radius is None:
        radius = check.number("R", default=RADIUS)
    height = length_told(wanted.quantity, "h", radius)
    return radius, check.number("h") if height is None else height


def _cos(check: Check, wanted: Wanted) -> float:
    radius, height = _rising(check, wanted)
    return nose_reach(radius, height) / radius


def _sine(check: Check, wanted: Wanted) -> object:
    return sqrt(1.0 - _cos(check, wanted) ** 2)


def _theta(check: Check, wanted: Wanted) -> object:
    return degrees(atan2(sqrt(1.0 - _cos(check, wanted) ** 2), _cos(check, wanted)))


def _reach(check: Check, wanted: Wanted) -> object:
    return nose_reach(*_rising(check, wanted))


def _tangent(check: Check, wanted: Wanted) -> object:
    return tan(radians(float(str(_theta(check, wanted)))))


def _smooth(check: Check, model: str, e: float, v: Sequence[float]) -> tuple[float, ...]:
    """Return a rebound without friction at nose and bed."""
    cloth = Cloth(1e-300, 1e-300, 10.0)
    rubber = Rubber(e, 0.0, 0.0, check.number("mu", default=0.0))
    world = world_of(check, 1, cloth=cloth, rubber=rubber, ball_cushion=model)
    return rebound(world, v, (0.0, 0.0, 0.0))


def _constrained_ratio(check: Check, _: Wanted) -> object:
    return -_smooth(check, "mathavan-2010", check.number("e"), (0.0, 1.0))[1]


def _free_ratio(check: Check, _: Wanted) -> object:
    return -_smooth(check, "han-2005", check.number("e"), (0.0, 1.0))[1]


def _smooth_angle(check: Check, wanted: Wanted) -> object:
    inward = radians(need(check, wanted, "in"))
    e = need(check, wanted, "e")
    out = _smooth(check, "mathavan-2010", e, (sin(inward), cos(inward)))
    return degrees(atan2(out[0], -out[1]))


def _spins(kind: str, v: Sequence[float], side: float) -> tuple[float, float, float]:
    """Return spin times radius (m/s) of a ball that slides, rolls, or rolls with side spin."""
    turn = 0.0 if kind.startswith("stun") else 1.0
    return -turn * v[1], turn * v[0], side


def _rubber(check: Check, wanted: Wanted) -> Rubber:
    e, mu = need(check, wanted, "e"), told(wanted, "muw")
    friction = check.number("mu_w", "mu") if mu is None else mu
    return Rubber(e, 0.0, 0.0, friction)


def _grid(check: Check, wanted: Wanted) -> object:
    """Return the rebound of `inc=ANGLE KIND`, with a flag for stick where six are asked for."""
    found = re.search(r"inc=\S+ (stun|roll)(?:\+(run|rev))?", wanted.quantity)
    if not found:
        raise NotApplicableError("input only in prose: motion")
    speed, angle = spoken(check, "V", r"V=# m/s"), radians(need(check, wanted, "inc"))
    side = 0.0
    if found[2]:
        share = check.number("R_wz_over_V", default=SIDE)
        side = share * speed * (1.0 if found[2] == "run" else -1.0)
    v = (speed * cos(angle), speed * sin(angle))
    spin, model, rubber = _spins(found[1], v, side), _model(check), _rubber(check, wanted)
    world = world_of(check, 1, rubber=rubber, ball_cushion=model)
    out = list(rebound(world, v, spin))
    if isinstance(wanted.value, list) and len(wanted.value) == len(out) + 1:
        out.append(_sticks(check, rubber, model, v, spin))
    return out


def _sticks(
    check: Check, rubber: Rubber, model: str, v: Sequence[float], spin: Sequence[float]
) -> float:
    """Return 1.0 where the ball sticks to the nose: more friction then changes nothing."""
    more = Rubber(rubber.restitution, 0.0, 0.0, rubber.friction * 1.01)
    one = rebound(world_of(check, 1, rubber=rubber, ball_cushion=model), v, spin)
    two = rebound(world_of(check, 1, rubber=more, ball_cushion=model), v, spin)
    return float(max(abs(a - b) for a, b in zip(one, two, strict=True)) < 1e-12)


def _square(check: Check, wanted: Wanted) -> object:
    """Return [speed out, RwX] over the speed of a rolling ball that hits squarely."""
    speed = need(check, wanted, "V")
    world = world_of(check, 1, rubber=_rubber(check, wanted), ball_cushion=_model(check))
    out = rebound(world, (0.0, speed), _spins(motion_of(check, wanted), (0.0, speed), 0.0))
    return [-out[1] / speed, out[2] / speed]


def _oblique(check: Check, wanted: Wanted) -> object:
    speed = spoken(check, "V", r"# m/s")
    angle = radians(spoken(check, "inc", r"# deg"))
    v = (speed * cos(angle), speed * sin(angle))
    world = world_of(check, 1, rubber=_rubber(check, wanted), ball_cushion=_model(check))
    out = rebound(world, v, _spins(motion_of(check, wanted), v, 0.0))
    return list(out[:2] if wanted.quantity.startswith("v") else out[2:])


def _reroll(check: Check, friction: float, e: float, speed: float) -> float:
    """Return the speed of rolling after a square hit over that before."""
    world = world_of(
        check,
        1,
        cloth=cloth_of(check),
        rubber=Rubber(e, 0.0, 0.0, friction),
        ball_cushion="mathavan-2010",
    )
    out = rebound(world, (0.0, speed), (-speed, 0.0, 0.0))
    return (-5.0 * out[1] + 2.0 * out[2]) / 7.0 / speed


def _restitution_for(check: Check, wanted: Wanted) -> object:
    """Return the restitution with which the model gives the re-rolling told, by bisection."""
    friction, speed = need(check, wanted, "mu_w"), need(check, wanted, "v_n")
    found = re.search(r"re-roll ([\d.]+)", wanted.quantity)
    target = float(found[1]) if found else check.number("re_roll")
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = (low + high) / 2.0
        under = _reroll(check, friction, middle, speed) < target
        low, high = (middle, high) if under else (low, middle)
    return (low + high) / 2.0


def _level(check: Check, rubber: Rubber, model: str) -> World:
    """Return a world whose noses stand as high as the balls' centres: all happens in a plane."""
    table = build_table(OPEN, OPEN, radius_of(check), None, None, 0.1)
    return world_of(check, 1, rubber=rubber, table=table, ball_cushion=model)


def _thrown_back(check: Check, wanted: Wanted) -> object:
    """Return slip and normal speed after a level hit by the compliant model."""
    slip, speed = need(check, wanted, "vt"), need_or(check, wanted, "vn", 1.0)
    rubber = Rubber(check.number("e"), 0.0, 0.0, check.number("mu"))
    if check.has("omega_ratio"):
        rubber = replace(rubber, frequency_ratio=check.number("omega_ratio"))
    out = rebound(_level(check, rubber, "stronge"), (slip, speed), (0.0, 0.0, 0.0))
    return [out[0] - out[4], -out[1]]


def _law_of(check: Check) -> Rubber:
    """Return the rubber that a law describes: `e=a+b v+c v^2 ; mu=d+f theta`."""
    terms = {}
    for name, text in re.findall(r"(\w+) ?= ?([^;]+)", check.text("formula", check.formula)):
        found = re.findall(rf"([-+]?) ?({NUMBER}) ?([a-z]*(?:\^2)?)", text)
        terms[name] = {power: float(f"{sign}{size}") for sign, size, power in found}
    if not {"e", "mu"} <= terms.keys():
        raise NotApplicableError("input only in prose: formula")
    e, mu = terms["e"], terms["mu"]
    return Rubber(
        restitution=e.get("", 0.0),
        restitution_slope=-e.get("v", 0.0),
        restitution_knee=0.0,
        friction=mu.get("", 0.0),
        restitution_bend=-e.get("v^2", 0.0),
        friction_slope=-mu.get("theta", 0.0),
    )


def _bounce_by_law(check: Check, wanted: Wanted) -> object:
    """Return speed after over before a level hit without friction."""
    speed = float(wanted.quantity[2:-1])
    rubber = replace(_law_of(check), friction=0.0, friction_slope=0.0)
    return -rebound(_level(check, rubber, "han-2005"), (0.0, speed), (0.0, 0.0, 0.0))[1] / speed


def _rub_by_law(check: Check, wanted: Wanted) -> object:
    """Return the impulse along over that into a level nose, of a ball that slips all the time."""
    angle = radians(float(wanted.quantity[3:-1].removesuffix("deg")))
    v = (sin(angle), cos(angle))
    out = rebound(_level(check, _law_of(check), "han-2005"), v, (0.0, 0.0, -100.0))
    return (v[0] - out[0]) / (v[1] - out[1])


KINDS = (
    *INVARIANTS,
    (r".*sin\(theta\)", _sine),
    (r"theta", _theta),
    (r"horizontal centre-nose distance", _reach),
    (r"constrained ratio", _constrained_ratio),
    (r"Han ratio", _free_ratio),
    (r".*in=.*, e=.*", _smooth_angle),
    (r".*inc=.*\[.*\]", _grid),
    (r"V=.* \[v_out/V, RwX/V\]", _square),
    (r"vX,vY|RwX,RwY,RwZ", _oblique),
    (r"vt=.* \[vt_out, vn_out\]", _thrown_back),
    (r"mu_w=.* v_n=.*", _restitution_for),
    (r"e\([\d.]+\)", _bounce_by_law),
    (r"mu\([\d.]+ deg\)", _rub_by_law),
    (r".*h ?= ?[\d.]+ ?(mm|D|R).*", _tangent),
)
"""Which quantity is answered by what."""
