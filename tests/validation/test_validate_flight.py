"""Group G, raised cues of group F and meetings in space, with other figures than the file's."""

import json
from dataclasses import replace
from math import atan, cos, degrees, radians, sin, sqrt
from pathlib import Path

import pytest

from tools.validate.adapters import run_check
from tools.validate.check import Check, Wanted, read_checks

FILE = Path(__file__).with_name("checks.json")
DROP = {"R": 0.03, "g": 9.8, "e_t": 0.4, "h": 0.02}
FALL = sqrt(2 * 0.02 / 9.8)
JUMP = {"R": 0.03, "m": 0.2, "M": 0.3, "V": 5.0, "g": 9.8, "mu_s": 0.2, "e_t": 0.5, "e_tip": 0.8}
SPEED = 1.8 * 5.0 / (1.0 + 0.2 / 0.3)
RISE = 0.5 * SPEED * sin(radians(30))
AHEAD = SPEED * cos(radians(30))
LEFT = AHEAD - min(0.2 * 1.5 * SPEED * sin(radians(30)), 2 / 7 * AHEAD)
BOUNCE = {"R": 0.03, "e_t": 0.6, "mu_s": 0.1, "low_v": [2.0, 0.0, -1.0], "low_w": [0.0, 0.0, 3.0]}
CUE = {"m": 0.2, "M": 0.5, "R": 0.03, "V": 2.0, "e": 0.5, "theta_deg": 40}


def ask(group, parameters, quantity, value, tol=1e-9, description=""):
    wanted = Wanted(quantity, value, tol, "abs")
    check = Check("other", group, "exact", description, description, parameters, (wanted,))
    return run_check(check).answers[0]


@pytest.mark.parametrize(
    ("group", "parameters", "quantity", "value"),
    [
        ("G airborne", DROP, "impact 1", FALL),
        ("G airborne", DROP, "impact 2", FALL * 1.8),
        ("G airborne", DROP, "impact 5", FALL * (1 + 2 * (0.4 + 0.16 + 0.064 + 0.0256))),
        ("G airborne", DROP, "accumulation time", FALL * (1 + 2 * 0.4 / 0.6)),
        ("G airborne", DROP, "apex 1", 0.02 * 0.16),
        ("G airborne", DROP, "apex 3", 0.02 * 0.4**6),
        ("G airborne", BOUNCE, "low: v", [1.84, 0.0, 0.6]),
        ("G airborne", BOUNCE, "low: w", [0.0, 2.5 * 0.16 / 0.03, 3.0]),
        ("G airborne", {**JUMP, "theta_deg": 30}, "v after tip", [AHEAD, 0.0, -2.0 * RISE]),
        ("G airborne", {**JUMP, "theta_deg": 30}, "v after slate", [LEFT, 0.0, RISE]),
        ("G airborne", {**JUMP, "theta_deg": 30}, "apex height gain", RISE**2 / 19.6),
        ("G airborne", {**JUMP, "theta_deg": 30}, "flight time", RISE / 4.9),
        ("G airborne", {**JUMP, "theta_deg": 30}, "flight range", LEFT * RISE / 4.9),
        (
            "F cue",
            CUE,
            "v",
            [3.0 / 1.4 * cos(radians(40)), 0.0, -3.0 / 1.4 * sin(radians(40))],
        ),
        ("F cue", {"R": 0.03}, "contact/axis offset ratio, r_tip=0.006", 0.03 / 0.036),
        (
            "F cue",
            {"R": 0.03, "mu_s": 0.3, "V": 6.0},
            "elev=70 a=0.3 b=-0.1",
            -degrees(atan(0.3 * sin(radians(70)) / (cos(radians(70)) - 0.1))),
        ),
        (
            "C throw",
            {"R": 0.03, "v": 2.0, "e": 0.8, "mu_b": 0.05, "motion": "roll"},
            "v_CB",
            [0.2, 0.0, 0.09],
        ),
        (
            "C throw",
            {"R": 0.03, "v": 2.0, "e": 0.8, "mu_b": 0.05, "motion": "roll"},
            "v_OB",
            [1.8, 0.0, -0.09],
        ),
        (
            "H detection",
            {
                "R": 0.03,
                "rel_pos": [0.0, 0.0, 0.5],
                "rel_vel": [0.0, 0.0, -1.0],
                "rel_acc_half": [0.0, 0.0, 0.0],
            },
            "t_contact",
            0.44,
        ),
    ],
)
def test_other_figures_of_flight(group, parameters, quantity, value):
    assert ask(group, parameters, quantity, value).status == "pass"
    off = [one + 1e-4 for one in value] if isinstance(value, list) else value + 1e-4
    assert ask(group, parameters, quantity, off).status == "fail"


def test_a_jump_is_read_from_words_where_no_field_tells_it():
    words = "Jump: 30 deg, e_tip=0.8, e_t=0.5"
    bare = {name: JUMP[name] for name in ("R", "m", "M", "V", "g", "mu_s")}
    assert ask("G airborne", bare, "flight time", RISE / 4.9, description=words).status == "pass"
    missing = ask("G airborne", bare, "flight time", 1.0)
    assert (missing.status, missing.reason) == ("not-applicable", "input only in prose: e_tip")


def test_flight_answers_all_of_its_checks_and_none_by_its_id():
    chosen = [c for c in read_checks(FILE) if c.group[0] in "FG" or c.id in {"B14", "C10", "H09"}]
    flying = [c for c in chosen if "rolling over" not in c.description]
    assert len(flying) >= 11
    for check in flying:
        result = run_check(replace(check, id="another"))
        assert {answer.status for answer in result.answers} == {"pass"}, check.id


def test_what_the_file_says_in_prose_only_is_a_field_here():
    checks = json.loads(FILE.read_text(encoding="utf-8"))["checks"]
    (bounce,) = [one for one in checks if one["description"].startswith("Slate bounce")]
    assert {"slip_v", "slip_w", "stick_v", "stick_w"} <= bounce["parameters"].keys()
