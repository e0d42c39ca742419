#!/usr/bin/python3
"""Draws the results of benchmarks/run.sh: benchmarks/plot.py RESULTS docs/pictures. Needs matplotlib (Debian:
python3-matplotlib).

Writes fitted exponents into the pictures' legends, and prints the tables of docs/performance.md in Markdown."""
import csv
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

TAMIS, OTHER, BLUE, GREY = "#d1495b", "#8d99ae", "#00798c", "#555555"
plt.rcParams.update({"font.size": 10, "axes.spines.top": False, "axes.spines.right": False, "figure.dpi": 150,
                     "axes.grid": True, "grid.alpha": 0.25, "grid.linewidth": 0.6, "legend.frameon": False})


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def rows_of(path):
    with open(path, newline="") as file:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def exponent(xs, ys):
    """Return the slope of the least-squares line through the logarithms."""
    u, v = [math.log(x) for x in xs], [math.log(y) for y in ys]
    mean_u, mean_v = sum(u) / len(u), sum(v) / len(v)
    return sum((a - mean_u) * (b - mean_v) for a, b in zip(u, v)) / sum((a - mean_u) ** 2 for a in u)


def table(header, lines):
    print("\n| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for line in lines:
        print("| " + " | ".join(line) + " |")


def ms(seconds):
    return f"{1e3 * seconds:.1f}" if seconds < 1 else f"{1e3 * seconds:.0f}"


def draw_size(results, pictures):
    figure, (time, memory) = plt.subplots(1, 2, figsize=(9.5, 3.9))
    lines = []
    for scene, colour in (("folded-cloth", TAMIS), ("colliding-bodies", BLUE)):
        rows = sorted((rows_of(p)[0] for p in results.glob(f"size-{scene}-*.csv")), key=lambda r: r["triangles"])
        if not rows:
            continue
        sizes = [r["triangles"] for r in rows]
        for key, style, word in (("cpu_cold", "--", "new"), ("cpu", "-", "kept")):
            values = [r[key] for r in rows]
            label = f"{scene}, {word}: $n^{{{exponent(sizes, values):.2f}}}$"
            time.loglog(sizes, values, style, color=colour, marker="o", markersize=3.5, label=label)
        memories = (("peak_memory_bytes", "--", "process"), ("detector_memory_bytes", "-", "detector"))
        for key, style, word in memories if scene == "folded-cloth" else ():  # the other's lines would lie on these
            values = [r[key] / 1e6 for r in rows]
            label = f"{scene}, {word}: $n^{{{exponent(sizes, values):.2f}}}$"
            memory.loglog(sizes, values, style, color=colour, marker="o", markersize=3.5, label=label)
        for r in rows:
            lines.append([scene, f"{r['triangles']:,.0f}", f"{r['contacts']:,.0f}", ms(r["cpu_cold"]), ms(r["cpu"]),
                          f"{1e9 * r['cpu'] / r['triangles']:.0f}", f"{r['detector_memory_bytes'] / 1e6:.0f}",
                          f"{r['peak_memory_bytes'] / 1e6:.0f}"])
    time.set(xlabel="triangles", ylabel="processor seconds, one thread", title="All contacts: time against size")
    memory.set(xlabel="triangles", ylabel="megabytes", title="Memory against size")
    for axes in (time, memory):
        axes.legend(fontsize=8, loc="upper left")
    figure.tight_layout()
    figure.savefig(pictures / "performance-size.png")
    table(["scene", "triangles", "contacts", "new ms", "kept ms", "kept ns a triangle", "detector MB", "process MB"],
          lines)


def draw_step(results, pictures):
    rows = rows_of(results / "step.csv")
    figure, (time, each) = plt.subplots(1, 2, figsize=(9.5, 3.7))
    lines = []
    for question, colour, word in (("contacts", TAMIS, "all contacts"), ("earliest", BLUE, "first contact")):
        picked = [r for r in rows if r["question"] == question]
        time.semilogy([r["scale"] for r in picked], [1e3 * r["cpu"] for r in picked], color=colour, marker="o",
                      markersize=3.5, label=word)
    all_contacts = [r for r in rows if r["question"] == "contacts"]
    scales = [r["scale"] for r in all_contacts]
    for key, colour, word in (("candidates", GREY, "pairs of moving boxes"), ("contacts", TAMIS, "contacts")):
        each.semilogy(scales, [r[key] for r in all_contacts], color=colour, marker="o", markersize=3.5, label=word)
    for r in all_contacts:
        first = next(e for e in rows if e["question"] == "earliest" and e["scale"] == r["scale"])
        lines.append([f"{r['scale']:.0f}", f"{r['candidates']:,.0f}", f"{r['contacts']:,.0f}", ms(r["cpu"]),
                      f"{1e6 * r['cpu'] / r['contacts']:.2f}", ms(first["cpu"])])
    time.set(xlabel="length of the step, 1 = as recorded", ylabel="processor ms, one thread, kept",
             title="cloth-ball: time against the length of the step")
    each.set(xlabel="length of the step, 1 = as recorded", ylabel="pairs", title="What there is to find")
    for axes in (time, each):
        axes.legend(fontsize=9)
    figure.tight_layout()
    figure.savefig(pictures / "performance-step.png")
    table(["step", "pairs of moving boxes", "contacts", "all contacts ms", "us a contact", "first contact ms"], lines)


def draw_contenders(results, pictures):
    data = json.loads((results / "contenders-ball.json").read_text())
    rows = [r for r in data["rows"] if r["threads"] == 1]
    groups = []
    for row in rows:
        if row["field"] not in groups:
            groups.append(row["field"])
    heights = [sum(r["field"] == g for r in rows) for g in groups]
    figure, axes = plt.subplots(len(groups), 1, figsize=(8.5, 0.34 * len(rows) + 0.75 * len(groups)),
                                gridspec_kw={"height_ratios": heights})
    for ax, group in zip(axes, groups):
        picked = sorted((r for r in rows if r["field"] == group), key=lambda r: -r["cpu"])
        values = [1e3 * r["cpu"] for r in picked]
        ax.barh([r["name"].replace(": boxes, build, search", "") for r in picked], values, height=0.65,
                color=[TAMIS if r["name"].startswith("tamis") else OTHER for r in picked])
        for i, row in enumerate(picked):
            wrong = f"   misses {row['missed']:,}" if row["missed"] else ""
            wrong += f", {row['extra']:,} wrong" if row["extra"] else ""
            ax.text(values[i], i, f" {values[i]:.0f} ms{wrong}", va="center", fontsize=9,
                    color="black" if not wrong else "#b00020")
        ax.set_title(group, loc="left", fontsize=10, fontweight="bold")
        ax.set_xlim(0, 1.25 * max(values))
        ax.grid(axis="y", visible=False)
        ax.set_xticks([])
        ax.spines["bottom"].set_visible(False)
    figure.suptitle(f"cloth-ball, {data['triangles']:,} triangles, {data['contacts']:,} contacts: "
                    "processor milliseconds, less is better; each panel has its own scale", fontsize=10, color=GREY)
    figure.tight_layout()
    figure.savefig(pictures / "performance-contenders.png")


def print_contenders(results):
    for name in ("funnel", "ball"):
        data = json.loads((results / f"contenders-{name}.json").read_text())
        print(f"\n**cloth-{name}**: {data['contacts']:,} contacts, {data['candidates']:,} pairs of swept boxes")
        lines = []
        for row in (r for r in data["rows"] if r["threads"] == 1):
            two = next((r for r in data["rows"] if r["name"] == row["name"] and r["field"] == row["field"]
                        and r["threads"] == 2), None)
            lines.append([row["field"].split(":")[0].split(",")[0], row["name"].replace(": boxes, build, search", ""),
                          ms(row["cpu"]), ms(row["seconds"]), ms(two["seconds"]) if two else "",
                          f"{row['vf']:,}", f"{row['ee']:,}", f"{row['missed']:,}", f"{row['extra']:,}"])
        table(["field", "who", "cpu ms", "ms, 1 thread", "ms, 2 threads", "vf", "ee", "missed", "extra"], lines)


def print_frames(results):
    lines = []
    for name in ("funnel", "ball"):
        for r in rows_of(results / f"{name}.csv"):
            lines.append([f"cloth-{name}", r["question"], f"{r['threads']:.0f}", ms(r["seconds_cold"]),
                          ms(r["seconds"]), ms(r["cpu_cold"]), ms(r["cpu"]),
                          f"{r['peak_memory_bytes'] / 1e6:.0f}"])
    table(["scene", "question", "threads", "new ms", "kept ms", "new cpu ms", "kept cpu ms", "process MB"], lines)
    table(["instruction set", "new cpu ms", "kept cpu ms"],
          [[r["isa"], ms(r["cpu_cold"]), ms(r["cpu"])] for r in rows_of(results / "isa.csv")])


def main():
    results, pictures = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    print_frames(results)
    print_contenders(results)
    draw_contenders(results, pictures)
    draw_size(results, pictures)
    draw_step(results, pictures)


if __name__ == "__main__":
    main()
