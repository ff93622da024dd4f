"""A game's files opened for the window.

One idea: the grammar of scripts is made once and kept in the user's folder, so that a game opens
in a tenth of the time. Invariant: where nothing can be kept, the same game is opened.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from platformdirs import user_cache_path

from engine.variant.load import load_variant

if TYPE_CHECKING:
    from pathlib import Path

    from engine.variant.variant import Variant


def open_variant(name_or_path: str | Path) -> Variant:
    """Return a variant by stem or path, checked whole; raises VariantError."""
    return load_variant(name_or_path, user_cache_path("headstring"))
