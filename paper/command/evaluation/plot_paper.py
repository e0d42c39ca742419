#!/usr/bin/env python3
"""plot_paper.py FOLDER: draws Table 1, Fig. 4 and Fig. 5 from the CSV files that `tamis-lab paper` writes to FOLDER."""
import csv
import io
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_paper.py: matplotlib is not installed (Debian: python3-matplotlib)")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def bars(rows, groups, names, value, title, unit, path, log=True):
    """Draw a group of bars for each scene and step, with a bar of height value(rows, group, name) for each name."""
    figure, axes = pyplot.subplots(figsize=(12, 5))
    width = 0.85 / len(names)
    for i, name in enumerate(names):
        heights = [value(rows, group, name) for group in groups]
        color = pyplot.get_cmap("tab20")(2 * i % 20 + i // 10)
        axes.bar([g + (i - (len(names) - 1) / 2) * width for g in range(len(groups))], heights, width, label=name,
                 color=color)
    axes.set_xticks(range(len(groups)))
    axes.set_xticklabels([f"{scene} {step}".replace("$", r"\$") for scene, step in groups], rotation=25, ha="right")
    if log:
        axes.set_yscale("log")
    axes.set_ylabel(unit)
    axes.set_title(title)
    axes.grid(axis="y", alpha=0.3)
    axes.set_axisbelow(True)
    if len(names) > 1:
        axes.legend(fontsize=8, ncol=2, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.tight_layout()
    picture = io.BytesIO()
    figure.savefig(picture, dpi=110)
    pyplot.close(figure)
    unfinished = path.with_name(f".{path.name}.part")
    unfinished.write_bytes(picture.getvalue())
    unfinished.replace(path)


def main():
    folder = pathlib.Path(sys.argv[1])
    table, stages = read(folder / "table1.csv"), read(folder / "stages.csv")
    groups = list(dict.fromkeys((row["scene"], row["step"]) for row in table))
    methods = list(dict.fromkeys(row["method"] for row in table))
    cell = {(row["scene"], row["step"], row["method"]): row for row in table}

    def column(key):
        return lambda _, group, method: float(cell[(*group, method)][key])

    bars(table, groups, methods, column("ms_a_frame"), "Table 1: time a frame, one thread", "ms",
         folder / "table1.png")
    bars(table, groups, methods, column("elementary_tests"), "Fig. 4: elementary tests left by each method",
         "pairs, all steps", folder / "fig4.png")
    pairs = {(row["scene"], row["step"], row["stage"]): int(row["vf"]) + int(row["ee"])
             for row in stages if row["method"] == "paper"}

    def culled(_, group, what):
        after_dnf, after_ncf = pairs[(*group, "ncf-published")], pairs[(*group, "newton")]
        if what == "of pairs without contact":
            contacts = int(cell[(*group, "paper")]["contacts"])
            after_dnf, after_ncf = after_dnf - contacts, after_ncf - contacts
        return 100 * (1 - after_ncf / after_dnf) if after_dnf > 0 else 0

    bars(stages, groups, ["of all pairs", "of pairs without contact"], culled,
         "Fig. 5: culled by NCF of what DNF leaves", "%", folder / "fig5.png", log=False)


if __name__ == "__main__":
    main()
