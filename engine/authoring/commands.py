"""The author's commands: format, new, schema.

One idea: a command finds the files, calls one function and prints; what is wrong is told as
everywhere, with its place and a mend.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

FILE = click.Path(path_type=Path)


@click.command("format")
@click.argument("paths", nargs=-1, required=True, type=FILE)
@click.option("--check", is_flag=True, help="Write nothing; say which files would change.")
def format_(paths: Sequence[Path], *, check: bool) -> None:
    """Write rule scripts in their one canonical spelling; comments and line breaks stay.

    PATHS are scripts, or folders that hold them. Exit status 0: all is well, 1: with --check, some
    would change, 2: a file cannot be read or parsed.
    """
    status = 0
    changed = 0
    files = list(_scripts(paths))
    for path in files:
        text = _formatted(path)
        if text is None:
            status = 2
        elif text:
            changed += 1
            click.echo(f"{path}: {'would change' if check else 'rewritten'}")
            if not check:
                path.write_text(text, encoding="utf-8", newline="\n")
    count = "1 file" if len(files) == 1 else f"{len(files)} files"
    click.echo(f"{count}, {changed} {'would change' if check else 'changed'}")
    sys.exit(status or int(check and changed > 0))


def _scripts(paths: Sequence[Path]) -> Iterator[Path]:
    for path in paths:
        if path.is_dir():
            yield from sorted(path.rglob("*.rules"))
        else:
            yield path


def _formatted(path: Path) -> str | None:
    """Return the new text of a script, "" where it stays as it is, None where it is broken."""
    from engine.variant.source import read_text  # noqa: PLC0415
    from rulelang.diagnostics import ScriptError, render  # noqa: PLC0415
    from rulelang.formatting import format_script  # noqa: PLC0415

    source = read_text(path)
    if not isinstance(source, str):
        for one in source:
            click.echo(render(one), err=True)
        return None
    try:
        text = format_script(source, str(path), _grammar_folder())
    except ScriptError as error:
        click.echo(str(error), err=True)
        return None
    return "" if text.encode() == path.read_bytes() else text


def _grammar_folder() -> Path:
    from platformdirs import user_cache_path  # noqa: PLC0415

    return user_cache_path("headstring")


@click.command()
@click.argument("name", required=False)
@click.option("--from", "base", metavar="VARIANT", help="The game to begin with.")
@click.option("--extends", is_flag=True, help="Say only what differs, instead of a whole copy.")
@click.option("--list", "list_", is_flag=True, help="List the games to begin with.")
def new(name: str | None, base: str | None, *, extends: bool, list_: bool) -> None:
    """Write a new game into the current folder: a variant file and a script that play at once.

    NAME is the stem of its files: small letters, digits, `_` and `-`.
    """
    from engine.authoring.scaffold import ScaffoldError, scaffold  # noqa: PLC0415
    from engine.variant.load import list_variants  # noqa: PLC0415

    games = list_variants()
    if list_:
        width = max(len(one.name) for one in games)
        for one in games:
            click.echo(f"{one.name:{width}}  {one.title}")
        return
    if name is None or base is None:
        raise click.UsageError("say `new NAME --from VARIANT`; `new --list` shows what there is")
    try:
        paths = scaffold(name, base, Path(), extends=extends)
    except ScaffoldError as error:
        raise click.UsageError(str(error)) from None
    for path in paths:
        click.echo(f"{path}: written")
    click.echo(f"next: edit them, then `python -m engine check ./{name}.toml`")


@click.command()
@click.argument("kind", required=False)
def schema(kind: str | None) -> None:
    """Print the JSON Schema of variant files.

    KIND is `variant`, or a part that variants share, such as `table`. An editor that knows TOML
    checks and completes a file whose first line is `#:schema PATH`.
    """
    from engine.authoring.schema import KINDS, schema_of  # noqa: PLC0415

    if kind is not None and kind not in KINDS:
        raise click.UsageError(f"there is no schema of `{kind}`: say one of {', '.join(KINDS)}")
    click.echo(json.dumps(schema_of(kind or "variant"), indent=2))
