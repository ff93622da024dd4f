"""Coverage-guided fuzzing of what reads files from strangers: `python -m tools.fuzz --minutes 5`.

One idea: an input that runs a line that no input ran before is kept and spoiled further. Python's
own trace of lines (`sys.settrace`) tells which lines ran: it needs nothing installed, runs on every
interpreter the project supports, and is told of our own packages alone, so an input costs a few
milliseconds. With `--atheris`, libFuzzer does the guiding where the package `atheris` is installed.
Invariant: every finding is kept as a file that raises it again: `python -m tools.fuzz FILE`.

A finding is an exception, an answer after more than a second, a diagnostic that cannot be shown, or
memory that grows without bound.
"""

from __future__ import annotations

import argparse
import hashlib
import random
import resource
import sys
import tempfile
import time
from pathlib import Path
from types import FunctionType
from typing import TYPE_CHECKING, Any

from engine.records.read import read_record
from engine.records.record import RecordError
from engine.records.run import run_record
from engine.records.show import explain_text
from engine.variant.load import check_variant, load_variant, read_draft
from engine.variant.words import vocabulary_of
from rulelang.compile import check_script, compile_script
from rulelang.diagnostics import render
from rulelang.formatting import format_script
from rulelang.surface import scan
from tools.scripts import random_script

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import CodeType, FrameType

ROOT = Path(__file__).resolve().parent.parent
OURS = (str(ROOT / "rulelang"), str(ROOT / "engine" / "variant"), str(ROOT / "engine" / "records"))
SLOW = 1.0
"""Seconds of work after which an answer is a finding."""
_SMALL, _HUGE = 4000, 0.02
"""Bytes of most inputs, and how many of them may be huge."""
_FOLLOWED = 4
"""So many calls of a function are followed line by line in one input; the rest cost too much."""
_WORDS = (
    b"if ", b'rule "A": ', b"foul x", b"define x as ", b"track x per game", b"(", b")", b":", b"\n",
    b"    ", b" and ", b" or ", b"not ", b"8-ball", b"cue ball", b" pocketed", b"for each of ",
    b"offer opponent: ", b"otherwise: ", b"phases a1, b1\n", b"timer t lasts 9 seconds\n", b"[1]",
    b"= ", b"[table]\n", b'extends = "nine_ball"\n', b"[[x]]\n", b'"', b"'''", b'"""', b"{", b"}",
    b"\xff", b"\x00", b"\xe2\x80\xa8", b"\xef\xbb\xbf", b"1e400", b"999999999999", b"-", b"L/4",
)  # fmt: skip


class Reader:
    """Reads one kind of file; `seeds` are the texts to begin with."""

    def __init__(self, name: str, read: Callable[[bytes], None], seeds: list[bytes]) -> None:
        self.name = name
        self.read = read
        self.seeds = seeds


def readers(folder: Path) -> dict[str, Reader]:
    """Return every reader of files; `folder` is where files are written for them."""
    variants = sorted((ROOT / "variants").glob("*.toml"))
    records = sorted((ROOT / "tests" / "golden").rglob("*.toml"))[::12]
    broken = sorted((ROOT / "tests" / "authoring" / "mistakes").glob("*"))
    scripts = sorted((ROOT / "variants").rglob("*.rules"))
    made = [random_script(random.Random(n), 3).encode() for n in range(20)]
    texts = [path.read_bytes() for path in (*scripts, *broken) if path.suffix == ".rules"]
    tomls = [path.read_bytes() for path in (*variants, *broken) if path.suffix == ".toml"]
    return {
        "script": Reader("script", _script_reader(), [*texts, *made]),
        "variant": Reader("variant", _variant_reader(folder), tomls),
        "record": Reader("record", _record_reader(folder), [one.read_bytes() for one in records]),
    }


def _script_reader() -> Callable[[bytes], None]:
    draft, _ = read_draft("eight_ball")
    if draft is None:
        raise ValueError("the table of eight_ball cannot be read")
    words = vocabulary_of(draft)

    def read(data: bytes) -> None:
        text = data.decode("utf-8", "replace")
        told = check_script(text, "fuzz.rules", words, lambda _name: None)
        for one in told:
            render(one)
        if not any(one.severity == "error" for one in told):
            compile_script(text, "fuzz.rules", words, lambda _name: None)
        if (
            len(text) < _SMALL
            and not any(one.code.startswith("R1") for one in told)
            and not scan(text, "")
        ):
            once = format_script(text)
            if format_script(once) != once:
                raise AssertionError("the formatter is not done after one turn")

    return read


