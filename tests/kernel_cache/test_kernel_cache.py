"""Compiled kernels that may be out of date are dropped; the others stay."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from engine.kernel_cache import STAMP, drop_stale, when_compiling

KERNEL = "from whole.part.inner import BY\n\n@njit\ndef outer(x): return x * BY\n"


@pytest.fixture
def package(tmp_path):
    part = tmp_path / "whole" / "part"
    part.mkdir(parents=True)
    (tmp_path / "whole" / "__init__.py").write_text("")
    (part / "__init__.py").write_text("")
    (part / "outer.py").write_text(KERNEL)
    (part / "inner.py").write_text("from whole.far import BY\n")
    (part / "plain.py").write_text("A = 1\n")
    (tmp_path / "whole" / "far.py").write_text("BY = 2\n")
    return part


@pytest.fixture
def cache(tmp_path):
    folder = tmp_path / "cache"
    folder.mkdir()
    fill(folder)
    return folder


def fill(folder):
    for name in ("outer.run-1.py311.nbi", "outer.run-1.py311.1.nbc", "other.x.nbi"):
        (folder / name).write_text("")


def test_the_first_time_drops_what_nobody_vouches_for(package, cache):
    assert drop_stale(cache, package) == ["outer.run-1.py311.nbi"]
    assert (cache / "other.x.nbi").exists()
    assert (cache / "outer.run-1.py311.1.nbc").exists()


@pytest.mark.parametrize("changed", ["part/outer.py", "part/inner.py", "far.py"])
def test_a_change_in_anything_a_kernel_uses_drops_it(package, cache, changed):
    drop_stale(cache, package)
    fill(cache)
    assert drop_stale(cache, package) == []
    path = package.parent / changed
    path.write_text(path.read_text() + "# changed\n")
    assert drop_stale(cache, package) == ["outer.run-1.py311.nbi"]
    assert drop_stale(cache, package) == []


def test_a_change_elsewhere_drops_nothing(package, cache):
    drop_stale(cache, package)
    fill(cache)
    (package / "plain.py").write_text("A = 2\n")
    (package / "outer.py").touch()
    assert drop_stale(cache, package) == []


def test_a_cache_that_cannot_be_written_is_no_trouble(package, tmp_path, monkeypatch):
    cache = tmp_path / "cache"
    cache.mkdir()
    fill(cache)

    def refuse(*_args, **_options):
        raise PermissionError

    monkeypatch.setattr(Path, "unlink", refuse)
    monkeypatch.setattr(Path, "write_text", refuse)
    assert drop_stale(cache, package) == []
    assert sorted(p.name for p in cache.glob("*.nbi")) == ["other.x.nbi", "outer.run-1.py311.nbi"]


def test_a_missing_cache_is_made(package, tmp_path):
    assert drop_stale(tmp_path / "none", package) == []
    assert (tmp_path / "none" / STAMP).exists()


def test_numba_is_not_loaded():
    code = "import sys, engine.kernel_cache; print('numba' in sys.modules)"
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=root
    )
    assert done.stdout.strip() == "False"


def test_the_first_compilation_is_told_and_only_that():
    from numba import njit  # slow to import

    told = []
    when_compiling(lambda: told.append("compiling"))
    assert not told
    for kernel in (njit(lambda x: x + 1), njit(lambda x: x * 2)):
        kernel(1)
        assert told == ["compiling"]


def test_a_kernel_that_is_on_disk_is_not_told(tmp_path):
    (tmp_path / "kept.py").write_text(
        "from numba import njit\n"
        "from engine.kernel_cache import when_compiling\n"
        "@njit(cache=True)\n"
        "def grow(x):\n"
        "    return x + 1\n"
        "when_compiling(lambda: print('compiling'))\n"
        "print(grow(1))\n"
    )
    root = Path(__file__).parents[2]
    code = f"import sys; sys.path[:0] = [{str(tmp_path)!r}, {str(root)!r}]; import kept"
    answers = [
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            cwd=tmp_path,
            env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "numba")},
        ).stdout.split()
        for _ in range(2)
    ]
    assert answers == [["compiling", "2"], ["2"]]
