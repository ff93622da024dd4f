"""The bar above the picture: nothing of it is cut at the usual size of a window."""

from dataclasses import replace

import pygame
import pytest

from engine.app.before import begin
from engine.app.board import board_of
from engine.app.hud import TOP, Hud
from engine.app.pen import Pen
from engine.game.match import start_match
from engine.variant.load import list_variants, load_variant


@pytest.fixture
def drawn(monkeypatch):
    pygame.freetype.init()
    cut = []
    fitted = Pen.fitted

    def watched(self, text, size, room):
        shown = fitted(self, text, size, room)
        cut.extend([] if shown == text else [text])
        return shown

    monkeypatch.setattr(Pen, "fitted", watched)
    hud = Hud(Pen(pygame.Surface((1280, TOP))))

    def draw(session):
        cut.clear()
        hud._top(board_of(session), "scanline (being prepared)   above   60 fps")
        return list(cut)

    return draw


def test_the_head_of_every_game_with_any_number_of_players_is_whole(drawn):
    for one in list_variants():
        variant = load_variant(one.name)
        for players in sorted(set(variant.players)):
            session = begin(start_match(variant, players, {}, 1))
            told = drawn(session)
            assert not told, (one.name, players)


def test_a_long_name_is_cut_before_it_covers_the_next(drawn, start):
    session = start("three_cushion")
    long = begin(replace(session.match, names=("W" * 80, "Bo")))
    assert drawn(long) == ["W" * 80]
