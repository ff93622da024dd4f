"""One shot of each family whose bits are pinned: `python -m tools.pinned [--update]`.

One idea: a hash that nobody meant to change shows a change that nobody meant. On another machine
or build the last bits may differ, so the places half a second into the shot are kept beside it.
Without an option, what the shots give now is printed.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
from functools import cache
from importlib.metadata import version
from math import atan2
from pathlib import Path
from typing import TYPE_CHECKING, Any

from engine.game.placing import opening_layout
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.variant.load import load_variant

if TYPE_CHECKING:
    from engine.physics.trace import Trace
    from engine.physics.world import Layout, World
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant

KEPT = Path(__file__).resolve().parent.parent / "tests" / "physics" / "pinned.json"
SHOTS = {
    "pool": ("eight_ball", Strike(7.0, 0.004, 0.0, 0.1, 0.2)),
    "snooker": ("snooker", Strike(4.0, 0.01, 0.0, 0.3, 0.1)),
    "carom": ("three_cushion", Strike(4.5, 0.02, 0.0, 0.3, 0.1)),
    "pyramid": ("free_pyramid", Strike(6.0, 0.003, 0.0, 0.0, 0.1)),
    "pins": ("five_pins", Strike(3.0, 0.01, 0.0, 0.2, 0.0)),
    "jump": ("eight_ball", Strike(4.0, 0.004, 0.4, 0.0, 0.0)),
}
"""By family the variant and the stroke; it goes at the nearest ball, its heading is off that."""

FAMILIES = tuple(SHOTS)


@cache
def _variant(name: str) -> Variant:
    return load_variant(name)


def shot_of(family: str) -> tuple[World, Layout, BallId, Strike]:
    """Return a family's shot: the opening, struck at the nearest ball with English."""
    name, strike = SHOTS[family]
    variant = _variant(name)
    layout, ball = opening_layout(variant), variant.cue_balls[0]
    x, y = layout[ball]
    others = [at for other, at in layout.items() if other != ball]
    u, v = min(others, key=lambda at: (at[0] - x) ** 2 + (at[1] - y) ** 2)
    heading = round(atan2(v - y, u - x) + strike.heading, 6)
    aimed = Strike(strike.speed, heading, strike.elevation, strike.side, strike.follow)
    return variant.world, layout, ball, aimed


def spoken(trace: Trace) -> dict[str, Any]:
    """Return what is pinned of a trace."""
    places = trace.positions([min(0.5, trace.duration)])[0]
    early = zip(trace.balls, places.tolist(), strict=True)
    return {
        "hash": trace.hash(),
        "events": len(trace.log),
        "at_half_a_second": {str(ball.id): place for ball, place in early},
    }


def build() -> str:
    """Return on what the bits depend beside the project: processor, system, compiler."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.exists() else []
    model = next((line.split(":")[1].strip() for line in lines if "model name" in line), "")
    libc = "-".join(platform.libc_ver())
    compiler = f"numba {version('numba')} llvmlite {version('llvmlite')}"
    return f"{platform.machine()} {model} {platform.system()} {libc} {compiler}"


def pinned() -> dict[str, Any]:
    """Return what is pinned."""
    kept: dict[str, Any] = json.loads(KEPT.read_text(encoding="utf-8"))
    return kept


def main() -> int:
    """Print what the families' shots give now, or pin it."""
    parser = argparse.ArgumentParser(prog="python -m tools.pinned", description=__doc__)
    parser.add_argument("--update", action="store_true", help="rewrite the pinned hashes")
    families = {family: spoken(simulate(*shot_of(family))) for family in FAMILIES}
    if parser.parse_args().update:
        told = {"build": build(), "families": families}
        KEPT.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")
    for family, told in families.items():
        print(f"{family:>10}  {told['hash']}  {told['events']} events")
    return 0


if __name__ == "__main__":
    sys.exit(main())
