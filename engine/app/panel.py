"""Pages on which something can be set: facts of the last shot, the cloth and the rubber.

One idea: a panel is a list of rows with values; what was set is a draft until it is accepted.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from engine.app.cloth import DIALS, on_world, roll_words
from engine.app.judging import facts_of, judged_again
from engine.app.units import Units
from engine.app.words import capital, spoken

if TYPE_CHECKING:
    from engine.app.judging import Fact
    from engine.app.session import Session
    from engine.physics.world import World


@dataclass(frozen=True, slots=True)
class FactsPanel:
    """What an eye saw of the last shot."""

    facts: tuple[Fact, ...]

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Names and values."""
        return tuple((capital(spoken(one.name)), one.words) for one in self.facts)

    @property
    def about(self) -> tuple[str, ...]:
        """What the page is for."""
        return ("What an eye saw of the shot played last; the referee judges it again by that.",)

    def stepped(self, row: int, by: int) -> FactsPanel:
        """Return the panel with the next value of a row."""
        return FactsPanel(
            tuple(one.stepped(by) if k == row else one for k, one in enumerate(self.facts))
        )

    def accept(self, session: Session) -> Session:
        """Return the session after what was set."""
        return judged_again(session, self.facts)


@dataclass(frozen=True, slots=True)
class ClothPanel:
    """Friction and restitution."""

    world: World
    units: Units = Units.METRIC

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Names and values."""
        return tuple((dial.about, dial.words(self.world)) for dial in DIALS)

    @property
    def about(self) -> tuple[str, ...]:
        """What the page is for, and what the numbers come to."""
        change = "Changed numbers begin a practice match from where the balls lie."
        own = "A ball or cushion with numbers of its own keeps them."
        return (capital(roll_words(self.world, self.units)), change, own)

    def stepped(self, row: int, by: int) -> ClothPanel:
        """Return the panel with the next value of a row."""
        return replace(self, world=DIALS[row].turned(self.world, by))

    def accept(self, session: Session) -> Session:
        """Return the session after what was set."""
        return on_world(session, self.world)


Panel = FactsPanel | ClothPanel


def facts_panel(session: Session) -> FactsPanel:
    """Return the panel of the shot played last."""
    return FactsPanel(facts_of(session))
