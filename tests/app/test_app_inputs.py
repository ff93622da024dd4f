import pytest

from engine.app.inputs import (
    ButtonPressed,
    ButtonReleased,
    FocusLost,
    Input,
    KeyPressed,
    KeyReleased,
    MouseMoved,
    Wheeled,
)


def fed(*events):
    hands = Input()
    hands.feed(events)
    return hands


def test_a_key_is_held_from_press_to_release():
    hands = fed(KeyPressed("left"))
    hands.feed([])
    assert hands.down("left")
    hands.feed([KeyReleased("left")])
    assert not hands.down("left")


def test_a_press_counts_in_its_own_frame_only():
    hands = fed(KeyPressed("space"))
    assert hands.pressed == ["space"]
    hands.feed([])
    assert hands.pressed == []


def test_a_press_and_release_within_one_frame_is_not_lost():
    hands = fed(KeyPressed("space"), KeyReleased("space"))
    assert hands.pressed == ["space"]
    assert not hands.down("space")


@pytest.mark.parametrize(
    ("keys", "horizontal", "vertical"),
    [
        ((), 0, 0),
        (("left",), -1, 0),
        (("right",), 1, 0),
        (("left", "right"), 0, 0),
        (("up",), 0, 1),
        (("down",), 0, -1),
        (("right", "down"), 1, -1),
    ],
)
def test_arrows_are_two_axes(keys, horizontal, vertical):
    hands = fed(*map(KeyPressed, keys))
    assert (hands.horizontal, hands.vertical) == (horizontal, vertical)
    assert (hands.horizontal_wasd, hands.vertical_wasd) == (0, 0)


@pytest.mark.parametrize(
    ("keys", "expected"),
    [(("a",), (-1, 0)), (("d", "w"), (1, 1)), (("s",), (0, -1)), (("a", "d"), (0, 0))],
)
def test_wasd_are_two_axes_of_their_own(keys, expected):
    hands = fed(*map(KeyPressed, keys))
    assert (hands.horizontal_wasd, hands.vertical_wasd) == expected
    assert (hands.horizontal, hands.vertical) == (0, 0)


def test_the_mouse_tells_place_way_and_buttons():
    hands = fed(MouseMoved((10, 20)), ButtonPressed(1, (10, 20)))
    assert hands.mouse == (10, 20)
    assert hands.buttons == {1}
    hands.feed([MouseMoved((14, 17)), ButtonReleased(1, (15, 17))])
    assert hands.moved == (5, -3)
    assert hands.buttons == set()


def test_the_wheel_adds_up_within_a_frame_and_is_forgotten_after():
    hands = fed(Wheeled(1), Wheeled(2))
    assert hands.wheel == 3
    hands.feed([])
    assert hands.wheel == 0


def test_nothing_is_held_when_the_window_loses_the_focus():
    hands = fed(KeyPressed("left"), KeyPressed("left shift"), ButtonPressed(1, (0, 0)))
    assert hands.shift
    hands.feed([FocusLost()])
    assert not hands.shift
    assert not hands.down("left")
    assert hands.buttons == set()
