"""A scripted player at the real window: keys and clicks into its queue, pictures and a log out.

One idea: the script sees what a player sees, looks for a stroke with the physics, and then sets
it key by key, so that a whole game proves the window, the controls and the rules together.

    python -m tools.play_script VARIANT --out DIR [--set NAME=VALUE] [--seed N] [--headless]
"""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING

from engine.app.pages import MENU
from engine.app.session import Mode
from tools.aimer import FINE, Plan, find_plan

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from engine.app.loop import Loop
    from engine.app.stroke import Stroke
    from rulelang.facts import Call

FOULS_AT = (1, 5, 12)
"""Strokes that are meant to go wrong."""


@dataclass(slots=True)
class Player:
    """One scripted game; `log` has a line for each shot, `pictures` what was saved."""

    out: Path
    lot: Random
    most: int = 400
    tries: int = 140
    fouls_at: tuple[int, ...] = FOULS_AT
    log: list[str] = field(default_factory=list)
    pictures: list[Path] = field(default_factory=list)
    taken: dict[tuple[str, ...], int] = field(default_factory=dict)
    finished: bool = False
    strokes: int = 0
    plan: Plan | None = None
    _script: Iterator[None] | None = None

    def each(self, loop: Loop) -> None:
        """Do the next step; to be called before every frame."""
        if self._script is None:
            self._script = self._play(loop)
        if next(self._script, self) is self:
            loop.running = False

    def _play(self, loop: Loop) -> Iterator[None]:
        while not loop.startup.playable:
            yield
        yield from self._tour(loop)
        while self.strokes < self.most:
            if loop.session.mode is Mode.OVER:
                self.finished = True
                break
            yield from self._one(loop)
        yield from pause(2)
        self._say("over: " + ", ".join(map(str, loop.session.match.situation.scores)))
        self._picture(loop, "end")
        yield from press("h")
        self._picture(loop, "end-why")
        yield from press("escape")
        yield from self._leave()

    def _tour(self, loop: Loop) -> Iterator[None]:
        """Look at the table in every manner, and at the pages."""
        for camera in ("above", "orbit", "cue"):
            for key, name in (("1", "wireframe"), ("2", "painter"), ("3", "scanline")):
                yield from press(key)
                while name not in loop.startup.renderers:
                    yield
                yield
                self._picture(loop, f"{camera}-{name}")
            yield from press("c")
        for key, name in (("f1", "keys"), ("escape", "menu")):
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
        self._picture(loop, "choose")
        self._say(f"  player {loop.session.shown.shooter} chooses {options[index]} of {options}")
        for _ in range((index - loop.session.picked) % len(options)):
            yield from press("down")
        yield from press("return")

    def _place(self, loop: Loop) -> Iterator[None]:
        self._picture(loop, "place")
        for key in ("left", "up"):
            yield from press(key, times=2)
        yield from drag_ball(loop, self.lot)
        self._picture(loop, "placed")
        yield from press("return")

    def _call(self, loop: Loop) -> Iterator[None]:
        self.plan = self._think(loop)
        self._picture(loop, "call")
        yield from announce(loop, self.plan.call)
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
        if self.strokes == 1:
            for number, key in enumerate("123", start=1):
                yield from pause(18)
                yield from press(key)
                self._picture(loop, f"rolling-{number}")
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
        if self.strokes == 3:
            yield from self._look_again(loop)
        if loop.session.mode is Mode.VERDICT:
            yield from press("return")

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

    def _say(self, text: str) -> None:
        self.log.append(text)
        print(text, flush=True)

    def _picture(self, loop: Loop, name: str) -> None:
        import pygame  # noqa: PLC0415  only in the window's process

        path = self.out / f"{len(self.pictures):03}-{name}.png"
        pygame.image.save(loop.window.surface, path)
        self.pictures.append(path)


def pause(frames: int) -> Iterator[None]:
    """Let frames pass."""
    for _ in range(frames):
        yield


def press(key: str, *, times: int = 1, shift: bool = False) -> Iterator[None]:
    """Press a key so many times within a frame; ends two frames later."""
    import pygame  # noqa: PLC0415

    code = pygame.key.key_code(key)
    if shift:
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_LSHIFT))
    for _ in range(times):
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=code))
        pygame.event.post(pygame.event.Event(pygame.KEYUP, key=code))
    yield
    if shift:
        pygame.event.post(pygame.event.Event(pygame.KEYUP, key=pygame.K_LSHIFT))
    yield


