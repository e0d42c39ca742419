#!/usr/bin/python3
"""Draws the matrix as one picture: benchmarks/matrix/plot.py DAILY.csv PICTURE.png. Needs matplotlib (Debian:
python3-matplotlib). Prints the table of paper/notes/performance.md in Markdown.

DAILY.csv is from compare.py --csv. There is a panel for each instruction set. A square of it is one step, a scene at a
scale: how many times as fast as the old build the new one is, as the geometric mean of the step's cells."""
import csv
import math
import sys
from statistics import geometric_mean

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCALES = ["x0.01", "x0.1", "x1", "x3", "x10", "x30"]
ISAS = {"best": "AVX-512", "avx512": "AVX-512", "avx2": "AVX2", "baseline": "baseline"}
MOST = 4  # the ratio of the strongest colour
NAMES = {"all": "all", **{name: name for name in ("AVX-512", "AVX2", "baseline", "contacts", "earliest", "free")},
         "keep": "a kept distance, 0.2", "three": "contacts, earliest, free of one step", "new": "new", "kept": "kept",
         "line2": "line searches of 2", "line4": "of 4", "line8": "of 8 trials", "substeps": "substeps",
         "d0": "no separation", "d": "with a separation"}


def rows_of(path):
    """Yield each row with the parts of its cell's name: scene, scale, question, state, separation."""
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            scene, scale, question, state, separation = row["cell"].split("/")
            yield row | {"scene": scene, "scale": scale, "question": question, "state": state,
                         "separation": separation, "ratio": float(row["ratio"])}


def squares(rows, scenes):
    """Return the ratios of one instruction set: a line a scene, a column a scale; NaN where no cell was asked."""
    of_step = {}
    for row in rows:
        of_step.setdefault((row["scene"], row["scale"]), []).append(row["ratio"])
    return [[geometric_mean(of_step[scene, scale]) if (scene, scale) in of_step else math.nan for scale in SCALES]
            for scene in scenes]


def draw_panel(axes, values, title):
    image = axes.imshow([[math.log2(v) for v in line] for line in values], cmap="RdBu", aspect="auto",
                        vmin=-math.log2(MOST), vmax=math.log2(MOST))
    for y, line in enumerate(values):
        for x, value in enumerate(line):
            if not math.isnan(value):
                is_dark = abs(math.log2(value)) > 0.7 * math.log2(MOST)
                axes.text(x, y, f"{value:.2g}" if value < 10 else f"{value:.0f}", ha="center", va="center", fontsize=7,
                          color="white" if is_dark else "black")
    axes.set_xticks(range(len(SCALES)), SCALES, fontsize=8)
    axes.xaxis.tick_top()
    axes.set_title(title, fontsize=10)
    axes.tick_params(length=0)
    return image


def draw(rows, picture):
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    isas = list(dict.fromkeys(row["isa"] for row in rows))
    figure, panels = plt.subplots(1, len(isas), figsize=(2.2 + 2.9 * len(isas), 1 + 0.2 * len(scenes)), sharey=True,
                                  squeeze=False, layout="constrained")
    for axes, isa in zip(panels[0], isas):
        image = draw_panel(axes, squares([row for row in rows if row["isa"] == isa], scenes), ISAS[isa])
    panels[0][0].set_yticks(range(len(scenes)), scenes, fontsize=8)
    bar = figure.colorbar(image, ax=panels, shrink=0.5, ticks=range(-2, 3))
    bar.ax.set_yticklabels(["1/4", "1/2", "1", "2", "4"])
    bar.set_label("times as fast as before", fontsize=8)
    figure.savefig(picture, dpi=100)


def print_table(rows):
    print("| of | cells | slower by more than 5% | slowest | geometric mean |\n|---|--:|--:|--:|--:|")
    groups = {}
    for row in rows:
        separation = "d0" if row["separation"] == "d0" else "d"
        for group in ("all", ISAS[row["isa"]], row["question"], row["state"], separation):
            groups.setdefault(group, []).append(row)
    for group, name in NAMES.items():
        ratios = [row["ratio"] for row in groups.get(group, [])]
        if ratios:
            print(f"| {name} | {len(ratios)} | {sum(r < 0.95 for r in ratios)} | {min(ratios):.2f} | "
                  f"{geometric_mean(ratios):.2f} |")
    for isa in dict.fromkeys(ISAS.values()):
        long = [row["ratio"] for row in groups.get(isa, []) if float(row["old_ms"]) > 1]
        if long:
            print(f"{isa}, above a millisecond before: {geometric_mean(long):.1f}")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    rows = list(rows_of(sys.argv[1]))
    print_table(rows)
    draw(rows, sys.argv[2])


if __name__ == "__main__":
    main()
