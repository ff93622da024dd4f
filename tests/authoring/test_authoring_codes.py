"""Closes the hole between a code and what its page says: each example is tried."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

from engine.variant.load import check_variant
from tools.codes import CODES, NOT_FOUND, Example, examples, told_of

PAGE = (Path(__file__).parents[2] / "docs" / "codes.md").read_text(encoding="utf-8")


def test_there_are_many_codes_and_each_has_an_example() -> None:
    assert len(CODES) >= 60
    assert [one.code for one in examples()] == [code for code in CODES if code != NOT_FOUND]


@pytest.mark.parametrize("example", examples(), ids=lambda one: one.code)
def test_the_example_raises_its_code_at_its_line_and_no_other(example: Example) -> None:
    told = told_of(example.broken, example)
    assert {one.code for one in told} == {example.code}, told
    assert example.line in {one.line for one in told}
    assert all(one.message and one.mend for one in told)
    assert all(one.severity in ("error", "warning") for one in told)


@pytest.mark.parametrize("example", examples(), ids=lambda one: one.code)
def test_nothing_is_told_of_the_mended_example(example: Example) -> None:
    assert told_of(example.mended, example) == []


def test_a_variant_that_is_not_there() -> None:
    assert [one.code for one in check_variant("snoker")] == [NOT_FOUND]


def test_the_page_has_an_anchor_for_each_code() -> None:
    assert re.findall(r"^### (\w+)$", PAGE, re.MULTILINE) == list(CODES)
    assert PAGE.count("```rules mended") + PAGE.count("```toml mended") == len(examples())
