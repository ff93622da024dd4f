"""The game loop: read the hands, change the session, draw, wait for the next frame.

One idea: a frame is a function of the time that has passed; the rate and slow frames change how
smooth it looks and never what happens.
"""

from __future__ import annotations

import gc
from contextlib import suppress
from dataclasses import dataclass, field, replace
from time import perf_counter, thread_time
from typing import TYPE_CHECKING

import pygame

from engine.app import commands
from engine.app.answers import answer
from engine.app.controls import Controls
from engine.app.exporting import Exporter
from engine.app.glide import Glide
from engine.app.hud import Hud, scale_for
from engine.app.inputs import CloseAsked, Input
from engine.app.keeping import shown_path
from engine.app.labels import shown_variant
from engine.app.opening import open_variant
from engine.app.overlay import draw_called
from engine.app.pages import MENU, Page, draw_page
from engine.app.pen import Pen
from engine.app.screen import Screen
from engine.app.session import SHOWING, Mode
from engine.app.speaker import Speaker
from engine.app.starting import draw_start
from engine.app.steps import act, pass_time, take_up
from engine.app.syncing import Syncer
from engine.app.trouble import ScriptTrouble, told
from engine.app.units import Units
from engine.app.view import View, camera_of, followed_place, stroke_seen, struck_ball
from engine.app.wishes import Ask
from engine.stage.stage import build_stage
from engine.variant.library import VariantError

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.app.inputs import InputEvent
    from engine.app.keeping import Keeper
    from engine.app.panel import Panel
    from engine.app.session import Session
    from engine.app.showing import Showing
    from engine.app.startup import Startup
    from engine.app.watching import Watch
    from engine.app.window import Window
    from engine.app.wishes import Wish
    from engine.scene.camera import Camera
    from engine.table.furniture import Point

SEARCHES = (10_000, 20, 50)
"""How many things are made before garbage is searched for: young, older, old ones."""
PAGE_KEYS = {"up": -1, "down": 1, "page up": -12, "page down": 12}


