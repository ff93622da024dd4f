"""Random shots under the monitor: `python -m tools.soak physics --shots N [--seed S]`.

One idea: shot number k of a seed and a list of variants is always the same shot, whatever the
number of shots or workers; breaks, strewn balls and crowds of touching balls on every shipped
table, struck at random.
Invariant: every shot that breaks a rule is kept as a record, which `python -m engine golden` plays
again; exit 1 where there is one.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict, replace
from pathlib import Path
from time import perf_counter

import numpy as np

from engine.physics.simulate import EVENT_CAP, warm_up
from engine.physics.world import MODEL_NAMES
from engine.variant.load import list_variants
from tools.soak.strokes import Plan
from tools.soak.watch import Tally, run, soak

MODELS = ("ball_ball", "ball_cushion", "motion")


def report(tally: Tally, seconds: float) -> dict[str, object]:
    """Return the figures of a soak as plain values."""
    times = np.array(tally.times or [0.0])
    return {
        "shots": tally.shots,
        "scenes": tally.scenes,
        "faults": len(tally.faults),
        "caps_reached": tally.caps,
        "largest_overlap_m": tally.overlap,
        "deepest_in_a_nose_m": tally.sunk,
        "farthest_torn_m": tally.torn,
        "largest_energy_gain_j": tally.gain,
        "largest_momentum_error_kg_m_s": tally.momentum,
        "flights": tally.flights,
        "pins_felled": tally.felled,
        "most_events": tally.events,
        "of_the_cap": f"{100.0 * tally.events / EVENT_CAP:.2f} %",
        "median_ms": round(float(np.median(times)), 3),
        "p99_ms": round(float(np.percentile(times, 99)), 3),
        "slowest_ms": round(tally.slowest[0], 3),
        "slowest_shot": f"{tally.slowest[1]} ({tally.slowest[2]})",
        "seconds": round(seconds, 1),
    }


def _plan(chosen: argparse.Namespace) -> Plan:
    names = tuple(chosen.variant or (listing.name for listing in list_variants()))
    given = {what: getattr(chosen, what) for what in MODELS}
    models = tuple((what, name) for what, name in sorted(given.items()) if name)
    return Plan(chosen.seed, names, models, chosen.every_model)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tools.soak", description=__doc__)
    parser.add_argument("what", choices=["physics"])
    parser.add_argument("--shots", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--variant", action="append", metavar="NAME", help="only this; repeatable")
    for what in MODELS:
        option = f"--{what.replace('_', '-')}"
        parser.add_argument(option, choices=MODEL_NAMES[what], help="instead of the variant's own")
    parser.add_argument("--every-model", action="store_true", help="go through all in turn")
    parser.add_argument("--workers", type=int, default=-1, help="processes; one a core")
    parser.add_argument("--folder", type=Path, default=Path("soak"), help="where failing shots go")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    return parser


def main() -> int:
    """Run a soak, keep failing shots as records, print the figures; return 1 where one failed."""
    chosen = _parser().parse_args()
    warm_up()
    soak(_plan(chosen), 0, 0)  # kernels of flights, too
    start = perf_counter()

    def progress(tally: Tally) -> None:
        if sys.stderr.isatty():
            left = (perf_counter() - start) * (chosen.shots / tally.shots - 1.0)
            told = f"{tally.shots} shots, {len(tally.faults)} faults, {left:.0f} s to go "
            print(f"\r{told}", end="", file=sys.stderr, flush=True)

    tally = run(_plan(chosen), chosen.shots, chosen.workers, progress)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    told = report(tally, perf_counter() - start)
    for fault in tally.faults:
        chosen.folder.mkdir(parents=True, exist_ok=True)
        path = chosen.folder / f"{fault.variant}-{chosen.seed}-{fault.number}.toml"
        path.write_text(fault.record, encoding="utf-8")
    if chosen.json:
        kept = [asdict(replace(fault, record="")) for fault in tally.faults]
        print(json.dumps({**told, "failing": kept}, indent=2))
        return int(bool(tally.faults))
    for fault in tally.faults:
        print(f"{fault.variant} {fault.number} {fault.scene}: {'; '.join(fault.words)}")
    for name, value in told.items():
        print(f"{name:>30}  {value}")
    return int(bool(tally.faults))


if __name__ == "__main__":
    sys.exit(main())
