"""From a session to a scene: where every ball is now, how it is turned, and what is marked.

One idea: the table shown is either the one before the next stroke or a moment of the last
stroke's trace; the rest is marks on the cloth.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import radians
from typing import TYPE_CHECKING

from engine.app.prediction import Foretelling
from engine.app.session import BEFORE_STROKE, SWING, Aid, Mode, Session
from engine.app.turning import Turning
from engine.game.situation import cue_ball_of
from engine.scene.shape import Disc, Mesh, Polyline
from engine.stage.cue import CuePose
from engine.stage.marks import LIFT, flat_path, flat_ring, tint_zone
from engine.stage.skin import facing
from engine.table.furniture import Places

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from engine.app.prediction import Prediction
    from engine.physics.trace import Trace
    from engine.scene.camera import Camera, Vector
    from engine.scene.scene import Scene
    from engine.stage.stage import Stage
    from engine.table.furniture import BallId, PinId, Table, Zone
    from engine.table.pin import Stance

FACING = facing()
GOLD = (250, 196, 70)
WHITE = (240, 240, 240)
BLUE = (110, 170, 255)
SPARE = 0.006
"""Seconds of a frame that looking at the coming stroke may take."""
AFTER = 1e-6
"""Seconds after a stroke at which the table is shown that it leaves."""
DRAWN_BACK = 0.30
"""How far (m) the cue is drawn back for the hardest stroke."""


@dataclass(slots=True)
class Showing:
    """Turns sessions into scenes; keeps how the balls lie turned from stroke to stroke."""

    stage: Stage
    _before: dict[BallId, NDArray[np.float64]] = field(default_factory=dict)
    _settled: dict[BallId, NDArray[np.float64]] = field(default_factory=dict)
    _turning: Turning | None = None
    _asked: object = None
    _table: object = None
    _foretelling: Foretelling | None = None
    _answer: Prediction | None = None

    def scene(self, session: Session, camera: Camera) -> Scene:
        """Return the scene of a session at this moment."""
        aids, discs = self._marks(session)
        return self.stage.scene(
            self.places(session),
            camera,
            orientations=self._orientations(session),
            cue=self._cue(session),
            aids=aids,
            discs=discs,
            pins=self._pins(session),
        )

    def _pins(self, session: Session) -> dict[PinId, Stance]:
        """Return how each pin stands or lies; one that waits for its place is not shown."""
        if session.is_showing and session.trace is not None:
            return session.trace.pins.stances(max(session.clock, 0.0))
        fallen = session.shown.rest.fallen
        return {pin: stance for pin, stance in self.stage.pins.upright.items() if pin not in fallen}

    def places(self, session: Session) -> dict[BallId, Vector]:
        """Return the centre of every ball shown, m."""
        if session.is_showing and session.trace is not None:
            return _moving(session.trace, session.clock)
        radii = {ball.id: ball.radius for ball in session.variant.world.balls}
        lying = session.layout
        if session.mode in (Mode.OVER, Mode.CHOOSING):
            lying = dict(session.match.situation.rest.positions)
        return {ball: (x, y, radii[ball]) for ball, (x, y) in lying.items()}

    def _orientations(self, session: Session) -> dict[BallId, NDArray[np.float64]]:
        """Return how every ball lies turned now; the end of a stroke is kept for the next."""
        trace = session.trace
        if not session.is_showing or trace is None:
            return self._settled
        if self._turning is None or self._turning.trace is not trace:
            self._before, self._turning = dict(self._settled), Turning(trace)
        now = self._turning.at(min(max(session.clock, 0.0), trace.duration))
        turned = {
            ball.id: turn @ self._before.get(ball.id, FACING)
            for ball, turn in zip(trace.balls, now, strict=True)
        }
        if session.clock >= trace.duration:
            self._settled.update(turned)
        return turned

    def _cue(self, session: Session) -> CuePose | None:
        if session.mode is Mode.AIMING or session.mode is Mode.CALLING:
            place, strike = session.cue_place, session.stroke.strike()
            ball, gap = session.cue_ball, 0.015 + DRAWN_BACK * session.stroke.speed / 12.0
        elif session.mode is Mode.STRIKING and session.last_stroke:
            last = session.last_stroke
            if last.shot.strike is None:
                return None
            strike = last.shot.strike
            ball = last.shot.struck or cue_ball_of(session.variant, last.before.shooter)
            place = last.shot.placement or last.before.rest.positions.get(ball)
            share = min(max(-session.clock / SWING, 0.0), 1.0)
            gap = (0.015 + DRAWN_BACK * strike.speed / 12.0) * share
        else:
            return None
        if place is None:
            return None
        radius = self.stage.spheres[ball].radius
        return CuePose(
            (place[0], place[1], radius),
            radius,
            strike.heading,
            max(strike.elevation, radians(4.0)),
            strike.side,
            strike.follow,
            gap,
        )

    def _marks(self, session: Session) -> tuple[list[Mesh | Polyline], list[Disc]]:
        if session.mode not in (Mode.CHOOSING, Mode.ARRANGING, *BEFORE_STROKE):
            return [], []
        aids: list[Mesh | Polyline] = []
        discs: list[Disc] = []
        lying = session.layout
        radius = self.stage.spheres[session.cue_ball].radius
        for ball, (x, y) in lying.items():
            size = self.stage.spheres[ball].radius
            if ball in (session.call.ball, session.held):
                aids.append(flat_ring((x, y), 1.5 * size, BLUE, 0.009))
            elif ball in session.admission.on and ball != session.cue_ball:
                discs.append(Disc((x, y, LIFT), 1.32 * size, GOLD, 0.75, 0.12 * size))
        if session.mode is Mode.PLACING and session.ahead.in_hand is not None:
            table = session.variant.world.table
            aids += draw_zone(table.zones[session.ahead.in_hand], table, radius)
        if session.mode in (Mode.AIMING, Mode.CALLING):
            aids += self._aim(session)
        return aids, discs

    def _aim(self, session: Session) -> list[Mesh | Polyline]:
        """Return the lines of the aiming aid, from the physics itself.

        While a stroke is still being looked at, the one before it on the same table is shown.
        """
        place = session.cue_place
        if session.aid is Aid.OFF or place is None:
            return []
        self._foretell(session)
        if self._answer is None or self._table is not session.ahead.rest:
            return []
        return draw_prediction(self._answer, session.aid)

    def _foretell(self, session: Session) -> None:
        """Go on with what is looked at, for as long as a frame can spare."""
        rest = session.ahead.rest
        asked = (session.stroke, session.cue_place, rest, session.cue_ball, session.aid)
        if self._foretelling is None and asked != self._asked:
            self._asked, self._foretelling = asked, Foretelling(session)
        if self._foretelling is None:
            return
        self._foretelling.go_on(SPARE)
        if self._foretelling.done:
            self._answer = self._foretelling.answer
            self._table = self._foretelling.session.ahead.rest
            self._foretelling = None


def _moving(trace: Trace, clock: float) -> dict[BallId, Vector]:
    """Return the centres (m) at a moment of a stroke; at its end without what is gone."""
    is_over = clock >= trace.duration
    rows = trace.positions([trace.duration + AFTER if is_over else max(clock, 0.0)])[0]
    return {
        ball.id: (float(row[0]), float(row[1]), float(row[2]))
        for ball, row in zip(trace.balls, rows, strict=True)
        if row[2] > 0.0 or not is_over
    }


def draw_zone(zone: Zone, table: Table, radius: float) -> list[Mesh | Polyline]:
    """Return what shows where a ball in hand may be put: a tint, or a ring about each place."""
    if isinstance(zone, Places):
        return [flat_ring(point, 1.4 * radius, WHITE, 0.004) for point in zone.points]
    tint = tint_zone(zone, table, WHITE, 0.14)
    return [tint] if tint else []


def draw_prediction(seen: Prediction, aid: Aid) -> list[Mesh | Polyline]:
    """Return what an aid shows of a prediction."""
    lines: list[Mesh | Polyline] = []
    if len(seen.to_contact) > 1:
        lines.append(flat_path(seen.to_contact, WHITE, 0.004, 0.85))
    if aid is Aid.LINE:
        return lines
    if seen.contact is not None:
        lines.append(flat_ring(seen.contact, seen.radius, WHITE, 0.003))
        if len(seen.object_way) > 1:
            lines.append(flat_path(seen.object_way, GOLD, 0.004, 0.9))
    lines += [flat_path(way, (190, 200, 215), 0.003, 0.6) for way in seen.ways if len(way) > 1]
    return lines