def drag_ball(loop: Loop, lot: Random) -> Iterator[None]:
    """Drag the ball in hand with the mouse to some place of its zone."""
    import pygame  # noqa: PLC0415

    from engine.scene.camera import project  # noqa: PLC0415

    session, screen = loop.session, loop.screen()
    if session.placing is None or not len(session.placing.free):
        return
    x, y = lot.choice(session.placing.free.tolist())
    seen = project(screen.camera, screen.size(), (x, y, session.placing.radius))
    if seen is None:
        return
    place = int(seen[0] + screen.picture[0]), int(seen[1] + screen.picture[1])
    if not screen.inside(place):
        return
    for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION, pygame.MOUSEBUTTONUP):
        about = {"pos": place, "button": 1} if kind != pygame.MOUSEMOTION else {"pos": place}
        pygame.event.post(pygame.event.Event(kind, about))
        yield
    yield


def announce(loop: Loop, call: Call) -> Iterator[None]:
    """Make a call key by key."""
    if call.safety:
        if not loop.session.call.safety:
            yield from press("o")
        return
    for _ in range(40):
        if loop.session.call.ball == call.ball or call.ball is None:
            break
        yield from press("tab")
    for _ in range(12):
        if loop.session.call.pocket == call.pocket or call.pocket is None:
            break
        yield from press("p")


def set_stroke(loop: Loop, stroke: Stroke) -> Iterator[None]:
    """Set aim, power and tip with the keys."""
    now = loop.session.stroke
    steps = round(((stroke.heading - now.heading + 180.0) % 360.0 - 180.0) / FINE)
    whole, fine = divmod(abs(steps), round(1.0 / FINE))
    side = "left" if steps > 0 else "right"
    yield from taps(side, whole, fine)
    steps = round((stroke.speed - now.speed) * 100.0)
    yield from taps("up" if steps > 0 else "down", *divmod(abs(steps), 10))
    for keys, tenths in (("da", stroke.side - now.side), ("ws", stroke.follow - now.follow)):
        count = round(abs(tenths) * 1000.0)
        yield from taps(keys[tenths < 0.0], count // 25, count % 25 // 5)
    yield
    set_ = loop.session.stroke
    if abs(set_.heading - stroke.heading) > 1e-6 or abs(set_.speed - stroke.speed) > 1e-6:
        raise RuntimeError(f"the keys set {set_} instead of {stroke}")


def taps(key: str, coarse: int, fine: int) -> Iterator[None]:
    """Press a key in coarse steps, then in fine ones."""
    for count, shift in ((coarse, False), (fine, True)):
        left = count
        while left > 0:
            yield from press(key, times=min(left, 30), shift=shift)
            left -= 30


def main(arguments: Sequence[str] | None = None) -> int:
    """Play one game; return 0 where it came to its end."""
    parser = argparse.ArgumentParser(description="Play a whole game through the real window.")
    parser.add_argument("variant")
    parser.add_argument("--out", type=Path, required=True, help="folder for pictures and log")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--players", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--rate", type=int, default=200)
    parser.add_argument("--most", type=int, default=400, help="give up after so many strokes")
    parser.add_argument("--headless", action="store_true", help="no display is needed")
    asked = parser.parse_args(arguments)
    if asked.headless:
        os.environ["SDL_VIDEODRIVER"] = "dummy"
    asked.out.mkdir(parents=True, exist_ok=True)
    player = Player(asked.out, Random(asked.seed), asked.most)
    status = _run(asked, player)
    (asked.out / "log.txt").write_text("\n".join(player.log) + "\n", encoding="utf-8")
    return status or (0 if player.finished else 1)


def _run(asked: argparse.Namespace, player: Player) -> int:
    from engine.app.play import play  # noqa: PLC0415

    width, _, height = asked.size.partition("x")
    return play(
        asked.variant,
        players=asked.players,
        settings=dict(one.split("=", 1) for one in asked.set),
        size=(int(width), int(height)),
        rate=asked.rate,
        seed=asked.seed,
        journal=asked.out / "journal.toml",
        each=player.each,
    )


if __name__ == "__main__":
    sys.exit(main())
