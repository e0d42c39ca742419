#!/usr/bin/python3
"""Compares public peers with Tamis: benchmarks/peers/plot.py OURS.csv PICTURE.png. Needs matplotlib (Debian:
python3-matplotlib).

OURS.csv is from benchmarks/peers/run.sh. The peers' times are in peers.csv; they come from other runs on a machine of the
same kind, so read factors, not digits. Prints the table of docs/performance.md in Markdown."""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"Tamis": "#d1495b", "Self-CCD": "#edae49", "sccd (its broad phase not counted)": "#66a182",
           "ipc-toolkit + additive CCD": "#00798c", "ipc-toolkit + Tight-Inclusion": "#2e4057"}


def rows_of(path):
    with open(path, newline="") as file:
        return [row | {"ms": float(row["ms"])} for row in csv.DictReader(file)]


def steps_of(rows):
    """Return the rows of each question and scene that has more than one, in their order."""
    steps = {}
    for row in rows:
        steps.setdefault((row["question"], row["scene"]), []).append(row)
    return {step: picked for step, picked in steps.items() if len(picked) > 1}


def in_words(ms):
    return f"{ms:,.0f}" if ms >= 100 else f"{ms:.1f}"


def print_table(steps):
    print("| question | step | who | ms | times Tamis | |\n|---|---|---|--:|--:|---|")
    for (question, scene), rows in steps.items():
        ours = next(row["ms"] for row in rows if row["who"] == "Tamis")
        for row in sorted(rows, key=lambda row: row["ms"]):
            factor = "" if row["who"] == "Tamis" else f"{row['ms'] / ours:.0f}"
            print(f"| {question} | {scene} | {row['who']} | {in_words(row['ms'])} | {factor} | {row['note']} |")


def draw(steps, picture):
    figure, axes = plt.subplots(figsize=(9, 0.62 * len(steps) + 1.3))
    for place, rows in enumerate(reversed(steps.values())):
        axes.plot([min(r["ms"] for r in rows), max(r["ms"] for r in rows)], [place, place], color="#cccccc", zorder=1)
        for i, row in enumerate(sorted(rows, key=lambda row: row["ms"])):
            axes.scatter(row["ms"], place, s=75, color=COLOURS[row["who"]], zorder=2)
            above = (0, 7) if i % 2 == 0 else (0, -15)  # so that close ones do not cover each other
            axes.annotate(in_words(row["ms"]), (row["ms"], place), xytext=above, textcoords="offset points",
                          ha="center", fontsize=8)
    axes.set(xscale="log", xlabel="milliseconds, one thread", ylim=(-0.6, len(steps) - 0.3))
    axes.xaxis.set_major_formatter(lambda ms, _: f"{ms:,.0f}")
    axes.set_yticks(range(len(steps)), [f"{scene}: {question}" for question, scene in reversed(steps)])
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.grid(axis="x", alpha=0.3)
    handles = [plt.Line2D([], [], marker="o", linestyle="", color=colour, label=who) for who, colour in COLOURS.items()]
    figure.legend(handles=handles, loc="upper center", ncols=3, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    figure.savefig(picture, dpi=150)


def main():
    steps = steps_of(rows_of(sys.argv[1]) + rows_of(pathlib.Path(__file__).with_name("peers.csv")))
    print_table(steps)
    draw(steps, sys.argv[2])


if __name__ == "__main__":
    main()
