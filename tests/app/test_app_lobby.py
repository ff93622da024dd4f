"""The start screen: found by typing, set by keys, played and come back to."""

from dataclasses import replace

import pygame
import pytest

from engine.app.evening import Reception
from engine.app.inputs import LEFT, ButtonPressed, CloseAsked, Input, KeyPressed
from engine.app.lobby import Entry, change, choose, hear, open_lobby, pick
from engine.app.lobby_table import draw_table
from engine.app.play import play, run
from engine.app.settings import Settings
from engine.app.startup import Startup
from engine.app.window import close_window, open_window
from engine.variant.load import list_variants, load_variant
from engine.variant.rack import lay_rack

window_test = pytest.mark.xdist_group("window")


@pytest.fixture
def lobby(tmp_path):
    names = ("eight_ball", "one_cushion", "snooker", "three_cushion")
    entries = [Entry(name, name.replace("_", "-").title()) for name in names]
    entries[2] = replace(entries[2], kept=(tmp_path / "kept.toml", tmp_path / "older.toml"))
    return open_lobby(entries, "snooker")


def keyed(lobby, *keys, shift=False):
    for key in keys:
        held = {"left shift"} if shift else set()
        lobby = hear(lobby, Input(pressed=[key], held=held))
    return lobby


def carded(lobby):
    return replace(lobby, card=load_variant(lobby.entry.name))


def test_it_opens_at_the_game_played_last(lobby):
    assert lobby.entry.name == "snooker"


