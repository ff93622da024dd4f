"""No name of the contract is lost to a keyword: each parses in every place it can stand."""

from __future__ import annotations

from pathlib import Path

import pytest

from rulelang.making import lark_of
from rulelang.parse import grammar

NAMES = dict(
    line.split(": ", 1)
    for line in Path(__file__)
    .with_name("contract_names.txt")
    .read_text(encoding="utf-8")
    .splitlines()
)
PLACES = {
    "ball": [
        "if @ pocketed: respot @",
        "if cue ball hit @: foul x",
        "if first ball hit is @: foul x",
        "if any of (@, cue ball) left table: foul x",
        "home of @ is x",
        "for each of (@, cue ball): spot it at x",
    ],
    "line": ["if 9-ball crossed @: foul x"],
    "zone": [
        "if 9-ball entered @: foul x",
        "if 9-ball left @ after 9-ball entered @: foul x",
        "if 9-ball is in @: foul x",
        "if every ball is in @: foul x",
        "if cue ball is in hand in @: foul x",
        "if 9-ball started in @: foul x",
        "if cue ball placed outside @: foul x",
        "if cue ball placed in @: foul x",
        "give opponent cue ball in hand in @",
    ],
    "spot": [
        "spot 9-ball at @ else near @ toward foot else near @ toward head",
        "home of red is @",
    ],
    "pocket": [
        "if 9-ball pocketed in @: foul x",
        "if 9-ball hit jaw of @: foul x",
        "if 9-ball rebounded from @: foul x",
        "if 9-ball settled in @: foul x",
    ],
    "cushion": [
        "if 9-ball hit cushion @: foul x",
        "if 9-ball pressed cushion @ before 9-ball hit cushion @: foul x",
        "if 9-ball left cushion @: foul x",
        "if 9-ball is frozen to cushion @: foul x",
    ],
    "pin": [
        "if cue ball toppled @: foul x",
        "if @ toppled: foul x",
        "if 9-ball touched @: foul x",
        "if @ leaned on 9-ball: foul x",
        "if @ toppled by cue ball: foul x",
    ],
    "phase": [
        "phases @",
        "phases x, @",
        "go to phase @",
        "if phase is @: foul x",
        "if phase is not @: foul x",
        "if next phase is one of (@, x): foul x",
        "fouls in phase @:\n    if shot is foul: foul x",
    ],
    "state": [
        "track @ per game per player starting 0",
        "track @ per shot",
        "if @ is 1: foul x",
        "if @ of shooter is 1: foul x",
        "add 1 to @",
        "add 1 to @ of opponent",
        "set @ to yes",
        "set @ of shooter to 3",
        "reset @",
        "reset @ of chooser",
    ],
    "value": [
        "track x per game starting @",
        "set x to @",
        "set x of shooter to @",
        "if x is @: foul y",
        "if x is not @: foul y",
        "if x is one of (@, y): foul y",
        "fact x one of (@, y) default @",
    ],
    "setting": ["if @: foul x", "if score of shooter is at least @: foul x"],
    "foul": ["foul @", "foul @ worth 4", "foul @ alone", "if foul is @: turn continues"],
    "option": [
        "offer opponent: @: nothing happens",
        "offer shooter:\n    @:\n        chooser plays\n    @ if shot is foul: nothing happens",
    ],
    "fact": [
        "fact @ default no",
        "fact @ ball supplied by @ to balls",
        "if @: foul x",
        "if @ is x: foul x",
        "fact x default no supplied by @ on cue ball",
    ],
}


def spoken(name: str) -> str:
    return f"{name}-ball" if name.isdigit() else name


@pytest.mark.parametrize("sort", PLACES)
def test_every_name_parses_in_every_place(sort: str) -> None:
    parser = grammar()
    lost = []
    for name in NAMES[sort].split():
        for place in PLACES[sort]:
            text = place.replace("@", spoken(name))
            try:
                parser.parse(text + "\n")
            except Exception as trouble:  # noqa: BLE001
                lost.append(f"{text!r}: {str(trouble).splitlines()[0]}")
    assert lost == []


def test_the_grammar_has_no_conflict() -> None:
    assert lark_of(strict=True).parse("if cue ball pocketed: respot cue\n")


def test_the_grammar_is_kept_in_the_folder_given(tmp_path: Path) -> None:
    grammar(tmp_path)
    assert [path.is_file() for path in tmp_path.iterdir()] == [True]
