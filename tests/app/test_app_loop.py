"""The real loop in a window without a screen: frames, keys, drawing, journal."""

import tomllib
from random import Random
from threading import Timer

import numpy as np
import pygame
import pytest

from engine.app.glide import Glide
from engine.app.inputs import ButtonPressed, CloseAsked, KeyPressed, KeyReleased
from engine.app.pages import MENU, Page
from engine.app.play import Sitting, make_loop, newest_journal, play
from engine.app.session import Mode
from engine.app.settings import Settings
from engine.app.startup import Startup
from engine.app.view import View
from engine.app.window import close_window, open_window
from engine.records.journal import resume
from engine.variant.load import load_variant
from tools.scripted.player import Player

pytestmark = pytest.mark.xdist_group("window")


@pytest.fixture
def loop(own_folders, start):
    window = open_window((900, 600), "test")
    match = start("three_cushion").match
    startup = Startup("scanline")
    startup.begin()
    sitting = Sitting(match, own_folders / "journal.toml")
    made = make_loop(window, sitting, Settings.model_validate({}), startup)
    made.startup.join()
    assert made.startup.trouble is None
    yield made
    close_window()


def press(loop, *keys):
    for key in keys:
        loop.frame([KeyPressed(key), KeyReleased(key)], 1.0 / 60.0)


def picture(loop):
    return pygame.surfarray.array3d(loop.window.surface).copy()


def test_a_frame_draws_a_table(loop):
    loop.frame([], 0.0)
    assert len(np.unique(picture(loop).reshape(-1, 3), axis=0)) > 100


def test_one_two_three_switch_the_renderer_also_while_balls_roll(loop):
    press(loop, "1")
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space")
    loop.frame([], 0.6)
    assert loop.session.mode is Mode.ROLLING
    seen = {}
    for key in "123":
        loop.frame([KeyPressed(key), KeyReleased(key)], 0.0)
        seen[loop.renderer] = picture(loop)
        assert loop.session.mode is Mode.ROLLING
    assert list(seen) == ["wireframe", "painter", "scanline"]
    assert (seen["wireframe"] != seen["painter"]).mean() > 0.1
    assert (seen["painter"] != seen["scanline"]).mean() > 0.01


def test_the_camera_key_goes_through_four_cameras(loop):
    seen = []
    for _ in range(4):
        press(loop, "c")
        seen.append(loop.view.camera)
    assert sorted(seen) == ["above", "cue", "follow", "orbit"]


def test_a_change_of_camera_is_gone_through_in_time_not_in_frames(loop):
    wanted = {}
    for rate in (30, 120):
        loop.view, loop.glide = View(), Glide()
        loop.frame([], 0.0)
        start = loop.screen().camera
        press(loop, "c")
        for _ in range(rate // 5):
            loop.frame([], 1.0 / rate)
        halfway = loop.screen().camera
        assert halfway.eye != start.eye
        assert loop.glide.is_moving
        for _ in range(rate):
            loop.frame([], 1.0 / rate)
        assert not loop.glide.is_moving
        assert loop.screen().camera.eye != halfway.eye
        wanted[rate] = halfway.eye
    assert wanted[30] == pytest.approx(wanted[120], abs=0.2)


def test_the_camera_goes_along_with_the_ball_that_is_struck(loop):
    loop.glide.time = 0.0
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    while loop.view.camera != "follow":
        press(loop, "c")
    press(loop, "space")
    targets = []
    for _ in range(20):
        loop.frame([], 0.05)
        targets.append(loop.screen().camera.target[:2])
    gone = loop.showing.places(loop.session)[loop.session.cue_ball][:2]
    assert targets[-1] == pytest.approx(gone)
    assert np.hypot(*np.subtract(targets[-1], targets[0])) > 0.1
    loop.frame([KeyPressed("left shift"), KeyPressed("c")], 0.0)
    assert loop.view.followed is not None


def test_the_window_fills_the_screen_and_goes_back(loop):
    before = loop.window.size
    press(loop, "f11")
    assert loop.window.is_full
    loop.frame([], 0.0)
    press(loop, "f11")
    loop.frame([], 0.0)
    assert not loop.window.is_full
    assert loop.window.size == before


def test_a_held_key_turns_as_far_at_any_rate(loop):
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    turned = []
    for rate in (24, 60, 240):
        before = loop.session.stroke.heading
        loop.frame([KeyPressed("left")], 0.0)
        for _ in range(rate):
            loop.frame([], 1.0 / rate)
        loop.frame([KeyReleased("left")], 0.0)
        turned.append((loop.session.stroke.heading - before) % 360.0)
    assert max(turned) - min(turned) <= 1.0
    assert min(turned) > 20.0


def test_pages_open_scroll_and_close(loop):
    press(loop, "f1")
    assert loop.page is Page.HELP
    press(loop, "down", "down")
    assert loop.scroll == 2
    press(loop, "escape")
    assert loop.page is None
    press(loop, "escape")
    assert loop.page is Page.MENU
    press(loop, *["down"] * [name for name, _ in MENU].index("quit"), "return")
    assert not loop.running
    assert not loop.wants_another


def test_up_from_the_head_of_the_menu_goes_to_its_foot_and_down_comes_back(loop):
    press(loop, "escape", "up")
    assert loop.scroll == len(MENU) - 1
    press(loop, "down")
    assert loop.scroll == 0


def test_a_page_keeps_the_keys_from_the_game(loop):
    before = loop.session
    press(loop, "f1", "left", "u", "space")
    assert loop.session.match is before.match
    assert loop.session.stroke == before.stroke


def test_closing_the_window_ends_the_loop(loop):
    loop.frame([CloseAsked()], 0.1)
    assert not loop.running


@pytest.mark.parametrize("size", [(480, 320), (900, 600), (1280, 720), (1920, 1080), (700, 1000)])
def test_any_size_of_window_can_be_drawn(loop, size):
    loop.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE, 32)
    press(loop, "f1")
    press(loop, "escape")
    loop.frame([], 0.0)
    box = loop.hud.picture_box()
    assert box[2] > size[0] // 2
    assert box[1] + box[3] <= size[1]