@dataclass(slots=True)
class Loop:
    """One window with one game in it."""

    window: Window
    session: Session
    showing: Showing
    startup: Startup
    keeper: Keeper
    watch: Watch
    renderer: str = "scanline"
    rate: int = 60
    text: float = 1.0
    theme: str = "dark"
    units: Units = Units.METRIC
    letters: bool = False
    speaker: Speaker = field(default_factory=Speaker)
    syncer: Syncer = field(default_factory=Syncer)
    view: View = field(default_factory=View)
    glide: Glide = field(default_factory=Glide)
    page: Page | None = None
    scroll: int = 0
    panel: Panel | None = None
    running: bool = True
    wants_another: bool = False
    frames: int = 0
    busy: float = 0.0
    """Seconds that the last frame took, without the wait for the next one."""
    worked: float = 0.0
    """Seconds of them in which this program was at work, not others on the machine."""
    hands: Input = field(default_factory=Input)
    controls: Controls = field(default_factory=Controls)
    hud: Hud = field(init=False)
    exporter: Exporter = field(init=False)
    picture_due: bool = False
    """Whether what is drawn next is to be saved as a picture."""
    _quiet: bool = False
    _rate_shown: float = 0.0
    _camera: Camera | None = None
    _followed: Point | None = None

    def __post_init__(self) -> None:
        self.exporter = Exporter(self.keeper.folder.parent / "pictures")
        pen = Pen(self.window.surface, theme=self.theme)
        self.hud = Hud(pen, self.controls.keyboard.keymap, self.units, letters=self.letters)

    def run(self, each: Callable[[Loop], None] | None = None) -> None:
        """Play until the player quits; `each` is called before every frame.

        Raises what the preparation raised.
        """
        clock = pygame.time.Clock()
        while self.running:
            seconds = clock.tick(self.rate) / 1000.0
            self._rate_shown = clock.get_fps()
            if self.startup.trouble is not None:
                raise self.startup.trouble
            if not self._quiet and self.startup.playable and not self.startup.saying:
                self._quieten()
            if each is not None:
                each(self)
            began, at_work = perf_counter(), thread_time()
            self.frame(self.window.read(), seconds)
            self.busy, self.worked = perf_counter() - began, thread_time() - at_work
        self._leave()

    def _quieten(self) -> None:
        """Take all that was loaded out of the search for garbage, for which a frame would wait."""
        gc.collect()
        gc.freeze()
        gc.set_threshold(*SEARCHES)
        self._quiet = True

    def frame(self, events: list[InputEvent], seconds: float) -> None:
        """Do one frame: take in `events`, let `seconds` pass, draw."""
        self.hands.feed(events)
        if any(isinstance(event, CloseAsked) for event in events):
            self.running = False
            return
        self._fit()
        if not self.startup.playable:
            self._draw_start()
        else:
            self._look_at_files()
            if made := self.exporter.take():
                self.note(made)
            self._take(events, seconds)
            before = self.session
            self.enter(pass_time(before, seconds, at_table=self.page is None))
            self.speaker.follow(before, self.session)
            self._look(seconds)
            self.draw()
            self._save_picture()
        self.window.show()
        self.frames += 1

    def _fit(self) -> None:
        """Take up the window's size."""
        self.hud.pen.surface = self.window.surface
        self.hud.pen.scale = scale_for(self.window.size, self.text)

    def screen(self) -> Screen:
        """Return where things are on the screen now."""
        camera = self._camera or self._wanted_camera()
        return Screen(self.hud.picture_box(), camera, self.view.camera, dict(self.hud.hot))

    def _look(self, seconds: float) -> None:
        """Let the eye go on its way to where it should be."""
        session = self.session
        moment = session.is_showing, len(session.match.played), session.mode is Mode.PLACING
        view = self.view.camera, self.view.followed, moment
        self._camera = self.glide.look(self._wanted_camera(), view, seconds)

    def _wanted_camera(self) -> Camera:
        """Return the camera as the view has it."""
        box, session = self.hud.picture_box(), self.session
        ball, heading = stroke_seen(session)
        if self.view.camera == "follow":
            places = self.showing.places(session)
            struck = struck_ball(session)
            self._followed = followed_place(self.view, places, struck, self._followed)
        table, size = session.variant.world.table, (box[2], box[3])
        return camera_of(self.view, table, size, ball, heading, self._followed)

    def _take(self, events: list[InputEvent], seconds: float) -> None:
        if self.page is not None:
            self._turn_page(events)
            return
        for wish in self.controls.read(self.hands, events, self.session, self.screen(), seconds):
            self._do(wish)

    def _turn_page(self, events: list[InputEvent]) -> None:
        """Let the keys and the mouse move the page that is open."""
        if self.panel is not None:
            self._hear_panel(self.panel)
            self._click_page(events)
            return
        self.scroll -= 3 * self.hands.wheel
        for key in self.hands.pressed:
            self.scroll += PAGE_KEYS.get(key, 0)
            if self.page is Page.MENU and key in ("up", "down"):
                self.scroll %= len(MENU)
            if self.page is Page.MENU and key in ("return", "enter", "space"):
                answer(self, Ask(MENU[min(max(self.scroll, 0), len(MENU) - 1)][0]))
                return
            if key in ("escape", "f1", "f2", "h", "return", "enter", "space"):
                self.page = None
                return
        self._click_page(events)

    def _click_page(self, events: list[InputEvent]) -> None:
        """Let the mouse ask for what stands on the page that is open."""
        screen = self.screen()
        for wish in self.controls.read(
            Input(mouse=self.hands.mouse), events, self.session, screen, 0.0
        ):
            if isinstance(wish, Ask):
                self._do(wish)

    def _hear_panel(self, panel: Panel) -> None:
        """Let the keys set what stands on the page that is open."""
        for key in self.hands.pressed:
            match key:
                case "up" | "down":
                    self.scroll = (self.scroll + PAGE_KEYS[key]) % len(panel.rows)
                case "left" | "right":
                    many = 10 if self.hands.shift else 1
                    panel = panel.stepped(self.scroll, many if key == "right" else -many)
                case "return" | "enter" | "space":
                    self.page, self.panel = None, None
                    self._accept(panel)
                    return
                case "escape":
                    self.page, self.panel = None, None
                    return
        self.panel = panel

    def _accept(self, panel: Panel) -> None:
        try:
            self.enter(panel.accept(self.session))
        except ScriptTrouble as trouble:
            words = told(trouble, self.session.variant)
            self.session = replace(self.session, trouble=words)

    def _look_at_files(self) -> None:
        """Take up the game's files where they have changed, or say what is wrong with them."""
        if self.session.mode in SHOWING or not self.watch.changed():
            return
        try:
            variant = open_variant(self.session.variant.path)
        except VariantError as trouble:
            self.session = replace(self.session, trouble=str(trouble))
            return
        session = take_up(self.session, variant)
        self.enter(session)
        if not session.trouble:
            self.build_stage()

    def build_stage(self) -> None:
        """Build anew what is seen of the game, with letters on every ball or without."""
        variant = shown_variant(self.session.variant, letters=self.letters)
        self.showing.stage = build_stage(variant)
        self.hud.letters = self.letters

    def _do(self, wish: Wish) -> None:
        if isinstance(wish, Ask):
            answer(self, wish)
            return
        before = self.session
        self.enter(act(before, wish))
        if isinstance(wish, commands.Confirm) and self.session.mode is Mode.STRIKING:
            self.scroll = 0

    def enter(self, session: Session) -> None:
        """Take up another session; what it changed of the match is kept at once."""
        before, self.session = self.session, session
        if session.match is before.match:
            return
        try:
            self.keeper.follow(session.match, session.timing.clock.left)
        except OSError as trouble:
            self.note(f"the journal cannot be written: {trouble}")

    def _leave(self) -> None:
        """Note the time that is left, so that the match can be gone on with."""
        with suppress(OSError):
            self.keeper.leave(self.session.timing.clock.left)
        self.syncer.close()

    def _save_picture(self) -> None:
        """Save what was drawn, where that was asked for."""
        if not self.picture_due:
            return
        self.picture_due = False
        path = self.exporter.path("picture", self.session.match)
        try:
            self.window.save(path)
        except OSError as trouble:
            self.note(f"the picture could not be saved: {trouble}")
        else:
            self.note(f"saved {shown_path(path)}")

    def note(self, text: str) -> None:
        """Say something to the player."""
        self.session = replace(self.session, note=text)

    def draw(self) -> None:
        """Draw the picture, the display and the page that is open."""
        screen = self.screen()
        renderer = self.startup.pick(self.renderer)
        if renderer is not None:
            scene = self.showing.scene(self.session, screen.camera)
            renderer.render(scene, self.window.part(screen.picture))
            self.window.take_back()
        draw_called(self.hud.pen, self.session, screen)
        self.hud.draw(self.session, self._status())
        if self.page is not None:
            last = draw_page(self.hud, self.page, self.session, self.scroll, self.panel)
            self.scroll = min(max(self.scroll, 0), last)

    def _status(self) -> str:
        ready = self.renderer in self.startup.renderers
        drawn = self.renderer if ready else f"{self.renderer} (being prepared)"
        return f"{drawn}   {self.view.camera}   {self._rate_shown:.0f} fps"

    def _draw_start(self) -> None:
        start = self.startup
        title = self.session.variant.title
        draw_start(self.hud.pen, title, start.saying, start.share, is_first=start.is_first)
