import os

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")

from functools import cache

import pytest

from engine.app.before import begin
from engine.app.session import Session
from engine.game.match import start_match
from engine.variant.load import load_variant


@cache
def variant(name: str):
    return load_variant(name)


@pytest.fixture
def start():
    """Return a function that starts a session of a variant."""

    def started(name: str, seed: int = 1, **settings: object) -> Session:
        return begin(start_match(variant(name), None, settings, seed))

    return started


@pytest.fixture
def own_folders(tmp_path, monkeypatch):
    """Keep the player's folders inside the test's own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path
