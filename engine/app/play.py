"""Playing a game in a window: from a variant's name to the end of the evening.

One idea: whatever is wrong is found and said in one line before a window opens. Invariant:
nobody sees a traceback for a mistake of his own.
"""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING

from engine.app.opening import open_variant
from engine.app.settings import Settings, data_folder, read_settings
from engine.app.trouble import ScriptTrouble
from engine.game.match import SettingError, start_match
from engine.variant.library import VariantError
from engine.variant.load import list_variants

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from engine.app.evening import Reception
    from engine.app.lobby import Chosen
    from engine.app.loop import Loop
    from engine.app.startup import Startup
    from engine.app.window import Window
    from engine.game.match import Match
    from engine.variant.variant import Value, Variant


@dataclass(frozen=True, slots=True)
class Sitting:
    """A match to be played, its journal, and whether that goes on or begins."""

    match: Match
    journal: Path
    goes_on: bool = False


MOST_KEPT = 30
"""Matches of a game that the start screen offers to go on with."""


class PlayError(ValueError):
    """Something that the player asked for cannot be; the message is one line."""


def play(
    variant: str | Path | None = None,
    players: int | None = None,
    settings: Mapping[str, str] | None = None,
    renderer: str | None = None,
    size: tuple[int, int] | None = None,
    rate: int | None = None,
    seed: int | None = None,
    resume: str | Path | bool = False,  # noqa: FBT001, FBT002  a flag or a path
    journal: str | Path | None = None,
    each: Callable[[Loop], None] | None = None,
    names: Sequence[str] = (),
    full_screen: bool | None = None,  # noqa: FBT001  a flag that may be left out
) -> int:
    """Play games in a window until the player quits; return the exit status.

    Without a `variant` the start screen lists all games. `names` are the players', `settings` the
    variant's, as text. `resume` is the path of a journal, or True for
    `journal`, or without one the newest of this variant. `each` is called with the loop before
    every frame.
    Status 2: what was asked for cannot be, told on stderr.
    """
    try:
        found = read_settings()
        for trouble in found.troubles:
            print(trouble, file=sys.stderr)  # noqa: T201  and the game goes on
        wishes = _with(found.settings, renderer, size, rate, full_screen=full_screen)
        first = None
        if variant is not None:
            first = _match(variant, players, settings or {}, seed, resume, journal, tuple(names))
            if not (resume or names):
                first = replace(first, match=_usually_named(first.match, wishes.names))
        run(first, wishes, each=each, note=" ".join(found.troubles[:1]))
    except (PlayError, SettingError, VariantError, *ScriptTrouble) as trouble:
        print(trouble, file=sys.stderr)  # noqa: T201  the way out is said here
        return 2
    except KeyboardInterrupt:
        return 130
    return 0


def _with(
    settings: Settings,
    renderer: str | None,
    size: tuple[int, int] | None,
    rate: int | None,
    *,
    full_screen: bool | None = None,
) -> Settings:
    """Return the settings with what the command line says instead."""
    given: dict[str, object] = {"renderer": renderer, "rate": rate, "full_screen": full_screen}
    given |= {"width": size[0], "height": size[1]} if size else {}
    said = {key: value for key, value in given.items() if value is not None}
    try:
        return Settings.model_validate(settings.model_dump() | said)
    except ValueError as trouble:
        wrong = ", ".join(f"{key} {value}" for key, value in said.items())
        known = "renderer wireframe, painter or scanline; rate 1 to 1000; size 480x320 or more"
        raise PlayError(f"this does not fit: {wrong}; use {known}") from trouble


def _match(
    name: str | Path,
    players: int | None,
    settings: Mapping[str, str],
    seed: int | None,
    resume: str | Path | bool,  # noqa: FBT001  a flag or a path
    journal: str | Path | None,
    names: tuple[str, ...] = (),
) -> Sitting:
    """Return the match, and where and how it is kept."""
    variant = open_variant(name)
    if resume and names:
        raise PlayError("a match that is gone on with has its names already; leave --name out")
    if resume:
        path = _journal_to_resume(variant.name, resume, journal)
        match = _resumed(path)
        if match.variant.name != variant.name:
            raise PlayError(f"{path} holds a match of {match.variant.name}, not of {variant.name}")
        return Sitting(match, path, goes_on=True)
    chosen = {key: read_value(variant, key, text) for key, text in settings.items()}
    return _fresh(variant, players, chosen, seed, journal, names)


