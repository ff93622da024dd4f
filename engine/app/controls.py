"""From hands to commands: what held keys, presses, drags and clicks mean at this moment.

One idea: given the input, the session and where things are on the screen, this answers a list
of values; it changes nothing itself. Invariant: a key that is held repeats by the clock, so the
frame rate does not change how fast the aim turns.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app import commands
from engine.app.inputs import LEFT, MIDDLE, RIGHT, ButtonPressed, ButtonReleased
from engine.app.keys import binding
from engine.app.session import BEFORE_STROKE, Mode
from engine.app.stroke import FASTEST
from engine.app.view import ball_under, cloth_point, pocket_under

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from engine.app.inputs import Input, InputEvent, Place
    from engine.app.session import Session
    from engine.scene.camera import Camera
    from engine.table.furniture import Point

DELAY = 0.28
"""Seconds that a key is held before it repeats."""
REPEATS = 45.0
"""Steps a second while it repeats."""
FULL_PULL = 260.0
"""Pixels that the mouse is drawn back for the hardest stroke."""
STILL = 4
"""Pixels within which a press and a release are a click."""

Box = tuple[int, int, int, int]
"""Left, top, width, height in pixels."""


@dataclass(frozen=True, slots=True)
class Ask:
    """What is asked of the window rather than of the game, by an action's name."""

    action: str
    amount: float = 1.0


@dataclass(frozen=True, slots=True)
class Screen:
    """Where things are: the picture's box, the camera in it, and what can be clicked."""

    picture: Box
    camera: Camera
    camera_name: str
    hot: Mapping[str, Box]

    def size(self) -> tuple[int, int]:
        """Return the picture's width and height."""
        return self.picture[2], self.picture[3]

    def inside(self, place: Place) -> bool:
        """Whether a place of the window is in the picture."""
        return _within(self.picture, place)

    def pixel(self, place: Place) -> tuple[float, float]:
        """Return a place of the window as a pixel of the picture."""
        return place[0] - self.picture[0] + 0.5, place[1] - self.picture[1] + 0.5

    def under(self, place: Place) -> str:
        """Return the name of what can be clicked there; empty for nothing."""
        return next((name for name, box in self.hot.items() if _within(box, place)), "")


def _within(box: Box, place: Place) -> bool:
    return box[0] <= place[0] < box[0] + box[2] and box[1] <= place[1] < box[1] + box[3]


Wish = commands.Command | Ask
PLAIN = (
    ("confirm", commands.Confirm()),
    ("back", commands.Back()),
    ("safety", commands.CallSafety()),
    ("group", commands.CallNextGroup()),
    ("undo", commands.Undo()),
    ("redo", commands.Redo()),
    ("fast", commands.Skip()),
    ("next", commands.NextGame()),
    ("aid", commands.ChangeAid()),
)
WINDOW = ("wireframe", "painter", "scanline", "camera", "text", "help", "save", "why", "menu")


