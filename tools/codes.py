"""Every code of a mistake with an example that raises it and the same, mended.

One idea: the examples lie in two text files beside the tests; the page of codes is made from them,
and a test holds that each raises its code at its line and that nothing is told of the mended one.
"""

from __future__ import annotations

import re
import shutil
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from engine.variant.codes import CODES as VARIANT_CODES
from engine.variant.library import VariantError, read_library
from engine.variant.load import check_variant, read_draft
from engine.variant.words import vocabulary_of
from rulelang.codes import CODES as SCRIPT_CODES
from rulelang.compile import check_script
from rulelang.diagnostics import render

if TYPE_CHECKING:
    from rulelang.diagnostics import Diagnostic

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "tests" / "authoring" / "codes"
CODES = {**SCRIPT_CODES, **VARIANT_CODES}
_PART = re.compile(
    r"^== (\w+) (\d+)(?: (\w+))?\n(.*?)^-- mended\n(.*?)(?=^== |\Z)", re.MULTILINE | re.DOTALL
)
NOT_FOUND = "V001"
"""The one mistake that no file can hold."""


@dataclass(frozen=True, slots=True)
class Example:
    """A broken text that raises `code` at `line`, and the same, mended.

    A script is read for the table of `game`, "" for that of the collection of mistakes.
    """

    code: str
    line: int
    game: str
    broken: str
    mended: str

    @property
    def is_script(self) -> bool:
        """Whether it is a script, not a variant file."""
        return self.code in SCRIPT_CODES


@cache
def examples() -> tuple[Example, ...]:
    """Return all examples in the order of the table of codes."""
    found = {
        code: Example(code, int(line), game, broken, mended)
        for name in ("scripts.txt", "variants.txt")
        for code, line, game, broken, mended in _PART.findall(
            (EXAMPLES / name).read_text(encoding="utf-8")
        )
    }
    return tuple(found[code] for code in CODES if code in found)


def told_of(text: str, example: Example) -> list[Diagnostic]:
    """Return what the author of `text`, broken or mended, is told."""
    if example.is_script:
        return _script(text, example.game)
    return _variant(text, example.code, latin=text == example.broken)


def _script(text: str, game: str) -> list[Diagnostic]:
    draft, _ = read_draft(game or ROOT / "tests" / "authoring" / "table.toml")
    if draft is None:
        raise ValueError("the table of the examples is broken")
    words = vocabulary_of(draft)
    found = check_script(text, "example.rules", words, lambda name: read_library(name, EXAMPLES))
    return [one for one in found if one.file == "example.rules"]


def _variant(text: str, code: str, *, latin: bool) -> list[Diagnostic]:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copytree(EXAMPLES / "tables", folder / "tables")
        path = folder / "example.toml"
        path.write_text(text, encoding="latin-1" if latin and code == "V002" else "utf-8")
        try:
            found = check_variant(path) if code == "V204" else read_draft(path)[1]
        except VariantError as error:
            found = list(error.diagnostics)
        short = {str(path): "example.toml"}
        return [_named(one, short.get(one.file, one.file)) for one in found]


def _named(one: Diagnostic, file: str) -> Diagnostic:
    from dataclasses import replace  # noqa: PLC0415

    return replace(one, file=file)


def page() -> str:
    """Return the page of codes: what each means, an example, what is told, and the mend."""
    by_code = {one.code: one for one in examples()}
    parts = []
    for code, meaning in CODES.items():
        sentence = meaning[0].upper() + meaning[1:].rstrip(".") + "."
        parts.append(f"### {code}\n\n{sentence}\n\n{_shown(code, by_code.get(code))}")
    return "\n" + "\n".join(parts)


def _shown(code: str, example: Example | None) -> str:
    if example is None:
        return "Such as `python -m engine check snoker`.\n" if code == NOT_FOUND else ""
    kind = "rules" if example.is_script else "toml"
    told = [one for one in told_of(example.broken, example) if one.code == code]
    return (
        f"```{kind} broken\n{example.broken}```\n\n"
        f"```\n{render(told[0])}\n```\n\nMended:\n\n```{kind} mended\n{example.mended}```\n"
    )
