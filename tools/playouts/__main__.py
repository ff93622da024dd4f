"""Random matches through the referee: `python -m tools.playouts [VARIANT...] --matches N`.

One idea: shots are made up from the vocabulary alone, as silly as can be told, and whatever is
played the rules must never clash, run out of fuel, lose a ball or leave nobody to move; the order
of rules inside a section decides nothing. In every second match half the shots score; in the
others fewer do, or all are silly (tools/playouts/players.py has the shares).
Invariant: the same seed plays the same matches, on any number of processes. Exit 1 for a finding.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict
from functools import cache
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from platformdirs import user_cache_path

from engine.variant.load import list_variants, load_variant
from tools.playouts.play import Finding, Tally, playout

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.variant.variant import Variant

SHARE = 20
"""So many matches are one piece of work."""


@cache
def _variant(name: str) -> Variant:
    return load_variant(name, user_cache_path("headstring"))


def play_share(name: str, first: int, last: int, seed: int, most: int) -> tuple[str, Tally]:
    """Play the matches `first` to `last` of a variant, the last left out."""
    tally = Tally()
    for number in range(first, last):
        tally.add(playout(_variant(name), number, seed, most))
    return name, tally


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tools.playouts", description=__doc__)
    parser.add_argument("variants", nargs="*", help="names of games; all without any")
    parser.add_argument("--matches", type=int, default=100, help="of each game")
    parser.add_argument("--shots", type=int, default=20_000, help="after which a match is left")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="findings go here as records")
    parser.add_argument("--json", action="store_true")
    return parser


def main(words: list[str] | None = None) -> int:
    """Play, print a line for each game and every finding; 1 where there is one."""
    given = _parser().parse_args(words)
    names = given.variants or [one.name for one in list_variants()]
    begun = perf_counter()
    tallies = {name: Tally() for name in names}
    work = [
        (name, first, min(first + SHARE, given.matches), given.seed, given.shots)
        for first in range(0, given.matches, SHARE)
        for name in names
    ]
    for done, (name, tally) in enumerate(_played(work, given.jobs), 1):
        tallies[name].add(tally)
        if sys.stderr.isatty():
            print(f"\r{done} of {len(work)} parts", end="", file=sys.stderr)
    seconds = perf_counter() - begun
    for tally in tallies.values():
        tally.findings.sort(key=lambda one: one.match)
    findings = [one for tally in tallies.values() for one in tally.findings]
    if given.keep:
        _keep(given.keep, findings)
    short = [name for name, tally in tallies.items() if 10 * tally.keen_ended < 9 * tally.keen]
    if given.json:
        told = {name: asdict(tally) for name, tally in tallies.items()}
        pace = round(_sum(tallies).shots / seconds)
        whole = {"seconds": round(seconds, 1), "shots_per_second": pace, "games": told}
        print(json.dumps(whole, indent=2))
    else:
        _tell(tallies, findings, seconds)
        for name in short:
            print(f"{name}: fewer than nine in ten of the matches ended in which half score")
    return int(bool(findings or short))


def _played(work: list[tuple[str, int, int, int, int]], jobs: int) -> Iterator[tuple[str, Tally]]:
    if jobs == 1:
        yield from (play_share(*one) for one in work)
        return
    with ProcessPoolExecutor(jobs) as pool:
        for done in as_completed([pool.submit(play_share, *one) for one in work]):
            yield done.result()


def _sum(tallies: dict[str, Tally]) -> Tally:
    total = Tally()
    for one in tallies.values():
        total.add(one)
    return total


def _tell(tallies: dict[str, Tally], findings: list[Finding], seconds: float) -> None:
    total = _sum(tallies)
    lines = {**tallies, f"{len(tallies)} games": total}
    width = max(map(len, lines))
    print(f"{'game':{width}}  matches    shots  longest  ended  ended where half score  findings")
    for name, one in lines.items():
        share = f"{one.keen_ended} of {one.keen}"
        print(
            f"{name:{width}}  {one.matches:7}  {one.shots:7}  {one.longest:7}  {one.ended:5}"
            f"  {share:>22}  {len(one.findings):8}"
        )
    for found in findings:
        print(f"{found.variant}, match {found.match}, shot {found.shot}: {found.what}")
    print(f"{seconds:.1f} s, {total.shots / seconds:.0f} shots a second")


def _keep(folder: Path, findings: list[Finding]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for one in findings:
        path = folder / f"{one.variant}-{one.match}-{one.shot}.toml"
        path.write_text(one.record, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
