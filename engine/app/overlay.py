"""What is drawn over the picture itself: the pocket that was called."""

from __future__ import annotations

from math import cos, pi, sin
from typing import TYPE_CHECKING

import pygame

from engine.app.session import BEFORE_STROKE
from engine.scene.camera import project

if TYPE_CHECKING:
    from engine.app.pen import Pen
    from engine.app.screen import Screen
    from engine.app.session import Session

BLUE = (110, 170, 255)


def draw_called(pen: Pen, session: Session, screen: Screen) -> None:
    """Draw a ring round the pocket that is called."""
    if session.mode not in BEFORE_STROKE or session.call.pocket is None:
        return
    left, top, width, height = screen.picture
    for pocket in session.variant.world.table.pockets:
        if pocket.id != session.call.pocket:
            continue
        ring = []
        for k in range(36):
            turn = 2.0 * pi * k / 36
            x = pocket.centre[0] + 1.15 * pocket.radius * cos(turn)
            y = pocket.centre[1] + 1.15 * pocket.radius * sin(turn)
            spot = project(screen.camera, (width, height), (x, y, 0.04))
            if spot is None:
                return
            ring.append((left + spot[0], top + spot[1]))
        pen.surface.set_clip(pygame.Rect(screen.picture))
        pygame.draw.lines(pen.surface, BLUE, True, ring, pen.px(3))  # noqa: FBT003
        pen.surface.set_clip(None)
