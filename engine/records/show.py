"""Outcomes of records as text and as JSON.

One idea: what is printed is made from the same values that decide pass and fail.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

import click

from engine.game.phrases import format_event
from engine.records.golden import DIFFERENT, UNUSABLE, Result
from engine.records.say import expectation
from engine.records.write import shot_table
from rulelang.diagnostics import render

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from engine.records.run import Judgement, Outcome
    from rulelang.decisions import RuleOutcome


def show_result(result: Result) -> None:
    """Print a record that does not pass: differences to stdout, mistakes to stderr."""
    if result.outcome is None:
        for mistake in result.mistakes:
            click.echo(render(mistake), err=True)
        return
    if result.status == DIFFERENT:
        click.echo(f"{result.path}: {result.outcome.record.title}")
        for one in result.outcome.differences:
            click.echo(f"  {one}")
    if result.outcome.replayed is False:
        click.echo(f"{result.path}: judged from its events, not replayed", err=True)


def summary(results: Sequence[Result]) -> str:
    """Return one line: how many passed, differ and cannot be used."""
    bad = sum(result.status == UNUSABLE for result in results)
    differ = sum(result.status == DIFFERENT for result in results)
    passed = len(results) - bad - differ
    return f"{passed} passed, {differ} differ, {bad} unusable"


def explain_text(outcome: Outcome, *, everything: bool = False) -> str:
    """Return what the referee says on each shot of a record, rule by rule."""
    rulebook = outcome.record.variant.program.rulebook
    lines = (
        [outcome.record.title, f"Sections of: {rulebook}"] if rulebook else [outcome.record.title]
    )
    for number, judged in enumerate(outcome.judgements, 1):
        phase = f", phase {judged.before.phase}" if judged.before.phase else ""
        lines += ["", f"Shot {number}, player {judged.before.shooter}{phase}"]
        lines += [f"  {key}: {_short(value)}" for key, value in told_of(judged).items()]
        lines += _events(judged)
        lines += [f"  {line}" for line in verdict_lines(judged)]
        lines += _rules(judged.verdict.explanation, everything=everything)
        lines += [f"  default: {one}" for one in defaults_of(judged)]
    lines += ["", *(f"differs: {one}" for one in outcome.differences)]
    return "\n".join(lines).rstrip()


def told_of(judged: Judgement) -> dict[str, object]:
    """Return what was told of a shot besides its events: choice, call, placing, facts."""
    known = shot_table(judged.shot)
    return {
        key: known[key] for key in ("choose", "call", "struck", "place", "facts") if key in known
    }


def _events(judged: Judgement) -> Iterator[str]:
    for index, event in enumerate(judged.verdict.events, 1):
        yield f"  {index:3d}  {format_event(event)}"


def verdict_lines(judged: Judgement) -> Iterator[str]:
    """Yield the verdict in short lines: fouls, points, who is next."""
    verdict = judged.verdict
    for foul in verdict.fouls:
        cites = ", ".join(foul.cites)
        worth = f", worth {foul.worth}" if foul.worth else ""
        yield f"foul: {foul.name}{worth} [{cites}] ({foul.rule})"
    for key, value in expectation(verdict, judged.before).items():
        if key != "fouls" and value not in ([], {}):
            yield f"{key}: {_short(value)}"


def _short(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{name} {_short(one)}" for name, one in value.items())
    if isinstance(value, bool):
        return "yes" if value else "no"
    return " ".join(map(_short, value)) if isinstance(value, list) else str(value)


def _rules(rules: Iterable[RuleOutcome], *, everything: bool) -> Iterator[str]:
    for rule in rules:
        if rule.outcome == "silent" and not everything:
            continue
        cites = f" [{', '.join(rule.cites)}]" if rule.cites else ""
        seen = _seen(rule.events)
        yield f"  {rule.outcome}: {rule.section}: {rule.rule}{cites}"
        if rule.because:
            yield f"      because {rule.because}{seen}"
        yield from (f"      -> {said}" for said in rule.said)


def defaults_of(judged: Judgement) -> Iterator[str]:
    """Yield what holds because no rule says otherwise."""
    verdict = judged.verdict
    stroke = any(one.section != "choice" for one in verdict.explanation)
    decided = any(
        said.startswith("turn ")
        for one in verdict.explanation
        if one.outcome == "fired"
        for said in one.said
    )
    if stroke and not decided and not verdict.after.over:
        yield "no rule keeps the turn, so it passes"


def _seen(events: Sequence[int]) -> str:
    if not events:
        return ""
    word = "event" if len(events) == 1 else "events"
    return f" ({word} {', '.join(str(at + 1) for at in events)})"


def explain_json(outcome: Outcome) -> dict[str, object]:
    """Return the same as plain values for JSON."""
    return {
        "title": outcome.record.title,
        "rulebook": outcome.record.variant.program.rulebook,
        "passed": outcome.passed,
        "shots": [
            {
                "player": judged.before.shooter,
                "phase": judged.before.phase,
                "told": told_of(judged),
                "events": [format_event(event) for event in judged.verdict.events],
                "verdict": expectation(judged.verdict, judged.before),
                "fouls": [asdict(foul) for foul in judged.verdict.fouls],
                "rules": [asdict(rule) for rule in judged.verdict.explanation],
                "defaults": list(defaults_of(judged)),
            }
            for judged in outcome.judgements
        ],
    }
