"""Where to look from: behind a ball, from above, and round the table."""

from __future__ import annotations

from math import atan2, cos, hypot, radians, sin, tan
from typing import TYPE_CHECKING

from engine.scene.camera import Camera, orbit
from engine.stage.clearance import borders_of, raise_cue
from engine.stage.cue import CuePose
from engine.stage.dimensions import measure

if TYPE_CHECKING:
    from engine.table.furniture import Point, Table

ABOVE_FIELD = radians(24.0)
MARGIN = 1.03
OVER_CUE = radians(13.0)
"""The eye behind a ball is at least so far above the cue, seen from the ball."""
STEEPEST = radians(84.0)
USUAL_NOSE = 1.27
"""Height of a nose in radii of a ball."""
ORBIT_FIELD = radians(42.0)


def above_camera(table: Table, aspect: float, margin: float = MARGIN) -> Camera:
    """Return a camera straight above that shows the whole table in a window of any ratio.

    `aspect` is width over height of the window; the table's long way follows the window's.
    """
    frame = measure(table)
    x, y = frame.outer
    lying = aspect >= 1.0
    across, along = (x, y) if lying else (y, x)
    slope = tan(ABOVE_FIELD / 2.0)
    height = frame.top + margin * max(across / (slope * aspect), along / slope)
    up = (0.0, 1.0, 0.0) if lying else (1.0, 0.0, 0.0)
    return Camera((0.0, 0.0, height), (0.0, 0.0, 0.0), up, ABOVE_FIELD)


def cue_camera(
    table: Table,
    ball: Point,
    heading: float,
    *,
    back: float = 0.85,
    height: float = 0.42,
    field: float = radians(46.0),
    elevation: float = 0.0,
) -> Camera:
    """Return a camera behind a ball at `ball` (m) that looks along `heading` (rad).

    `back` and `height` are the eye's distance behind the ball and above the bed, m. With the cue
    at an `elevation` (rad), or raised over what is behind the ball, the eye rises to look over it.
    """
    ahead = cos(heading), sin(heading)
    steep = min(_drawn(table, ball, heading, elevation) + OVER_CUE, STEEPEST)
    if steep > atan2(height, back):
        away = hypot(back, height)
        back, height = away * cos(steep), away * sin(steep)
    eye = ball[0] - back * ahead[0], ball[1] - back * ahead[1], height + table.nose_height
    reach = 0.55 + 0.12 * table.length
    target = ball[0] + reach * ahead[0], ball[1] + reach * ahead[1], 0.0
    return Camera(eye, target, field=field)


def orbit_distance(table: Table, azimuth: float, elevation: float, aspect: float) -> float:
    """Return from how far (m) all of the table is seen, in a window of any ratio.

    `aspect` is width over height of the window; angles in rad, elevation in (0, pi/2).
    """
    frame = measure(table)
    slope = tan(ORBIT_FIELD / 2.0)
    flat, steep = cos(elevation), sin(elevation)
    corners = [
        (sx * frame.outer[0], sy * frame.outer[1], z)
        for sx in (-1, 1)
        for sy in (-1, 1)
        for z in (frame.top, -frame.rail)
    ]
    far = 0.0
    for x, y, z in corners:
        toward = x * cos(azimuth) + y * sin(azimuth)
        across = y * cos(azimuth) - x * sin(azimuth)
        near = toward * flat + z * steep
        up = z * flat - toward * steep
        far = max(far, near + MARGIN * max(abs(across) / aspect, abs(up)) / slope)
    return far


def _drawn(table: Table, ball: Point, heading: float, elevation: float) -> float:
    """Return the elevation that a cue at the middle of a ball of usual size is drawn at."""
    radius = table.nose_height / USUAL_NOSE
    pose = CuePose((ball[0], ball[1], radius), radius, heading, elevation)
    return raise_cue(borders_of(table), pose).elevation


def orbit_camera(
    table: Table, azimuth: float, elevation: float, distance: float | None = None
) -> Camera:
    """Return a camera that looks at the table's middle; elevation in (0, pi/2), rad.

    Without a `distance` (m) it stands as far as the table's length asks.
    """
    steep = min(max(elevation, 0.03), 1.55)
    away = distance if distance is not None else 1.25 * table.length + 0.45
    return orbit((0.0, 0.0, 0.0), azimuth, steep, max(away, 0.1), ORBIT_FIELD)