def test_every_shot_is_in_the_journal_before_the_next(loop, own_folders):
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space")
    kept = resume(own_folders / "journal.toml", load_variant)
    assert len(kept.played) == 1
    assert kept.situation.rest.positions == loop.session.match.situation.rest.positions
    press(loop, "u")
    assert resume(own_folders / "journal.toml", load_variant).played == ()


def test_a_full_disk_is_told_and_the_game_goes_on(loop, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("engine.app.keeping.Keeper.follow", full)
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space")
    assert "No space left" in loop.session.note
    assert loop.session.mode is Mode.STRIKING


def test_f5_saves_the_shot_as_a_record_and_says_where(loop, own_folders):
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space", "f", "f5")
    assert loop.session.note.startswith("saved ")
    saved = list((own_folders / "data").rglob("*.toml"))
    assert len(saved) == 1
    record = tomllib.loads(saved[0].read_text(encoding="utf-8"))
    assert record["variant"] == "three_cushion"
    assert record["shot"][0]["strike"]["speed"] == loop.session.last.shot.strike.speed


def test_a_scripted_player_plays_through_the_real_loop(own_folders):
    player = Player(own_folders, Random(2), most=3, tries=12, fouls_at=(2,))
    status = play(
        "eight_ball",
        seed=5,
        size=(900, 600),
        rate=500,
        journal=own_folders / "match.toml",
        each=player.each,
    )
    assert status == 0
    assert player.strokes == 3
    assert len(player.pictures) > 15
    assert resume(own_folders / "match.toml", load_variant).played


def test_a_killed_match_is_gone_on_with(own_folders):
    first = Player(own_folders, Random(1), most=1, fouls_at=())
    path = own_folders / "match.toml"
    assert play("three_cushion", seed=5, rate=500, journal=path, each=first.each) == 0
    seen = []

    def look(loop):
        seen.append(len(loop.session.match.played))
        loop.running = False

    assert play("three_cushion", resume=True, journal=path, each=look) == 0
    assert seen[0] == 1


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"variant": "eight_bal"}, "eight_ball"),
        ({"variant": "three_cushion", "players": 9}, "players"),
        ({"variant": "three_cushion", "settings": {"taget": "5"}}, "target"),
        ({"variant": "three_cushion", "settings": {"target": "many"}}, "whole number"),
        ({"variant": "three_cushion", "rate": 0}, "rate"),
        ({"variant": "three_cushion", "names": ("A", "B", "C")}, "3 names are too many"),
        ({"variant": "three_cushion", "renderer": "oil"}, "wireframe"),
        ({"variant": "three_cushion", "resume": True}, "no match"),
        ({"variant": "three_cushion", "resume": "nowhere.toml"}, "nowhere.toml"),
    ],
)
@pytest.mark.usefixtures("own_folders")
def test_a_mistake_of_the_player_is_one_clear_line(capsys, asked, words):
    assert play(**asked) == 2
    told = capsys.readouterr().err
    assert words in told
    assert "Traceback" not in told


def test_a_bad_settings_file_is_told_with_its_place_and_the_game_goes_on(own_folders, capsys):
    folder = own_folders / "config" / "headstring"
    folder.mkdir(parents=True)
    text = (
        'rate = 0\nnames = ["Ann", "Bo", "Cy"]\ntheme = "light"\ncamera = "orbit"\nsmooth = false\n'
    )
    (folder / "settings.toml").write_text(text, encoding="utf-8")
    seen = []

    def look(loop):
        seen.append(loop)
        loop.running = False

    assert play("three_cushion", each=look) == 0
    assert "settings.toml:1:8: rate" in capsys.readouterr().err
    assert "settings.toml:1:8: rate" in seen[0].session.note
    assert seen[0].session.names == ("Ann", "Bo")
    assert seen[0].hud.pen.theme == "light"
    assert seen[0].view.camera == "orbit"
    assert seen[0].glide.time == 0.0
    assert seen[0].rate == 60


