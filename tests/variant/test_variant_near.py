"""One slip, one message: a misspelt key is not missing too, a misspelt script brings no others."""

from pathlib import Path

import pytest

from engine.variant.load import check_variant

SHIPPED = Path(__file__).parents[2] / "variants"


@pytest.mark.parametrize(
    ("game", "ending", "right", "wrong", "mend"),
    [
        ("snooker", "toml", "title =", "tittle =", "did you mean `title`?"),
        ("three_cushion", "toml", "cue_balls =", "cue-balls =", "did you mean `cue_balls`?"),
        ("three_cushion", "toml", "players =", "player =", "did you mean `players`?"),
        (
            "nine_ball",
            "rules",
            '"pool-rotation"',
            '"pool-rotations"',
            "did you mean `pool-rotation`?",
        ),
        ("nine_ball", "rules", '"pool-rotation"', "pool-rotation", 'write `uses "pool-rotation"`'),
        ("eight_ball", "rules", "define ", "defin ", "did you mean `define`?"),
        ("straight_pool", "rules", "phases break", "phase break", "did you mean `phases`?"),
    ],
)
def test_one_slip_has_one_message(tmp_path, game, ending, right, wrong, mend):
    for end in ("toml", "rules"):
        text = (SHIPPED / f"{game}.{end}").read_text(encoding="utf-8")
        text = text.replace(right, wrong, 1) if end == ending else text
        (tmp_path / f"{game}.{end}").write_text(text, encoding="utf-8")
    (found,) = check_variant(tmp_path / f"{game}.toml")
    assert found.mend == mend
    assert found.snippet[found.column - 1 : found.column - 1 + found.width].strip()
