"""The declarations of a script and of those it uses, made into one scope.

One idea: a game's own file has the last word on headers, phases and order; names may be given
once only. Invariant: a name whose declaration could not be read is poisoned, not unknown.
"""

from __future__ import annotations

import re
from difflib import get_close_matches
from typing import TYPE_CHECKING

from rulelang import code as k
from rulelang import syntax as s
from rulelang.code import Mistake
from rulelang.program import FactDecl, Track
from rulelang.scope import Scope
from rulelang.surface import LONGEST
from rulelang.timers import declare_timer

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.vocabulary import Value, Vocabulary

    Tell = Callable[[s.Script, Mistake], None]

_FOUL = re.compile(r"(?<!is )(?<!of )\bfoul (?!is\b)([a-z][a-z0-9-]*)")
"""What a rule that could not be read calls: its foul is known all the same."""
_SCOPES = {"rack": "game", "frame": "game", "game": "game"}


class Declarations:
    """Everything declared, with the headers."""

    def __init__(self, vocabulary: Vocabulary, scripts: list[s.Script], tell: Tell) -> None:
        self.scope = Scope(vocabulary)
        self.scripts = scripts
        self.scope.scripts = scripts
        self.tell = tell
        self.headers: dict[str, str] = {}
        self.written: dict[str, tuple[str, Value, bool]] | None = None
        self.phase_places: list[tuple[s.Script, str, s.Span]] = []
        for script in scripts:
            self._unread(script)
        for script in scripts:
            for node in script.declarations:
                self._take(script, node)
        for script in scripts:
            self._found_in_rules(script)

    def header(self, word: str) -> str:
        """Return the text of a header, the main script's before a used one's."""
        return self.headers.get(word, "")

    def _take(self, script: s.Script, node: s.Declaration) -> None:
        match node:
            case s.Header():
                self._header(script, node)
            case s.Phases():
                self._phases(script, node)
            case s.Zones():
                if self._new(script, node.name, node.at):
                    self._zones(script, node)
            case s.Track():
                if self._new(script, node.name, node.at):
                    self._track(script, node)
            case s.Timer():
                if self._new(script, node.name, node.at):
                    self._timer(script, node)
            case s.Fact():
                if self._new(script, node.name, node.at):
                    self._fact(script, node)
            case s.Define():
                if self._new(script, node.name, node.at):
                    self.scope.defines[node.name] = node
            case s.Home() | s.SpottingOrder():
                pass

    def _header(self, script: s.Script, node: s.Header) -> None:
        if node.word == "language" and float(node.text) != 1:
            message = f"version {node.text} of the language is not known"
            self.tell(script, Mistake("R110", node.at, message, "say `language 1`"))
        if node.word == "side":
            self._side(script, node)
        self.headers[node.word] = node.text

    def _side(self, script: s.Script, node: s.Header) -> None:
        most = self.scope.vocabulary.players[1]
        mates = float(node.text)
        if not mates.is_integer() or mates < 1 or 2 * mates > most:
            message = f"a side cannot have {node.text} of at most {most} players"
            mend = f"say `players per side {max(1, most // 2)}`"
            self.tell(script, Mistake("R307", node.at, message, mend))
            return
        self.scope.mates = int(mates)

    def _phases(self, script: s.Script, node: s.Phases) -> None:
        names = [name for name, _ in node.names]
        for number, (name, at) in enumerate(node.names):
            if name in names[:number]:
                self.tell(script, Mistake("R205", at, f'"{name}" is given twice', "drop one"))
        self.scope.phases = tuple(dict.fromkeys(names))
        self.phase_places = [(script, name, at) for name, at in node.names]

    def _zones(self, script: s.Script, node: s.Zones) -> None:
        for name, at in node.members:
            try:
                self.scope.place("zone", name, at)
            except Mistake as trouble:
                self.tell(script, trouble)
        self.scope.families[node.name] = tuple(name for name, _ in node.members)

    def _new(self, script: s.Script, name: str, at: s.Span) -> bool:
        scope = self.scope
        taken = (*scope.families, *scope.tracks, *scope.facts, *scope.defines)
        if name in scope.owners and name in taken:
            other = scope.owners[name]
            earlier = _line_of(other, name)
            place = f"line {earlier}" if other is script else other.file
            message = f'"{name}" is given twice, also in {place}'
            self.tell(script, Mistake("R205", at, message, "give one of them another name"))
            return False
        scope.poisoned.discard(name)
        scope.owners[name] = script
        scope.sources[name] = script.source
        return True

    def _track(self, script: s.Script, node: s.Track) -> None:
        units = list(node.units)
        per_player = "player" in units or "side" in units
        spans = [unit for unit in units if unit not in ("player", "side")]
        if len(spans) > 1:
            message = f'"{node.name}" has more than one scope: {", ".join(spans)}'
            self.tell(script, Mistake("R205", node.at, message, "keep one"))
        unit = spans[0] if spans else "game"
        kind, value, by_breaker = self._start(script, node)
        self.scope.tracks[node.name] = Track(
            node.name, _SCOPES.get(unit, unit), per_player, value, by_breaker, "side" in units
        )
        self.scope.track_kinds[node.name] = kind

    def _start(self, script: s.Script, node: s.Track) -> tuple[str, Value, bool]:
        match node.start:
            case s.Number(value=number):
                return k.NUMBER, number, False
            case s.Flag(value=flag):
                return k.FLAG, flag, False
            case s.Player(words="breaker"):
                return k.PLAYER, 1, True
            case s.Name(name=name):
                settings = self.scope.vocabulary.settings
                if name in settings:
                    value = settings[name]
                    kind = k.FLAG if isinstance(value, bool) else k.NUMBER
                    return (k.NAME if isinstance(value, str) else kind), value, False
                return k.NAME, name, False
            case s.Nothing():
                return k.NAME, "none", False
            case None:
                return self._guessed(node.name)
            case _:
                message = f'"{node.name}" cannot start with this'
                mend = "start with a number, yes, no, a name or `breaker`"
                self.tell(script, Mistake("R301", node.at, message, mend))
                return k.NUMBER, 0, False

    def _guessed(self, name: str) -> tuple[str, Value, bool]:
        """Return kind and start of a tracked value by what the rules write to it."""
        if self.written is None:
            self.written = _written(self.scripts)
        return self.written.get(name, (k.NUMBER, 0, False))

    def _timer(self, script: s.Script, node: s.Timer) -> None:
        try:
            declare_timer(self.scope, node)
        except Mistake as trouble:
            self.tell(script, trouble)

    def _fact(self, script: s.Script, node: s.Fact) -> None:
        kind = node.kind
        default: Value | None = None
        match node.default:
            case s.Flag(value=flag):
                kind, default = kind or "flag", flag
            case s.Number(value=number):
                kind, default = kind or "number", number
            case s.Name(name=name):
                default = name
                if node.values and name not in node.values:
                    message = f'"{node.name}" is never "{name}"'
                    mend = f"it is one of {', '.join(node.values)}"
                    self.tell(script, Mistake("R306", node.at, message, mend))
            case _:
                pass
        self.scope.facts[node.name] = FactDecl(
            node.name, kind or "values", default, node.values, node.predicate
        )
        self.scope.fact_nodes[node.name] = node

    def _found_in_rules(self, script: s.Script) -> None:
        for rule in script.rules:
            for node in s.walk(rule.body):
                if isinstance(node, s.Foul):
                    self.scope.fouls.setdefault(node.name)
        for line in script.source.split("\n"):
            for name in _FOUL.findall(line.split("#")[0]):
                self.scope.fouls.setdefault(name)

    def _unread(self, script: s.Script) -> None:
        """Poison the names whose declarations could not be parsed."""
        if len(script.source) > LONGEST:
            return
        heads: dict[str, str] = {}
        for word, rest in re.findall(
            r"^([a-z]+) +([a-z0-9][a-z0-9 ,-]*)", script.source, re.MULTILINE
        ):
            if word not in heads:
                heads[word] = next(iter(get_close_matches(word, _HEADS, 1, 0.7)), "")
            head = heads[word]
            names = re.findall(r"[a-z0-9-]+", rest)
            if head == "phases":
                self.scope.phases = tuple(names)
            elif head:
                self.scope.poisoned.update((names[0], "-".join(names[:2])))


_HEADS = ("define", "track", "fact", "zones", "timer", "phases")


def _line_of(script: s.Script, name: str) -> int:
    for node in script.declarations:
        if isinstance(node, s.Zones | s.Define | s.Track | s.Fact | s.Timer) and node.name == name:
            return node.at.line
    return 1


def _written(scripts: list[s.Script]) -> dict[str, tuple[str, Value, bool]]:
    """Return kind and start of every value to which a rule writes a flag or a name."""
    found: dict[str, tuple[str, Value, bool]] = {}
    for script in scripts:
        for rule in script.rules:
            for node in s.walk(rule.body):
                if isinstance(node, s.Write) and isinstance(node.value, s.Flag):
                    found.setdefault(node.name, (k.FLAG, False, False))
                elif isinstance(node, s.Write) and isinstance(node.value, s.Name):
                    found.setdefault(node.name, (k.NAME, "none", False))
    return found
