#!/usr/bin/env python3
"""Compares two builds of tamis_matrix, cell by cell and in turns. Prints the ratios of time, old to new, worst first,
and their geometric mean. Answers that contradict each other are an error.

    benchmarks/matrix/compare.py OLD/bin/tamis_matrix NEW/bin/tamis_matrix --part daily --csv daily.csv
    benchmarks/matrix/compare.py OLD/bin/tamis_matrix NEW/bin/tamis_matrix --recorded
    benchmarks/matrix/compare.py OLD/bin/tamis_matrix NEW/bin/tamis_matrix --cells 'kick*/x3/*' --isa avx2 --repeat 7
    benchmarks/matrix/compare.py OLD/bin/tamis_matrix NEW/bin/tamis_matrix --sweep 0.8 --limit 60
    benchmarks/matrix/compare.py BUILD/bin/tamis_matrix BUILD/bin/tamis_matrix --threads 1,16 --cells '*-300k/*'

Parts (benchmarks/matrix/cells.hpp): night, every cell below a limit of work; daily, two cells of each scene and scale,
chosen so that every question, state and separation occurs, with every instruction set; quick, the short ones of the
daily cells. Cells that the night leaves out are counted at the start.

--sweep RATIO gives a first look at many cells: each is asked in one turn, and in all turns only if its ratio is below
RATIO. Answers that take longer than --limit are given up, and named at the end. (Use chrt -r with it, not -f: a build
that has a core for itself would keep this program from reading the clock.) After Ctrl-C or kill it prints what was
measured.
"""
import argparse
import collections
import csv
import fnmatch
import json
import select
import signal
import statistics
import subprocess
import sys

ISAS = ["baseline", "avx2", "avx512"]
RECORDED = [f"{scene}/x1/{question}/*/d0" for scene in ("cloth-ball", "cloth-funnel", "kick-62-63", "kick-63-64", "kick-64-65", "armadillo-rollers")
            for question in ("contacts", "earliest", "keep", "truncate", "within")]
LONG = 0.5  # seconds: a cell that takes longer is asked in at most two turns, whatever --repeat says


class GivenUp(Exception):
    """A build took longer than the limit; the message is the build's program."""


class Driver:
    """A process of one build that answers questions; it makes each scene once, and times questions by itself."""

    def __init__(self, program, isa, threads, limit):
        self.command = [program, "--isa", isa, *(["--threads", threads] if threads != "1" else []), "--serve"]
        self.limit = limit  # seconds; None: no limit
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        if not select.select([self.process.stdout], [], [], self.limit)[0]:
            self.process.kill()
            self.process.wait()
            self.start()
            raise GivenUp(self.command[0])
        answer = self.process.stdout.readline()
        if not answer:
            raise SystemExit(f"compare: {self.command[0]} ended at {line or 'a timed question'}")
        return json.loads(answer)


def contradiction(old, new):
    """Return how two answers to one cell contradict each other, or "". Brackets may differ, but must overlap."""
    if old["contacts"] != new["contacts"]:
        return f"{old['contacts']} and {new['contacts']} contacts"
    if old["pairs"] != new["pairs"]:
        return "other pairs touch"
    for old_lower, old_upper, new_lower, new_upper in zip(old["lower"], old["upper"], new["lower"], new["upper"]):
        if old_lower > new_upper or new_lower > old_upper:
            return f"times [{old_lower}, {old_upper}] and [{new_lower}, {new_upper}]"
    return ""


def parts_of(cell, questions):
    """Yield name, sum and largest time of each part's questions: a line search of 8 trials has those of 2 and 4."""
    if "/line/" not in cell:
        yield cell, sum(questions), max(questions)
        return
    for count in (2, 4, 8):
        yield cell.replace("/line/", f"/line{count}/"), sum(questions[:count]), max(questions[:count])


def medians_of(turns):
    """Return the median time of each question over the turns of one build."""
    return [statistics.median(times) for times in zip(*turns)]


def costs_of(cell, turns):
    """Return for each part of a cell its name, the old build's sum and largest time, then the new build's."""
    old, new = ([*parts_of(cell, medians_of(of_build))] for of_build in turns)
    return [(name, *of_old, *of_new) for (name, *of_old), (_, *of_new) in zip(old, new)]


