"""Closes the hole between a fuzzer that runs and one that would notice."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

from tools.fuzz import Coverage, Reader, fuzz, readers, spoiled


def test_it_finds_what_raises_and_keeps_it(tmp_path: Path) -> None:
    def read(data: bytes) -> None:
        if b"foul" in data and b"\xff" in data:
            raise ValueError("found")

    reader = Reader("script", read, [b"if 8-ball pocketed: foul x\n", b"\xff"])
    found = list(fuzz(reader, 0.05, 3, tmp_path))
    assert len(found) == 1
    assert "ValueError: found" in found[0]
    (kept,) = tmp_path.iterdir()
    with pytest.raises(ValueError, match="found"):
        read(kept.read_bytes())


def test_an_input_that_runs_a_new_line_is_told() -> None:
    coverage = Coverage()
    reader = readers(Path())["script"]
    assert coverage.run(reader.read, b"if 8-ball pocketed: foul x\n")
    assert not coverage.run(reader.read, b"if 8-ball pocketed: foul x\n")
    assert coverage.run(reader.read, b"if 8-ball is pocketed: foul x\n")


@pytest.mark.parametrize("name", ["script", "variant", "record"])
def test_every_reader_stands_what_is_spoiled(tmp_path: Path, name: str) -> None:
    chance = random.Random(1)
    reader = readers(tmp_path)[name]
    small = [seed for seed in reader.seeds if len(seed) < 3000]
    for _ in range(12):
        reader.read(spoiled(chance.choice(small), chance.choice(small), chance))
