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
SLIDING, ROLLING_MU, SLOWING, LIVELY, GRIP = range(19, 24)
BALL_WIDTH = 24
"""Piece start and end, r, v, w, acceleration, rate of w_x and w_y; radius, mass, the horizontal
distance at which the ball touches a nose, the time at which its side spin has ceased, and height
of the centre with its speed, which only flight changes. Then what the ball has of its own: sliding
and rolling friction and loss of side spin; and by how much its restitution against balls, and its
friction in parts, differ from the world's."""

(P_BALL, P_T0, P_T1, P_KIND, P_X, P_Y, P_VX, P_VY, P_WX, P_WY, P_WZ, P_AX, P_AY, P_BX, P_BY) = (
    range(15)
)
P_Z, P_VZ = 15, 16
FLAT_WIDTH, PIECE_WIDTH = 15, 17
"""The columns of a piece on the bed, and all, with height and its speed at the start."""

K_NOSE_TIME, K_DROP_TIME, K_PAIR_TIME, K_NOSE, K_DROP, K_PAIR, K_TOUCHED = range(7)
FORESEEN_WIDTH = 7
"""What is foreseen of a ball: times, and the nose, drop and ball they are about; and whether it is
touched by an event that others resolve."""

E_KIND, E_TIME, E_FIRST, E_SECOND, E_SPEED = range(5)
EVENT_WIDTH = 5

TOUCHING, NOSE, DROPPED, LEFT, ROLLING, STOPPED, LANDED, TOPPLED, LEANT = (
    float(kind) for kind in range(9)
)
"""Kinds of event: balls collided, nose hit, pocketed, left the table, rolling began, ball stopped,
ball landed, pin toppled, pin met that stands. In those two second is the pin's number, and who met
it is a ball, or another pin k as -1 - k. A pin toppled has the impulse it got in place of speed.

Floats, since a kernel is compiled anew for every whole number it is called with.
"""

ON_RAIL = -2.0
"""The second of a landing that was on top of the rail, and not on the bed."""

(
    G_THRESHOLD,
    G_GRAVITY,
    G_E,
    G_FLOOR,
    G_RISE,
    G_DECAY,
    G_NOSE,
    G_MOTION,
    G_BALL_BALL,
    G_CLUSTER,
    G_TOUCH,
    G_OUT_X,
    G_OUT_Y,
    G_BED,
    G_E_SLOPE,
    G_E_KNEE,
    G_RAIL,
) = range(17)
WORLD_WIDTH = 17
"""The world's numbers: cloth, contact, nose height, models, the gap (m) up to which balls take part
in one blow, the outer bounds, the bed's restitution, how that of two balls falls with speed, and
how wide the rail is behind the noses.
What may differ from ball to ball, nose to nose and pocket to pocket stands in their rows."""

N_CURVED, N_X, N_Y, N_DX, N_DY, N_SIZE, N_SPAN, N_LOX, N_LOY, N_HIX, N_HIY = range(11)
N_E, N_SLOPE, N_KNEE, N_RUB, N_MODEL, N_UPRIGHT, N_PIN = range(11, 18)
N_BEND, N_LEAST, N_RUB_SLOPE, N_RATIO = range(18, 22)
NOSE_WIDTH = 22
"""A nose: straight from (X, Y) along (DX, DY) for SIZE, or an arc about (X, Y) of radius SIZE
(negative where the bed lies inside) whose middle looks along (DX, DY) and whose half sweep is
SPAN; and its bounding box. Then its rubber: restitution with slope and knee, friction, model;
how tall (m) an upright body is, which a ball meets at its equator, 0 for a nose at nose height; and
the number of the pin it is, or -1. Last the rest of its rubber: the square's factor and the least
of restitution, the slope of friction, and the frequencies' ratio of `stronge`."""

D_X, D_Y, D_SIZE, D_MODEL, D_LIP, D_RIM, D_E, D_RUB = range(8)
DROP_WIDTH = 8
"""A pocket: its drop circle, its model, the radius of its lip and the height of its rim (m), and
restitution and friction of what the ball meets in it."""

C_TIME, C_UNTIL, C_ALARM = range(3)
CLOCK_WIDTH = 3
"""The clock: time of the last event, time up to which was asked, and the time at which whoever
resolves rare events wants to be asked (infinite for never)."""

DONE, PAUSED, FULL, STORM, DOWN, ASK = range(6)
"""How a run ends: all at rest, `until` reached, buffers full, more events than the cap, no ball
flies any more (in `flight` alone), or an event that others resolve."""

PIECES, EVENTS, STARTED, CAP, ASK_WHAT, ASK_WHO, ASK_OTHER = range(7)
COUNTS_WIDTH = 7
"""Counts: rows of both buffers, whether (or how far) the shot has started, and the event cap; and
what is asked (ASK_*), about which ball, and which other ball, nose or pocket."""

SLIDE_ROLL, TWO_SPEED = range(2)
ELASTIC, FRICTIONAL, MATHAVAN_2014 = range(3)
RESTITUTION, HAN, MATHAVAN, STRONGE = range(4)
DROP_EDGE, RIM_LIP = range(2)
HERTZ, SIMULTANEOUS, SEQUENTIAL = range(3)
"""Codes of models; those above FRICTIONAL, MATHAVAN, DROP_EDGE and HERTZ are not built in."""

ASK_DROP, ASK_PAIR, ASK_NOSE, ASK_CLUSTER, ASK_ALARM = (float(what) for what in range(5))
"""What a kernel may ask for: see `engine.physics.asked`."""

STILL = 1e-9
"""A speed (m/s) below which a ball does not move or slip: rounding, not motion."""

SOFT = 1e-3
"""An approach (m/s) below which a contact rests, carried by tiny lossless bounces."""

HOP = 1e-3
"""A bounce off the bed that would rise less than this (m) does not rise at all."""

RUN = 2.5e-4
"""How high (m) the hops are that carry a ball along the top of the rail, paid for by its speed."""

KICK = 1e-3
"""The least speed (m/s) at which a resting contact bounces, paid for by the balls' spin."""