def _fresh(
    variant: Variant,
    players: int | None,
    settings: Mapping[str, Value],
    seed: int | None = None,
    journal: str | Path | None = None,
    names: tuple[str, ...] = (),
) -> Sitting:
    now = datetime.now(tz=UTC)
    lot = int(now.timestamp()) % 1_000_000 if seed is None else seed
    stem = f"{variant.name}-{now.strftime('%Y%m%d-%H%M%S')}.toml"
    path = Path(journal) if journal else data_folder() / "journals" / stem
    least, most, usual = variant.players
    count = min(max(len(names), usual, least), most) if players is None else players
    return Sitting(named(start_match(variant, count, settings, lot), names), path)


def named(match: Match, names: tuple[str, ...]) -> Match:
    """Return the match with its players' names; raises PlayError for more than there are."""
    count = match.situation.players
    if len(names) > count:
        raise PlayError(f"{len(names)} names are too many: there are {count} players")
    return replace(match, names=tuple(name.strip() for name in names))


def _usually_named(match: Match, names: Sequence[str]) -> Match:
    """Return the match with the names of the settings, as far as there are players for them."""
    return named(match, tuple(names)[: match.situation.players])


def _chosen(chosen: Chosen) -> Sitting:
    """Return the match that was chosen on the start screen."""
    if chosen.kept is not None:
        return Sitting(_resumed(chosen.kept), chosen.kept, goes_on=True)
    variant = open_variant(chosen.name)
    return _fresh(variant, chosen.players, chosen.settings, names=chosen.names)


def _journal_to_resume(
    name: str,
    resume: str | Path | bool,  # noqa: FBT001  a flag or a path
    journal: str | Path | None,
) -> Path:
    if resume is not True:
        return Path(str(resume))
    return Path(journal) if journal else newest_journal(name)


def _resumed(path: Path) -> Match:
    from engine.records.journal import resume  # noqa: PLC0415
    from engine.records.record import RecordError  # noqa: PLC0415

    try:
        return resume(path, open_variant)
    except OSError as trouble:
        raise PlayError(f"{path}: cannot be read: {trouble.strerror}") from trouble
    except RecordError as trouble:
        raise PlayError(f"{path} is no journal to go on with: {trouble}") from trouble


def newest_journal(name: str) -> Path:
    """Return the newest journal of a variant; raises PlayError where there is none."""
    found = _kept(name)
    if not found:
        raise PlayError(f"there is no match of {name} to go on with; leave --resume out")
    return found[0]


def _kept(name: str) -> tuple[Path, ...]:
    """Return the journals of a variant, newest first."""
    found = (data_folder() / "journals").glob(f"{name}-[0-9]*.toml")
    return tuple(sorted(found, reverse=True)[:MOST_KEPT])


def read_value(variant: Variant, key: str, text: str) -> Value:
    """Return a setting's value from text, by the kind of its default.

    Raises SettingError for a setting that the variant does not have, or that does not read so.
    """
    if key not in variant.settings:
        known = ", ".join(variant.settings)
        has = f"; it has: {known}" if known else ": it has none"
        raise SettingError(f"{variant.title} has no setting {key}{has}")
    default = variant.settings[key].default
    if isinstance(default, bool):
        words = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}
        if text.lower() not in words:
            raise SettingError(f"the setting {key} is true or false, not {text!r}")
        return words[text.lower()]
    if isinstance(default, int):
        try:
            return int(text)
        except ValueError:
            raise SettingError(f"the setting {key} is a whole number, not {text!r}") from None
    return text