@dataclass(slots=True)
class Controls:
    """The player's hands over time: how long keys are held, what is being dragged."""

    _held: dict[str, float] = field(default_factory=dict)
    _owed: dict[str, float] = field(default_factory=dict)
    _pressed_at: Place = (0, 0)
    _grip: str = ""
    _pulled_from: float = 0.0

    def read(
        self,
        hands: Input,
        events: Iterable[InputEvent],
        session: Session,
        screen: Screen,
        seconds: float,
    ) -> list[Wish]:
        """Return what is asked for in this frame."""
        wishes: list[Wish] = []
        for key in hands.pressed:
            wishes += self._press(key, hands, session)
        for key, count in self._steps(hands, seconds).items():
            wishes += _step(key, count, hands, session, screen)
        wishes += self._mouse(hands, events, session, screen)
        if hands.wheel:
            wishes.append(Ask("zoom", float(hands.wheel)))
        return wishes

    def _press(self, key: str, hands: Input, session: Session) -> list[Wish]:
        sign = -1 if hands.shift else 1
        if key.isdigit() and hands.shift and session.mode is Mode.CHOOSING:
            return [commands.Choose(int(key) - 1)]
        for action in WINDOW:
            if key in binding(action).keys:
                return [Ask(action)]
        for action, command in PLAIN:
            if key in binding(action).keys:
                return [command]
        if key in binding("ball").keys:
            return [commands.CallNextBall(sign)]
        if key in binding("pocket").keys:
            return [commands.CallNextPocket(sign)]
        if key in binding("replay").keys:
            return [commands.Replay(0.25 if hands.shift else 1.0)]
        if key in binding("centre").keys:
            return [commands.SetTip(0.0, 0.0), commands.SetElevation(0.0)]
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

    def _mouse(
        self, hands: Input, events: Iterable[InputEvent], session: Session, screen: Screen
    ) -> list[Wish]:
        wishes: list[Wish] = []
        for event in events:
            match event:
                case ButtonPressed(button, place):
                    self._pressed_at = place
                    wishes += self._grab(button, place, session, screen)
                case ButtonReleased(button, place):
                    wishes += self._let_go(button, place, session, screen)
        if hands.moved != (0, 0) and self._grip:
            wishes += self._drag(hands, session, screen)
        return wishes

    def _grab(self, button: int, place: Place, session: Session, screen: Screen) -> list[Wish]:
        name = screen.under(place)
        if button == LEFT and name:
            self._grip = name
            return _click(name, place, screen)
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
            return _call_there(place, session, screen) if session.mode is Mode.CALLING else []
        return []

    def _let_go(self, _button: int, place: Place, session: Session, screen: Screen) -> list[Wish]:
        grip, self._grip = self._grip, ""
        gone = max(abs(place[0] - self._pressed_at[0]), abs(place[1] - self._pressed_at[1]))
        if grip == "pull":
            if place[1] - self._pressed_at[1] > 2 * STILL:
                return [commands.Confirm()]
            return [commands.SetSpeed(self._pulled_from)]
        if grip == "cloth" and gone <= STILL and session.mode is Mode.AIMING:
            point = _cloth(place, screen, session)
            return [commands.AimAt(point)] if point else []
        if grip == "cloth" and gone <= STILL and session.mode is Mode.VERDICT:
            return [commands.Confirm()]
        return []

    def _drag(self, hands: Input, session: Session, screen: Screen) -> list[Wish]:
        dx, dy = hands.moved
        match self._grip:
            case "view":
                return [Ask("orbit", -0.006 * dx), Ask("tilt", 0.006 * dy)]
            case "pull":
                pull = (hands.mouse[1] - self._pressed_at[1]) / FULL_PULL
                return [commands.SetSpeed(max(pull, 0.0) * FASTEST)] if pull > 0.0 else []
            case "cloth" if session.mode is Mode.PLACING:
                return _put(hands.mouse, screen, session)
            case "cloth" if session.mode is Mode.AIMING and screen.camera_name == "cue":
                return [commands.Turn(-dx * (0.004 if hands.shift else 0.06))]
            case "cloth" if session.mode is Mode.AIMING and screen.inside(hands.mouse):
                if hands.shift:
                    return [commands.Turn(-dx * 0.004)]
                point = _cloth(hands.mouse, screen, session)
                return [commands.AimAt(point)] if point else []
            case "cloth":
                return [Ask("orbit", -0.006 * dx), Ask("tilt", 0.006 * dy)]
            case name if name in ("tip", "power", "elevation"):
                return _click(name, hands.mouse, screen)
        return []


