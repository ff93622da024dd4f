"""Closes the hole between values made cheaply and the frozen slotted dataclasses they stand for."""

from __future__ import annotations

import copy
import pickle
import sys
from dataclasses import FrozenInstanceError, asdict, dataclass, field, fields, replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from rulelang.frozen import value


def classes(decorate):
    """Return the same three classes, decorated."""

    class Nothing:
        """No attribute."""

    class One:
        first: int

    class More:
        """With defaults."""

        first: int
        second: str = "b"
        third: list[int] = field(default_factory=list)
        fourth: int = field(default=4, repr=False)
        fifth: int = field(default=5, compare=False)

    return [decorate(one) for one in (Nothing, One, More)]


PLAIN = classes(dataclass(frozen=True, slots=True))
CHEAP = classes(value)
ARGUMENTS = [
    (0, (), {}),
    (1, (1,), {}),
    (1, (), {"first": 2}),
    (2, (1,), {}),
    (2, (1, "c", [2]), {"fifth": 6}),
    (2, (), {"third": [1], "first": 1}),
]


@pytest.mark.parametrize(("which", "said", "named"), ARGUMENTS)
def test_a_value_looks_as_a_dataclass_does(which, said, named):
    plain, cheap = PLAIN[which](*said, **named), CHEAP[which](*said, **named)
    assert repr(cheap) == repr(plain)
    assert asdict(cheap) == asdict(plain)
    assert [one.name for one in fields(cheap)] == [one.name for one in fields(plain)]
    assert type(cheap).__match_args__ == type(plain).__match_args__
    assert not hasattr(cheap, "__dict__")


@pytest.mark.parametrize("a", ARGUMENTS)
@pytest.mark.parametrize("b", ARGUMENTS)
def test_two_values_are_equal_where_dataclasses_are(a, b):
    (one, said, named), (other, more, others) = a, b
    plain = PLAIN[one](*said, **named) == PLAIN[other](*more, **others)
    assert (CHEAP[one](*said, **named) == CHEAP[other](*more, **others)) is plain


def test_equal_values_have_one_hash():
    assert hash(CHEAP[1](3)) == hash(CHEAP[1](3))
    assert len({CHEAP[1](3), CHEAP[1](3), CHEAP[1](4), CHEAP[0]()}) == 3


@pytest.mark.parametrize("arguments", [(), (1, 2), (1, 2, 3)])
def test_wrong_arguments_are_refused(arguments):
    with pytest.raises(TypeError):
        CHEAP[1](*arguments)


def test_a_value_never_changes():
    one = CHEAP[2](1)
    with pytest.raises(FrozenInstanceError):
        one.first = 2
    with pytest.raises(FrozenInstanceError):
        del one.first
    with pytest.raises(FrozenInstanceError):
        one.other = 2


def test_a_value_is_copied_replaced_and_matched():
    one = CHEAP[2](1, "x", [7])
    assert replace(one, first=2) == CHEAP[2](2, "x", [7])
    assert copy.deepcopy(one) == one
    assert copy.copy(one).third is one.third
    match one:
        case object(first=1, third=[seven]):
            assert seven == 7


def test_a_value_may_refuse_what_it_is_made_of():
    @value
    class Positive:
        number: int

        def __post_init__(self):
            if self.number < 0:
                raise ValueError(self.number)

    assert Positive(1).number == 1
    with pytest.raises(ValueError, match="-1"):
        Positive(-1)


def test_each_value_has_a_list_of_its_own():
    assert CHEAP[2](1).third is not CHEAP[2](1).third


def test_a_value_of_the_language_goes_to_another_process():
    from rulelang.diagnostics import Diagnostic

    one = Diagnostic("R101", "x.rules", 1, 2, "wrong")
    assert pickle.loads(pickle.dumps(one)) == one  # noqa: S301 - its own bytes
