"""A match of each game through the real window, from the start screen to its end.

One idea: what is pressed and clicked is what a player would press and click; every screen is
saved as a picture to be looked at.

    python -m tools.scripted_play --games nine_ball --size 1280x720 --out DIR [--keyboard]

Exit status 0: every match came to its end; 1: one did not.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from functools import partial
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING

from tools.scripted import FOULS_AT
from tools.scripted.display import DISPLAYS, VIRTUAL, display

if TYPE_CHECKING:
    from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Play; return 0 where every match came to its end."""
    asked = _parser().parse_args(arguments)
    size = _size(asked.size)
    if asked.inside:
        return _play(asked, asked.games, size)
    failed = []
    with display(asked.display, size) as env:
        for game in asked.games.split(","):
            env |= {f"XDG_{kind}_HOME": str(asked.out / game / kind.lower()) for kind in FOLDERS}
            words = [*(arguments or sys.argv[1:]), "--games", game, "--inside"]
            command = [sys.executable, "-m", "tools.scripted_play", *words]
            status = subprocess.run(command, env=env, check=False).returncode
            print(f"{game}: {'to its end' if status == 0 else 'NOT to its end'}", flush=True)
            failed += [game] if status else []
    return 1 if failed else 0


FOLDERS = ("CONFIG", "DATA")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tools.scripted_play", description=__doc__)
    parser.add_argument("--games", default="nine_ball", help="names with commas between them")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--out", type=Path, required=True, help="folder for pictures and logs")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--players", type=int)
    parser.add_argument("--name", action="append", default=[], help="of each player in turn")
    parser.add_argument(
        "--tell", action="append", default=[], metavar="FACT@STROKE", help="what an eye saw"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rate", type=int, default=200)
    parser.add_argument("--tries", type=int, default=140, help="strokes thought of for each played")
    parser.add_argument("--most", type=int, default=400, help="give up after so many strokes")
    fouls = ",".join(map(str, FOULS_AT))
    parser.add_argument("--fouls", default=fouls, help="strokes that are meant to go wrong")
    parser.add_argument("--rounds", type=int, default=2, help="games of a match without an end")
    parser.add_argument("--kept", action="store_true", help="go on with the newest match kept")
    parser.add_argument("--keyboard", action="store_true", help="the mouse is not touched")
    parser.add_argument("--display", choices=DISPLAYS, default=VIRTUAL)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    return parser


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    return int(width), int(height)


def _play(asked: argparse.Namespace, game: str, size: tuple[int, int]) -> int:
    from engine.app.lobby import NAME  # noqa: PLC0415  the window's process
    from engine.app.play import read_value, run  # noqa: PLC0415
    from engine.app.settings import Settings  # noqa: PLC0415
    from engine.variant.load import load_variant  # noqa: PLC0415
    from tools.scripted.player import Player  # noqa: PLC0415

    variant = load_variant(game)
    given = dict(one.split("=", 1) for one in asked.set)
    wanted = {
        key: read_value(variant, key, text)
        for key, text in given.items()
        if key in variant.settings
    }
    if asked.players is not None:
        wanted = {"players": asked.players, **wanted}
    wanted |= {f"{NAME}{place}": name for place, name in enumerate(asked.name, start=1)}
    wanted |= {"match": 1} if asked.kept else {}
    tells = {int(at): fact for fact, _, at in (one.partition("@") for one in asked.tell)}
    out = asked.out / game
    out.mkdir(parents=True, exist_ok=True)
    player = Player(
        out,
        Random(asked.seed),
        asked.most,
        asked.tries,
        keyboard=asked.keyboard,
        fouls_at=tuple(map(int, asked.fouls.split(","))),
        most_games=asked.rounds,
        tells=tells,
    )
    settings = Settings(width=size[0], height=size[1], rate=asked.rate)
    run(None, settings, each=player.each, greet=partial(player.greet, name=game, wanted=wanted))
    (out / "log.txt").write_text("\n".join(player.log) + "\n", encoding="utf-8")
    return 0 if player.finished else 1


if __name__ == "__main__":
    sys.exit(main())
