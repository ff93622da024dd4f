"""From held and pressed keys to wishes.

One idea: a key is asked what it does by the keymap; how often it steps is told by the clock, so
the frame rate does not change how fast the aim turns.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app import commands
from engine.app.keymap import Keymap
from engine.app.session import BEFORE_STROKE, Mode
from engine.app.wishes import Ask, wishes_of

if TYPE_CHECKING:
    from engine.app.inputs import Input
    from engine.app.screen import Screen
    from engine.app.session import Session
    from engine.app.wishes import Wish

DELAY = 0.28
"""Seconds that a key is held before it repeats."""
REPEATS = 45.0
"""Steps a second while it repeats."""


@dataclass(slots=True)
class Keyboard:
    """The keys over time: how long each is held, and the steps it owes."""

    keymap: Keymap = field(default_factory=Keymap)
    _held: dict[str, float] = field(default_factory=dict)
    _owed: dict[str, float] = field(default_factory=dict)

    def read(self, hands: Input, session: Session, screen: Screen, seconds: float) -> list[Wish]:
        """Return what the keys ask for in this frame."""
        wishes: list[Wish] = []
        for key in hands.pressed:
            wishes += self._press(key, session, shift=hands.shift)
        for key, count in self._steps(hands, seconds).items():
            wishes += self._step(key, count, session, screen, fine=hands.shift)
        return wishes

    def _press(self, key: str, session: Session, *, shift: bool) -> list[Wish]:
        choice = self.keymap.place("choose", key)
        if shift and choice is not None and session.mode is Mode.CHOOSING:
            return [commands.Choose(choice)]
        for action in self.keymap.actions(key):
            wishes = wishes_of(action, shift=shift)
            if wishes:
                return wishes
        return []

    def _steps(self, hands: Input, seconds: float) -> dict[str, int]:
        """Return how many steps each key asks for: one at its press, more while it is held."""
        steps: dict[str, int] = {}
        for key in hands.pressed:
            steps[key] = steps.get(key, 0) + 1
            self._held[key], self._owed[key] = 0.0, 0.0
        for key in list(self._held):
            if key not in hands.held:
                del self._held[key]
                continue
            before = self._held[key]
            self._held[key] = before + (0.0 if key in hands.pressed else seconds)
            more = max(0.0, self._held[key] - DELAY) - max(0.0, before - DELAY)
            self._owed[key] = self._owed.get(key, 0.0) + more * REPEATS
            whole = int(self._owed[key])
            if whole:
                self._owed[key] -= whole
                steps[key] = steps.get(key, 0) + whole
        return steps

    def _step(
        self, key: str, count: int, session: Session, screen: Screen, *, fine: bool
    ) -> list[Wish]:
        """Return what `count` steps of a key ask for."""
        for action, size in (("orbit", 0.03), ("tilt", 0.02), ("zoom", 0.5)):
            place = self.keymap.place(action, key)
            if place is not None:
                forward = place == (1 if action == "orbit" else 0)
                return [Ask(action, size * count * (1 if forward else -1))]
        if session.mode is Mode.CHOOSING:
            picked = self.keymap.place("pick", key)
            return [] if picked is None else [commands.Pick(count if picked else -count)]
        if session.mode in (Mode.PLACING, Mode.ARRANGING):
            way = self.keymap.place("move", key)
            if way is not None:
                return [_moved(way, count * (0.001 if fine else 0.01), screen)]
        return self._stroke_step(key, count, session, fine=fine)

    def _stroke_step(self, key: str, count: int, session: Session, *, fine: bool) -> list[Wish]:
        if session.mode not in BEFORE_STROKE:
            return []
        stroke = session.stroke
        for action in ("turn", "power", "spin", "elevate"):
            place = self.keymap.place(action, key)
            if place is None:
                continue
            sign = count if place == 0 else -count
            match action:
                case "turn":
                    return [commands.Turn(sign * (0.01 if fine else 1.0))]
                case "power":
                    return [commands.SetSpeed(stroke.speed + sign * (0.01 if fine else 0.1))]
                case "elevate":
                    raised = stroke.elevation + sign * (0.2 if fine else 1.0)
                    return [commands.SetElevation(raised)]
                case _:
                    return [_tip_moved(place, count * (0.005 if fine else 0.025))]
        return []


def _tip_moved(way: int, by: float) -> commands.MoveTip:
    """Return a move of the tip up, left, down or right."""
    side, follow = ((0.0, by), (-by, 0.0), (0.0, -by), (by, 0.0))[way]
    return commands.MoveTip(side, follow)


def _moved(way: int, by: float, screen: Screen) -> commands.MoveBall:
    """Return a move of the ball in hand left, right, up or down as the screen lies."""
    right = screen.camera.basis()[0]
    x, y = float(right[0]), float(right[1])
    if way > 1:
        x, y = -y, x
    sign = by if way in (1, 2) else -by
    return commands.MoveBall(x * sign, y * sign)