def _step(key: str, count: int, hands: Input, session: Session, screen: Screen) -> list[Wish]:
    """Return what `count` steps of a key that may be held ask for."""
    if key in binding("orbit").keys:
        return [Ask("orbit", 0.03 * count * (1 if key == "." else -1))]
    if key in binding("tilt").keys:
        return [Ask("tilt", 0.02 * count * (1 if key == "page up" else -1))]
    if key in binding("zoom").keys:
        return [Ask("zoom", 0.5 * count * (1 if key == "=" else -1))]
    arrows = ("left", "right", "up", "down")
    if session.mode is Mode.CHOOSING and key in binding("pick").keys:
        return [commands.Pick(count if key == "down" else -count)]
    if session.mode is Mode.PLACING and key in arrows:
        return [_moved(key, count * (0.001 if hands.shift else 0.01), screen)]
    if session.mode not in BEFORE_STROKE:
        return []
    return _stroke_step(key, count, session, fine=hands.shift)


def _stroke_step(key: str, count: int, session: Session, *, fine: bool) -> list[Wish]:
    stroke = session.stroke
    tip = count * (0.005 if fine else 0.025)
    lift = count * (0.2 if fine else 1.0)
    speed = count * (0.01 if fine else 0.1)
    turn = count * (0.01 if fine else 1.0)
    match key:
        case "left":
            return [commands.Turn(turn)]
        case "right":
            return [commands.Turn(-turn)]
        case "up":
            return [commands.SetSpeed(stroke.speed + speed)]
        case "down":
            return [commands.SetSpeed(stroke.speed - speed)]
        case "a":
            return [commands.MoveTip(-tip, 0.0)]
        case "d":
            return [commands.MoveTip(tip, 0.0)]
        case "w":
            return [commands.MoveTip(0.0, tip)]
        case "s":
            return [commands.MoveTip(0.0, -tip)]
        case "e":
            return [commands.SetElevation(stroke.elevation + lift)]
        case "q":
            return [commands.SetElevation(stroke.elevation - lift)]
    return []


def _moved(key: str, by: float, screen: Screen) -> commands.MoveBall:
    """Return a move of the ball in hand along the screen's own right or up."""
    right = screen.camera.basis()[0]
    x, y = float(right[0]), float(right[1])
    if key in ("up", "down"):
        x, y = -y, x
    sign = by if key in ("right", "up") else -by
    return commands.MoveBall(x * sign, y * sign)


def _cloth(place: Place, screen: Screen, session: Session) -> Point | None:
    radius = session.variant.world.balls[0].radius
    return cloth_point(screen.camera, screen.size(), screen.pixel(place), radius)


def _put(place: Place, screen: Screen, session: Session) -> list[Wish]:
    point = _cloth(place, screen, session)
    return [commands.PutBall(point)] if point else []


def _call_there(place: Place, session: Session, screen: Screen) -> list[Wish]:
    pixel, size = screen.pixel(place), screen.size()
    ball = ball_under(screen.camera, size, pixel, session.layout, session.variant)
    if ball is not None and ball != session.cue_ball:
        return [commands.CallBall(ball)]
    pocket = pocket_under(screen.camera, size, pixel, session.variant)
    return [commands.CallPocket(pocket)] if pocket else []


def _click(name: str, place: Place, screen: Screen) -> list[Wish]:
    """Return what a click, or a drag, on a thing of the display asks for."""
    kind, _, rest = name.partition(":")
    left, top, width, height = screen.hot.get(name, (0, 0, 1, 1))
    right = (place[0] - left) / width
    up = 1.0 - (place[1] - top) / height
    match kind:
        case "option":
            return [commands.Choose(int(rest))]
        case "confirm":
            return [commands.Confirm()]
        case "tip":
            return [commands.SetTip(2.0 * right - 1.0, 2.0 * up - 1.0)]
        case "power":
            return [commands.SetSpeed(min(max(right, 0.0), 1.0) * FASTEST)]
        case "elevation":
            return [commands.SetElevation(min(max(right, 0.0), 1.0) * 80.0)]
        case "ask":
            return [Ask(rest)]
    return []
