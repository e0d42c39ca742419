#!/usr/bin/env python3
"""Fails if a count of some cell of the matrix (nodes visited, pairs that enter a stage) is more than 5% above the
committed one. Counts are the same on every machine and instruction set. A change of cost is a decision: --update writes
the counts of now, and the commit says why.

    benchmarks/matrix/guard.py build/dev/bin/tamis_matrix              the quick part, as the tests do
    benchmarks/matrix/guard.py build/dev/bin/tamis_matrix --update     writes the counts of the quick part

If the data of recorded scenes is absent, their cells are skipped and counted. --update keeps the committed counts of
such cells, and drops cells that the quick part no longer has.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys

MOST_GROWTH = 1.05
COUNTS = ["nodes", "boxes", "slab", "apart", "near", "dnf", "ncf", "solve", "exact"]  # in the order of the pipeline
COMMITTED = pathlib.Path(__file__).with_name("counts.csv")


def counted(driver):
    """Return the counts of each cell of the quick part that can be asked here, by the cell's name."""
    lines = subprocess.run([driver, "--part", "quick", "*"], check=True, capture_output=True, text=True).stdout
    cells = {}
    for row in map(json.loads, lines.splitlines()):
        unknown = row["counts"].keys() - set(COUNTS)
        if unknown:
            raise SystemExit(f"guard: {row['cell']} counts {', '.join(unknown)}: name it in COUNTS")
        cells[row["cell"]] = {name: row["counts"].get(name, 0) for name in COUNTS}
    return cells


def committed():
    with open(COMMITTED, newline="") as file:
        return {row.pop("cell"): {name: int(count) for name, count in row.items()} for row in csv.DictReader(file)}


def write(cells):
    with open(COMMITTED, "w", newline="") as file:
        writer = csv.DictWriter(file, ["cell", *COUNTS], lineterminator="\n")
        writer.writeheader()
        writer.writerows({"cell": cell, **counts} for cell, counts in sorted(cells.items()))


def scene_of(cell):
    return cell.partition("/")[0]


def left_out(old, new):
    """Return the committed cells that the quick part no longer has although their scenes are here."""
    here = {scene_of(cell) for cell in new}
    return {cell for cell in old.keys() - new.keys() if scene_of(cell) in here}


def changes(old, new):
    """Yield cell, name, committed count and count of now, where the two differ by more than 5%."""
    for cell in sorted(old.keys() & new.keys()):
        for name in COUNTS:
            before, now = old[cell][name], new[cell][name]
            if max(before, now) > MOST_GROWTH * min(before, now):
                yield cell, name, before, now


def check(old, new):
    uncommitted = sorted(new.keys() - old.keys())
    for cell in uncommitted:
        print(f"{cell}: no committed counts")
    stale = left_out(old, new)
    for cell in sorted(stale):
        print(f"{cell}: counts of a cell that is not asked")
    grown = 0
    for cell, name, before, now in changes(old, new):
        grown += now > before
        print(f"{cell}: {name} {'grew' if now > before else 'fell'} from {before} to {now}")
    print(f"{len(new)} cells, {grown} counts grew by more than 5%; "
          f"{len(old.keys() - new.keys() - stale)} committed cells skipped: their recorded scenes are not here")
    if grown or uncommitted or stale:
        raise SystemExit("guard: is the cost meant? Then run this with --update and say why in the commit")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="tamis_matrix")
    parser.add_argument("--update", action="store_true")
    asked = parser.parse_args()
    new = counted(asked.driver)
    if not new:
        sys.exit("guard: the driver asked no cell")
    if asked.update:
        old = committed() if COMMITTED.exists() else {}
        write({cell: counts for cell, counts in old.items() if cell not in left_out(old, new)} | new)
    else:
        check(committed(), new)


if __name__ == "__main__":
    main()
