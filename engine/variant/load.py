"""The way from a name to a checked game: load, check, list.

One idea: loading and checking are one walk; `check_variant` returns the mistakes, `load_variant`
raises them all at once. Importing this module reads nothing and starts nothing.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from pydantic_core import ValidationError

from engine.variant.assemble import Draft, assemble
from engine.variant.library import (
    VariantError,
    find_script,
    open_variant,
    read_library,
    resolve,
    script_names,
    shipped_folder,
)
from engine.variant.report import Report, nearest
from engine.variant.source import dotted, read_text
from engine.variant.spec import VariantSpec
from engine.variant.variant import Variant
from engine.variant.words import vocabulary_of
from rulelang.diagnostics import ScriptError
from rulelang.frozen import value

if TYPE_CHECKING:
    from pathlib import Path

    from engine.variant.locate import KeyPath
    from engine.variant.source import Node
    from rulelang.diagnostics import Diagnostic
    from rulelang.probe import Probe


@value
class Listing:
    """A shipped variant by name, and the title that its file gives it."""

    name: str
    title: str
    path: Path


@dataclass(slots=True)
class _Reading:
    """What has been made of one variant so far, and every mistake on the way."""

    path: Path
    diagnostics: list[Diagnostic]
    report: Report | None = None
    draft: Draft | None = None


@value
class _Script:
    """A rule script as text, and where those lie that it uses."""

    path: Path
    text: str
    home: Path

    def library(self, name: str) -> tuple[str, str] | None:
        """Return text and file name of a script that this one uses by name."""
        return read_library(name, self.home)


def load_variant(
    name_or_path: str | Path, cache: Path | None = None, probe: Probe | None = None
) -> Variant:
    """Return a variant by stem or path, checked whole, script included.

    `cache` is a folder where the grammar of scripts may be kept from run to run; `probe` counts
    what the rules do. Raises VariantError, which carries every diagnostic.
    """
    from rulelang.compile import compile_script  # noqa: PLC0415  the parser is slow to import

    reading = _read(resolve(name_or_path))
    draft = reading.draft
    script = _find_script(reading)
    if reading.diagnostics or draft is None or script is None:
        raise VariantError(_in_order(reading) + _script_mistakes(draft, script, cache))
    try:
        program = compile_script(
            script.text, str(script.path), vocabulary_of(draft), script.library, cache, probe
        )
    except ScriptError as error:
        raise VariantError(list(error.diagnostics)) from None
    return Variant(
        name=reading.path.stem,
        title=draft.spec.title,
        rulebook=draft.spec.rulebook,
        path=reading.path,
        script_path=script.path,
        world=draft.world,
        balls=draft.balls,
        cue_balls=draft.cue_balls,
        rack=draft.rack,
        players=draft.players,
        settings=draft.settings,
        look=draft.look,
        program=program,
        pins=draft.pins,
        same_time=draft.spec.same_time,
    )


def check_variant(name_or_path: str | Path, cache: Path | None = None) -> list[Diagnostic]:
    """Return every mistake of a variant, in its files and in its script; none raises.

    As long as the files are not good enough to tell the names that the script may use, only the
    mistakes of its surface are told. Warnings are told too. `cache` as in `load_variant`.
    """
    try:
        reading = _read(resolve(name_or_path))
    except VariantError as error:
        return list(error.diagnostics)
    if reading.draft is None:
        return _in_order(reading) + _surface_mistakes(reading, cache)
    script = _find_script(reading)
    return _in_order(reading) + _script_mistakes(reading.draft, script, cache)


def read_draft(name_or_path: str | Path) -> tuple[Draft | None, list[Diagnostic]]:
    """Return a variant without its rules, and every mistake in its TOML files.

    Raises VariantError where the variant cannot be found at all.
    """
    reading = _read(resolve(name_or_path))
    return reading.draft, _in_order(reading)


def _in_order(reading: _Reading) -> list[Diagnostic]:
    """Return the mistakes of the variant's own file first, each file's from the top down."""
    own = str(reading.path)
    return sorted(
        reading.diagnostics, key=lambda one: (one.file != own, one.file, one.line, one.column)
    )


def list_variants() -> list[Listing]:
    """Return the shipped variants by name; a file that cannot be read is listed untitled."""
    return [
        Listing(path.stem, _title(path), path) for path in sorted(shipped_folder().glob("*.toml"))
    ]


def _title(path: Path) -> str:
    text = read_text(path)
    if not isinstance(text, str):
        return ""
    try:
        title = tomllib.loads(text).get("title", "")
    except (tomllib.TOMLDecodeError, RecursionError):
        return ""
    return title if isinstance(title, str) else ""


def _read(path: Path) -> _Reading:
    opened = open_variant(path)
    reading = _Reading(path, opened.diagnostics)
    if opened.node is None:
        return reading
    reading.report = Report(opened.node, opened.diagnostics)
    try:
        spec = VariantSpec.read(opened.node.plain())
    except ValidationError as error:
        reading.report.add_shape_errors(error, opened.broken)
        _check_the_rest(opened.node, error, reading.report)
        return reading
    reading.draft = assemble(spec, reading.report)
    return reading


def _prune(plain: object, path: KeyPath) -> None:
    """Take what lies at `path` out of a plain tree; an array is taken out whole."""
    for index, key in enumerate(path):
        if not isinstance(plain, dict) or key not in plain:
            return
        if index == len(path) - 1 or not isinstance(plain[key], dict):
            del plain[key]
            return
        plain = plain[key]


_STAND_INS: dict[str, object] = {
    "title": "?", "rulebook": "?", "players": 2, "colour": "#808080",
    "length": 2.54, "width": 1.27, "nose_height": 0.036, "rail_width": 0.1,
    "diameter": 0.057, "mass": 0.17, "restitution": 0.9, "friction": 0.2, "friction_floor": 0.01,
    "sliding": 0.2, "rolling": 0.01, "spin_deceleration": 10.0,
    "tip_restitution": 0.7, "tip_friction": 0.6, "end_mass_ratio": 20.0,
}  # fmt: skip
"""What is taken for a value that is missing or wrong, so that the rest can be judged."""


def _stand_in(plain: object, path: KeyPath) -> None:
    """Put a sensible value at `path`, or at what encloses it, where one is known."""
    for index, key in enumerate(path):
        if not isinstance(plain, dict):
            return
        if key not in plain and key in _STAND_INS:
            plain[key] = _STAND_INS[str(key)]
            return
        if index < len(path) - 1:
            plain = plain.get(key)


_LEANS_ON: dict[str, tuple[KeyPath, ...]] = {
    "V301": (("table", "spots"),),
    "V302": (("balls", "ball"), ("rack",)),
    "V303": (("table", "lines"),),
    "V305": (("rack",),),
    "V306": (("balls",),),
    "V401": (("table", "length"), ("table", "width")),
    "V404": (("table", "length"), ("table", "width")),
    "V408": (("table", "length"), ("table", "width"), ("table", "lines")),
    "V402": (("rack",), ("balls",), ("table",)),
    "V403": (("rack",), ("balls",), ("table",)),
    "V405": (("table",),),
    "V406": (("balls",), ("table",)),
    "V407": (("balls", "ball"), ("rack",)),
    "V503": (("players",), ("cue_balls",)),
}
"""Mistakes of meaning that may come only from what has the wrong shape there and is left out."""


def _may_follow(one: Diagnostic, wrong: set[KeyPath]) -> bool:
    """Tell whether a mistake of meaning may be due to one of shape at one of the `wrong` places.

    A key that is not known may be the misspelt name of what is missed.
    """
    if one.code == "V110":
        return any(dotted(path).startswith(one.key) for path in wrong)
    return any(
        path[: len(part)] == part or part[: len(path)] == path
        for part in _LEANS_ON.get(one.code, ())
        for path in wrong
    )


def _check_the_rest(node: Node, error: ValidationError, report: Report) -> None:
    """Add the mistakes of meaning in what is left without the values that have no right shape."""
    plain = node.plain()
    wrong: set[KeyPath] = set()
    for one in error.errors(include_url=False):
        path = tuple(key for key in one["loc"] if key != "[key]")
        unknown = one["type"] == "extra_forbidden" and isinstance(one["input"], dict)
        wrong.add(path[:-1] if unknown else path)
        _prune(plain, path)
        if one["type"] != "extra_forbidden":
            _stand_in(plain, path)
    try:
        spec = VariantSpec.read(plain)
    except ValidationError:
        return
    second = Report(node)
    assemble(spec, second)
    report.diagnostics += [one for one in second.diagnostics if not _may_follow(one, wrong)]


def _find_script(reading: _Reading) -> _Script | None:
    """Return the rule script of a variant, or None and a mistake where it cannot be had."""
    draft, report = reading.draft, reading.report
    if draft is None or report is None:
        return None
    home = reading.path.parent
    stem = draft.spec.rules or reading.path.stem
    path = find_script(stem, home)
    if path is None:
        mend = f'write {stem}.rules beside this file, or name another with rules = "..."'
        report.add("V204", ("rules",), f"there is no rule script `{stem}.rules`", mend)
        return None
    text = read_text(path)
    if isinstance(text, str):
        return _Script(path, text, home)
    reading.diagnostics += text
    return None


def _surface_mistakes(reading: _Reading, cache: Path | None) -> list[Diagnostic]:
    """Return what can be told of the script of a variant whose names are not known yet."""
    from rulelang.parse import parse  # noqa: PLC0415  the parser is slow to import

    path = find_script(reading.path.stem, reading.path.parent)
    text = None if path is None else read_text(path)
    if path is None or text is None:
        return []
    return parse(text, str(path), cache)[1] if isinstance(text, str) else text


def _script_mistakes(
    draft: Draft | None, script: _Script | None, cache: Path | None
) -> list[Diagnostic]:
    from rulelang.compile import check_script  # noqa: PLC0415  the parser is slow to import

    if draft is None or script is None:
        return []
    words = vocabulary_of(draft)
    found = check_script(script.text, str(script.path), words, script.library, cache)
    return [_with_near_script(one, script.home) for one in found]


def _with_near_script(one: Diagnostic, home: Path) -> Diagnostic:
    """Return a mistake with the nearest script for its mend, where one to use is not found."""
    near = nearest(one.message.split('"')[1], script_names(home)) if one.code == "R204" else ""
    return replace(one, mend=near) if near.startswith("did") else one
