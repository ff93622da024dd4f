"""The examples of the page for researchers do what the page says."""

import doctest
import subprocess
import sys
from pathlib import Path

import pytest

from engine import research
from engine.variant.library import VariantError
from tools.robustness import ROWS, rows

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "research.md"


def test_every_example_of_the_page_gives_what_stands_there():
    text = PAGE.read_text(encoding="utf-8").replace("```", "")
    parsed = doctest.DocTestParser().get_doctest(text, {}, "research", str(PAGE), 0)
    assert len(parsed.examples) > 40
    told = []
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(parsed, out=told.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(told)


def test_importing_it_costs_nothing():
    code = (
        "import sys; from engine import research; "
        "print(sorted({'numpy', 'numba', 'pydantic', 'lark', 'pygame'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert done.stdout.strip() == "[]"


def test_a_lab_reads_no_rules_and_tells_all_mistakes(tmp_path):
    path = tmp_path / "broken.toml"
    path.write_text('title = "x"\nplayers = -1\n', encoding="utf-8")
    with pytest.raises(VariantError) as raised:
        research.load(path)
    assert raised.value.diagnostics
    code = (
        "import sys; from engine import research; lab = research.load('snooker'); "
        "print('lark' in sys.modules, len(lab.world.balls))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert done.stdout.split() == ["False", "22"]


def test_an_opening_is_struck():
    lab = research.load("nine_ball")
    layout = lab.opening(seed=3)
    assert layout != lab.opening(seed=4)
    assert research.aim(layout, lab.cue_balls[0], "1") == pytest.approx(0.0, abs=1e-9)
    from engine.physics.world import Strike

    trace = lab.shoot(layout, Strike(6.0, 0.0))
    assert trace.balls[research.column(trace, "9")].id == "9"


def test_every_nasty_configuration_has_a_test_and_stands_in_the_page():
    assert sorted(rows()) == list(range(1, ROWS + 1))
    page = (ROOT / "docs" / "physics.md").read_text(encoding="utf-8")
    for tests in rows().values():
        assert all(f"`{name}`" in page for _, name in tests)
