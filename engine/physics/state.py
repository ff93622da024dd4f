"""The columns of the solvers' arrays.

One idea: a shot's state is a few plain arrays, so that one kernel can run it and anyone can stop
and resume it. `BALLS` rows hold each ball's current piece from its own local origin; `PIECES` and
`EVENTS` rows are the trace as it grows. Invariant: a row's r, v, w are those at its own T0, and
are never chained from a later time.
"""

from __future__ import annotations

REST, SPIN, ROLL, SLIDE, FAST, GONE, FLY = range(7)
"""Kinds of motion; FAST is the two-speed model's upper branch, GONE is gone, FLY above the bed."""

(T0, END, X, Y, VX, VY, WX, WY, WZ, AX, AY, BX, BY, RADIUS, MASS, REACH, CEASE, Z, VZ) = range(19)
BALL_WIDTH = 19
"""Piece start and end, r, v, w, acceleration, rate of w_x and w_y; radius, mass, the horizontal
distance at which the ball touches a nose, the time at which its side spin has ceased, and height
of the centre with its speed, which only flight changes."""

(P_BALL, P_T0, P_T1, P_KIND, P_X, P_Y, P_VX, P_VY, P_WX, P_WY, P_WZ, P_AX, P_AY, P_BX, P_BY) = (
    range(15)
)
P_Z, P_VZ = 15, 16
FLAT_WIDTH, PIECE_WIDTH = 15, 17
"""The columns of a piece on the bed, and all, with height and its speed at the start."""

E_KIND, E_TIME, E_FIRST, E_SECOND, E_SPEED = range(5)
EVENT_WIDTH = 5

TOUCHING, NOSE, DROPPED, LEFT, ROLLING, STOPPED, LANDED = (float(kind) for kind in range(7))
"""Kinds of event: balls collided, nose hit, pocketed, left the table, rolling began, ball stopped,
ball landed.

Floats, since a kernel is compiled anew for every whole number it is called with.
"""

(
    G_SLIDING,
    G_ROLLING,
    G_SPIN,
    G_THRESHOLD,
    G_GRAVITY,
    G_E,
    G_FLOOR,
    G_RISE,
    G_DECAY,
    G_RUBBER,
    G_SLOPE,
    G_KNEE,
    G_FRICTION,
    G_NOSE,
    G_MOTION,
    G_BALL_BALL,
    G_CUSHION,
    G_OUT_X,
    G_OUT_Y,
    G_BED,
) = range(20)
"""The world's numbers: cloth, contact, rubber, nose height, models, the outer bounds, and the bed's
restitution."""

N_CURVED, N_X, N_Y, N_DX, N_DY, N_SIZE, N_SPAN, N_LOX, N_LOY, N_HIX, N_HIY = range(11)
"""A nose: straight from (X, Y) along (DX, DY) for SIZE, or an arc about (X, Y) of radius SIZE
(negative where the bed lies inside) whose middle looks along (DX, DY) and whose half sweep is
SPAN; and its bounding box."""

C_TIME, C_SUM = range(2)
"""The clock: time of the last event."""

SLIDE_ROLL, TWO_SPEED = range(2)
ELASTIC, FRICTIONAL = range(2)
RESTITUTION, HAN, MATHAVAN = range(3)

STILL = 1e-9
"""A speed (m/s) below which a ball does not move or slip: rounding, not motion."""

SOFT = 1e-3
"""An approach (m/s) below which a contact rests, carried by tiny lossless bounces."""

HOP = 1e-3
"""A bounce off the bed that would rise less than this (m) does not rise at all."""

KICK = 1e-3
"""The least speed (m/s) at which a resting contact bounces, paid for by the balls' spin."""
