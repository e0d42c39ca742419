#!/usr/bin/env python3
"""Attacks the command: every verb and option, with bad streams, files, names and outputs, signals and limits.

`--seed S --only FAMILY:NUMBER` repeats a case. Exit code 1: a promise of docs/reliability.md was broken. Needs only the
standard library."""
import argparse
import concurrent.futures
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time

import attack_endings
import attack_files
import attack_names
import attack_options
import attack_outputs
import attack_streams
import attack_values
import command
import discovery
import inputs

FAMILIES = {"values": attack_values, "streams": attack_streams, "outputs": attack_outputs, "names": attack_names,
            "files": attack_files, "options": attack_options, "endings": attack_endings}
SHORT = 110  # cases of each family in the short form


class World:
    """The command, its verbs, the template of its inputs, and the cases of each family."""

    def __init__(self, tamis, template, has_limits):
        self.tamis, self.template, self.has_limits = tamis, pathlib.Path(template), has_limits
        self.verbs = discovery.verbs_of(tamis)
        self.cases = {name: list(family.cases(self)) for name, family in FAMILIES.items()}

    def baseline(self, verb, large=False):
        words = inputs.baseline(verb, large)
        return list(words) if words else [verb.name]


def require_baselines(world):
    """Exit if the baseline of a verb is an error: attacks on that verb would test nothing."""
    for verb in world.verbs:
        with tempfile.TemporaryDirectory() as place:
            folder = new_folder(world, place)
            outcome = folder.run(world.baseline(verb))
            if outcome.code == 2:
                sys.exit(f"hostile: {' '.join(outcome.words)}: {outcome.err.decode()}"
                         f"hostile: say in tools/command/tests/hostile/inputs.py how '{verb.name}' is asked")


def new_folder(world, place):
    shutil.copytree(world.template, f"{place}/here", symlinks=True)
    folder = command.Folder(world.tamis, f"{place}/here")
    folder.world = world
    return folder


def start_worker(*arguments):
    global WORLD
    WORLD = World(*arguments)


def attack(family, number, seed):
    """Make one attack; return which promise is broken, or None."""
    world_cases = WORLD.cases[family]
    with tempfile.TemporaryDirectory() as place:
        try:
            FAMILIES[family].attack(new_folder(WORLD, place), world_cases[number], random.Random(f"{seed}:{family}:{number}"))
        except command.Broken as broken:
            return str(broken).replace(place, "FOLDER")
    return None


def chosen(world, seed, only, is_long):
    """Return (family, number) of the cases of one round, in random order."""
    family, _, number = (only or "").partition(":")
    if number:
        return [(family, int(number))]
    order = random.Random(seed)
    picked = []
    for family, cases in [(family, world.cases[family])] if only else world.cases.items():
        numbers = range(len(cases))
        picked += [(family, n) for n in (numbers if is_long else order.sample(numbers, min(SHORT, len(numbers))))]
    order.shuffle(picked)
    return picked


def run_round(pool, world, seed, only, is_long, deadline):
    """Make the attacks of one round until `deadline`; return the number of cases, and of broken promises."""
    todo = iter(chosen(world, seed, only, is_long))
    running, done, broken = {}, 0, 0
    while True:
        while len(running) < 2 * os.cpu_count() and time.monotonic() < deadline and (case := next(todo, None)):
            running[pool.submit(attack, *case, seed)] = case
        if not running:
            return done, broken
        for future in concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED).done:
            family, number = running.pop(future)
            done += 1
            if future.result():
                broken += 1
                print(f"BROKEN --seed {seed} --only {family}:{number}: {future.result()}", flush=True)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tamis", required=True, help="the built command")
    parser.add_argument("--seconds", type=float, default=0, help="go on for so long, with new seeds; default: one short round")
    parser.add_argument("--seed", type=int, default=None, help="default: 1 for a short round, else the clock")
    parser.add_argument("--only", help="FAMILY or FAMILY:NUMBER; families: " + ", ".join(FAMILIES))
    parser.add_argument("--without-limits", action="store_true", help="of memory, files and sizes: a sanitizer needs more")
    return parser.parse_args()


def main():
    options = arguments()
    is_long = options.seconds > 0
    seed = options.seed if options.seed is not None else int(time.time()) if is_long else 1
    deadline = time.monotonic() + options.seconds if is_long else float("inf")
    with tempfile.TemporaryDirectory() as template:
        inputs.write_inputs(pathlib.Path(template))
        setting = (os.path.abspath(options.tamis), template, not options.without_limits)
        world = World(*setting)
        require_baselines(world)
        total = failures = 0
        with concurrent.futures.ProcessPoolExecutor(initializer=start_worker, initargs=setting) as pool:
            while True:
                done, broken = run_round(pool, world, seed, options.only, is_long, deadline)
                total, failures = total + done, failures + broken
                print(f"seed {seed}: {total} cases on {len(world.verbs)} verbs, {failures} broken", flush=True)
                seed += 1
                if not is_long or time.monotonic() >= deadline:
                    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
