"""Reads the hostile files of a folder in one process of bounded memory; prints how each fared.

`python hostile_child.py FOLDER`: every file of it whose name begins with `variant-` or `record-`.
A line of JSON for each: seconds of work, MiB that memory grew by, codes, the longest diagnostic,
and the exception where one got out.
"""

from __future__ import annotations

import json
import resource
import sys
from functools import cache
from pathlib import Path
from time import process_time

from engine.records.read import read_record
from engine.records.record import RecordError
from engine.variant.load import check_variant, load_variant
from rulelang.diagnostics import render

MEMORY = 400 * 1024 * 1024
"""Bytes that reading may ask for beyond what the program has when it is warm."""
load = cache(load_variant)


def codes_of(path: Path) -> list[str]:
    if path.name.startswith("variant-"):
        told = check_variant(path)
    else:
        try:
            read_record(path, load)
        except RecordError as error:
            told = error.diagnostics
        else:
            told = ()
    for one in told:
        if len(render(one)) > 3000:
            raise AssertionError(f"{one.code}: a diagnostic of {len(render(one))} characters")
    return [one.code for one in told]


def grown() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024


def main(folder: Path) -> None:
    check_variant("nine_ball")
    load("nine_ball")
    held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (held + MEMORY, held + MEMORY))
    for path in sorted(folder.iterdir()):
        if not path.name.startswith(("variant-", "record-")):
            continue
        before, begun, trouble, codes = grown(), process_time(), "", []
        try:
            codes = codes_of(path)
        except (Exception, MemoryError) as error:  # noqa: BLE001 - whatever got out is told
            trouble = f"{type(error).__name__}: {error}"
        seconds = process_time() - begun
        told = {"seconds": seconds, "grown": grown() - before, "codes": codes, "trouble": trouble}
        sys.stdout.write(json.dumps({"name": path.name, **told}) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
