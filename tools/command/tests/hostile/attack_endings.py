"""Attacks by signals at any moment, and by limits of the system: output files must be complete, old or absent."""
import resource
import signal
import time

import command
import inputs

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE, signal.SIGKILL]
MOMENTS = 6
SIZES = [0, 1, 100, 600, 4000, 20000]
MEMORY = [8, 16, 24, 32, 40, 48, 64, 80, 100, 150, 250]  # MB
FILES = range(3, 9)


def writers(world):
    return [verb for verb in world.verbs if any(o.is_output_file or o.is_output_folder for o in verb.options)]


def cases(world):
    for verb in writers(world):
        yield from ((verb, "signal", number) for number in SIGNALS for _ in range(MOMENTS))
        yield from ((verb, "size", size) for size in (SIZES if world.has_limits else []))
    for verb in world.verbs if world.has_limits else []:
        yield from ((verb, "memory", size) for size in MEMORY)
        yield from ((verb, "files", count) for count in FILES)


def attack(folder, case, random):
    verb, kind, value = case
    words = folder.world.baseline(verb, large=True)
    option = next((o for o in verb.options if o.is_output_file), None)
    if option:
        out = folder.path / f"out{inputs.SUFFIXES.get(verb.name, '')}"
        words += [option.name, out.name]
        out.write_text("old")
    if kind == "signal":
        return attack_signal(folder, words, out if option else None, value, random)
    limit = {"size": resource.RLIMIT_FSIZE, "memory": resource.RLIMIT_AS, "files": resource.RLIMIT_NOFILE}[kind]
    outcome = folder.run(words, limits=[(limit, value << 20 if kind == "memory" else value)])
    if b"error while loading shared libraries" in outcome.err:
        return None  # a message of the system: the command did not begin
    command.check(outcome)
    folder.require_nothing_unfinished(outcome)
    if outcome.code == 2 and option:
        outcome.require(out.read_bytes() == b"old", "an error, and yet the old file is gone")
    return None


def attack_signal(folder, words, out, number, random):
    start = time.monotonic()
    whole = folder.run_and_check(words)
    seconds = time.monotonic() - start
    complete = out.read_bytes() if out else None
    if complete is not None:
        out.write_text("old")
    for path in folder.files():
        if any(part in ("frames", "laboratory") for part in path.parts):
            path.unlink()
    outcome = folder.interrupt(words, number, random.uniform(0.2, 1.1) * seconds)
    outcome.require(outcome.code in (-number, whole.code), f"neither ended by signal {number} nor done")
    if complete is not None:
        content = out.read_bytes()
        # Times in the output differ from run to run, so numbers of rows are compared.
        outcome.require(content == b"old" or content.count(b"\n") == complete.count(b"\n"),
                        "the output is neither old nor complete")
    again = folder.run_and_check(words + (["--resume"] if "paper" in words else []))
    again.require(again.code == whole.code, f"after signal {number} the same command does not go on")
