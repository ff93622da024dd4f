"""The jitted root finder against dense sampling and numpy's companion matrix."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.geometry.roots import NEVER, first_fall, polish, refine

roots = st.floats(-0.5, 1.5).map(lambda x: round(x, 6))


def plain_first_fall(k, low, high):
    """All real roots by numpy, then the first at which the sign goes from + to -."""
    found = np.roots(np.trim_zeros(np.asarray(k)[::-1], "f"))
    real = np.sort([r.real for r in found if abs(r.imag) < 1e-9 and low < r.real < high])
    cuts = np.concatenate([[low], real, [high]])
    middles = 0.5 * (cuts[1:] + cuts[:-1])
    signs = np.polyval(np.asarray(k)[::-1], middles) >= 0.0
    for i in range(len(signs) - 1):
        if signs[i] and not signs[i + 1]:
            return cuts[i + 1]
    return NEVER


@settings(max_examples=400, deadline=None)
@given(st.lists(roots, min_size=1, max_size=4, unique=True), st.sampled_from([-1.0, 1.0]))
def test_first_fall_agrees_with_all_roots(given_roots, sign):
    apart = np.diff(np.sort([*given_roots, 0.0, 1.0]))
    if (apart < 1e-3).any():
        return
    k = np.zeros(5)
    k[: len(given_roots) + 1] = sign * np.poly(given_roots)[::-1]
    expected = plain_first_fall(k, 0.0, 1.0)
    found = first_fall(*k, 0.0, 1.0)
    assert found == expected or found == pytest.approx(expected, abs=1e-9)


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(-1, 1), min_size=5, max_size=5))
def test_first_fall_agrees_with_dense_sampling(k):
    at = np.linspace(0.0, 1.0, 4001)
    p = np.polyval(k[::-1], at)
    falls = np.nonzero((p[:-1] >= 0.0) & (p[1:] < 0.0))[0]
    found = first_fall(*k, 0.0, 1.0)
    if len(falls):
        # a pair of crossings may hide between two samples, so the answer may only be earlier
        assert found <= at[falls[0] + 1]
    if found < NEVER:
        after = np.polyval(k[::-1], np.nextafter(found, 2.0) + 1e-9)
        assert after < 1e-8


@pytest.mark.parametrize("leading", [0.0, 1e-300, 1e-30, -1e-18, 1e-14, 1e-6])
def test_leading_coefficient_may_vanish(leading):
    assert first_fall(0.5, -1.0, 0.0, 0.0, leading, 0.0, 1.0) == pytest.approx(0.5, abs=1e-6)


@pytest.mark.parametrize(
    ("k", "expected"),
    [
        ((0.25, -1.0, 1.0, 0.0, 0.0), NEVER),
        ((0.0, 1.0, 0.0, 0.0, 0.0), NEVER),
        ((0.0, -1.0, 0.0, 0.0, 0.0), 0.0),
        ((0.0, 1.0, -2.0, 0.0, 0.0), 0.5),
        ((-1.0, 0.0, 0.0, 0.0, 0.0), NEVER),
        ((-0.1, 1.0, -1.0, 0.0, 0.0), 0.5 + np.sqrt(0.15)),
        ((0.0, 0.0, -1.0, 0.0, 0.0), 0.0),
        ((0.0, 0.0, 0.0, 0.0, 0.0), NEVER),
    ],
)
def test_special_cases(k, expected):
    found = first_fall(*k, 0.0, 1.0)
    assert found == expected or found == pytest.approx(expected, abs=1e-12)


def test_refine_is_exact_to_rounding():
    root = refine(-2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0)
    assert abs(root - np.sqrt(2.0)) <= 4.5e-16


def test_polish_removes_the_error_of_a_rough_root():
    t = polish(0.5, 0.05, -1.0, 0.0, 0.04905, 0.0, 0.05715, 0.48380194 + 3e-8)
    x, y = 0.5 - t + 0.04905 * t * t, 0.05
    assert abs(np.hypot(x, y) - 0.05715) < 1e-16
