"""Speed tables: `python -m tools.bench physics|rules|render [--json]`.

One idea: every table is a list of rows that are printed as they come; all rows of a table are from
one run on one machine, so their ratios mean something even where the machine is noisy.
"""

from __future__ import annotations

import argparse
import json
import sys
from importlib import import_module

TABLES = ("physics", "rules", "render")
OPTIONS = ("physics", "render")
"""Tables with options of their own."""


def main() -> int:
    """Print one table, or with --json one list of its rows."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench", description=__doc__)
    tables = parser.add_subparsers(dest="table", required=True)
    for name in TABLES:
        one = tables.add_parser(name, help=f"the table of {name}")
        one.add_argument("--json", action="store_true", help="print a JSON list")
        if name in OPTIONS:
            import_module(f"tools.bench.{name}").add_options(one)
    chosen = parser.parse_args()
    make = import_module(f"tools.bench.{chosen.table}").rows
    rows: list[dict[str, object]] = []
    for row in make(chosen) if chosen.table in OPTIONS else make():
        if not chosen.json:
            if not rows:
                print("  ".join(f"{name:>{_width(name)}}" for name in row))
            print("  ".join(f"{row[name]!s:>{_width(name)}}" for name in row), flush=True)
        rows.append(row)
    if chosen.json:
        print(json.dumps(rows, indent=2))
    return 0


def _width(name: str) -> int:
    return 60 if name == "work" else 10


if __name__ == "__main__":
    sys.exit(main())
