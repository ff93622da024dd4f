"""Where the player looks from, and what the pointer points at.

One idea: the view is a value; a camera is made from it for each frame.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import hypot, pi, radians
from typing import TYPE_CHECKING

from engine.game.situation import cue_ball_of
from engine.scene.camera import ground_point, orbit, ray
from engine.stage.cameras import above_camera, cue_camera, orbit_camera, orbit_distance

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from engine.app.session import Session
    from engine.scene.camera import Camera, Pixel, Size, Vector
    from engine.table.furniture import BallId, PocketId, Point, Table
    from engine.variant.variant import Variant

CAMERAS = ("cue", "above", "orbit", "follow")


@dataclass(frozen=True, slots=True)
class View:
    """The camera in use, angles of the free one in rad, how near each is, the ball followed.

    Without a ball of his own choice the player follows the one that is struck.
    """

    camera: str = "above"
    azimuth: float = pi * 1.1
    elevation: float = radians(38.0)
    zoom: float = 1.0
    followed: BallId | None = None

    def next_camera(self) -> View:
        """Return the view from the next camera."""
        later = CAMERAS[(CAMERAS.index(self.camera) + 1) % len(CAMERAS)]
        return replace(self, camera=later, zoom=1.0)

    def following(self, balls: Sequence[BallId]) -> View:
        """Return the view that follows the next of `balls`, the one struck after the last."""
        if self.camera != "follow" or not balls:
            return replace(self, camera="follow", zoom=1.0)
        place = balls.index(self.followed) + 1 if self.followed in balls else 0
        return replace(self, followed=balls[place] if place < len(balls) else None)

    def zoomed(self, notches: float) -> View:
        """Return the view nearer by notches of the wheel, or farther."""
        return replace(self, zoom=min(max(self.zoom * 1.1**notches, 0.5), 6.0))

    def orbited(self, azimuth: float, elevation: float) -> View:
        """Return the view turned about the table by rad."""
        steep = min(max(self.elevation + elevation, 0.08), 1.5)
        return replace(self, azimuth=self.azimuth + azimuth, elevation=steep)


def camera_of(
    view: View,
    table: Table,
    size: Size,
    ball: Point | None,
    heading: float,
    followed: Point | None = None,
) -> Camera:
    """Return the camera for a window of `size`; `ball` and `heading` (rad) are the stroke's.

    `followed` is where the ball is (m) that the camera follows.
    """
    if view.camera == "cue" and ball is not None:
        near = 1.0 / view.zoom
        return cue_camera(table, ball, heading, back=0.85 * near, height=0.42 * near**0.7)
    if view.camera == "orbit":
        away = orbit_distance(table, view.azimuth, view.elevation, size[0] / size[1])
        return orbit_camera(table, view.azimuth, view.elevation, away / view.zoom)
    if view.camera == "follow":
        x, y = followed or ball or (0.0, 0.0)
        return orbit((x, y, 0.0), view.azimuth, view.elevation, 1.7 / view.zoom, radians(42.0))
    return _nearer(above_camera(table, size[0] / size[1]), view.zoom, ball)


def _nearer(camera: Camera, zoom: float, about: Point | None) -> Camera:
    """Return the camera from above nearer to the cloth, moved toward what is played."""
    x, y = about or (0.0, 0.0)
    share = max(0.0, 1.0 - 1.0 / zoom)
    place = x * share, y * share
    return replace(
        camera,
        eye=(place[0], place[1], camera.eye[2] / zoom),
        target=(place[0], place[1], 0.0),
    )


def cloth_point(camera: Camera, size: Size, pixel: Pixel, height: float) -> Point | None:
    """Return the point of the cloth under a ball shown at a pixel, None above the horizon."""
    return ground_point(camera, size, pixel, height)


def ball_under(
    camera: Camera, size: Size, pixel: Pixel, lying: Mapping[BallId, Point], variant: Variant
) -> BallId | None:
    """Return the ball that the pointer is on: the nearest to the eye of those its ray meets."""
    way = ray(camera, size, pixel)
    radii = {ball.id: ball.radius for ball in variant.world.balls}
    found: tuple[float, BallId] | None = None
    for ball, (x, y) in lying.items():
        centre = x - camera.eye[0], y - camera.eye[1], radii[ball] - camera.eye[2]
        along = sum(a * b for a, b in zip(centre, way, strict=True))
        miss = hypot(*(a - along * b for a, b in zip(centre, way, strict=True)))
        if miss < 1.3 * radii[ball] and along > 0.0 and (found is None or along < found[0]):
            found = along, ball
    return found[1] if found else None


def pocket_under(camera: Camera, size: Size, pixel: Pixel, variant: Variant) -> PocketId | None:
    """Return the pocket that the pointer is on, with some room about it."""
    point = ground_point(camera, size, pixel)
    if point is None:
        return None
    for pocket in variant.world.table.pockets:
        away = hypot(point[0] - pocket.centre[0], point[1] - pocket.centre[1])
        if away < 1.8 * pocket.radius:
            return pocket.id
    return None


def followed_place(
    view: View, places: Mapping[BallId, Vector], struck: BallId, last: Point | None
) -> Point | None:
    """Return where the ball is that the view follows, from where balls are (m).

    One that is gone is looked for where it was `last`.
    """
    there = places.get(view.followed or struck)
    return (there[0], there[1]) if there is not None and there[2] > 0.0 else last


def struck_ball(session: Session) -> BallId:
    """Return the ball of the stroke shown, or of the one to come."""
    last = session.last_stroke
    if session.is_showing and last is not None:
        return last.shot.struck or cue_ball_of(session.variant, last.before.shooter)
    return session.cue_ball


def stroke_seen(session: Session) -> tuple[Point | None, float]:
    """Return where the cue ball of the stroke shown lies, and the heading in rad."""
    last = session.last_stroke
    if session.is_showing and last is not None and last.shot.strike is not None:
        place = last.shot.placement or last.before.rest.positions.get(struck_ball(session))
        return place, last.shot.strike.heading
    return session.cue_place, radians(session.stroke.heading)