def ask_in_turns(cell, drivers, turns, sweep):
    """Return the times of each build, turn by turn; with a sweep one turn alone, if all ratios are at least `sweep`."""
    times = [], []
    for turn in range(turns):
        for which in ((0, 1) if turn % 2 == 0 else (1, 0)):
            times[which].append(drivers[which].ask("")["ms"])
        if sweep and all(old_sum >= sweep * new_sum for _, old_sum, _, new_sum, _ in costs_of(cell, times)):
            break
    return times


def measure(cell, isa, drivers, asked):
    """Yield the rows of a cell. `drivers`: the old and the new build with one instruction set."""
    answers = [driver.ask(cell) for driver in drivers]
    turns = min(asked.repeat, 2) if answers[0]["seconds"] > LONG else asked.repeat
    times = ask_in_turns(cell, drivers, turns, asked.sweep)
    for name, old_sum, old_most, new_sum, new_most in costs_of(cell, times):
        yield {"cell": name, "isa": isa, "ratio": old_sum / new_sum, "old_ms": old_sum, "new_ms": new_sum,
               "old_most_ms": old_most, "new_most_ms": new_most,
               "old_second_ms": medians_of(times[0])[1] if "/line/" in cell else "", "turns": len(times[0]),
               "same_bits": answers[0]["bits"] == answers[1]["bits"], "old_boxes": boxes(answers[0]),
               "new_boxes": boxes(answers[1]), "contacts": answers[1]["contacts"], "bits": answers[1]["bits"],
               "problem": contradiction(*answers)}


def boxes(answer):
    return answer["counts"].get("boxes", "")


