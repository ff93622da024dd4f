"""What a page on a game says that its files say already: equipment, rules, records.

One idea: a page is written by hand as far as it judges (what is left out, how a section is read)
and made from the variant, the script and the records for the rest.
"""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from rulelang.program import by_section

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.variant.variant import Setting, Variant
    from rulelang.program import RuleInfo

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / "docs" / "games"
START, END = "<!-- made: game -->", "<!-- end -->"
MADE = re.compile(rf"\n*{re.escape(START)}.*?{re.escape(END)}\n*", re.DOTALL)


def with_files(text: str, game: str) -> str:
    """Return a page with what the files of `game` say at its end."""
    from engine.variant.load import load_variant  # noqa: PLC0415

    variant = load_variant(game)
    made = "\n".join([*_equipment(variant), *_rules(variant), *_records(game)])
    return f"{MADE.sub('', text).rstrip()}\n\n{START}\n{made}\n{END}\n"


def _equipment(variant: Variant) -> Iterator[str]:
    table = variant.world.table
    yield "## Equipment, as the variant has it\n"
    size = f"{_mm(table.length)} by {_mm(table.width)}"
    yield f"- bed {size} between the noses, which are {_mm(table.nose_height)} high"
    if table.pockets:
        names = ", ".join(f"`{pocket.id}`" for pocket in table.pockets)
        yield f"- pockets: {names}"
    if table.pins:
        names = ", ".join(f"`{pin.id}`" for pin in table.pins)
        yield f"- pins: {names}"
    sizes = Counter((ball.radius, ball.mass) for ball in variant.world.balls)
    for (radius, mass), count in sizes.items():
        alike = [b for b in variant.world.balls if (b.radius, b.mass) == (radius, mass)]
        named = ", ".join(f"`{ball.id}`" for ball in alike)
        told = f"{_mm(2 * radius)} in diameter, {1000 * mass:.4g} g: {named}"
        yield f"- {count} {'ball' if count == 1 else 'balls'}, {told}"
    for zone in table.zones:
        yield f"- zone `{zone}`"
    least, most, _ = variant.players
    yield f"- players: {least if least == most else f'{least} to {most}'}"
    for setting in variant.settings.values():
        yield f"- setting `{setting.name}`: {_setting(setting)}"
    models = variant.world.models
    yield (
        f"- models: balls `{models.ball_ball}`, cushions `{models.ball_cushion}`,"
        f" motion `{models.motion}`, flight `{models.flight}`"
    )
    yield ""


def _mm(length: float) -> str:
    return f"{1000 * length:.5g} mm"


def _setting(setting: Setting) -> str:
    default = str(setting.default).lower() if isinstance(setting.default, bool) else setting.default
    others = [str(one) for one in setting.choices if one != setting.default]
    bounds = [
        f"{word} {bound}"
        for word, bound in (("at least", setting.least), ("at most", setting.most))
        if bound is not None
    ]
    more = (
        f" ({', '.join([*(f'or {one}' for one in others), *bounds])})" if others or bounds else ""
    )
    about = f"; {setting.about}" if setting.about else ""
    return f"{default}{more}{about}"


def _rules(variant: Variant) -> Iterator[str]:
    yield "## Rules, as the script has them\n"
    section = ""
    for rule in by_section(variant.program.rules):
        if rule.section != section:
            section = rule.section
            yield f"### {section.capitalize()}\n"
        yield _rule(rule, variant)
    yield ""


def _rule(rule: RuleInfo, variant: Variant) -> str:
    own = Path(rule.file).name
    shared = "" if rule.file == str(variant.script_path) else f" (from `{own}`)"
    cites = f" [{', '.join(rule.cites)}]" if rule.cites else ""
    head, _, body = rule.text.removeprefix(f'"{rule.name}"').partition(":")
    _, overrides, others = head.partition("overrides")
    lines = [line for line in body.splitlines() if line.strip()]
    indents = [len(line) - len(line.lstrip()) for line in lines if line.startswith(" ")]
    cut = min(indents, default=0)
    code = "\n".join(
        f"      {line[cut:] if line.startswith(' ') else line.strip()}" for line in lines
    )
    instead = f", in place of {others.strip()}" if overrides else ""
    return f"- **{rule.name}**{cites}{shared}{instead}\n\n{code}\n"


def _records(game: str) -> Iterator[str]:
    found = sorted((ROOT / "tests" / "golden" / game).rglob("*.toml"))
    yield f"## Records: {len(found)}\n"
    for path in found:
        record = tomllib.loads(path.read_text(encoding="utf-8"))
        cites = ", ".join(record.get("cites", ()))
        yield f"- `{path.stem}`: {record.get('title', '')} [{cites}]"


__all__ = ["PAGES", "with_files"]
