"""Run checks from files: `python -m tools.validate FILE... [--json]`; exit 1 where one fails.

One idea: a file of any figures in the format of `tests/validation/checks.json` is read, run through
the public API, and told quantity by quantity.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from tools.validate.adapters import run_check
from tools.validate.check import CheckFileError, read_checks
from tools.validate.tell import as_json, summary, tell

if TYPE_CHECKING:
    from tools.validate.check import Result


def main() -> int:
    """Print every check and a summary; return 0, 1 where a check fails, 2 for a bad file."""
    parser = argparse.ArgumentParser(prog="python -m tools.validate", description=__doc__)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    chosen = parser.parse_args()
    results: list[Result] = []
    for path in chosen.files:
        try:
            checks = read_checks(path)
        except CheckFileError as error:
            print(error, file=sys.stderr)
            return 2
        for check in checks:
            results.append(run_check(check))
            if not chosen.json:
                print(tell(results[-1]), flush=True)
    if chosen.json:
        print(json.dumps(as_json(results), indent=2))
    else:
        print(summary(results))
    return int(any(result.status == "fail" for result in results))


if __name__ == "__main__":
    sys.exit(main())
