"""The first time a gap closes: the first downward crossing of a quartic in a window.

One idea: between neighbouring critical points a polynomial is monotone, so isolate by derivatives
and finish each bracket by Newton's method kept inside it. Works for every degree up to four, with
a leading coefficient of exactly zero or as good as zero, since nothing is divided by it.
Invariant: only a change from p >= 0 to p < 0 counts; a double root that turns back does not.
"""

from __future__ import annotations

from math import inf, sqrt

from engine.geometry.kernel import kernel

NEVER = inf


@kernel
def value(k0: float, k1: float, k2: float, k3: float, k4: float, s: float) -> float:
    """Return k0 + k1 s + k2 s^2 + k3 s^3 + k4 s^4."""
    return k0 + s * (k1 + s * (k2 + s * (k3 + s * k4)))


@kernel
def refine(k0: float, k1: float, k2: float, k3: float, k4: float, low: float, high: float) -> float:
    """Return the root between `low` and `high`, where the quartic changes sign, to an ulp."""
    rising = value(k0, k1, k2, k3, k4, low) < 0.0
    s = 0.5 * (low + high)
    for _ in range(100):
        p = value(k0, k1, k2, k3, k4, s)
        if p == 0.0:
            break
        if (p < 0.0) == rising:
            low = s
        else:
            high = s
        slope = k1 + s * (2.0 * k2 + s * (3.0 * k3 + s * 4.0 * k4))
        guess = s - p / slope if slope != 0.0 else low
        if not low < guess < high:
            guess = 0.5 * (low + high)
        if abs(guess - s) <= 2.3e-16 * abs(s) or guess in (low, high):
            s = guess
            break
        s = guess
    return s


@kernel
def _bends(k2: float, k3: float, k4: float) -> tuple[float, float]:
    """Return the inflection points of a quartic, ascending; NEVER stands for a missing one."""
    a, b, c = 6.0 * k4, 3.0 * k3, k2
    if a == 0.0:
        return (-c / b, NEVER) if b != 0.0 else (NEVER, NEVER)
    inside = b * b - 4.0 * a * c
    if inside <= 0.0:
        return NEVER, NEVER
    q = -0.5 * (b + (sqrt(inside) if b >= 0.0 else -sqrt(inside)))
    first = q / a
    second = c / q if q != 0.0 else NEVER
    return (first, second) if first < second else (second, first)


@kernel
def first_fall(
    k0: float, k1: float, k2: float, k3: float, k4: float, low: float, high: float
) -> float:
    """Return the first s in [low, high] where the quartic goes from >= 0 to < 0, or NEVER.

    Where it is below zero at `low`, it must first rise.
    """
    first, second = _bends(k2, k3, k4)
    s, p = low, value(k0, k1, k2, k3, k4, low)
    slope = k1 + s * (2.0 * k2 + s * (3.0 * k3 + s * 4.0 * k4))
    for piece in range(3):
        end = high
        if piece == 0 and low < first < high:
            end = first
        elif piece <= 1 and low < second < high and second > s:
            end = second
        if end <= s:
            continue
        end_slope = k1 + end * (2.0 * k2 + end * (3.0 * k3 + end * 4.0 * k4))
        if (slope < 0.0) != (end_slope < 0.0):
            turn = refine(k1, 2.0 * k2, 3.0 * k3, 4.0 * k4, 0.0, s, end)
            q = value(k0, k1, k2, k3, k4, turn)
            if p >= 0.0 > q:
                return refine(k0, k1, k2, k3, k4, s, turn)
            s, p = turn, q
        q = value(k0, k1, k2, k3, k4, end)
        if p >= 0.0 > q:
            return refine(k0, k1, k2, k3, k4, s, end)
        s, p, slope = end, q, end_slope
    return NEVER


@kernel
def polish(
    cx: float,
    cy: float,
    bx: float,
    by: float,
    ax: float,
    ay: float,
    distance: float,
    t: float,
) -> float:
    """Return `t` after two Newton steps on |c + b t + a t^2| = distance, free of cancellation."""
    for _ in range(2):
        x, y = cx + t * (bx + t * ax), cy + t * (by + t * ay)
        vx, vy = bx + 2.0 * t * ax, by + 2.0 * t * ay
        reach = sqrt(x * x + y * y)
        closing = x * vx + y * vy
        if closing == 0.0:
            break
        step = (reach - distance) * reach / closing
        if abs(step) > 1e-6:
            break
        t -= step
    return max(t, 0.0)


__all__ = ["NEVER", "first_fall", "polish", "refine", "value"]
