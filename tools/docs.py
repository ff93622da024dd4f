"""Documents that are made from the program: `python -m tools.docs` writes, `--check` compares.

One idea: a document holds marked blocks, `<!-- made: NAME -->` to `<!-- end -->`; each block is
made anew by one function, so that what can be wrong is never written by hand. Files that are made
as a whole, such as schemas, are treated alike.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
import textwrap
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(<!-- made: ([a-z-]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def _table(codes: Mapping[str, str]) -> str:
    rows = "\n".join(f"| {code} | {text} |" for code, text in codes.items())
    return f"| code | meaning |\n|---|---|\n{rows}\n"


def variant_codes() -> str:
    """Return the table of mistakes in variant files."""
    from engine.variant.codes import CODES  # noqa: PLC0415

    return _table(CODES)


def record_codes() -> str:
    """Return the table of mistakes in records."""
    from engine.records.codes import CODES  # noqa: PLC0415

    return _table(CODES)


def script_codes() -> str:
    """Return the table of mistakes in scripts."""
    from rulelang.codes import CODES  # noqa: PLC0415

    return _table(CODES)


def games() -> str:
    """Return the games that ship, by title."""
    from engine.variant.load import list_variants  # noqa: PLC0415

    shipped = list_variants()
    links = sorted(f"[{one.title}](docs/games/{one.name}.md)" for one in shipped)
    return f"{len(shipped)} games: {', '.join(links)}.\n"


def codes() -> str:
    """Return the page of codes of variant files and scripts."""
    from tools.codes import page  # noqa: PLC0415

    return page()


def events() -> str:
    """Return the events of shot records, each with its phrase."""
    from tools.phrases import EVENT_PHRASES  # noqa: PLC0415

    rows = "\n".join(f"| `{event}` | `{phrase}` |" for event, phrase in EVENT_PHRASES)
    return f"| event | phrase |\n|---|---|\n{rows}\n"


def phrases() -> str:
    """Return every phrase of the language by groups."""
    from tools.phrases import PHRASES  # noqa: PLC0415

    text = ""
    for group in dict.fromkeys(one.group for one in PHRASES):
        rows = "\n".join(
            f"| {_code(one.spelling)} | {one.meaning} | {_code(one.example)} |"
            for one in PHRASES
            if one.group == group
        )
        text += f"\n### {group}\n\n| phrase | meaning | example |\n|---|---|---|\n{rows}\n"
    return text


def _code(text: str) -> str:
    """Return lines of a script as they can stand in a table."""
    lines = [line.replace("|", "&#124;") for line in text.split("\n")]
    return "<br>".join(
        f"{'&nbsp;' * (len(line) - len(line.lstrip()))}<code>{line.lstrip()}</code>"
        for line in lines
    )


def commands() -> str:
    """Return what every command says of itself, its options as a table."""
    from engine.__main__ import main  # noqa: PLC0415

    return "\n" + "\n".join(_command(name, main.commands[name]) for name in sorted(main.commands))


def _command(name: str, command: click.Command) -> str:
    words = [_argument(one) for one in command.params if isinstance(one, click.Argument)]
    about = " ".join(line.strip() or "\n\n" for line in (command.help or "").splitlines())
    about = re.sub(r" *\n\n *", "\n\n", about).strip()
    text = f"### {name}\n\n`python -m engine {' '.join([name, *words])}`\n\n{about}\n"
    options = [one for one in command.params if isinstance(one, click.Option)]
    if not options:
        return text
    rows = "\n".join(f"| `{_written(one)}` | {one.help or ''} |" for one in options)
    return f"{text}\n| option | meaning |\n|---|---|\n{rows}\n"


def _argument(argument: click.Argument) -> str:
    word = str(argument.name).upper() + ("..." if argument.nargs == -1 else "")
    return word if argument.required else f"[{word}]"


def _written(option: click.Option) -> str:
    name = ", ".join(option.opts)
    if option.is_flag:
        return name
    kind = option.type
    choices = list(kind.choices) if isinstance(kind, click.Choice) else []
    return f"{name} {'/'.join(map(str, choices)) or option.metavar}"


def keys() -> str:
    """Return the table of keys."""
    from engine.app.keys import BINDINGS  # noqa: PLC0415

    rows = "\n".join(f"| {one.shown} | {one.about} |" for one in BINDINGS)
    return f"| key | what it does |\n|---|---|\n{rows}\n"


def actions() -> str:
    """Return the names by which the settings give keys."""
    from engine.app.keys import BINDINGS  # noqa: PLC0415

    return textwrap.fill(", ".join(f"`{one.action}`" for one in BINDINGS) + ".", 100) + "\n"


def key_tables() -> str:
    """Return every key by groups, then what the mouse does."""
    from engine.app.keys import BINDINGS, MOUSE, groups  # noqa: PLC0415

    text = ""
    for group in groups():
        rows = [
            f"| {one.shown} | {one.about}{'; with Shift in fine steps' * (one.takes == 'shift')} |"
            for one in BINDINGS
            if one.group == group
        ]
        text += f"\n### {group}\n\n| keys | what they do |\n|---|---|\n" + "\n".join(rows) + "\n"
    rows = [f"| {what} | {about} |" for what, about in MOUSE]
    return f"{text}\n### Mouse\n\n| hand | what it does |\n|---|---|\n" + "\n".join(rows) + "\n"


def validation() -> str:
    """Return how many published figures are met, by group."""
    from tools.validate.adapters import run_check  # noqa: PLC0415
    from tools.validate.check import read_checks  # noqa: PLC0415
    from tools.validate.tell import as_table, summary  # noqa: PLC0415

    checks = read_checks(ROOT / "tests" / "validation" / "checks.json")
    results = [run_check(check) for check in checks]
    return f"\n{summary(results)}\n\n{as_table(results)}\n"


def robustness() -> str:
    """Return which test is about which nasty configuration."""
    from tools.robustness import table  # noqa: PLC0415

    return table()


def proofs() -> str:
    """Return a line for each game: its files, what they cite, and what its records prove."""
    from engine.proving.coverage import coverage_of  # noqa: PLC0415
    from engine.proving.games import load_game, records_by_game  # noqa: PLC0415
    from engine.proving.told import percent  # noqa: PLC0415

    found, _ = records_by_game((), ROOT / "tests" / "golden")
    rows = [
        "| game | lines of TOML | lines of rules | sections cited | records | rules | outcomes |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, paths in sorted(found.items()):
        one = coverage_of(load_game(name, paths))
        rows.append(
            f"| [{name}](games/{name}.md) | {one.toml_lines} | {one.rule_lines} |"
            f" {len(one.sections)} | {one.records} | {percent(one.rules_fired, one.rules)} |"
            f" {percent(one.outcomes_seen, one.outcomes)} |"
        )
    return "\n".join(rows) + "\n"


MAKERS: Mapping[str, Callable[[], str]] = {
    "variant-codes": variant_codes,
    "record-codes": record_codes,
    "script-codes": script_codes,
    "codes": codes,
    "events": events,
    "phrases": phrases,
    "commands": commands,
    "keys": keys,
    "key-tables": key_tables,
    "actions": actions,
    "games": games,
    "proofs": proofs,
    "validation": validation,
    "robustness": robustness,
}


def _schema(kind: str) -> str:
    from engine.authoring.schema import schema_of  # noqa: PLC0415

    return json.dumps(schema_of(kind), indent=1) + "\n"


def _textmate() -> str:
    from rulelang.highlight import textmate  # noqa: PLC0415

    return json.dumps(textmate(), indent=1) + "\n"


def files() -> Mapping[str, Callable[[], str]]:
    """Return whole files that are made, by their place in the project."""
    from engine.authoring.schema import KINDS  # noqa: PLC0415

    schemas = {f"variants/schema/{kind}.json": partial(_schema, kind) for kind in KINDS}
    return {**schemas, "editors/vscode/rules.tmLanguage.json": _textmate}


def pages() -> Mapping[str, Callable[[], str]]:
    """Return the pages on games, which end with what the game's files say."""
    from tools.game_pages import PAGES, with_files  # noqa: PLC0415

    return {
        str(path.relative_to(ROOT)): partial(
            with_files, path.read_text(encoding="utf-8"), path.stem
        )
        for path in sorted(PAGES.glob("*.md"))
    }


def remade(text: str) -> str:
    """Return a document with every marked block made anew."""
    return BLOCK.sub(lambda found: found[1] + MAKERS[found[2]]() + found[3], text)


def main() -> int:
    """Write or check all documents; return 1 where a checked one is stale."""
    parser = argparse.ArgumentParser(prog="python -m tools.docs", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    check = parser.parse_args().check
    stale = []
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        if not path.exists():
            continue
        text = path.read_text(encoding="utf-8")
        fresh = remade(text)
        if fresh != text:
            stale.append(path.relative_to(ROOT))
            if not check:
                path.write_text(fresh, encoding="utf-8")
    for name, make in {**files(), **pages()}.items():
        path = ROOT / name
        fresh = make()
        if path.exists() and path.read_text(encoding="utf-8") == fresh:
            continue
        stale.append(path.relative_to(ROOT))
        if not check:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(fresh, encoding="utf-8")
    for path in stale:
        print(f"{path}: {'stale, run python -m tools.docs' if check else 'written'}")
    return int(check and bool(stale))


if __name__ == "__main__":
    sys.exit(main())
