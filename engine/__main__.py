"""The command line: parse arguments, call one function, print.

One idea: every command imports what it needs when it runs, so that `--help` answers at once and
commands that move no ball never load the physics.
"""

from __future__ import annotations

import atexit
import gc
import json
import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from engine.authoring.commands import format_, new, schema

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from engine.records.run import Outcome
    from engine.variant.variant import Value, Variant
    from rulelang.diagnostics import Diagnostic

RENDERERS = ("wireframe", "painter", "scanline")
CAMERAS = ("cue", "above", "orbit")
COMPILING = "compiling (once per installation, some seconds)"
FILE = click.Path(path_type=Path)


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="headstring")
def main() -> None:
    """Headstring: every cue sport is two text files, a table in TOML and a script of rules.

    A game is named as `list` names it, or by the path of its TOML file.
    """
    atexit.register(gc.freeze)  # a process that ends need not look for garbage once more


@main.command()
@click.argument("variant", required=False)
@click.option("--players", type=int, metavar="N", help="How many play.")
@click.option("--name", "names", multiple=True, metavar="NAME", help="Of each player in turn.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="A house rule.")
@click.option("--renderer", type=click.Choice(RENDERERS), help="What to begin with (keys 1 2 3).")
@click.option("--size", metavar="WIDTHxHEIGHT", help="Size of the window, such as 1280x720.")
@click.option("--full-screen", is_flag=True, default=None, help="Fill the screen (key F11).")
@click.option("--rate", type=click.IntRange(1, 1000), metavar="N", help="Frames a second.")
@click.option("--seed", type=int, metavar="N", help="Where all chance in the match comes from.")
@click.option(
    "--journal",
    type=FILE,
    metavar="FILE",
    help="Keep the match in this file.",
)
@click.option("--resume", is_flag=True, help="Go on with the match in the journal.")
def play(variant: str | None, **options: object) -> None:
    """Play a game in a window, or choose one on the start screen. F1 shows the keys."""
    from engine.app.play import play as open_window  # noqa: PLC0415

    needs = ("players", "names", "seed", "journal", "resume")
    if variant is None and (options["settings"] or any(options[name] for name in needs)):
        raise click.UsageError("which game is that for? `python -m engine list` shows them all")
    settings = dict(_pair(text) for text in options.pop("settings"))  # type: ignore[attr-defined]
    size = _size(options.pop("size"))
    sys.exit(open_window(variant, settings=settings, size=size, **options))  # type: ignore[arg-type]


def _pair(text: str) -> tuple[str, str]:
    name, between, value = text.partition("=")
    if not between:
        raise click.UsageError(f"--set {text}: write it as NAME=VALUE, such as target=5")
    return name.strip(), value.strip()


def _size(text: object) -> tuple[int, int] | None:
    if text is None:
        return None
    width, _, height = str(text).partition("x")
    if not (width.isdecimal() and height.isdecimal()):
        raise click.UsageError(f"--size {text}: write it as WIDTHxHEIGHT, such as 1280x720")
    return int(width), int(height)


@main.command("list")
@click.option("--json", "as_json", is_flag=True, help="Print a JSON list.")
def list_games(*, as_json: bool) -> None:
    """List the games that are at hand."""
    from engine.variant.load import list_variants  # noqa: PLC0415

    games = list_variants()
    if as_json:
        rows = [{"name": one.name, "title": one.title} for one in games]
        click.echo(json.dumps(rows, indent=2))
        return
    width = max((len(one.name) for one in games), default=0)
    for one in games:
        click.echo(f"{one.name:{width}}  {one.title}")


@main.command()
@click.argument("variants", nargs=-1)
@click.option("--json", "as_json", is_flag=True, help="Print a JSON list of mistakes.")
def check(variants: Sequence[str], *, as_json: bool) -> None:
    """Check variant files and their scripts; every mistake comes with a mend.

    Without a name, all games at hand are checked. Exit status 0: no mistake, 1: mistakes,
    2: a variant cannot be found.
    """
    gc.set_threshold(100_000)  # short work: looking for garbage costs more than it frees
    from engine.variant.library import VariantError, resolve  # noqa: PLC0415
    from engine.variant.load import check_variant, list_variants  # noqa: PLC0415

    names = list(variants) or [one.name for one in list_variants()]
    found: list[Diagnostic] = []
    status = 0
    for name in names:
        try:
            found += check_variant(resolve(name), _grammar_folder())
        except VariantError as error:
            found += error.diagnostics
            status = 2
    _tell(found, as_json=as_json)
    if not as_json and not found:
        click.echo(f"{len(names)} checked, no mistakes")
    sys.exit(status or int(any(one.severity == "error" for one in found)))


def _tell(diagnostics: Sequence[Diagnostic], *, as_json: bool) -> None:
    from dataclasses import asdict  # noqa: PLC0415

    from rulelang.diagnostics import render  # noqa: PLC0415

    if as_json:
        click.echo(json.dumps([asdict(one) for one in diagnostics], indent=2))
        return
    for one in diagnostics:
        click.echo(render(one), err=True)


@main.command()
@click.argument("paths", nargs=-1, type=FILE)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON list, an object a record.")
@click.option("--update", is_flag=True, help="Rewrite expectations to what the referee says.")
@click.option("--pictures", type=FILE, metavar="FOLDER", help="Draw what differs there.")
@click.option("--coverage", is_flag=True, help="Say which rules and sections the records prove.")
@click.option("--mutate", is_flag=True, help="Make the rules wrong and see if a record notices.")
@click.option(
    "--jobs", type=click.IntRange(0), default=0, metavar="N", help="Processes for --mutate."
)
@click.option(
    "--records",
    type=FILE,
    default="tests/golden",
    metavar="FOLDER",
    help="Where records lie by game: tests/golden.",
)
def golden(paths: Sequence[Path], *, as_json: bool, update: bool, **options: object) -> None:
    """Judge recorded shots again and show what differs.

    PATHS are record files, or folders that hold them. With --coverage and --mutate they may be
    names of games, and none means all. Exit status 0: all pass (and nothing is missing),
    1: some differ, 2: a file cannot be used.
    """
    if options["coverage"] or options["mutate"]:
        sys.exit(_prove(paths, as_json=as_json, **options))
    if not paths:
        raise click.UsageError("which records? Give files or folders.")
    from engine.records.golden import run_paths, status_of  # noqa: PLC0415
    from engine.records.show import show_result, summary  # noqa: PLC0415

    results = []
    for result in run_paths(paths, _loader()):
        results.append(result)
        if not as_json:
            show_result(result)
        if result.outcome is None or result.outcome.passed:
            continue
        if options["pictures"]:
            _draw(result.path, result.outcome, options["pictures"])  # type: ignore[arg-type]
        if update:
            _update(result.path, result.outcome)
    if as_json:
        click.echo(json.dumps([result.as_json() for result in results], indent=2))
    else:
        click.echo(summary(results))
    sys.exit(0 if update and status_of(results) == 1 else status_of(results))


def _prove(paths: Sequence[Path], *, as_json: bool, **options: object) -> int:
    from engine.proving.commands import coverage, mutation  # noqa: PLC0415

    folder: Path = options["records"]  # type: ignore[assignment]
    jobs: int = options["jobs"]  # type: ignore[assignment]
    if options["coverage"]:
        return coverage(paths, folder, _grammar_folder(), as_json=as_json)
    return mutation(paths, folder, _grammar_folder(), jobs, as_json=as_json)


def _draw(path: Path, outcome: Outcome, folder: Path) -> None:
    from engine.proving.pictures import draw_outcome  # noqa: PLC0415

    picture = folder / f"{path.parent.name}-{path.stem}.png"
    if draw_outcome(outcome, picture):
        click.echo(f"{picture}: drawn", err=True)
    else:
        click.echo(f"{path}: no picture, where the balls lay is not known", err=True)


def _update(path: Path, outcome: object) -> None:
    from engine.records.update import update_text  # noqa: PLC0415

    path.write_text(update_text(path.read_text(encoding="utf-8"), outcome), encoding="utf-8")  # type: ignore[arg-type]
    click.echo(f"{path}: rewritten", err=True)


@main.command()
@click.argument("record", type=FILE)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("--all", "everything", is_flag=True, help="Show the rules that did not fire, too.")
def explain(record: Path, *, as_json: bool, everything: bool) -> None:
    """Say what the referee decides on a recorded shot and by which rules."""
    from engine.records.read import read_record  # noqa: PLC0415
    from engine.records.record import RecordError  # noqa: PLC0415
    from engine.records.run import run_record  # noqa: PLC0415
    from engine.records.show import explain_json, explain_text  # noqa: PLC0415

    try:
        outcome = run_record(read_record(record, _loader()))
    except RecordError as error:
        _tell(error.diagnostics, as_json=False)
        sys.exit(2)
    if as_json:
        click.echo(json.dumps(explain_json(outcome), indent=2))
    else:
        click.echo(explain_text(outcome, everything=everything))


@main.command()
@click.argument("variant")
@click.option("--speed", type=float, required=True, metavar="X", help="Speed of the cue, m/s.")
@click.option("--heading", type=float, default=0.0, metavar="X", help="Degrees; 0 is to the foot.")
@click.option("--elevation", type=float, default=0.0, metavar="X", help="Degrees above the bed.")
@click.option("--side", type=float, default=0.0, metavar="X", help="Tip right of centre, radii.")
@click.option("--follow", type=float, default=0.0, metavar="X", help="Tip above centre, radii.")
@click.option("--place", nargs=2, type=float, metavar="X Y", help="Where the ball in hand goes, m.")
@click.option("--seed", type=int, default=0, metavar="N", help="Decides the rack.")
@click.option("--record", type=FILE, metavar="FILE", help="Keep the shot as a record.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def simulate(variant: str, place: tuple[float, float] | None, **options: object) -> None:
    """Play the first stroke of a game without a window: events, verdict, where the balls lie."""
    from engine.records.first import first_stroke  # noqa: PLC0415

    loaded = _load(variant)
    _tell_compiling()
    try:
        click.echo(first_stroke(loaded, place, **options))  # type: ignore[arg-type]
    except ValueError as error:
        raise click.UsageError(str(error)) from None


@main.command()
@click.argument("variant")
@click.option(
    "--renderer", type=click.Choice(RENDERERS), default="scanline", help="scanline by default."
)
@click.option("--camera", type=click.Choice(CAMERAS), default="cue", help="cue by default.")
@click.option("--size", metavar="WIDTHxHEIGHT", default="1280x720", help="1280x720 by default.")
@click.option("--seed", type=int, default=0, metavar="N", help="Decides the rack.")
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FILE.png",
    help="Where the picture goes.",
)
def render(variant: str, renderer: str, camera: str, size: str, seed: int, output: Path) -> None:
    """Draw a game's starting position as a PNG, without a window."""
    from engine.app.picture import render_variant  # noqa: PLC0415
    from engine.game.placing import opening_layout  # noqa: PLC0415

    loaded = _load(variant)
    _tell_compiling()
    layout = opening_layout(loaded, seed)
    render_variant(loaded, layout, renderer, camera, _size(size) or (1280, 720), output)
    click.echo(f"{output}: {loaded.title}, {renderer}, seen from {camera}")


@main.command()
@click.argument("record", type=FILE)
@click.option("--gif", type=FILE, metavar="FILE.gif", help="A moving picture of the shot.")
@click.option("--paths", type=FILE, metavar="FILE.png", help="The ways of all balls, every shot.")
@click.option("--shot", type=click.IntRange(1), default=1, metavar="N", help="Which; the first.")
@click.option("--size", metavar="WIDTHxHEIGHT", default="640x360", help="640x360 by default.")
def export(record: Path, gif: Path | None, paths: Path | None, shot: int, size: str) -> None:
    """Make pictures of a recorded shot, or of a shot of a journal, without a window.

    Exit status 2: the record cannot be used, or has nothing to show.
    """
    if gif is None and paths is None:
        raise click.UsageError("which picture? Give --gif FILE.gif or --paths FILE.png")
    from engine.app.clip import NoStrokeError, write_clip  # noqa: PLC0415
    from engine.proving.pictures import draw_outcome  # noqa: PLC0415
    from engine.records.read import read_record  # noqa: PLC0415
    from engine.records.record import RecordError  # noqa: PLC0415
    from engine.records.run import run_record  # noqa: PLC0415

    _tell_compiling()
    try:
        outcome = run_record(read_record(record, _loader()))
        if gif is not None:
            if shot > len(outcome.judgements):
                raise click.UsageError(f"{record} has {len(outcome.judgements)} shots")
            one = outcome.judgements[shot - 1]
            wide = _size(size) or (640, 360)
            write_clip(gif, outcome.record.variant, one.before, one.shot, size=wide)
            click.echo(f"{gif}: shot {shot} of {record}")
        if paths is not None:
            known = draw_outcome(outcome, paths)
            click.echo(f"{paths}: {f'the ways of {record}' if known else 'no place is known'}")
    except RecordError as error:
        _tell(error.diagnostics, as_json=False)
        sys.exit(2)
    except (NoStrokeError, OSError) as error:
        click.echo(f"{record}: {error}", err=True)
        sys.exit(2)


def _tell_compiling() -> None:
    """Say so where kernels must be compiled first: the wait is long, and comes once."""
    from engine.kernel_cache import when_compiling  # noqa: PLC0415

    when_compiling(partial(click.echo, COMPILING, err=True))


def _loader() -> Callable[[str], Variant]:
    """Return a way to load variants by stem, each once."""
    from functools import cache  # noqa: PLC0415

    from engine.variant.load import load_variant  # noqa: PLC0415

    folder = _grammar_folder()
    return cache(lambda name: load_variant(name, folder))


def _grammar_folder() -> Path:
    """Return where the grammar of scripts is kept from run to run."""
    from platformdirs import user_cache_path  # noqa: PLC0415

    return user_cache_path("headstring")


def _load(variant: str) -> Variant:
    from engine.variant.library import VariantError  # noqa: PLC0415
    from engine.variant.load import load_variant  # noqa: PLC0415

    try:
        return load_variant(variant, _grammar_folder())
    except VariantError as error:
        _tell(error.diagnostics, as_json=False)
        sys.exit(2)


def typed(text: str) -> Value:
    """Return a setting's value as it is written on the command line."""
    if text in {"true", "yes", "on"}:
        return True
    if text in {"false", "no", "off"}:
        return False
    return int(text) if text.lstrip("-").isdecimal() else text


for command in (format_, new, schema):
    main.add_command(command)

if __name__ == "__main__":
    main()
