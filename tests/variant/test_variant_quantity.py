"""Closes the hole between what people write and the SI number it stands for."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.variant.quantity import (
    ANGLE,
    ANGLES,
    LENGTH,
    LENGTHS,
    MASS,
    MASSES,
    QuantityError,
    read_quantity,
)

NAMES = {"L": 2.54, "W": 1.27, "R": 0.03}


@pytest.mark.parametrize(
    ("written", "metres"),
    [
        ("2.84 m", 2.84),
        ("52.5 mm", 0.0525),
        ("52.5mm", 0.0525),
        ("9 in", 0.2286),
        ("11 ft 8 1/2 in", 11 * 0.3048 + 8.5 * 0.0254),
        ("4 9/16 in", 4.5625 * 0.0254),
        ("1/2 in", 0.0127),
        ("-3 cm", -0.03),
        ("-(1 m - 20 cm)", -0.8),
        ("1 m / 4", 0.25),
        ("3 * 2 cm", 0.06),
        ("1e-2 m", 0.01),
        ("0", 0.0),
        (2.54, 2.54),
        (3, 3.0),
    ],
)
def test_lengths(written, metres):
    assert read_quantity(written, LENGTH) == pytest.approx(metres)


@pytest.mark.parametrize(
    ("written", "metres"),
    [
        ("-L/4", -0.635),
        ("L/2 - 0.324 m", 0.946),
        ("2 R + 0.5 mm", 0.0605),
        ("2R", 0.06),
        ("2(L - W)", 2.54),
        ("1/2 L", 1.27),
        ("W * L / L", 1.27),
        ("-W", -1.27),
    ],
)
def test_lengths_by_name(written, metres):
    assert read_quantity(written, LENGTH, NAMES) == pytest.approx(metres)


def test_masses_and_angles():
    assert read_quantity("6 oz", MASS) == pytest.approx(0.1701, abs=1e-5)
    assert read_quantity("170 g", MASS) == pytest.approx(0.170)
    assert read_quantity("142 deg", ANGLE) == pytest.approx(math.radians(142))
    assert read_quantity("90°", ANGLE) == pytest.approx(math.pi / 2)


@pytest.mark.parametrize(
    "written",
    [
        *("", "m", "2.84", "2.84 k", "2 m 3", "1 m +", "(1 m", "1 m)", "1 m * 1 m", "1 m + 1"),
        *("1/0 in", "1 m / 0", "2,84 m", "nan", "inf", "1e999 m", "__import__('os')"),
        *("1 m; 2 m", "L", "5 5 m", "1 m ** 9", "1" * 200 + " m", "-" * 100 + "1 m"),
        *("(" * 50 + "1 m" + ")" * 50, True, None, []),
    ],
)
def test_what_is_no_length_is_refused(written):
    with pytest.raises(QuantityError):
        read_quantity(written, LENGTH)


@pytest.mark.parametrize(("kind", "units"), [(LENGTH, LENGTHS), (MASS, MASSES), (ANGLE, ANGLES)])
@given(number=st.floats(0.001, 900), data=st.data())
def test_any_number_with_any_unit_is_read(kind, units, number, data):
    unit = data.draw(st.sampled_from(sorted(units)))
    expected = number * units[unit]
    assert read_quantity(f"{number!r} {unit}", kind) == pytest.approx(expected)
    assert read_quantity(f"-{number!r}{unit}", kind) == pytest.approx(-expected)


@given(st.integers(0, 30), st.integers(0, 11), st.integers(0, 15), st.sampled_from([2, 4, 8, 16]))
def test_feet_and_inches_with_fractions(feet, inches, part, whole):
    written = f"{feet} ft {inches} {part}/{whole} in"
    expected = feet * 0.3048 + (inches + part / whole) * 0.0254
    assert read_quantity(written, LENGTH) == pytest.approx(expected)


@given(st.text(alphabet="0123456789./+-*() LWRmcfinte°", max_size=30))
def test_no_text_does_anything_but_give_a_number_or_a_reason(written):
    try:
        value = read_quantity(written, LENGTH, NAMES)
    except QuantityError:
        return
    assert math.isfinite(value)


@given(st.floats(-5, 5), st.floats(-5, 5), st.floats(-5, 5))
def test_arithmetic_is_that_of_numbers(a, b, c):
    written = f"({a:.6f} m - {b:.6f} m) * 2 + {c:.6f} m / 4"
    expected = (float(f"{a:.6f}") - float(f"{b:.6f}")) * 2 + float(f"{c:.6f}") / 4
    assert read_quantity(written, LENGTH) == pytest.approx(expected, abs=1e-9)
