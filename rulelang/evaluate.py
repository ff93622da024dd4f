"""The referee's questions, asked in order: fouls, points, turn, table, next shot, ending.

One idea: a section's rules read what the sections before it left, and what they decide together
becomes the next section's view. Invariant: the order of rules inside a section never matters.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.closures import clear, fresh, opponent, singles
from rulelang.decisions import (
    Admission,
    Decisions,
    Ending,
    Foul,
    InHand,
    Required,
)
from rulelang.explain import Explanation
from rulelang.facts import Rest, Shot
from rulelang.program import CONSEQUENCE, SECTIONS, CompiledRule, Program
from rulelang.settle import (
    RuleClash,
    Turn,
    decide_in_hand,
    decide_phase,
    decide_turn,
    offers_of,
    sum_points,
    table_actions,
    write_state,
)
from rulelang.watch import OutOfFuel, Watch

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from rulelang.facts import Call, Situation
    from rulelang.vocabulary import Tracked

__all__ = ["Admission", "OutOfFuel", "RuleClash", "admit", "choose", "judge", "start"]

Fired = list[tuple[CompiledRule, list[tuple[Any, ...]]]]
FOULS, POINTS, TURN, TABLE, NEXT_SHOT, ENDING = range(1, 7)


def start(program: Program, situation: Situation) -> Decisions:
    """Return what the rules say at the start of a game: state, phase, ball in hand."""
    c = _watch(program, situation)
    c.state = _start_state(program, situation)
    c.next_player = situation.breaker
    c.shooter = situation.breaker
    first = program.phases[0] if program.phases else ""
    c.phase = c.next_phase = first
    c.stage = CONSEQUENCE
    fired = _fire(program.compiled.get("game start", ()), c)
    c.state = write_state(program, fired, c.state)
    turn = decide_turn(fired, c)
    return Decisions(
        points=sum_points(fired, c.players),
        state=c.state,
        phase=decide_phase(fired) or first,
        next_player=situation.breaker if turn.player is None else turn.player,
        table=table_actions(program, fired, c),
        in_hand=decide_in_hand(fired),
        offers=offers_of(fired),
        homes=_homes(program, c),
    )


def admit(program: Program, situation: Situation, call: Call | None = None) -> Admission:
    """Return what must be announced, what may be chosen, and which balls are on."""
    c = _watch(program, situation)
    c.call = call
    c.cue = program.bits[_cue_ball(program, situation.shooter)]
    c.objects = program.ball_mask & ~c.cue
    fired = _fire(_rules(program, "before shot", c.phase), c)
    required = tuple(Required(d[1], d[2]) for _, made in fired for d in made if d[0] == "require")
    on = frozenset[str]()
    if program.on is not None:
        on = frozenset(program.names[bit] for bit in singles(program.on(c) & c.on_before))
    return Admission(required, offers_of(fired), on)


def judge(program: Program, situation: Situation, shot: Shot, *, explain: bool = True) -> Decisions:
    """Return everything the rules decide about a shot.

    Raises RuleClash where two rules decide one thing differently and neither overrides.
    """
    return _judge(program, situation, shot, explain=explain)[1]


def _judge(
    program: Program, situation: Situation, shot: Shot, *, explain: bool
) -> tuple[Watch, Decisions]:
    c = _watch(program, situation)
    c.show(shot, program.settled_within)
    log: list[Any] | None = [] if explain else None
    views: list[tuple[Any, ...]] = []
    _judge_fouls(program, c, log)
    _keep(views, c, log)

    fired = _section(program, c, POINTS, log)
    points = sum_points(fired, c.players)
    state = write_state(program, fired, c.state)
    _enter(program, c, TURN)
    c.state = state
    if any(points):
        c.scores = tuple(a + b for a, b in zip(c.scores, points, strict=True))
    _keep(views, c, log)

    fired = _section(program, c, TURN, log)
    turn = decide_turn(fired, c)
    c.state = write_state(program, fired, c.state)
    c.continues, c.next_phase = turn.continues, decide_phase(fired) or c.phase
    c.next_player = _to_play(c, turn)
    _enter(program, c, TABLE)
    c.homes = _homes(program, c)
    _keep(views, c, log)

    fired = _section(program, c, TABLE, log)
    c.state = write_state(program, fired, c.state)
    c.actions = table_actions(program, fired, c)
    _enter(program, c, NEXT_SHOT)
    _keep(views, c, log)

    fired = _section(program, c, NEXT_SHOT, log)
    in_hand, offers = decide_in_hand(fired), offers_of(fired)
    before_next = c.state
    c.state = write_state(program, fired, c.state)
    written = {name for name in c.state if c.state[name] != before_next.get(name)}
    if fired and any(d[0] == "write" for _, made in fired for d in made):
        written |= {d[2] for _, made in fired for d in made if d[0] == "write"}
    _enter(program, c, ENDING)
    _keep(views, c, log)

    fired = _section(program, c, ENDING, log)
    c.state = write_state(program, fired, c.state)
    endings, eliminated = _endings(fired, situation)
    for ending in endings:
        last = _fire(program.compiled.get(f"{ending.unit} end", ()), c)
        c.state = write_state(program, last, c.state)
    next_player = _still_in(c, turn, eliminated)
    if offers and not endings:
        next_player = offers[0].player
    over = bool(endings)
    decisions = Decisions(
        fouls=c.fouls,
        points=points,
        state=_reset(program, c.state, turn, written),
        phase=c.next_phase,
        next_player=next_player,
        continues=turn.continues,
        table=tuple(a for a in c.actions if not (over and type(a).__name__ == "Rerack")),
        in_hand=None if over else in_hand,
        offers=() if over else offers,
        endings=endings,
        eliminated=eliminated,
        homes=c.homes,
        explanation=() if log is None else Explanation(program, c, log, views),  # type: ignore[arg-type]
    )
    return c, decisions


def choose(
    program: Program,
    situation: Situation,
    option: str,
    key: int | None,
    before: Situation | None,
    shot: Shot | None,
) -> Decisions:
    """Return what happens when `situation.shooter` chooses `option`.

    `key` is the offer's; without it the consequences are found by the option's name. `before`
    and `shot` are the judged situation and shot, None where nothing is known of them.
    """
    made = _consequence(program, option, key)
    if before is not None and shot is not None:
        c, judged = _judge(program, before, shot, explain=False)
        c.next_phase = judged.phase
    else:
        c = _watch(program, situation)
        c.cue = program.bits[_cue_ball(program, situation.shooter)]
        c.objects = program.ball_mask & ~c.cue
        if made is not None and made.to == "opponent":
            c.shooter = opponent(c, situation.shooter)
    clear(c.memo, tuple(range(program.memo_size)))
    c.chooser = c.next_player = situation.shooter
    c.phase = situation.phase if before is None else before.phase
    c.state, c.scores = situation.state, situation.scores
    rest = shot.rest if shot is not None else Rest(situation.zones, situation.frozen)
    c.shot = shot or Shot(program.names[c.cue], (), rest=rest)
    c.stage = CONSEQUENCE
    c.homes = _homes(program, c)
    c.actions = ()
    out: list[tuple[Any, ...]] = []
    rules = [rule for found in program.compiled.values() for rule in found]
    if made is not None:
        made.run(c, out)
    rule = next((r for r in rules if made is not None and r.number == made.rule), None)
    fired: Fired = [] if rule is None else [(rule, out)]
    return _chosen(program, situation, before, c, fired)


def _chosen(
    program: Program, situation: Situation, before: Situation | None, c: Watch, fired: Fired
) -> Decisions:
    acts = [d for _, made in fired for d in made]
    players = [d[1] for d in acts if d[0] == "plays" or (d[0] == "turn" and d[2] is not None)]
    restored = any(d[0] == "restore" for d in acts) and before is not None
    origin = before if restored and before is not None else situation
    player = players[0] if players else situation.shooter
    in_hand = decide_in_hand(fired)
    if in_hand is None and origin.in_hand is not None and not any(d[0] == "rerack" for d in acts):
        in_hand = InHand(player, origin.in_hand)
    endings, eliminated = _endings(fired, situation)
    return Decisions(
        points=sum_points(fired, c.players),
        state=write_state(program, fired, c.state),
        phase=decide_phase(fired) or origin.phase,
        next_player=player,
        continues=player == situation.shooter,
        table=table_actions(program, fired, c),
        in_hand=in_hand,
        offers=offers_of(fired),
        endings=endings,
        eliminated=eliminated,
        homes=c.homes,
    )


def _consequence(program: Program, option: str, key: int | None) -> Any:
    if key is not None and 0 <= key < len(program.consequences):
        return program.consequences[key]
    return next((one for one in program.consequences if one.option == option), None)


def _watch(program: Program, situation: Situation) -> Watch:
    c = Watch(program.bits, program.names, program.ball_mask, situation)
    c.values = program.values
    c.memo = fresh(program.memo_size)
    return c


def _cue_ball(program: Program, player: int) -> str:
    balls = program.vocabulary.cue_balls
    return balls[(player - 1) % len(balls)]


def _start_state(program: Program, situation: Situation) -> dict[str, Tracked]:
    state: dict[str, Tracked] = {}
    for name, track in program.tracked.items():
        if track.scope == "match" and name in situation.state:
            state[name] = situation.state[name]
        else:
            state[name] = start_of(program, name, situation)
    return state


def start_of(program: Program, name: str, situation: Situation) -> Tracked:
    """Return the value a tracked name starts with."""
    track = program.tracked[name]
    value = situation.breaker if track.by_breaker else track.start
    return (value,) * situation.players if track.per_player else value


def _judge_fouls(program: Program, c: Watch, log: Any) -> None:
    c.stage = FOULS
    early = _fire(_rules(program, "fouls", c.phase), c)
    c.fouls = _fouls(early)
    c.legal = not c.fouls
    late_rules = _rules(program, "late fouls", c.phase)
    if late_rules:
        clear(c.memo, program.staged)
        early += _fire(late_rules, c)
    fired, beaten = _override(early)
    if log is not None:
        log.append(((*program.compiled["fouls"], *program.compiled["late fouls"]), fired, beaten))
    c.fouls = _fouls(fired)
    c.legal = not c.fouls
    clear(c.memo, program.staged)


def _fouls(fired: Fired) -> tuple[Foul, ...]:
    found: dict[str, Foul] = {}
    alone: dict[str, Foul] = {}
    for rule, made in fired:
        for d in made:
            if d[0] != "foul":
                continue
            foul = Foul(d[1], d[2], rule.info.name, rule.info.cites)
            table = alone if d[3] else found
            if d[1] not in table or table[d[1]].worth < d[2]:
                table[d[1]] = foul
    return tuple((alone or found).values())


def _section(program: Program, c: Watch, stage: int, log: Any) -> Fired:
    c.stage = stage
    name = SECTIONS[stage]
    fired = _fire(_rules(program, name, c.phase), c)
    beaten: dict[int, CompiledRule] = {}
    if fired:
        fired, beaten = _override(fired)
    if log is not None:
        log.append((program.compiled[name], fired, beaten))
    return fired


def _rules(program: Program, section: str, phase: str) -> tuple[CompiledRule, ...]:
    """Return the rules of a section that can fire in a phase."""
    found = program.by_phase.get(section, {}).get(phase)
    if found is not None:
        return found
    rules = program.compiled.get(section, ())
    return tuple(rule for rule in rules if rule.phases is None or phase in rule.phases)


def _fire(rules: Iterable[CompiledRule], c: Watch) -> Fired:
    fired: Fired = []
    happened = c.happened
    for rule in rules:
        if rule.needs and not rule.needs & happened:
            continue
        made = rule.run(c)
        if made is not None:
            fired.append((rule, made))
    return fired


def _override(fired: Fired) -> tuple[Fired, dict[int, CompiledRule]]:
    """Withdraw the rules that a rule in force overrides; overrides have no circles."""
    overriding = [rule for rule, _ in fired if rule.overrides]
    if not overriding:
        return fired, {}
    beaten: dict[int, CompiledRule] = {}
    settled = False
    while not settled:
        now: dict[int, CompiledRule] = {}
        for rule in overriding:
            if rule.number not in beaten:
                for number in rule.overrides:
                    now.setdefault(number, rule)
        settled = now.keys() == beaten.keys()
        beaten = now
    return [(rule, made) for rule, made in fired if rule.number not in beaten], beaten


def _keep(views: list[tuple[Any, ...]], c: Watch, log: Any) -> None:
    """Keep what the next section sees, where an explanation may ask for it."""
    if log is not None:
        views.append(_view(c))


def _view(c: Watch) -> tuple[Any, ...]:
    return (
        c.fouls, c.legal, c.state, c.scores, c.next_phase, c.next_player, c.continues, c.actions,
        c.homes,
    )  # fmt: skip


def _enter(program: Program, c: Watch, stage: int) -> None:
    c.stage = stage
    clear(c.memo, program.staged)


def _to_play(c: Watch, turn: Turn) -> int:
    if turn.continues:
        return c.shooter
    return opponent(c, c.shooter) if turn.player is None else turn.player


def _still_in(c: Watch, turn: Turn, eliminated: frozenset[int]) -> int:
    player = c.next_player
    for _ in range(c.players):
        if player not in eliminated:
            return player
        player = player % c.players + 1
    return turn.player or player


def _homes(program: Program, c: Watch) -> Mapping[str, str]:
    return {program.names[bit]: spot for balls, spot in program.homes for bit in singles(balls(c))}


def _endings(fired: Fired, situation: Situation) -> tuple[tuple[Ending, ...], frozenset[int]]:
    found: dict[str, tuple[int, CompiledRule]] = {}
    out = set(situation.eliminated)
    for rule, made in fired:
        for d in made:
            if d[0] == "end":
                if d[1] in found and found[d[1]][0] != d[2]:
                    raise RuleClash("winner", found[d[1]][1], rule)
                found[d[1]] = (d[2], rule)
            elif d[0] == "seat":
                (out.add if d[2] else out.discard)(d[1])
    return tuple(Ending(unit, who) for unit, (who, _) in found.items()), frozenset(out)


def _reset(
    program: Program, state: Mapping[str, Tracked], turn: Turn, written: set[str]
) -> Mapping[str, Tracked]:
    """Set back what is tracked per shot, and per turn where the turn passes."""
    changed: dict[str, Tracked] = {}
    for name, track in program.tracked.items():
        if track.scope == "shot" or (track.scope == "turn" and not turn.continues):
            value = state.get(name)
            if name in written:
                continue
            changed[name] = (track.start,) * len(value) if isinstance(value, tuple) else track.start
    return {**state, **changed} if changed else state
