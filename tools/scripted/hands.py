"""Hands at the real window: keys and clicks put into its queue, as a player's would come.

One idea: what takes several frames is a generator that yields once a frame.
"""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from tools.aimer import FINE

if TYPE_CHECKING:
    from collections.abc import Iterator
    from random import Random

    from engine.app.loop import Loop
    from engine.app.stroke import Stroke
    from rulelang.facts import Call


def pause(frames: int) -> Iterator[None]:
    """Let frames pass."""
    for _ in range(frames):
        yield


def settle() -> Iterator[None]:
    """Wait until the camera has come to rest."""
    until = monotonic() + 0.7
    while monotonic() < until:
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


def type_text(text: str) -> Iterator[None]:
    """Type letters one by one."""
    for letter in text:
        yield from press("space" if letter == " " else letter)


def type_name(name: str) -> Iterator[None]:
    """Type a name, capitals and all, as the keyboard's layout has it."""
    import pygame  # noqa: PLC0415

    for letter in name:
        pygame.event.post(pygame.event.Event(pygame.TEXTINPUT, text=letter))
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
