"""Attacks by stdin, stdout and stderr that are closed or full."""
import itertools
import os

STATES = ["open", "closed", "full"]


def cases(world):
    for verb in world.verbs:
        asks = [["--help"], ["--no-such-option"], []] + ([["--json"]] if verb.has("--json") else [])
        yield from itertools.product([verb], asks, STATES, STATES, [False, True])


def attack(folder, case, random):
    verb, ask, out, err, closes_stdin = case
    words = folder.world.baseline(verb) + ask
    streams, closed = {}, [0] if closes_stdin else []
    for number, name, state in ((1, "out", out), (2, "err", err)):
        if state == "closed":
            closed.append(number)
        if state == "full":
            streams[name] = os.open("/dev/full", os.O_WRONLY)
    try:
        outcome = folder.run(words, closed=closed, **streams)
    finally:
        for descriptor in streams.values():
            os.close(descriptor)
    expected = 2 if ask == ["--no-such-option"] or out != "open" else 0 if ask == ["--help"] else None
    outcome.require(outcome.code in ((0, 1) if expected is None else (expected,)), f"stdout {out}, stderr {err}")
    folder.require_nothing_unfinished(outcome)
