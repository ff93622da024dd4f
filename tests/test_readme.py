"""What the README says works: its links lead somewhere, its commands exist, its example runs."""

import re
import shlex
from pathlib import Path

import pytest

from engine.__main__ import main

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", README, re.DOTALL)
COMMANDS = [
    command
    for kind, text in BLOCKS
    if not kind
    for line in text.splitlines()
    for command in re.findall(r"python -m engine ([^&]+)", line)
]


@pytest.mark.parametrize("link", sorted(set(re.findall(r"\]\(([^)#]+)", README))))
def test_a_link_leads_to_a_file(link):
    assert (ROOT / link).exists()


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_tours_exists_with_its_options(command):
    name, *rest = shlex.split(command)
    options = {opt for param in main.commands[name].params for opt in param.opts}
    assert {one for one in rest if one.startswith("-")} <= options


def test_the_tours_show_commands_for_players_authors_and_testers():
    assert {command.split()[0] for command in COMMANDS} >= {"play", "new", "check", "golden"}


def test_the_example_of_the_research_tour_runs(capsys):
    example = next(text for kind, text in BLOCKS if kind == "python")
    exec(compile(example, "README.md", "exec"), {})  # noqa: S102  the README's own words
    assert "BallsCollided" in capsys.readouterr().out
