"""Every check of the project in one command: `python -m tools.check`.

One idea: a check is a name and a command; all run, and what failed is said again at the end.
The tests run last, so that the output closes with pytest's own summary.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


@dataclass(frozen=True, slots=True)
class Check:
    """One check: what it is called, the command, and whether the quick half has it."""

    name: str
    command: tuple[str, ...]
    quick: bool = True


PYTHON = sys.executable
CHECKS = (
    Check("format", (PYTHON, "-m", "ruff", "format", "--check", ".")),
    Check("lint", (PYTHON, "-m", "ruff", "check", ".")),
    Check("variants", (PYTHON, "-m", "engine", "check")),
    Check("scripts", (PYTHON, "-m", "engine", "format", "--check", "variants")),
    Check("documents", (PYTHON, "-m", "tools.docs", "--check")),
    Check("layers", (PYTHON, "-c", "from importlinter.cli import lint_imports_command as c; c()")),
    Check("types", (PYTHON, "-m", "mypy"), quick=False),
)


def main() -> int:
    """Run the checks and the tests; return the exit status, 0 when all is well."""
    parser = argparse.ArgumentParser(prog="python -m tools.check", description=__doc__)
    parser.add_argument("--fast", action="store_true", help="leave out types and slow tests")
    fast = parser.parse_args().fast
    environment = {**os.environ, "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
    failed = []
    for check in CHECKS:
        if fast and not check.quick:
            continue
        print(f"== {check.name}", flush=True)
        if subprocess.run(check.command, cwd=ROOT, env=environment, check=False).returncode:
            failed.append(check.name)
    if failed:
        print(f"== failed before the tests: {', '.join(failed)}", flush=True)
    print("== tests", flush=True)
    tests = [PYTHON, "-m", "pytest", *(["-x"] if fast else [])]
    status = subprocess.run(tests, cwd=ROOT, env=environment, check=False).returncode
    return status or int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