def run(
    first: Sitting | None,
    settings: Settings,
    *,
    each: Callable[[Loop], None] | None = None,
    greet: Callable[[Reception], None] | None = None,
    note: str = "",
) -> None:
    """Open a window and play in it: the `first` match, else what is chosen on the start screen.

    `note` is said at the first table. `each` is called with the loop, `greet` with the start
    screen, before every frame. Raises PlayError where no window can be opened.
    """
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "hide")
    from engine.app.pen import Pen  # noqa: PLC0415  pygame is loaded for a window only
    from engine.app.starting import draw_start  # noqa: PLC0415
    from engine.app.window import NoWindowError, close_window, open_window  # noqa: PLC0415

    title = first.match.variant.title if first else "Headstring"
    try:
        window = open_window((settings.width, settings.height), title)
    except NoWindowError as trouble:
        raise PlayError(f"no window can be opened: {trouble}") from trouble
    if settings.full_screen:
        window.toggle_full_screen()
    pen = Pen(window.surface, theme=settings.theme)
    draw_start(pen, title, "starting ...", 0.0, is_first=False)
    window.show()
    from engine.app.startup import Startup  # noqa: PLC0415  after the window

    startup = Startup(settings.renderer)
    startup.begin()
    try:
        sitting = first or _receive(window, settings, startup, "", greet)
        while sitting is not None:
            window.entitle(sitting.match.variant.title)
            loop = make_loop(window, sitting, settings, startup)
            loop.session, note = replace(loop.session, note=note), ""
            loop.run(each)
            name = sitting.match.variant.name
            more = loop.wants_another
            sitting = _receive(window, settings, startup, name, greet) if more else None
    finally:
        close_window()


def _receive(
    window: Window,
    settings: Settings,
    startup: Startup,
    last: str,
    greet: Callable[[Reception], None] | None,
) -> Sitting | None:
    """Return the match chosen on the start screen, which begins at the game played last.

    None where the player leaves.
    """
    from engine.app.evening import Reception  # noqa: PLC0415  pygame
    from engine.app.lobby import Entry, open_lobby  # noqa: PLC0415

    games = [Entry(one.name, one.title, _kept(one.name)) for one in list_variants()]
    lobby = open_lobby(games, last, tuple(settings.names))
    while True:
        lobby = Reception(window, lobby, startup, settings).run(greet)
        if lobby.chosen is None:
            return None
        try:
            return _chosen(lobby.chosen)
        except (PlayError, SettingError, VariantError, *ScriptTrouble) as trouble:
            lobby = replace(lobby, chosen=None, card=None, trouble=str(trouble))


def make_loop(window: Window, sitting: Sitting, settings: Settings, startup: Startup) -> Loop:
    """Return the loop of a match in a window that is open, its preparation begun."""
    from engine.app.before import begin  # noqa: PLC0415
    from engine.app.controls import Controls  # noqa: PLC0415  the window comes before the rest
    from engine.app.glide import TIME, Glide  # noqa: PLC0415
    from engine.app.keeping import Keeper  # noqa: PLC0415
    from engine.app.keyboard import Keyboard  # noqa: PLC0415
    from engine.app.labels import shown_variant  # noqa: PLC0415
    from engine.app.loop import Loop  # noqa: PLC0415
    from engine.app.session import Aid  # noqa: PLC0415
    from engine.app.showing import Showing  # noqa: PLC0415
    from engine.app.speaker import LOUD, Speaker  # noqa: PLC0415
    from engine.app.syncing import Syncer  # noqa: PLC0415
    from engine.app.timing import timing_of  # noqa: PLC0415
    from engine.app.units import Units  # noqa: PLC0415
    from engine.app.view import View  # noqa: PLC0415
    from engine.app.watching import watch_variant  # noqa: PLC0415
    from engine.game.placing import prepare_places  # noqa: PLC0415
    from engine.records.journal import times_of  # noqa: PLC0415
    from engine.stage.stage import build_stage  # noqa: PLC0415

    match = sitting.match
    syncer = Syncer()
    keeper = Keeper(sitting.journal, data_folder() / "shots", syncer.sync)
    try:
        (keeper.carry_on if sitting.goes_on else keeper.start)(match)
    except OSError as trouble:
        message = f"{sitting.journal}: the journal cannot be written: {trouble}"
        raise PlayError(message) from trouble
    Thread(target=prepare_places, args=(match.variant,), name="places", daemon=True).start()
    times = times_of(sitting.journal) if sitting.goes_on else {}
    return Loop(
        window=window,
        session=begin(match, aid=Aid(settings.aid), timing=timing_of(match, times)),
        showing=Showing(build_stage(shown_variant(match.variant, letters=settings.colour_safe))),
        startup=startup,
        keeper=keeper,
        watch=watch_variant(match.variant),
        syncer=syncer,
        renderer=settings.renderer,
        rate=settings.rate,
        text=settings.text,
        theme=settings.theme,
        units=Units(settings.units),
        letters=settings.colour_safe,
        view=View(settings.camera),
        glide=Glide(TIME if settings.smooth else 0.0),
        speaker=Speaker(settings.volume or LOUD, muted=not settings.volume),
        controls=Controls(Keyboard(settings.keymap)),
    )
