"""Results as text, as JSON, and as the table of the documents."""

from __future__ import annotations

from collections import Counter
from math import isfinite
from typing import TYPE_CHECKING

from tools.validate.check import DIFFERS, FAIL, NOT_APPLICABLE, PASS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tools.validate.check import Answer, Result

ORDER = (PASS, FAIL, DIFFERS, NOT_APPLICABLE)


def tell(result: Result) -> str:
    """Return a check as lines: its id and status, then each quantity."""
    head = f"{result.check.id}  {result.status}  {result.check.description}"
    return "\n".join([head, *(f"    {_line(answer)}" for answer in result.answers)])


def _line(answer: Answer) -> str:
    wanted = answer.wanted
    told = f"{wanted.quantity}: expected {_short(wanted.value)}"
    if answer.status == NOT_APPLICABLE:
        got = "" if answer.got is None else f", got {_short(answer.got)}"
        return f"{told}{got}  not-applicable: {answer.reason}"
    limit = f"tolerance {wanted.tol:g} {wanted.mode}"
    by = f": {answer.reason.removeprefix(wanted.quantity).strip()}" if answer.reason else ""
    return f"{told}, got {_short(answer.got)} {wanted.unit}  ({limit})  {answer.status}{by}"


def _short(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.10g}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_short, value)) + "]"
    return str(value)


def summary(results: Sequence[Result]) -> str:
    """Return one line: checks by status, and quantities by status."""
    checks = Counter(result.status for result in results)
    parts = Counter(answer.status for result in results for answer in result.answers)
    told = ", ".join(f"{checks[one]} {one}" for one in ORDER)
    inside = ", ".join(f"{parts[one]} {one}" for one in ORDER)
    return f"{len(results)} checks: {told} (quantities: {inside})"


def as_json(results: Sequence[Result]) -> dict[str, object]:
    """Return all results and their counts as plain values."""
    checks = Counter(result.status for result in results)
    return {
        "checks": [_result_json(result) for result in results],
        "summary": {"checks": len(results), **{one: checks[one] for one in ORDER}},
    }


def _result_json(result: Result) -> dict[str, object]:
    return {
        "id": result.check.id,
        "group": result.check.group,
        "kind": result.check.kind,
        "status": result.status,
        "reasons": list(result.reasons),
        "quantities": [_answer_json(answer) for answer in result.answers],
    }


def _answer_json(answer: Answer) -> dict[str, object]:
    wanted = answer.wanted
    return {
        "quantity": wanted.quantity,
        "expected": wanted.value,
        "got": answer.got,
        "tol": wanted.tol,
        "tol_mode": wanted.mode,
        "unit": wanted.unit,
        "status": answer.status,
        "reason": answer.reason,
        "off_in_tolerances": answer.off if isfinite(answer.off) else None,
    }


def as_table(results: Sequence[Result]) -> str:
    """Return a table by group: how many checks pass, fail, are not applicable, and why not."""
    groups = dict.fromkeys(result.check.group for result in results)
    lines = [
        "| group | pass | fail | differ | not applicable | parts left out or different |",
        "|---|--:|--:|--:|--:|---|",
    ]
    for group in groups:
        own = [result for result in results if result.check.group == group]
        counts = Counter(result.status for result in own)
        why = "; ".join(_why(own))
        numbers = " | ".join(str(counts[one]) for one in ORDER)
        lines.append(f"| {group} | {numbers} | {why} |")
    return "\n".join(lines) + "\n"


def _why(results: Sequence[Result]) -> list[str]:
    reasons: dict[str, list[str]] = {}
    for result in results:
        for reason in result.reasons:
            reasons.setdefault(reason, []).append(result.check.id)
    return [f"{', '.join(ids)}: {reason}" for reason, ids in reasons.items()]
