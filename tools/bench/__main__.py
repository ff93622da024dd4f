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


def main() -> int:
    """Print one table, or with --json one list of its rows."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench", description=__doc__)
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("--json", action="store_true", help="print a JSON list")
    chosen = parser.parse_args()
    rows: list[dict[str, object]] = []
    for row in import_module(f"tools.bench.{chosen.table}").rows():
        if not chosen.json:
            if not rows:
                print("  ".join(f"{name:>{_width(name)}}" for name in row))
            print("  ".join(f"{row[name]!s:>{_width(name)}}" for name in row), flush=True)
        rows.append(row)
    if chosen.json:
        print(json.dumps(rows, indent=2))
    return 0


def _width(name: str) -> int:
    return 44 if name == "work" else 10


if __name__ == "__main__":
    sys.exit(main())
