"""The player's settings: a TOML file in the folder where the system keeps such files.

One idea: every setting has a default, so the file may be missing; a bad one is told with its place
and what would be right, and its default is taken. Invariant: only this package looks for the
player's folders.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from platformdirs import user_config_dir, user_data_dir
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from engine.app.keymap import Keymap, KeyTroubleError, keymap_of
from engine.variant.report import Report
from engine.variant.source import Node, parse_source

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rulelang.diagnostics import Diagnostic

NAME = "headstring"
RendererName = Literal["wireframe", "painter", "scanline"]
CameraName = Literal["cue", "above", "orbit", "follow"]


class Settings(BaseModel):
    """What the player may set; sizes in pixels, `rate` in frames a second, `keys` by action."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    rate: int = Field(60, ge=1, le=1000)
    renderer: RendererName = "scanline"
    camera: CameraName = "above"
    smooth: bool = True
    width: int = Field(1280, ge=480, le=7680)
    height: int = Field(720, ge=320, le=4320)
    full_screen: bool = False
    theme: Literal["dark", "light"] = "dark"
    text: float = Field(1.0, ge=0.5, le=3.0)
    units: Literal["metric", "imperial"] = "metric"
    colour_safe: bool = False
    volume: float = Field(0.7, ge=0.0, le=1.0)
    aid: Literal["off", "line", "ghost", "object", "all"] = "object"
    names: list[str] = Field(default_factory=list)
    keys: dict[str, str | list[str]] = Field(default_factory=dict)

    @property
    def keymap(self) -> Keymap:
        """Which key does what; raises KeyTroubleError for keys that cannot be used."""
        return keymap_of(self.keys)


@dataclass(frozen=True, slots=True)
class Found:
    """The settings of a file, and what is wrong with it; for that the defaults are taken."""

    settings: Settings
    troubles: tuple[str, ...] = ()


def settings_path() -> Path:
    """Return where the player's settings file is looked for."""
    return Path(user_config_dir(NAME, appauthor=False)) / "settings.toml"


def data_folder() -> Path:
    """Return the folder of the player's journals and saved shots."""
    return Path(user_data_dir(NAME, appauthor=False))


def read_settings(path: Path | None = None) -> Found:
    """Return the settings of a file, the defaults where there is none or where it is wrong."""
    path = path or settings_path()
    default = Settings.model_validate({})
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return Found(default)
    except (OSError, UnicodeDecodeError) as trouble:
        return Found(default, (f"{path}: cannot be read: {trouble}; the defaults are taken",))
    source = parse_source(text, path, path.parent)
    if not isinstance(source, Node):
        return Found(default, tuple(_told(one, "the defaults are taken") for one in source))
    return _checked(source, _floats(tomllib.loads(text)))


def _checked(source: Node, raw: dict[str, object]) -> Found:
    """Return the settings without those that do not fit, each told."""
    report = Report(source, shape=Settings)
    try:
        settings = Settings.model_validate(raw)
    except ValidationError as trouble:
        report.add_shape_errors(trouble, ())
        wrong = {str(one["loc"][0]) for one in trouble.errors(include_url=False)}
        settings = Settings.model_validate({k: v for k, v in raw.items() if k not in wrong})
    keys = dict(settings.keys)
    while True:
        try:
            keymap_of(keys)
        except KeyTroubleError as trouble:
            report.add("", ("keys", trouble.action), str(trouble))
            del keys[trouble.action]
        else:
            break
    settings = settings.model_copy(update={"keys": keys})
    return Found(settings, tuple(_told(one, _instead(one)) for one in report.diagnostics))


def _told(one: Diagnostic, instead: str) -> str:
    """Return a mistake in one line: place, what is wrong, what would mend it, what is taken."""
    place = f"{one.file}:{one.line}:{one.column}"
    key = f"{one.key}: " if one.key else ""
    mend = f"; {one.mend}" if one.mend else ""
    return f"{place}: {key}{one.message}{mend} ({instead})"


def _instead(one: Diagnostic) -> str:
    key = one.key.split(".")[0].split("[")[0]
    if key == "keys":
        return "the usual keys are taken"
    if key not in Settings.model_fields:
        return "it is left out"
    default = getattr(Settings.model_validate({}), key)
    shown = str(default).lower() if isinstance(default, bool) else repr(default).replace("'", '"')
    return f"{key} = {shown} is taken"


def _floats(raw: Mapping[str, object]) -> dict[str, object]:
    """Let a whole number stand where a fraction may."""
    whole = {key: raw[key] for key in ("text", "volume") if type(raw.get(key)) is int}
    return {**raw, **{key: float(str(number)) for key, number in whole.items()}}
