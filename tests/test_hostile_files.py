"""Closes the hole between any file from a stranger and an answer in a second, in bounded memory.

All files are read in one child process whose memory is limited by the system.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="limits of memory, pipes and devices are Linux's"
)
CHILD = Path(__file__).with_name("hostile_child.py")
VARIANT = 'extends = "nine_ball"\n'
RECORD = 'format = 1\nvariant = "nine_ball"\ntitle = "x"\n'
SHOT = "[[shot]]\nexpect = {}\nevents = []\n"


def events(text: str) -> str:
    return f"{RECORD}[[shot]]\nexpect = {{}}\nevents = [\n{text}]\n"


def many(line: str, times: int) -> str:
    """Return a line many times, `{n}` its number."""
    return "".join(line.replace("{n}", str(number)) for number in range(times))


TOML = {
    "dates": many(f"d{{n}} = 1979-05-27T07:32:00.{'9' * 60}Z\n", 2800),
    "far-dates": "title = 9999-12-31T23:59:59.999999+23:59\nplayers = 0001-01-01\n",
    "bad-dates": many("d{n} = 1979-13-45T99:99:99Z\n", 7000),
    "hex-numbers": many(f"d{{n}} = 0x{'f' * 1900}\n", 120),
    "endless-number": f"players = {'9' * 1990}\n",
    "exponents": "[table.spots]\n" + many('s{n} = ["1e99999999{n} m", "1e-99999999{n}"]\n', 3000),
    "heavy-cue": 'cue.mass = "1e999999999 kg"\ntable.length = "9e9999 in"\ntable.width = inf\n',
    "sums": f'table.length = "{"1+" * 900}1 m"\n',
    "brackets": f'table.length = "{"(" * 900}1{")" * 900} m"\n',
    "fractions": f'table.length = "{"1/" * 900}1 m"\n',
    "digits-of-others": 'table.length = "\u0661\u0662 m"\ntable.width = "\uff11 m"\n',
    "endless-names": many(f"[settings.{'a' * 1900}{{n}}]\n", 120),
    "unseen-names": many('"\u202e' + "\u200b" * 900 + '{n}" = 1\n', 80),
    "marks": 'title = "' + "a" + "\u0301" * 1900 + '"\n',
    "dotted-headings": many("[" + ".".join(f"k{{n}}x{n}" for n in range(14)) + "]\n", 1400),
    "empty-arrays": "a = [" + "[]," * 900 + "]\n",
    "open-braces": "x = {\n" * 30_000,
    "open-lists": "x = [\n" * 30_000,
    "odd-quotes": "x = 'a\n" * 25_000,
    "long-ranges": '[rack.pattern]\nrows = ["*"]\nballs = [\n' + '"1..200",\n' * 15_000 + "]\n",
    "wide-range": '[balls.ball."-99999999..99999999"]\nvalue = 1\n',
    "many-rows": '[rack.pattern]\nballs = ["1..15"]\nrows = [\n' + '"*",\n' * 30_000 + "]\n",
    "many-players": "players = { fewest = -9999999999, most = 99999999999999999, usual = 1 }\n",
    "cushions": "[table.cushions]\n" + many('c{n} = { from = ["{n} mm", 0] }\n', 5000),
    "zones-of-zones": "[table.zones]\n" + many('z{n} = { opposite = ["z{n}", "z1"] }\n', 5000),
    "a-circle-of-spots": '[table.spots]\na = { spot = "b" }\nb = { spot = "a" }\n',
    "endless-sums": "[table.spots]\n" + many(f's{{n}} = ["{"L/4-" * 400}L/4", 0]\n', 110),
    "wrong-kinds": "title = []\nrulebook = {}\ntable = 1\nballs = 2\ncue = true\nrack = nan\n",
}
RECORDS = {
    "events": events('"cue hits 1",\n' * 17_000),
    "no-events": events('"zzz",\n' * 26_000),
    "long-event": events(f'"cue {"hits " * 380}",\n'),
    "endless-time": events(f'"cue hits 1 at {"9" * 1800}.5 s",\n"cue hits 1 at 1e999 s",\n'),
    "shots": RECORD + '[[shot]]\nexpect = {}\nevents = ["cue hits 1"]\n' * 3000,
    "choices": RECORD + '[[shot]]\nexpect = {}\nchoice = "play"\n' * 5000,
    "balls": RECORD + "[before]\non_table = [\n" + '"1",\n' * 30_000 + "]\n" + SHOT,
    "scores": RECORD + "[before]\nscores = [\n" + "1,\n" * 60_000 + "]\n" + SHOT,
    "places": RECORD + "[before.positions]\n" + many("b{n} = [0.0, 0.0]\n", 11_000) + SHOT,
    "nowhere": RECORD + "[before.positions]\n1 = [nan, inf]\ncue = [1e308, -1e308]\n" + SHOT,
    "settings": RECORD + "[settings]\n" + many("s{n} = 1\n", 15_000) + SHOT,
    "facts": RECORD + SHOT + "[shot.facts]\n" + many("f{n} = 1\n", 15_000),
    "expected": RECORD + "[[shot]]\nevents = []\n[shot.expect]\n" + many("e{n} = 1\n", 15_000),
    "fouls": RECORD
    + "[[shot]]\nevents = []\n[shot.expect]\nfouls = [\n"
    + many('"x{n}",\n', 24_000)
    + "]\n",
    "a-stroke-out-of-reason": RECORD
    + "[[shot]]\nexpect = {}\nstrike = { speed = 1e308, heading = nan }\n",
    "a-path-for-a-game": RECORD.replace("nine_ball", "../../../../etc/passwd") + SHOT,
    "a-device-for-a-game": RECORD.replace("nine_ball", "/dev/zero") + SHOT,
    "a-nul-in-a-game": RECORD.replace("nine_ball", "a\\u0000b") + SHOT,
    "huge-score": RECORD + f"[before]\nscores = [{'9' * 1900}, 1]\n" + SHOT,
}
SCRIPTS = {
    "rules": many('rule "R{n}": if 8-ball pocketed: foul x\n', 4000),
    "lines": "# nothing\n" * 19_000,
    "tracks-written": many("track t{n} per game\npoints: if t{n} is 1: add 1 to t{n}\n", 1100),
    "uses": many('uses "x{n}"\n', 4000),
    "uses-itself": 'uses "uses-itself"\nfoul x\n',
    "uses-paths": 'uses "../../../etc/passwd"\nuses "/dev/zero"\nuses ""\nuses "con"\n',
    "timers": many("timer t{n} lasts 9 seconds\nwhen t{n} expires: foul x\n", 1700),
    "loops": "points:\n"
    + "".join("    " * (n + 1) + "for each of object balls:\n" for n in range(20))
    + "    " * 21
    + "award 1 to shooter\n",
    "products": f"points: award {' times '.join(['999999999'] * 300)} to shooter\n",
    "defines-that-fan": "define a0 when 8-ball pocketed\n"
    + "".join(f"define a{n + 1} when a{n} and a{n} and a{n}\n" for n in range(38))
    + "if a38: foul x\n",
    "unseen": "if 8-ball\u200b pocketed: foul x\n" * 3000,
    "look-alikes": "\u0456f 8-ball pocketed: foul x\n" * 3000,
    "backwards": "\u202eif 8-ball pocketed: foul x\n" * 3000,
    "hard-blanks": "if\u00a08-ball pocketed: foul x\n" * 3000,
    "names-unknown": many("if nm{n} pocketed: foul x\n", 3000),
    "deep": "".join("    " * n + "if 8-ball pocketed:\n" for n in range(23))
    + " " * 92
    + "foul x\n",
    "random": random.Random(5).choices(
        ["if", "foul", "and", "or", "not", "(", ")", ":", ",", "for", "each", "of", "\n"], k=9000
    ),
}
RAW = {
    "megabytes": b"a = 1\n" * 2_000_000,
    "utf-16": ("title = 'x'\n" * 9000).encode("utf-16"),
    "latin": b"title = '\xe9'\n" * 9000,
    "overlong": b"title = '\xc0\x80'\n",
    "surrogate": b"title = '\xed\xa0\x80'\n",
    "bytes": random.Random(1).randbytes(200_000),
    "signs": bytes(random.Random(2).choices(b"[]{}=.\"'\n #ab1-_,", k=200_000)),
    "nul": b"\0" * 250_000,
}


def write(folder: Path) -> None:
    """Lay all the files down."""
    for name, text in TOML.items():
        (folder / f"variant-{name}.toml").write_text(VARIANT + text, encoding="utf-8")
    for name, text in RECORDS.items():
        (folder / f"record-{name}.toml").write_text(text, encoding="utf-8")
    for name, text in SCRIPTS.items():
        (folder / f"variant-s-{name}.toml").write_text(f'{VARIANT}rules = "{name}"\n')
        (folder / f"{name}.rules").write_text("".join(text), encoding="utf-8")
    for name, raw in RAW.items():
        for kind in ("variant", "record"):
            (folder / f"{kind}-raw-{name}.toml").write_bytes(raw)
        (folder / f"variant-s-raw-{name}.toml").write_text(f'{VARIANT}rules = "raw-{name}"\n')
        (folder / f"raw-{name}.rules").write_bytes(raw)
    _odd_files(folder)


def _odd_files(folder: Path) -> None:
    """Lay down what is no file, and files that lead in circles."""
    for kind in ("variant", "record"):
        (folder / f"{kind}-folder.toml").mkdir()
        (folder / f"{kind}-device.toml").symlink_to("/dev/zero")
        (folder / f"{kind}-circle.toml").symlink_to(folder / f"{kind}-circle.toml")
        (folder / f"{kind}-astray.toml").symlink_to(folder / "no-such-file")
        os.mkfifo(folder / f"{kind}-pipe.toml")
    (folder / "variant-itself.toml").write_text('extends = "variant-itself"\n')
    (folder / "variant-one.toml").write_text('extends = "variant-two"\n')
    (folder / "variant-two.toml").write_text('extends = "variant-one"\n')
    for number in range(40):
        (folder / f"chain-{number}.toml").write_text(f'extends = "chain-{number + 1}"\n')
    (folder / "variant-chain.toml").write_text('extends = "chain-0"\n')
    for number in range(40):
        (folder / f"long-{number}.rules").write_text(f'uses "long-{number + 1}"\n')
    (folder / "variant-long.toml").write_text(f'{VARIANT}rules = "long-0"\n')
    (folder / "one.rules").write_text('uses "other"\nfoul x\n')
    (folder / "other.rules").write_text('uses "one"\nfoul y\n')
    (folder / "variant-s-one.toml").write_text(f'{VARIANT}rules = "one"\n')
    (folder / "tables").mkdir()
    (folder / "tables" / "endless.toml").symlink_to("/dev/zero")
    (folder / "variant-part.toml").write_text(f'{VARIANT}table = "endless"\n')
    (folder / "endless.rules").symlink_to("/dev/zero")
    (folder / "variant-script.toml").write_text(f'{VARIANT}rules = "endless"\n')
    (folder / "folder.rules").mkdir()
    (folder / "variant-s-folder.toml").write_text(f'{VARIANT}rules = "folder"\n')


@pytest.fixture(scope="module")
def fared(tmp_path_factory) -> dict[str, dict]:
    folder = tmp_path_factory.mktemp("hostile")
    write(folder)
    root = CHILD.parent.parent
    told = subprocess.run(
        [sys.executable, str(CHILD), str(folder)],
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
        cwd=root,
        env={**os.environ, "PYTHONPATH": str(root)},
    )
    assert told.returncode == 0, told.stderr[-2000:]
    rows = [json.loads(line) for line in told.stdout.splitlines()]
    return {row["name"]: row for row in rows}


def test_every_file_was_read(fared) -> None:
    assert len(fared) > len(TOML) + len(RECORDS) + len(SCRIPTS) + 3 * len(RAW)


def test_nothing_is_raised(fared) -> None:
    assert {name: row["trouble"] for name, row in fared.items() if row["trouble"]} == {}


def test_each_answer_takes_a_second_at_most(fared) -> None:
    slow = {name: row["seconds"] for name, row in fared.items() if row["seconds"] > 1.5}
    assert slow == {}, "a second, and some for a busy machine"


def test_memory_is_bounded(fared) -> None:
    assert {name: row["grown"] for name, row in fared.items() if row["grown"] > 150} == {}


def test_at_most_a_hundred_mistakes_are_told(fared) -> None:
    assert {name for name, row in fared.items() if len(row["codes"]) > 101} == set()


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("variant-device.toml", "V001"),
        ("record-device.toml", "V001"),
        ("record-folder.toml", "V001"),
        ("record-pipe.toml", "V001"),
        ("variant-circle.toml", "V001"),
        ("variant-itself.toml", "V202"),
        ("variant-one.toml", "V202"),
        ("variant-chain.toml", "V202"),
        ("variant-part.toml", "V201"),
        ("variant-s-rules.toml", "R109"),
        ("variant-raw-megabytes.toml", "V003"),
        ("variant-long-ranges.toml", "V105"),
        ("record-nowhere.toml", "V105"),
        ("record-a-stroke-out-of-reason.toml", "V105"),
        ("record-a-path-for-a-game.toml", "T201"),
    ],
)
def test_what_is_wrong_is_told(fared, name, code) -> None:
    assert code in fared[name]["codes"]
