"""A new game from one that is there: two files that check clean and play at once.

One idea: a copy to change anywhere, or a file that extends the other and says what differs.
Invariant: no file that is there already is touched, and a game's name is free.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

from engine.variant.library import VariantError, find_script, resolve, shipped_folder

_STEM = re.compile(r"(?=.{1,60}$)[a-z0-9]+([-_][a-z0-9]+)*")
_TITLE = re.compile(r"^title *=.*$", re.MULTILINE)
_RULES = re.compile(r"^rules *=.*\n", re.MULTILINE)
_SCHEMA = re.compile(r"^#:schema .*\n")
_GAME = re.compile(r'^game +"[^"\n]*"', re.MULTILINE)

_EXTENDING = """{schema}extends = "{base}"
title = "{title}"

# Say here only what differs, such as another default:
#
#   [settings.target]
#   default = 15
"""
_USING = """language 1
game "{title}"{cites}
uses "{base}"

# Say here only what differs. A rule of the other game is replaced by name:
#
#   turn:
#       rule "My rule" [1] overrides "Its rule": if cue ball pocketed: turn passes
"""


class ScaffoldError(ValueError):
    """A new game that cannot be written, and why."""


def scaffold(name: str, base: str, folder: Path, *, extends: bool) -> tuple[Path, Path]:
    """Write NAME.toml and NAME.rules into `folder`, made from the variant `base`.

    Raises ScaffoldError where the name is taken or cannot be one, or `base` does not exist.
    """
    _free(name, folder)
    try:
        variant = resolve(base)
    except VariantError as error:
        raise ScaffoldError(str(error)) from None
    if variant.parent.resolve() not in (shipped_folder().resolve(), folder.resolve()):
        raise ScaffoldError(f"{variant} lies elsewhere: begin in the folder where it is")
    text = variant.read_text(encoding="utf-8")
    stem = re.search(r'^rules *= *"([^"]*)"', text, re.MULTILINE)
    script = find_script(stem.group(1) if stem else variant.stem, variant.parent)
    rules = "" if script is None else script.read_text(encoding="utf-8")
    title = name.replace("_", " ").replace("-", " ").capitalize()
    head = _schema_line(folder)
    if extends or not rules or re.search(r"^extends *=", text, re.MULTILINE):
        toml = _EXTENDING.format(schema=head, base=variant.stem, title=title)
        cites = re.search(r'^game +"[^"]*"( cites "[^"]*")', rules, re.MULTILINE)
        rules = _USING.format(title=title, base=variant.stem, cites=cites.group(1) if cites else "")
    else:
        toml = head + _RULES.sub("", _SCHEMA.sub("", text))
        toml = _TITLE.sub(f'title = "{title}"', toml, count=1)
        rules = _GAME.sub(f'game "{title}"', rules, count=1)
    paths = (folder / f"{name}.toml", folder / f"{name}.rules")
    for path, written in zip(paths, (toml, rules), strict=True):
        path.write_text(written, encoding="utf-8", newline="\n")
    return paths


def _free(name: str, folder: Path) -> None:
    if _STEM.fullmatch(name) is None:
        better = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")[:60]
        raise ScaffoldError(
            f"`{name[:60]}` is no name of a game"
            + (f": write `{better}`" if better else ": use small letters, digits, `_` and `-`")
        )
    if (shipped_folder() / f"{name}.toml").exists():
        raise ScaffoldError(f"there is a game `{name}` already: choose another name")
    for end in ("toml", "rules"):
        path = folder / f"{name}.{end}"
        if path.exists():
            raise ScaffoldError(f"{path} is there already: choose another name, or move it")


def _schema_line(folder: Path) -> str:
    """Return the line by which an editor finds the schema, "" where none is at hand."""
    schema = shipped_folder() / "schema" / "variant.json"
    if not schema.exists():
        return ""
    try:
        path = Path(os.path.relpath(schema, folder.resolve())).as_posix()
    except ValueError:
        path = schema.as_uri()
    return f"#:schema {path if path.startswith(('.', 'file:')) else './' + path}\n"
