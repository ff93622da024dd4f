"""A scripted player at the real window: keys and clicks into its queue, pictures and a log out.

One idea: the script sees what a player sees, looks for a stroke with the physics, and then sets
it key by key, so that a whole game proves the window, the controls and the rules together.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app.judging import facts_of
from engine.app.lobby import NAME
from engine.app.pages import MENU
from engine.app.session import Mode
from tools.aimer import Plan, find_plan
from tools.scripted import FOULS_AT
from tools.scripted.hands import (
    announce,
    drag_ball,
    pause,
    press,
    set_stroke,
    settle,
    type_name,
    type_text,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from pathlib import Path
    from random import Random

    from engine.app.evening import Reception
    from engine.app.loop import Loop
    from engine.variant.variant import Value

OF_A_KIND = 12
"""Pictures of one screen in a match."""


@dataclass(slots=True)
class Player:
    """One scripted match; `log` has a line for each shot, `pictures` what was saved.

    It ends with the match, or after `most_games` of it, and gives up after `most` strokes, each the
    best of `tries`. With `keyboard` no mouse is used,
    without `looks` nothing is saved and every page stays shut. `tells` are facts that an eye sees
    of a stroke, by the stroke's number; they are set on the page for them.
    """

    out: Path
    lot: Random
    most: int = 400
    tries: int = 140
    fouls_at: tuple[int, ...] = FOULS_AT
    keyboard: bool = False
    looks: bool = True
    most_games: int = 1
    tells: Mapping[int, str] = field(default_factory=dict)
    log: list[str] = field(default_factory=list)
    pictures: list[Path] = field(default_factory=list)
    saved: Counter[str] = field(default_factory=Counter)
    taken: dict[tuple[str, ...], int] = field(default_factory=dict)
    finished: bool = False
    strokes: int = 0
    games: int = 0
    plan: Plan | None = None
    _script: Iterator[None] | None = None
    _welcome: Iterator[None] | None = None

    def greet(self, reception: Reception, name: str, wanted: Mapping[str, Value]) -> None:
        """Do the next step on the start screen, until the game is chosen with what is `wanted`."""
        if self._welcome is None:
            self._welcome = self._choose_game(reception, name, wanted)
        next(self._welcome, None)

    def _choose_game(
        self, reception: Reception, name: str, wanted: Mapping[str, Value]
    ) -> Iterator[None]:
        while reception.lobby.card is None:
            yield
        yield
        self._picture(reception, "start")
        titles = {one.name: one.title for one in reception.lobby.entries}
        yield from type_text(titles[name].lower())
        while (entry := reception.lobby.entry) is None or entry.name != name:
            yield from press("down")
        while reception.lobby.card is None:
            yield
        yield
        self._picture(reception, "found")
        for row, value in wanted.items():
            while reception.lobby.rows[reception.lobby.row] != row:
                yield from press("tab")
            if row.startswith(NAME):
                yield from type_name(str(value))
                yield
            else:
                yield from self._turn_to(reception, row, value)
        self._picture(reception, "set")
        yield from press("return")

    def _turn_to(self, reception: Reception, row: str, value: Value) -> Iterator[None]:
        """Change a row of the start screen by its arrows until it says `value`."""
        for _ in range(2000):
            now = reception.lobby.value(row)
            if now == value:
                return
            down = isinstance(now, int) and isinstance(value, int) and now > value
            yield from press("left" if down else "right")
        raise RuntimeError(f"{row} cannot be set to {value}")

    def each(self, loop: Loop) -> None:
        """Do the next step; to be called before every frame."""
        if self._script is None:
            self._script = self._play(loop)
        if next(self._script, self) is self:
            loop.running = False

    def _play(self, loop: Loop) -> Iterator[None]:
        while not loop.startup.playable:
            yield
        if self.looks:
            yield from self._tour(loop)
        while self.strokes < self.most:
            if loop.session.mode is Mode.OVER:
                self.games += 1
                if loop.session.match.situation.match_over or self.games >= self.most_games:
                    self.finished = True
                    break
                self._picture(loop, "game-over")
                yield from press("n")
            yield from self._one(loop)
        yield from settle()
        self._say("over: " + ", ".join(map(str, loop.session.match.situation.scores)))
        self._picture(loop, "end")
        yield from press("h")
        self._picture(loop, "end-why")
        yield from press("escape")
        yield from self._leave()

    def play_on(self, loop: Loop) -> Iterator[None]:
        """Yield for ever: game after game, with every key about a shot now and then."""
        while not loop.startup.playable:
            yield
        while True:
            if loop.session.mode is Mode.OVER:
                self.games += 1
                yield from press("n")
            if self.lot.random() < 0.05:
                yield from press(self.lot.choice("123c"))
            yield from self._one(loop)

    def _tour(self, loop: Loop) -> Iterator[None]:
        """Look at the table in every manner, and at the pages."""
        for camera in ("above", "orbit", "cue"):
            yield from settle()
            for key, name in (("1", "wireframe"), ("2", "painter"), ("3", "scanline")):
                yield from press(key)
                while name not in loop.startup.renderers:
                    yield
                yield
                self._picture(loop, f"{camera}-{name}")
            yield from press("c")
        yield from press("f4")
        self._picture(loop, "letters")
        yield from press("f4")
        for _ in range(4):
            yield from press("f3")
            self._picture(loop, "text-size")
        pages = {"f1": "keys", "escape": "menu", "f2": "rules", "f10": "cloth"}
        for key, name in pages.items():
            yield from press(key)
            self._picture(loop, name)
            yield from press("escape")

    def _one(self, loop: Loop) -> Iterator[None]:
        session = loop.session
        match session.mode:
            case Mode.CHOOSING:
                yield from self._choose(loop)
            case Mode.PLACING:
                yield from self._place(loop)
            case Mode.CALLING:
                yield from self._call(loop)
            case Mode.AIMING:
                yield from self._strike(loop)
            case Mode.STRIKING | Mode.ROLLING:
                yield from self._watch(loop)
            case Mode.VERDICT:
                yield from self._listen(loop)
            case Mode.OVER:
                yield

    def _choose(self, loop: Loop) -> Iterator[None]:
        options = loop.session.match.situation.options
        count = self.taken.get(options, 0)
        self.taken[options] = count + 1
        index = max(len(options) - 1 - count, 0)
        yield from self._wait("choose")
        self._picture(loop, "choose")
        self._say(f"  player {loop.session.shown.shooter} chooses {options[index]} of {options}")
        for _ in range((index - loop.session.picked) % len(options)):
            yield from press("down")
        yield from press("return")

    def _place(self, loop: Loop) -> Iterator[None]:
        yield from self._wait("place")
        self._picture(loop, "place")
        for key in ("left", "up"):
            yield from press(key, times=2)
        if not self.keyboard:
            yield from drag_ball(loop, self.lot)
        self._picture(loop, "placed")
        yield from press("return")

    def _call(self, loop: Loop) -> Iterator[None]:
        self.plan = self._think(loop)
        self._picture(loop, "call")
        yield from announce(loop, self.plan.call)
        yield from self._wait("called")
        self._picture(loop, "called")
        yield from press("return")
        yield from self._strike(loop)

    def _think(self, loop: Loop) -> Plan:
        foul = self.strokes + 1 in self.fouls_at
        return find_plan(loop.session, self.lot, self.tries, foul=foul)

    def _strike(self, loop: Loop) -> Iterator[None]:
        plan, self.plan = self.plan or self._think(loop), None
        yield from set_stroke(loop, plan.stroke)
        self.strokes += 1
        if self.strokes < 4 or self.strokes % 10 == 0:
            self._picture(loop, "aim")
        yield from press("space")
        if loop.session.mode in (Mode.AIMING, Mode.CALLING, Mode.PLACING):
            raise RuntimeError(f"the stroke was refused: {loop.session.note}")

    def _watch(self, loop: Loop) -> Iterator[None]:
        if self.strokes == 1 and self.looks:
            for number, key in enumerate("123", start=1):
                yield from pause(18)
                yield from press(key)
                self._picture(loop, f"rolling-{number}")
        if not self.looks:
            yield from pause(self.lot.choice((5, 30, 90)))
        yield from press("f")

    def _listen(self, loop: Loop) -> Iterator[None]:
        yield
        played = loop.session.last
        if played is None:
            raise AssertionError("a verdict is on a shot")
        verdict, strike = played.verdict, played.shot.strike
        said = ", ".join(foul.name for foul in verdict.fouls) or "legal"
        call = played.shot.call
        named = "safety" if call.safety else " ".join(x for x in (call.ball, call.pocket) if x)
        stroke = f"{strike.speed:.1f} m/s" if strike else "-"
        self._say(
            f"{len(loop.session.match.played):3} player {played.before.shooter} "
            f"{played.before.phase or '-':12} {named:18} {stroke:9} {said}; points "
            f"{verdict.points}, next player {verdict.after.shooter}"
        )
        if verdict.is_foul or self.strokes < 4 or verdict.after.offers or self.strokes % 10 == 0:
            self._picture(loop, "verdict")
        if self.strokes in self.tells:
            yield from self._tell(loop, self.tells[self.strokes])
        if self.strokes == 3 or (not self.looks and self.lot.random() < 0.1):
            yield from self._look_again(loop)
        if loop.session.mode is Mode.VERDICT:
            yield from press("return")

    def _tell(self, loop: Loop, fact: str) -> Iterator[None]:
        """Say that an eye saw it of the stroke played last."""
        names = [one.name for one in facts_of(loop.session)]
        yield from press("z")
        yield from press("down", times=names.index(fact))
        yield from press("right")
        self._picture(loop, "seen")
        yield from press("return")
        self._say(f"  {fact}: {loop.session.note}")
        self._picture(loop, "judged-again")

    def _look_again(self, loop: Loop) -> Iterator[None]:
        """Use the keys around a shot once: why, save, replay, undo and redo."""
        yield from press("h")
        self._picture(loop, "why")
        yield from press("escape")
        yield from press("f5")
        self._picture(loop, "saved")
        self._say(f"  {loop.session.note}")
        yield from press("r")
        yield from pause(20)
        self._picture(loop, "replay")
        yield from press("f")
        count = len(loop.session.match.played)
        yield from press("u")
        yield from press("y")
        if len(loop.session.match.played) != count:
            raise RuntimeError("undo and redo do not lead back")

    def _leave(self) -> Iterator[None]:
        yield from press("escape")
        yield from press("down", times=[name for name, _ in MENU].index("quit"))
        yield from press("return")
        yield from pause(5)

    def _wait(self, name: str) -> Iterator[None]:
        """Let the camera come to rest, where the first pictures of a screen are made."""
        if self.looks and self.saved[name] < OF_A_KIND // 3:
            yield from settle()

    def _say(self, text: str) -> None:
        self.log.append(text)
        if self.looks:
            print(text, flush=True)

    def _picture(self, shown: Loop | Reception, name: str) -> None:
        import pygame  # noqa: PLC0415  only in the window's process

        self.saved[name] += 1
        if not self.looks or self.saved[name] > OF_A_KIND:
            return
        path = self.out / f"{len(self.pictures):03}-{name}.png"
        pygame.image.save(shown.window.surface, path)
        self.pictures.append(path)
