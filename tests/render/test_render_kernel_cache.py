"""Compiled kernels that may be out of date are dropped; the others stay."""

import os

from engine.render.kernel_cache import drop_stale


def test_only_what_is_older_than_the_newest_source_goes(tmp_path):
    sources, cache = tmp_path / "sources", tmp_path / "cache"
    sources.mkdir()
    cache.mkdir()
    for name, age in (("inner.py", 100.0), ("outer.py", 900.0)):
        (sources / name).write_text("@njit")
        os.utime(sources / name, (5000.0 - age, 5000.0 - age))
    ages = {"outer.old-1.py311.nbi": 4500.0, "outer.new-2.py311.nbi": 4950.0, "other.x.nbi": 1.0}
    for name, when in ages.items():
        (cache / name).write_text("")
        os.utime(cache / name, (when, when))
    (sources / "plain.py").write_text("")
    assert drop_stale(cache, sources) == ["outer.old-1.py311.nbi"]
    assert sorted(p.name for p in cache.iterdir()) == ["other.x.nbi", "outer.new-2.py311.nbi"]
    assert drop_stale(cache, sources) == []


def test_a_missing_cache_is_no_trouble(tmp_path):
    (tmp_path / "a.py").write_text("")
    assert drop_stale(tmp_path / "none", tmp_path) == []