def test_a_ball_of_the_colour_of_the_cloth_is_seen_on_the_plan():
    variant = load_variant("snooker")
    surface = pygame.Surface((900, 500))
    draw_table(surface, variant, (0, 0, 900, 500))
    table, (x, y) = variant.world.table, lay_rack(variant.rack, 1)["green"]
    scale = 900 / (table.length + 2.0 * table.rail_width)
    left = round(450 + scale * x) - 8
    level = round(scale * (table.width / 2.0 + table.rail_width - y))
    row = [surface.get_at((left + step, level))[:3] for step in range(17)]
    edge = tuple(part // 3 for part in variant.look.cloth)
    assert row.count(edge) >= 2


def test_nothing_is_being_prepared_when_all_is_ready(monkeypatch):
    monkeypatch.setattr(Startup, "_warm", lambda self, name, *_: setattr(self, "saying", name))
    startup = Startup("scanline")
    startup._prepare()
    assert startup.saying == ""


def test_typing_finds_games_by_any_word(lobby):
    found = keyed(lobby, *"cush")
    assert [one.name for one in found.shown] == ["one_cushion", "three_cushion"]
    assert keyed(found, "backspace", "space", *"thr").entry.name == "three_cushion"
    assert keyed(found, "escape").shown == lobby.entries


def test_a_game_that_is_called_just_so_comes_first():
    entries = [Entry("american_snooker", "American snooker"), Entry("snooker", "Snooker")]
    lobby = keyed(open_lobby(entries), *"snooker")
    assert [one.name for one in lobby.shown] == ["snooker", "american_snooker"]


def test_a_word_that_no_game_has_leaves_none_to_play(lobby):
    none = keyed(lobby, *"xyz", "return")
    assert none.entry is None
    assert none.chosen is None


def test_the_ends_of_the_list_hold(lobby):
    assert keyed(lobby, *["down"] * 9).entry.name == "three_cushion"
    assert keyed(lobby, *["up"] * 9).entry.name == "eight_ball"


def test_nothing_is_chosen_before_the_game_is_loaded(lobby):
    assert choose(lobby).chosen is None


def test_a_number_is_set_within_its_bounds():
    lobby = carded(open_lobby([Entry("three_cushion", "Three-cushion")]))
    row = lobby.rows.index("target")
    more = keyed(lobby, *["tab"] * row, "right", "right")
    assert more.value("target") == lobby.value("target") + 2
    least = keyed(more, *["left"] * 500)
    assert least.value("target") == max(lobby.card.settings["target"].least or 0, 0)
    assert choose(more).chosen.settings == {"target": more.value("target")}


def test_what_was_set_is_forgotten_with_another_game(lobby):
    there = change(carded(lobby), "match", 1)
    assert there.match == 1
    assert pick(there, 0).match == 0


def test_a_kept_match_can_be_gone_on_with(lobby, tmp_path):
    on = change(carded(lobby), "match", 1)
    assert choose(on).chosen.kept == tmp_path / "kept.toml"
    assert choose(change(on, "match", 1)).chosen.kept == tmp_path / "older.toml"
    assert choose(change(on, "match", 2)).chosen.kept is None
    assert choose(carded(lobby)).chosen.kept is None


def typed(lobby, text):
    for letter in text:
        lobby = hear(lobby, Input(pressed=[letter.lower()], typed=letter))
    return lobby


def test_names_are_typed_where_they_stand_and_go_with_the_match(lobby):
    lobby = carded(lobby)
    first = keyed(lobby, *["tab"] * lobby.rows.index("name 1"))
    first = keyed(typed(first, "Änne 2x"), "backspace")
    assert first.entry.name == "snooker"
    both = typed(keyed(first, "tab"), "Bo")
    assert choose(both).chosen.names == ("Änne 2", "Bo")
    again = pick(both, 0)
    assert choose(carded(again)).chosen.names == ("Änne 2", "Bo")


def test_a_name_has_an_end_and_other_players_names_are_left_out(lobby):
    lobby = replace(carded(lobby), names=("A", "B", "C", "D"))
    assert choose(lobby).chosen.names == ("A", "B")
    long = typed(keyed(lobby, *["tab"] * lobby.rows.index("name 2")), "x" * 50)
    assert len(choose(long).chosen.names[1]) == 20


def test_every_setting_of_every_game_can_be_stepped():
    for one in list_variants():
        lobby = carded(open_lobby([Entry(one.name, one.title)]))
        for row in lobby.rows[1:]:
            for by in (1, -1, -1):
                lobby = change(lobby, row, by)
            value = lobby.value(row)
            if row in lobby.card.settings and lobby.card.settings[row].choices:
                assert value in lobby.card.settings[row].choices


@pytest.fixture
def reception():
    window = open_window((1280, 720), "test")
    entries = [Entry(one.name, one.title) for one in list_variants()]
    made = Reception(window, open_lobby(entries), Startup("wireframe"))
    yield made
    close_window()


@window_test
def test_the_card_of_every_game_is_drawn(reception, monkeypatch):
    monkeypatch.setattr("engine.app.evening.PAUSE", 0.0)
    seen = set()
    for place in range(len(reception.lobby.entries)):
        reception.lobby = pick(reception.lobby, place)
        reception.frame([])
        assert reception.lobby.trouble == ""
        seen.add(pygame.image.tobytes(reception.window.surface, "RGB"))
    assert len(seen) == len(reception.lobby.entries)


@window_test
def test_a_game_that_cannot_be_loaded_is_told_and_not_played(reception, monkeypatch):
    monkeypatch.setattr("engine.app.evening.PAUSE", 0.0)
    reception.lobby = open_lobby([Entry("no_such_game", "None")])
    reception.frame([])
    assert "no_such_game" in reception.lobby.trouble
    reception.frame([KeyPressed("return")])
    assert reception.lobby.chosen is None


@window_test
def test_a_click_on_the_picked_game_plays_it(reception, monkeypatch):
    monkeypatch.setattr("engine.app.evening.PAUSE", 0.0)
    reception.frame([])
    left, top, wide, high = reception.screen.hot["pick:1"]
    click = ButtonPressed(LEFT, (left + wide // 2, top + high // 2))
    reception.frame([click])
    reception.frame([])
    assert reception.lobby.picked == 1
    reception.frame([click])
    assert reception.lobby.chosen.name == reception.lobby.entries[1].name


@window_test
def test_from_the_start_screen_into_a_game_and_back(own_folders):
    told = []

    def greet(reception):
        told.append("lobby")
        if told.count("loop") > 0:
            reception.lobby = replace(reception.lobby, left=True)
        reception.lobby = keyed(reception.lobby, "return")

    def each(loop):
        told.append("loop")
        loop.running, loop.wants_another = False, True

    run(None, Settings.model_validate({"renderer": "wireframe"}), each=each, greet=greet)
    assert told[0] == told[-1] == "lobby"
    assert told.count("loop") == 1
    assert list((own_folders / "data" / "headstring" / "journals").glob("*.toml"))


@window_test
@pytest.mark.usefixtures("own_folders")
def test_leaving_the_start_screen_ends_without_trouble(monkeypatch):
    read = [[CloseAsked()]]
    monkeypatch.setattr("engine.app.window.Window.read", lambda _self: read.pop() if read else [])
    assert play() == 0
