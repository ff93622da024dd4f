"""Every mistake of a collection of broken files, and what its author is told.

`python -m tools.mistakes [FILES...]` prints the answers. A file says on the line that is wrong
what is to be told there: `# expect: CODE "part of message or mend" at "what the caret covers"`;
`# expect above: ...` speaks of the line before, where a comment would be part of the mistake.

One idea: a message is read by eye here and held fast by the same file in a test.
Invariant: an answer has a place inside the file, a code, a sentence and a mend.
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from engine.variant.codes import CODES as VARIANT_CODES
from engine.variant.library import read_library
from engine.variant.load import read_draft
from engine.variant.words import vocabulary_of
from rulelang.codes import CODES as SCRIPT_CODES
from rulelang.compile import check_script
from rulelang.diagnostics import render

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rulelang.diagnostics import Diagnostic

ROOT = Path(__file__).parents[1]
COLLECTION = ROOT / "tests" / "authoring" / "mistakes"
TABLE = ROOT / "tests" / "authoring" / "table.toml"
"""The game whose balls, spots and zones the broken scripts may name."""

CODES = {**VARIANT_CODES, **SCRIPT_CODES}
_EXPECT = re.compile(
    r'# expect( above)?: ([VR]\d{3}) "((?:[^"\\]|\\.)*)"(?: at "((?:[^"\\]|\\.)*)")?'
)


@dataclass(frozen=True, slots=True)
class Expected:
    """What is to be told in a line: code, part of the text, and what the caret covers."""

    line: int
    code: str
    words: str
    culprit: str


def collection() -> list[Path]:
    """Return the broken files, TOML first."""
    return sorted(COLLECTION.glob("*.toml")) + sorted(COLLECTION.glob("*.rules"))


def expected_in(path: Path) -> list[Expected]:
    """Return what a broken file says is to be told of it, by lines."""
    found = []
    text = path.read_bytes().decode("utf-8", "replace")
    for number, line in enumerate(text.split("\n"), 1):
        for above, code, words, culprit in _EXPECT.findall(line):
            at = number - 1 if above else number
            found.append(Expected(at, code, _plain(words), _plain(culprit)))
    return sorted(found, key=lambda one: (one.line, one.code))


def _plain(text: str) -> str:
    return text.replace('\\"', '"')


def answers(path: Path) -> list[Diagnostic]:
    """Return what the author of a broken file is told, from the top of the file down."""
    if path.suffix == ".toml":
        told = read_draft(path)[1]
    else:
        draft, _ = read_draft(TABLE)
        if draft is None:
            message = f"{TABLE} is broken itself"
            raise ValueError(message)
        text = path.read_text(encoding="utf-8")
        words = vocabulary_of(draft)
        told = list(
            check_script(text, str(path), words, lambda name: read_library(name, path.parent))
        )
    return sorted(told, key=lambda one: (one.line, one.column))


def amiss(path: Path) -> Iterator[str]:
    """Give, as sentences, what differs between the answers to a file and what it expects."""
    told, wanted = answers(path), expected_in(path)
    if [(one.line, one.code) for one in wanted] != sorted((one.line, one.code) for one in told):
        yield f"told {[(one.line, one.code) for one in told]}, expected {wanted}"
    for one in told:
        yield from _unfit(one)
    for want in wanted:
        same = [one for one in told if (one.line, one.code) == (want.line, want.code)]
        if not any(_fits(one, want) for one in same):
            yield f"line {want.line}: nothing says {want.words!r} at {want.culprit!r}"


def _fits(one: Diagnostic, want: Expected) -> bool:
    under = one.snippet[one.column - 1 : one.column - 1 + one.width]
    return want.words in f"{one.message} {one.mend}" and want.culprit in ("", under)


def _unfit(one: Diagnostic) -> Iterator[str]:
    if one.code not in CODES or not one.message or not one.mend:
        yield f"line {one.line}: {one.code} lacks a sentence or a mend"
    if one.snippet and not 1 <= one.column <= len(one.snippet) + 1:
        yield f"line {one.line}: the caret stands outside the line"


def main(names: list[str]) -> int:
    """Print every answer and a count; 1 where one is not as its file expects."""
    paths = [Path(name) for name in names] or collection()
    count, wrong = 0, 0
    for path in paths:
        for one in answers(path):
            count += 1
            sys.stdout.write(render(one).replace(f"{path.parent}/", "") + "\n")
        for sentence in amiss(path):
            wrong += 1
            sys.stdout.write(f"    NOT AS EXPECTED: {sentence}\n")
        sys.stdout.write("\n")
    kinds = [sum(path.suffix == end for path in paths) for end in (".toml", ".rules")]
    sys.stdout.write(f"{count} answers to {kinds[0]} TOML files and {kinds[1]} scripts")
    sys.stdout.write(f", {wrong} not as expected\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