def _variant_reader(folder: Path) -> Callable[[bytes], None]:
    path = folder / "fuzz.toml"

    def read(data: bytes) -> None:
        path.write_bytes(data)
        for one in check_variant(path):
            render(one)

    return read


def _record_reader(folder: Path) -> Callable[[bytes], None]:
    path = folder / "record.toml"
    known: dict[str, Any] = {}

    def load(name: str) -> Any:
        if name not in known:
            known[name] = load_variant(name)
        return known[name]

    def read(data: bytes) -> None:
        path.write_bytes(data)
        try:
            record = read_record(path, load)
            if len(data) < _SMALL and all(step.shot.strike is None for step in record.steps):
                explain_text(run_record(record), everything=True)
        except RecordError as trouble:
            for one in trouble.diagnostics:
                render(one)

    return read


class Coverage:
    """The lines of our packages that ran; `run` says whether an input ran a new one."""

    def __init__(self) -> None:
        self.lines: set[tuple[CodeType, int]] = set()
        self.ours: dict[CodeType, bool] = {}
        self.calls: dict[CodeType, int] = {}

    def run(self, read: Callable[[bytes], None], data: bytes) -> bool:
        """Run `read` on `data`; raises what it raises."""
        before = len(self.lines)
        self.calls.clear()
        sys.settrace(self._called)
        try:
            read(data)
        finally:
            sys.settrace(None)
        return len(self.lines) > before

    def _called(self, frame: FrameType, _event: str, _arg: object) -> Any:
        code = frame.f_code
        if code not in self.ours:
            self.ours[code] = code.co_filename.startswith(OURS)
        if not self.ours[code]:
            return None
        calls = self.calls[code] = self.calls.get(code, 0) + 1
        return self._line if calls <= _FOLLOWED else None

    def _line(self, frame: FrameType, event: str, _arg: object) -> Any:
        if event == "line":
            self.lines.add((frame.f_code, frame.f_lineno))
        return self._line


def spoiled(data: bytes, other: bytes, chance: random.Random) -> bytes:
    """Return an input like `data`, with some bytes or lines changed, some taken from `other`."""
    for _ in range(chance.randint(1, 4)):
        data = chance.choice(_SPOILERS)(data, other, chance)
    return data[: 60_000 if chance.random() < _HUGE else _SMALL]


def _put(data: bytes, _other: bytes, chance: random.Random) -> bytes:
    at = chance.randint(0, len(data))
    return data[:at] + chance.choice(_WORDS) * chance.choice((1, 1, 1, 3, 400)) + data[at:]


def _cut(data: bytes, _other: bytes, chance: random.Random) -> bytes:
    a, b = sorted((chance.randint(0, len(data)), chance.randint(0, len(data))))
    return data[:a] + data[min(b, a + 200) :]


def _flip(data: bytes, _other: bytes, chance: random.Random) -> bytes:
    at = chance.randint(0, max(0, len(data) - 1))
    return data[:at] + bytes([chance.randint(0, 255)]) + data[at + 1 :]


def _lines(data: bytes, other: bytes, chance: random.Random) -> bytes:
    mine, theirs = data.split(b"\n"), other.split(b"\n")
    at, take = chance.randint(0, len(mine)), chance.randint(0, len(theirs))
    return b"\n".join([*mine[:at], *theirs[take : take + chance.randint(1, 6)], *mine[at:]])


def _swap(data: bytes, other: bytes, chance: random.Random) -> bytes:
    mine, theirs = data.split(b" "), other.split(b" ")
    mine[chance.randrange(len(mine))] = chance.choice(theirs)
    return b" ".join(mine)


def _double(data: bytes, _other: bytes, chance: random.Random) -> bytes:
    a, b = sorted((chance.randint(0, len(data)), chance.randint(0, len(data))))
    return data[:b] + data[a:b] * chance.choice((1, 2, 30)) + data[b:]


_SPOILERS = (_put, _cut, _flip, _lines, _lines, _swap, _swap, _double)