@pytest.mark.usefixtures("own_folders")
def test_without_a_screen_the_player_is_told(capsys, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "x11")
    monkeypatch.setenv("DISPLAY", ":987")
    pygame.display.quit()
    assert play("three_cushion") == 2
    assert "no window can be opened" in capsys.readouterr().err


def test_the_newest_journal_is_the_one_to_resume(own_folders):
    folder = own_folders / "data" / "headstring" / "journals"
    folder.mkdir(parents=True)
    for name in ("three_cushion-20200101-000000.toml", "three_cushion-20300101-000000.toml"):
        (folder / name).write_text("", encoding="utf-8")
    assert newest_journal("three_cushion").name == "three_cushion-20300101-000000.toml"


def opened(loop, name):
    press(loop, name)
    return loop.page


def test_what_an_eye_saw_is_set_by_keys_alone(own_folders, start):
    window = open_window((900, 600), "test")
    sitting = Sitting(start("snooker").match, own_folders / "journal.toml")
    startup = Startup("wireframe")
    startup.begin()
    made = make_loop(window, sitting, Settings.model_validate({"renderer": "wireframe"}), startup)
    made.startup.join()
    assert opened(made, "z") is None
    assert "no shot" in made.session.note
    press(made, "return", "space", "f")
    assert opened(made, "z") is Page.FACTS
    press(made, "down", "right", "return")
    assert made.page is None
    assert made.session.last.shot.facts == {"path": "full"}
    kept = resume(own_folders / "journal.toml", load_variant)
    assert kept.played[-1].shot.facts == {"path": "full"}
    assert len(kept.played) == 1
    close_window()


def test_the_cloth_is_looked_at_and_changed_by_keys_alone(loop):
    world = loop.session.variant.world
    assert opened(loop, "f10") is Page.CLOTH
    press(loop, "down", "right", "escape")
    assert loop.session.variant.world is world
    press(loop, "f10", "down", "right", "right", "return")
    assert loop.session.variant.world.cloth.rolling > world.cloth.rolling
    assert "practice" in loop.session.note
    assert loop.page is None


def test_a_row_is_changed_by_a_click(loop):
    press(loop, "f10")
    left, top, wide, high = loop.hud.hot["ask:value-1"]
    before = loop.panel.rows
    loop.frame([ButtonPressed(1, (left + wide // 2, top + high // 2))], 0.0)
    assert loop.panel.rows[1] != before[1]
    assert loop.scroll == 1


def test_pictures_are_saved_without_the_menu_on_them(loop, own_folders):
    loop.frame([], 0.0)
    plain = picture(loop)
    press(loop, "escape", *["down"] * [name for name, _ in MENU].index("picture"), "return")
    loop.frame([], 0.0)
    (path,) = (own_folders / "data" / "headstring" / "pictures").glob("*-picture.png")
    saved = pygame.surfarray.array3d(pygame.image.load(path))
    box = loop.hud.picture_box()
    inside = np.s_[box[0] : box[0] + box[2], box[1] : box[1] + box[3]]
    assert np.array_equal(saved[inside], plain[inside])
    assert loop.session.note.startswith("saved ")


def test_a_clip_is_made_while_the_game_goes_on(loop, monkeypatch):
    monkeypatch.setattr("engine.app.clip.RATE", 4)
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space", "f", "f8")
    assert "being made" in loop.session.note
    loop.exporter.join()
    loop.frame([], 0.0)
    assert loop.session.note.startswith("saved ")


def test_letters_come_and_go_on_every_ball(loop):
    press(loop, "3")
    loop.frame([], 0.0)
    plain = picture(loop)
    press(loop, "f4")
    assert loop.letters
    assert (picture(loop) != plain).any()
    press(loop, "f4")
    assert np.array_equal(picture(loop), plain)


def test_space_halts_what_is_shown_and_the_brackets_change_its_pace(loop):
    if loop.session.mode is Mode.PLACING:
        press(loop, "return")
    press(loop, "space")
    loop.frame([], 0.6)
    press(loop, "space")
    clock = loop.session.clock
    loop.frame([], 0.5)
    assert loop.session.clock == clock
    press(loop, "'")
    assert loop.session.clock > clock
    press(loop, "[", "space")
    assert loop.session.pace == 0.5


def test_memory_that_is_given_back_late_is_waited_for(loop):
    loop.frame([], 0.0)
    held = [loop.window.part((0, 0, 10, 10))]
    assert loop.window.surface.get_locked()
    Timer(0.003, held.clear).start()
    loop.window.take_back()
    assert not loop.window.surface.get_locked()
