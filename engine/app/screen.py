"""Where things are on the screen, and what lies under the pointer.

One idea: the screen is a value, so that hands can be read without a window.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.app.view import ball_under, cloth_point, pocket_under

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.app.inputs import Place
    from engine.app.session import Session
    from engine.scene.camera import Camera
    from engine.table.furniture import BallId, PocketId, Point

Box = tuple[int, int, int, int]
"""Left, top, width, height in pixels."""


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
        return within(self.picture, place)

    def pixel(self, place: Place) -> tuple[float, float]:
        """Return a place of the window as a pixel of the picture."""
        return place[0] - self.picture[0] + 0.5, place[1] - self.picture[1] + 0.5

    def under(self, place: Place) -> str:
        """Return the name of what can be clicked there; empty for nothing."""
        return next((name for name, box in self.hot.items() if within(box, place)), "")

    def cloth(self, place: Place, session: Session) -> Point | None:
        """Return where a ball's centre would lie (m) under a place of the window."""
        radius = session.variant.world.balls[0].radius
        return cloth_point(self.camera, self.size(), self.pixel(place), radius)

    def ball(self, place: Place, session: Session) -> BallId | None:
        """Return the ball under a place of the window."""
        pixel = self.pixel(place)
        return ball_under(self.camera, self.size(), pixel, session.layout, session.variant)

    def pocket(self, place: Place, session: Session) -> PocketId | None:
        """Return the pocket under a place of the window."""
        return pocket_under(self.camera, self.size(), self.pixel(place), session.variant)


def within(box: Box, place: Place) -> bool:
    """Whether a place lies in a box."""
    return box[0] <= place[0] < box[0] + box[2] and box[1] <= place[1] < box[1] + box[3]
