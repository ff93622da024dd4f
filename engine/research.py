"""The researcher's entrance: load a table, lay balls out, strike, and read what happened.

One idea: a `Lab` is a shipped or own variant reduced to its physics, and everything else is plain
values: layouts are dicts of places in m, strikes and traces those of `engine.physics`. Invariant:
no state; the same call gives the same bits, alone or in a batch. Importing this loads nothing
heavier than the standard library.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2
from typing import TYPE_CHECKING, TypeVar

from engine.table.furniture import BallId

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from pathlib import Path

    from engine.physics.batch import Stroke
    from engine.physics.trace import Trace
    from engine.physics.world import Layout, Strike, World
    from engine.table.furniture import Point

    Kept = TypeVar("Kept")
    Places = Mapping[str, Point]
    """Where balls lie (m), by name."""


@dataclass(frozen=True, slots=True)
class Lab:
    """A table with its balls, cloth and models: `world`, and which balls may be struck."""

    name: str | Path
    world: World
    cue_balls: tuple[BallId, ...]

    def opening(self, seed: int = 0) -> dict[str, Point]:
        """Return where all balls lie (m) when a game opens; balls placed by lot follow the seed."""
        from platformdirs import user_cache_path  # noqa: PLC0415

        from engine.game.placing import opening_layout  # noqa: PLC0415  reads the rules
        from engine.variant.load import load_variant  # noqa: PLC0415

        layout = opening_layout(load_variant(self.name, user_cache_path("headstring")), seed)
        return {str(ball): place for ball, place in layout.items()}

    def with_models(self, **names: str) -> Lab:
        """Return the same table with other models, such as `ball_cushion="han-2005"`.

        Raises ValueError at the first shot where there is no such model.
        """
        return replace(self, world=replace(self.world, models=replace(self.world.models, **names)))

    def shoot(self, layout: Places, strike: Strike, ball: str | None = None) -> Trace:
        """Return the shot: the first cue ball, or another `ball`, struck among the others.

        Raises ValueError for what cannot be.
        """
        from engine.physics.simulate import simulate  # noqa: PLC0415

        struck = BallId(ball or self.cue_balls[0])
        return simulate(self.world, _named(layout), struck, strike)

    def shoot_all(
        self,
        shots: Sequence[tuple[Places, Strike]],
        workers: int = 1,
        keep: Callable[[Trace], Kept] | None = None,
    ) -> list[Trace] | list[Kept]:
        """Return the trace of each shot in order, or what `keep` makes of it where it is played.

        `workers` is the number of processes, -1 for one a core. Same bits as one by one.
        """
        from engine.physics.batch import simulate_batch  # noqa: PLC0415

        struck = self.cue_balls[0]
        strokes: list[Stroke] = [(_named(layout), struck, strike) for layout, strike in shots]
        return simulate_batch(self.world, strokes, workers, keep)


def load(name_or_path: str | Path) -> Lab:
    """Return a variant's table by stem or path; its rules are not read.

    Raises VariantError, which carries every mistake of the file.
    """
    from engine.variant.library import VariantError  # noqa: PLC0415
    from engine.variant.load import read_draft  # noqa: PLC0415

    draft, diagnostics = read_draft(name_or_path)
    if diagnostics or draft is None:
        raise VariantError(list(diagnostics))
    return Lab(name_or_path, draft.world, draft.cue_balls)


def _named(layout: Places) -> Layout:
    return {BallId(name): place for name, place in layout.items()}


def aim(layout: Places, ball: str, at: str | Point) -> float:
    """Return the heading (rad) from a ball to another, or to a place (m)."""
    (x, y) = layout[ball]
    u, v = layout[at] if isinstance(at, str) else at
    return atan2(v - y, u - x)


def column(trace: Trace, ball: str) -> int:
    """Return the place of a ball along the ball axis of a trace's arrays."""
    return [str(one.id) for one in trace.balls].index(ball)


__all__ = ["Lab", "aim", "column", "load"]
