"""The other simulator's side of the speed table; run by its own interpreter, not by ours.

Reads works as JSON from standard input, plays each shot with `pooltool`, and writes one JSON line
for each work: times in ms and numbers of events. Needs nothing of this project.
"""

from __future__ import annotations

import json
import sys
from time import thread_time
from typing import Any

import pooltool as pt  # type: ignore[import-not-found]
from pooltool.objects.table import specs  # type: ignore[import-not-found]

Work = dict[str, Any]


def table_of(work: Work) -> Any:
    """Return a table of the work's kind and size."""
    kinds = {
        "pool": specs.PocketTableSpecs,
        "snooker": specs.SnookerTableSpecs,
        "carom": specs.BilliardTableSpecs,
    }
    return pt.Table.from_table_specs(kinds[work["kind"]](l=work["length"], w=work["width"]))


def system_of(work: Work, shot: dict[str, Any]) -> Any:
    """Return a system with the shot's balls; its long side is +y, ours is +x."""
    table, balls = table_of(work), {}
    for name, (x, y) in shot["layout"].items():
        at = work["width"] / 2 - y, work["length"] / 2 + x
        balls[name] = pt.Ball.create(name, xy=at, R=work["radius"], m=work["mass"])
    (vx, vy), (wx, wy, wz) = shot["velocity"], shot["spin"]
    moved = balls[work["ball"]]
    moved.state.rvw[1] = [-vy, vx, 0.0]
    moved.state.rvw[2] = [-wy, wx, wz]
    moved.state.s = pt.constants.sliding
    return pt.System(cue=pt.Cue(cue_ball_id=work["ball"]), table=table, balls=balls)


def play(work: Work) -> dict[str, object]:
    """Return the times (ms, processor) and events of a work's shots; the first is not counted."""
    times, events = [], []
    for number, shot in enumerate([work["shots"][0], *work["shots"]]):
        system = system_of(work, shot)
        begun = thread_time()
        pt.simulate(system, inplace=True)
        if number:
            times.append((thread_time() - begun) * 1000.0)
            events.append(len(system.events))
    return {"name": work["name"], "times": times, "events": events}


def main() -> None:
    """Answer every work, one line each."""
    print(json.dumps({"version": pt.__version__}), flush=True)
    for work in json.load(sys.stdin):
        try:
            answer = play(work)
        except Exception as error:  # noqa: BLE001  its bug is a row, not our end
            answer = {"name": work["name"], "error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
