"""Compiling by two processes: the kernels they compile are those that the solver calls."""

import subprocess
import sys
from pathlib import Path

from engine.physics import prepare
from engine.physics.simulate import warm_up
from engine.physics.stepwise import run

ROOT = Path(__file__).parents[2]

SHARES = """
from engine.physics import prepare
from engine.physics.simulate import warm_up

warm_up()
for share in (prepare._foreseeing(), prepare._meeting()):
    for function, types in share:
        function.compile(types)
        assert not function.stats.cache_misses, function.py_func.__name__
        assert function.stats.cache_hits or function.signatures
"""


def test_what_the_shares_compile_is_what_a_shot_uses():
    warm_up()
    subprocess.run([sys.executable, "-c", SHARES], cwd=ROOT, check=True)


def test_a_kernel_that_was_compiled_is_kept_and_another_is_not():
    warm_up()
    assert prepare.is_kept(run)

    class Other:
        stats = run.stats

        def py_func(self):
            """Never compiled."""

    assert not prepare.is_kept(Other)


def test_nothing_is_compiled_twice(monkeypatch):
    warm_up()
    monkeypatch.setattr(prepare, "start", lambda _: 1 / 0)
    said = []
    prepare.prepare(said.append)
    assert said == []


def test_another_process_finds_all_kept():
    warm_up()
    helper = prepare.start("meeting")
    assert isinstance(helper, subprocess.Popen)
    assert helper.wait(60.0) == 0
