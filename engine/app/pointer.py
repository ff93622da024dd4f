"""From the mouse to wishes: what a click, a drag and the wheel mean at this moment.

One idea: a press takes hold of something, and until it is let go every move is about that.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.app import commands
from engine.app.inputs import LEFT, MIDDLE, RIGHT, ButtonPressed, ButtonReleased
from engine.app.session import Mode
from engine.app.stroke import FASTEST, STEEPEST
from engine.app.wishes import Ask, wishes_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from engine.app.inputs import Input, InputEvent, Place
    from engine.app.screen import Screen
    from engine.app.session import Session
    from engine.app.wishes import Wish

FULL_PULL = 260.0
"""Pixels that the mouse is drawn back for the hardest stroke."""
STILL = 4
"""Pixels within which a press and a release are a click."""
GAUGES = ("tip", "power", "elevation")


@dataclass(slots=True)
class Pointer:
    """The mouse over time: what it has taken hold of, and where."""

    _pressed_at: Place = (0, 0)
    _grip: str = ""
    _pulled_from: float = 0.0

    def read(
        self, hands: Input, events: Iterable[InputEvent], session: Session, screen: Screen
    ) -> list[Wish]:
        """Return what the mouse asks for in this frame."""
        wishes: list[Wish] = []
        for event in events:
            match event:
                case ButtonPressed(button, place):
                    self._pressed_at = place
                    wishes += self._grab(button, place, session, screen)
                case ButtonReleased(_, place):
                    wishes += self._let_go(place, session, screen)
        if hands.moved != (0, 0) and self._grip:
            wishes += self._drag(hands, session, screen)
        if hands.wheel:
            wishes.append(Ask("zoom", float(hands.wheel)))
        return wishes

    def _grab(self, button: int, place: Place, session: Session, screen: Screen) -> list[Wish]:
        name = screen.under(place)
        if button == LEFT and name:
            self._grip = name
            return clicked(name, place, screen)
        if not screen.inside(place):
            return []
        if button == MIDDLE:
            self._grip = "view"
        elif button == RIGHT and session.mode is Mode.AIMING:
            self._grip, self._pulled_from = "pull", session.stroke.speed
        elif button == LEFT:
            self._grip = "cloth"
            if session.mode is Mode.PLACING:
                return _put(place, screen, session)
            if session.mode is Mode.ARRANGING:
                ball = screen.ball(place, session)
                return [commands.CallBall(ball)] if ball else []
            saying = session.mode in (Mode.CALLING, Mode.CHOOSING)
            return _call_there(place, session, screen) if saying else []
        return []

    def _let_go(self, place: Place, session: Session, screen: Screen) -> list[Wish]:
        grip, self._grip = self._grip, ""
        gone = max(abs(place[0] - self._pressed_at[0]), abs(place[1] - self._pressed_at[1]))
        if grip == "pull":
            if place[1] - self._pressed_at[1] > 2 * STILL:
                return [commands.Confirm()]
            return [commands.SetSpeed(self._pulled_from)]
        if grip == "cloth" and gone <= STILL and session.mode is Mode.AIMING:
            point = screen.cloth(place, session)
            return [commands.AimAt(point)] if point else []
        if grip == "cloth" and gone <= STILL and session.mode is Mode.VERDICT:
            return [commands.Confirm()]
        return []

    def _drag(self, hands: Input, session: Session, screen: Screen) -> list[Wish]:
        dx, dy = hands.moved
        match self._grip:
            case "pull":
                pull = (hands.mouse[1] - self._pressed_at[1]) / FULL_PULL
                return [commands.SetSpeed(max(pull, 0.0) * FASTEST)] if pull > 0.0 else []
            case "cloth" if session.mode in (Mode.PLACING, Mode.ARRANGING):
                return _put(hands.mouse, screen, session)
            case "cloth" if session.mode is Mode.AIMING:
                return _aim(hands, session, screen)
            case "view" | "cloth":
                return [Ask("orbit", -0.006 * dx), Ask("tilt", 0.006 * dy)]
            case name if name in GAUGES:
                return clicked(name, hands.mouse, screen)
        return []


def _aim(hands: Input, session: Session, screen: Screen) -> list[Wish]:
    dx = hands.moved[0]
    if hands.shift or screen.camera_name == "cue":
        return [commands.Turn(-dx * (0.01 if hands.shift else 0.06))]
    point = screen.cloth(hands.mouse, session) if screen.inside(hands.mouse) else None
    return [commands.AimAt(point)] if point else []


def _put(place: Place, screen: Screen, session: Session) -> list[Wish]:
    point = screen.cloth(place, session)
    return [commands.PutBall(point)] if point else []


def _call_there(place: Place, session: Session, screen: Screen) -> list[Wish]:
    ball = screen.ball(place, session)
    if ball is not None and ball != session.cue_ball:
        return [commands.CallBall(ball)]
    pocket = screen.pocket(place, session)
    return [commands.CallPocket(pocket)] if pocket else []


def clicked(name: str, place: Place, screen: Screen) -> list[Wish]:
    """Return what a click, or a drag, on a thing of the display asks for."""
    kind, _, rest = name.partition(":")
    left, top, width, height = screen.hot.get(name, (0, 0, 1, 1))
    right = (place[0] - left) / width
    up = 1.0 - (place[1] - top) / height
    match kind:
        case "option":
            return [commands.Choose(int(rest))]
        case "do":
            return wishes_of(rest)
        case "tip":
            return [commands.SetTip(2.0 * right - 1.0, 2.0 * up - 1.0)]
        case "power":
            return [commands.SetSpeed(min(max(right, 0.0), 1.0) * FASTEST)]
        case "elevation":
            return [commands.SetElevation(min(max(right, 0.0), 1.0) * STEEPEST)]
        case "ask":
            return [Ask(rest)]
    return []