def number(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def print_group(title, ratios):
    print(f"{title:24} {len(ratios):6} cells, {sum(ratio < 1 for ratio in ratios):6} slower, "
          f"{sum(ratio < 0.95 for ratio in ratios):6} by more than 5%, worst {min(ratios):.3f}, "
          f"geometric mean {statistics.geometric_mean(ratios):.3f}")


def print_table(rows, sweep):
    """Print all cells (with a sweep those below its ratio), then the groups of all cells."""
    columns = ["ratio", "old_ms", "new_ms", "old_most_ms", "new_most_ms", "old_boxes", "new_boxes", "contacts", "isa",
               "cell", "problem"]
    print(" ".join(f"{column:>11}" for column in columns))
    shown = [row for row in rows if not sweep or row["ratio"] < sweep or row["problem"]]
    for row in sorted(shown, key=lambda row: row["ratio"]):
        print(" ".join(f"{number(row[column]):>11}" for column in columns))
    print()
    groups = collections.defaultdict(list)
    for row in rows:
        _, _, question, state, separation = row["cell"].split("/")
        for group in (f"{question}, {state}", f"separation {separation[1:]}", row["isa"]):
            groups[group].append(row["ratio"])
    for group, ratios in sorted(groups.items()):
        print_group(group, ratios)
    print_group("all", [row["ratio"] for row in rows])
    print_earliest_by_contacts(rows)


def print_earliest_by_contacts(rows):
    """Print the new build's ratios of time, earliest to contacts, for each scene, state and separation with both.

    The first contact should cost no more than all contacts.
    """
    ms = {(row["cell"], row["isa"]): row["new_ms"] for row in rows}
    pairs = ((cell, time, ms.get((cell.replace("/contacts/", "/earliest/"), isa))) for (cell, isa), time in ms.items()
             if "/contacts/" in cell)
    ratios = sorted((earliest / time, cell) for cell, time, earliest in pairs if earliest)
    if ratios:
        print(f"earliest by contacts     {len(ratios):6} cells, {sum(ratio > 1.1 for ratio, _ in ratios):6} above 1.1, "
              f"most {ratios[-1][0]:.3f} of {ratios[-1][1]}, geometric mean "
              f"{statistics.geometric_mean([ratio for ratio, _ in ratios]):.3f}")


def list_cells(program, part, patterns):
    command = [program, "--part", part, "--list", *patterns]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()


def cells_of_both(asked, patterns):
    """Return the cells that both builds know: an old build may lack a question."""
    known = set(list_cells(asked.old, asked.part, patterns))
    cells = list_cells(asked.new, asked.part, patterns)
    if len(cells) > len(known):
        print(f"not asked, as the old build does not know the question: {len(set(cells) - known)} cells", file=sys.stderr)
    return [cell for cell in cells if cell in known]


def print_left_out(program, patterns):
    steps = collections.Counter("/".join(cell.split("/")[:2]) for cell in list_cells(program, "left-out", patterns))
    if steps:
        print(f"left out, as too much work: {sum(steps.values())} cells: "
              + ", ".join(f"{count} of {step}" for step, count in steps.items()), file=sys.stderr)


def two_numbers(text):
    numbers = text.split(",")
    if len(numbers) != 2 or not all(number.isdecimal() for number in numbers):
        raise argparse.ArgumentTypeError(f"'{text}': give two numbers, of the old build and of the new one, as 1,16")
    return numbers


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", help="tamis_matrix, built against the old version")
    parser.add_argument("new")
    parser.add_argument("--part", choices=("night", "daily", "quick"), default="night", help="[night]")
    parser.add_argument("--cells", action="append", metavar="PATTERN", help="only these; may be given again")
    parser.add_argument("--recorded", action="store_true", help="the recorded steps alone: what the budget counts (CONTRIBUTING, A budget)")
    parser.add_argument("--without", action="append", default=[], metavar="PATTERN", help="not these")
    parser.add_argument("--repeat", type=int, default=3, metavar="N", help="turns a cell [3]")
    parser.add_argument("--sweep", type=float, metavar="RATIO", help="one turn only where no slower than this")
    parser.add_argument("--limit", type=float, metavar="SECONDS", help="wall clock of one answer, scene included")
    parser.add_argument("--threads", type=two_numbers, default="1,1", metavar="OLD,NEW", help="of each build; more than one are timed by "
                        "the wall clock, on a machine with nothing else to do [1,1]")
    parser.add_argument("--isa", metavar="NAME,...", help="instruction sets [night: best; else: all]")
    parser.add_argument("--csv", metavar="FILE", help="all rows, for plot.py")
    return parser.parse_args()


def isas_of(asked):
    if asked.isa:
        return asked.isa.split(",")
    return ["best"] if asked.part == "night" else ISAS


def measure_all(asked, cells):
    """Return the rows of all cells, and the answers that were given up; after an interrupt, those until then."""
    builds = [*zip((asked.old, asked.new), asked.threads)]
    drivers = {isa: [Driver(program, isa, threads, asked.limit) for program, threads in builds] for isa in isas_of(asked)}
    rows, given_up = [], []
    try:
        for i, cell in enumerate(cells):
            print(f"\r{i + 1}/{len(cells)} {cell:60}", end="", file=sys.stderr, flush=True)
            for isa, pair in drivers.items():
                try:
                    rows += measure(cell, isa, pair, asked)
                except GivenUp as build:
                    given_up.append(f"{cell}, {isa}, by {build}")
    except KeyboardInterrupt:
        print(" and no further", end="", file=sys.stderr)
    print(file=sys.stderr)
    return rows, given_up


def problems_of(rows):
    """Return cells whose answers contradict each other, or whose bits differ between the new build's instruction sets."""
    bits = collections.defaultdict(set)
    for row in rows:
        bits[row["cell"]].add(row["bits"])
    return ([row["cell"] for row in rows if row["problem"]] + [cell for cell, seen in bits.items() if len(seen) > 1])


def write(rows, name):
    if not name:
        return
    with open(name, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    for ending in (signal.SIGINT, signal.SIGTERM):  # the shell sets a background process to ignore SIGINT
        signal.signal(ending, signal.default_int_handler)
    asked = arguments()
    patterns = RECORDED if asked.recorded else asked.cells or ["*"]
    cells = cells_of_both(asked, patterns)
    cells = [cell for cell in cells if not any(fnmatch.fnmatch(cell, pattern) for pattern in asked.without)]
    if not cells:
        raise SystemExit("compare: no such cells")
    if asked.part == "night":
        print_left_out(asked.new, patterns)
    rows, given_up = measure_all(asked, cells)
    if rows:
        write(rows, asked.csv)
        print_table(rows, asked.sweep)
    for line in given_up:
        print(f"given up after {asked.limit:g} s: {line}")
    wrong = problems_of(rows)
    if wrong:
        raise SystemExit(f"compare: the answers of {len(wrong)} cells contradict each other: {', '.join(wrong[:5])} ...")


if __name__ == "__main__":
    main()
