"""The player's settings: a TOML file in the folder where the system keeps such files.

One idea: every setting has a default, so the file may be missing; a bad one is told with its
place and what would be right. Invariant: only this package looks for the player's folders.
"""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from platformdirs import user_config_dir, user_data_dir
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from engine.app.keymap import KeyTroubleError, keymap_of

if TYPE_CHECKING:
    from engine.app.keymap import Keymap

NAME = "headstring"
RendererName = Literal["wireframe", "painter", "scanline"]


class SettingsError(ValueError):
    """A settings file that cannot be used; the message says where and what would mend it."""


class Settings(BaseModel):
    """What the player may set; sizes in pixels, `rate` in frames a second, `keys` by action."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    rate: int = Field(60, ge=1, le=1000)
    renderer: RendererName = "scanline"
    width: int = Field(1280, ge=480, le=7680)
    height: int = Field(720, ge=320, le=4320)
    text: float = Field(1.0, ge=0.5, le=3.0)
    volume: float = Field(0.7, ge=0.0, le=1.0)
    aid: Literal["off", "line", "ghost", "object", "all"] = "object"
    keys: dict[str, str | list[str]] = Field(default_factory=dict)

    @property
    def keymap(self) -> Keymap:
        """Which key does what; raises KeyTroubleError for keys that cannot be used."""
        return keymap_of(self.keys)


def settings_path() -> Path:
    """Return where the player's settings file is looked for."""
    return Path(user_config_dir(NAME, appauthor=False)) / "settings.toml"


def data_folder() -> Path:
    """Return the folder of the player's journals and saved shots."""
    return Path(user_data_dir(NAME, appauthor=False))


def read_settings(path: Path | None = None) -> Settings:
    """Return the settings of a file, the defaults where there is none.

    Raises SettingsError for a file that is no TOML or holds what does not fit.
    """
    path = path or settings_path()
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return Settings.model_validate({})
    except (OSError, UnicodeDecodeError) as trouble:
        raise SettingsError(f"{path}: cannot be read: {trouble}") from trouble
    try:
        found = Settings.model_validate(_floats(tomllib.loads(text)))
        keymap_of(found.keys)
    except tomllib.TOMLDecodeError as trouble:
        raise SettingsError(f"{path}: not TOML: {trouble}") from trouble
    except KeyTroubleError as trouble:
        where = _line_of(text, trouble.action)
        raise SettingsError(f"{path}:{where}: keys.{trouble.action}: {trouble}") from trouble
    except ValidationError as trouble:
        raise SettingsError("\n".join(_complaints(path, text, trouble))) from trouble
    return found


def _floats(raw: dict[str, object]) -> dict[str, object]:
    """Let a whole number stand where a fraction may."""
    whole = {key: raw[key] for key in ("text", "volume") if type(raw.get(key)) is int}
    return raw | {key: float(str(number)) for key, number in whole.items()}


def _complaints(path: Path, text: str, trouble: ValidationError) -> list[str]:
    return [
        f"{path}:{_line_of(text, str(one['loc'][0]))}: {one['loc'][0]}: {_mend(one)}"
        for one in trouble.errors()
    ]


def _line_of(text: str, key: str) -> int:
    for number, line in enumerate(text.splitlines(), start=1):
        if re.match(rf'\s*"?{re.escape(key)}"?\s*[=.\]]', line) or line.strip() == f"[{key}]":
            return number
    return 1


def _mend(error: object) -> str:
    found = dict(error)  # type: ignore[call-overload]
    if found["type"] == "extra_forbidden":
        known = ", ".join(Settings.model_fields)
        return f"there is no such setting; the settings are {known}"
    told = found["msg"].replace("a valid integer", "a whole number").removeprefix("Input ")
    return f"{found['input']!r} does not fit: it {told}"
