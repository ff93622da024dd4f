"""Which test shows that a nasty configuration is dealt with: the table in docs/physics.md.

One idea: a test named `test_NN_...` is about row NN, and its docstring, or else its name, says what
must happen; so the table is read off the tests.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent / "tests" / "physics"
NAMED = re.compile(r"test_(\d\d)_(\w+)")
ROWS = 40


def rows() -> dict[int, list[tuple[str, str]]]:
    """Return by row the tests: what must happen, and the test's name."""
    found: dict[int, list[tuple[str, str]]] = {}
    for path in sorted(TESTS.glob("test_physics_robust_*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            named = NAMED.fullmatch(node.name) if isinstance(node, ast.FunctionDef) else None
            if isinstance(node, ast.FunctionDef) and named is not None:
                words = (ast.get_docstring(node) or named[2].replace("_", " ")).rstrip(".")
                told = words[0].upper() + words[1:]
                found.setdefault(int(named[1]), []).append((told, node.name))
    return found


def table() -> str:
    """Return the table in Markdown."""
    lines = ["| row | what must happen | test |", "|---|---|---|"]
    for row, tests in sorted(rows().items()):
        lines += [f"| {row} | {words} | `{name}` |" for words, name in tests]
    return "\n".join(lines) + "\n"


__all__ = ["ROWS", "rows", "table"]