def fuzz(reader: Reader, minutes: float, seed: int, keep: Path) -> Iterator[str]:
    """Spoil inputs for some minutes; yield a sentence for each finding, which is kept as a file."""
    chance = random.Random(seed)
    coverage = Coverage()
    end = time.monotonic() + minutes * 60
    runs, seen = 0, set[str]()
    corpus = [seed for seed in reader.seeds if len(seed) < _SMALL] or reader.seeds
    pending = list(corpus)
    while time.monotonic() < end:
        data = pending.pop() if pending else spoiled(*_two(corpus, chance), chance)
        runs += 1
        start = time.process_time()
        try:
            fresh = coverage.run(reader.read, data)
        except Exception as trouble:  # noqa: BLE001 - any is a finding
            fresh, sentence = False, f"{type(trouble).__name__}: {str(trouble)[:200]}"
        else:
            sentence = ""
        if not sentence and time.process_time() - start > SLOW:
            sentence = _slow(reader, data)
        if fresh:
            corpus.append(data)
        place = sentence.split(":")[0]
        if sentence and sentence not in seen:
            seen.add(sentence)
            name = f"{reader.name}-{hashlib.sha256(data).hexdigest()[:12]}"
            keep.mkdir(parents=True, exist_ok=True)
            (keep / name).write_bytes(data)
            yield f"{place}: {sentence} ({keep / name})"
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    print(
        f"{reader.name}: {runs} inputs, {len(corpus)} kept, {len(coverage.lines)} lines,"
        f" {len(seen)} findings, at most {peak} MB"
    )


def _two(corpus: list[bytes], chance: random.Random) -> tuple[bytes, bytes]:
    fresh = corpus[-30:] if chance.random() < 0.5 else corpus
    return chance.choice(fresh), chance.choice(corpus)


def _slow(reader: Reader, data: bytes) -> str:
    """Return a sentence where an input is slow without the trace too."""
    start = time.process_time()
    try:
        reader.read(data)
    except Exception as trouble:  # noqa: BLE001
        return f"{type(trouble).__name__}: {str(trouble)[:200]}"
    spent = time.process_time() - start
    return f"slow: {spent:.1f} s for {len(data)} bytes" if spent > SLOW else ""


def _functions() -> Iterator[Any]:
    """Give every function and method of the packages that are watched."""
    for name, module in list(sys.modules.items()):
        if not (getattr(module, "__file__", None) or "").startswith(OURS):
            continue
        for thing in vars(module).values():
            inside = vars(thing).values() if isinstance(thing, type) else (thing,)
            for one in inside:
                if isinstance(one, FunctionType) and one.__module__ == name:
                    yield one


def with_atheris(reader: Reader, minutes: float, keep: Path) -> None:
    """Let libFuzzer guide; it ends the process by itself."""
    import atheris  # noqa: PLC0415

    for function in _functions():
        atheris.instrument_func(function)
    corpus = keep / f"corpus-{reader.name}"
    corpus.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(reader.seeds):
        (corpus / f"seed-{number}").write_bytes(seed)
    limits = [f"-max_total_time={int(minutes * 60)}", "-timeout=5", "-rss_limit_mb=1500"]
    limits += [f"-artifact_prefix={keep}/{reader.name}-", "-max_len=4000"]
    atheris.Setup([sys.argv[0], *limits, str(corpus)], reader.read)
    atheris.Fuzz()


def main() -> int:
    """Fuzz, or read kept findings again; return 1 where anything was found."""
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__)
    parser.add_argument("files", nargs="*", type=Path, help="findings to read again")
    parser.add_argument("--what", choices=("script", "variant", "record"), help="only this reader")
    parser.add_argument("--minutes", type=float, default=1.0, help="for each reader")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, default=ROOT / "build" / "fuzz")
    parser.add_argument("--atheris", action="store_true", help="guided by libFuzzer")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        known = readers(Path(name))
        for path in chosen.files:
            known[path.name.split("-")[0]].read(path.read_bytes())
        if chosen.files:
            return 0
        found = 0
        for reader in known.values():
            if chosen.what not in (None, reader.name):
                continue
            if chosen.atheris:
                with_atheris(reader, chosen.minutes, chosen.keep)
            for sentence in fuzz(reader, chosen.minutes, chosen.seed, chosen.keep):
                found += 1
                print(sentence, flush=True)
    return int(found > 0)


if __name__ == "__main__":
    sys.exit(main())
