"""Asks Tamis, ipctk and python-fcl the same questions about the same frames: compare.py FRAMES --out FOLDER.

FRAMES is the folder that holds cloth-ball and cloth-funnel. Answers are compared, too: Tamis decides exactly whether a
step that another package calls safe is free. Writes compare.csv, compare.md and compare.png.
"""

from __future__ import annotations

import argparse
import csv
import pathlib
import statistics
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import fcl
import ipctk
import matplotlib.pyplot as plt
import numpy as np
import trimesh

import tamis

SCENES = ("cloth-funnel", "cloth-ball")


class Row(NamedTuple):
    """One answer, with the median time of several runs, and a verdict: whether the answer is right."""

    scene: str
    question: str
    who: str
    threads: int
    milliseconds: float
    answer: str
    verdict: str


def median_ms(ask: Callable[[], Any], repeat: int) -> tuple[Any, float]:
    """Return the answer, and the median time of `repeat` runs after a first run (of the first if `repeat` is 0)."""
    times = []
    for _ in range(repeat + 1):
        begin = time.perf_counter()
        answer = ask()
        times.append(1000 * (time.perf_counter() - begin))
    return answer, statistics.median(times[1:] or times)


def ask_steps(scene: str, folder: pathlib.Path, threads: int, repeat: int) -> list[Row]:
    """Ask for all contacts, the first contact and the largest safe step of recorded cloth."""
    first, last = tamis.read_frames(folder)
    mesh, start, end = first.mesh, first.positions, last.positions
    detector = tamis.Detector(mesh, threads=threads)
    judge = tamis.Detector(mesh)
    rows = []

    def add(question: str, who: str, answer: str, ms: float, verdict: str) -> None:
        rows.append(Row(scene, question, who, threads, ms, answer, verdict))
        print(*rows[-1], sep="  ", flush=True)

    found, ms = median_ms(lambda: detector.contacts(start, end), 5 * repeat)
    add("all contacts", "tamis", f"{len(found):,} contacts", ms, "exact")
    earliest, ms = median_ms(lambda: detector.earliest(start, end), 5 * repeat)
    add("first contact", "tamis", f"{earliest.toi_lower:.6g}", ms, "exact")

    ipctk.set_num_threads(threads)
    surface = ipctk.CollisionMesh(start, mesh.edges, mesh.faces)
    columns = np.asfortranarray(start), np.asfortranarray(end)  # else ipctk copies them to this order in every call
    candidates = ipctk.Candidates()
    _, ms = median_ms(lambda: candidates.build(surface, *columns, broad_phase=ipctk.LBVH()), repeat)
    count = len(candidates.fv_candidates) + len(candidates.ee_candidates)
    add("candidates only", "ipctk, LBVH", f"{count:,} candidates", ms, "no contacts")

    phases = {"TightInclusion": ipctk.TightInclusionCCD(), "Additive": ipctk.AdditiveCCD()}
    kept = {"TightInclusion": 1e-4, "Additive": 0.1}
    for name, narrow in phases.items():
        safe, ms = median_ms(lambda f=kept[name]: detector.safe_step(start, end, f), 5 * repeat)
        add(f"safe step, as {name}", "tamis", f"{safe.toi_lower:.6g}", ms, "proven")

        def ask(narrow: Any = narrow) -> float:
            return ipctk.compute_collision_free_stepsize(surface, *columns, 0.0, ipctk.LBVH(), narrow)

        step, ms = median_ms(ask, repeat)
        is_free = judge.is_free(start, start + step * (end - start))
        ratio = step / earliest.toi_lower if earliest.toi_lower else 1
        add(
            f"safe step, as {name}",
            f"ipctk, {name}",
            f"{step:.6g}",
            ms,
            f"{'free' if is_free else 'NOT FREE'}, {ratio:.3f}",
        )
    return rows


def ask_spheres(subdivisions: int, repeat: int) -> list[Row]:
    """Ask about a sphere that moves towards another: python-fcl (and trimesh, which uses it) has only rigid motion."""
    sphere = trimesh.creation.icosphere(subdivisions)
    n, faces = len(sphere.vertices), np.asarray(sphere.faces)
    at, to = np.array([4.0, 0.1, 0.2]), np.array([0.0, 0.1, 0.2])
    start = np.concatenate([sphere.vertices, sphere.vertices + at])
    end = np.concatenate([sphere.vertices, sphere.vertices + to])
    detector = tamis.Detector(tamis.Mesh(np.concatenate([faces, faces + n])), threads=1)
    first, ms = median_ms(lambda: detector.earliest(start, end), 5 * repeat)
    scene, rows = f"two spheres, {2 * len(faces):,} triangles", []
    rows.append(Row(scene, "first contact", "tamis", 1, ms, f"{first.toi_lower:.9f}", "exact"))

    def body(position: np.ndarray) -> Any:
        model = fcl.BVHModel()
        model.beginModel(n, len(faces))
        model.addSubModel(sphere.vertices, faces)
        model.endModel()
        return fcl.CollisionObject(model, fcl.Transform(position))

    still, moving = body(np.zeros(3)), body(at)
    solvers = {
        "default": {},
        "naive, 1000 samples": {"ccd_solver_type": 0, "ccd_motion_type": 0, "num_max_iterations": 1000},
    }
    for name, choice in solvers.items():

        def ask(choice: dict[str, int] = choice) -> tuple[bool, float]:
            result = fcl.ContinuousCollisionResult()
            request = fcl.ContinuousCollisionRequest(**choice)
            fcl.continuousCollide(still, fcl.Transform(np.zeros(3)), moving, fcl.Transform(to), request, result)
            return result.is_collide, result.time_of_contact

        (collides, when), ms = median_ms(ask, repeat)
        late = when - first.toi_upper
        verdict = f"{late:.1e} too late: inside" if collides and late > 0 else "in time" if collides else "MISSED"
        rows.append(
            Row(scene, "first contact", f"python-fcl, {name}", 1, ms, f"{when:.9f}" if collides else "none", verdict)
        )
    for row in rows:
        print(*row, sep="  ")
    return rows


def short(milliseconds: float) -> str:
    """Return a number with three digits."""
    return f"{milliseconds:,.0f}" if milliseconds >= 100 else f"{milliseconds:#.3g}"


def draw(rows: list[Row], path: pathlib.Path) -> None:
    """Draw the times of each question on recorded cloth, side by side."""
    threads = min(row.threads for row in rows)
    scenes = [scene for scene in SCENES if any(row.scene == scene for row in rows)]
    figure, all_axes = plt.subplots(1, len(scenes), figsize=(11, 3.6), layout="constrained", squeeze=False)
    for axes, scene in zip(all_axes[0], scenes):
        chosen = [row for row in rows if row.scene == scene and row.threads == threads][::-1]
        bars = axes.barh(
            [f"{row.question}\n{row.who}" for row in chosen],
            [row.milliseconds for row in chosen],
            color=["#4d7fb3" if row.who == "tamis" else "#c8a24a" for row in chosen],
        )
        axes.bar_label(bars, [short(row.milliseconds) for row in chosen], padding=3, fontsize=8)
        axes.set(xscale="log", title=f"{scene}, {threads} thread{'s' if threads > 1 else ''}", xlabel="milliseconds")
        axes.margins(x=0.2)
        axes.tick_params(axis="y", labelsize=7)
    figure.savefig(path, dpi=150)


def main() -> None:
    """Ask, and write tables and picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--scenes", nargs="*", default=SCENES)
    parser.add_argument("--threads", type=int, nargs="*", default=[1])
    parser.add_argument("--repeat", type=int, default=3, help="runs of the others; of Tamis five times as many")
    arguments = parser.parse_args()
    rows = []
    for scene in arguments.scenes:
        for threads in arguments.threads:
            rows += ask_steps(scene, arguments.frames / scene, threads, arguments.repeat)
    rows += ask_spheres(4, arguments.repeat)
    arguments.out.mkdir(parents=True, exist_ok=True)
    with (arguments.out / "compare.csv").open("w", newline="") as file:
        csv.writer(file).writerows([Row._fields, *rows])
    lines = ["| scene | question | who | threads | ms | answer | checked |", "|---|---|---|--:|--:|---|---|"]
    lines += ["| " + " | ".join([*row[:3], str(row.threads), short(row.milliseconds), *row[5:]]) + " |" for row in rows]
    (arguments.out / "compare.md").write_text("\n".join(lines) + "\n")
    draw(rows, arguments.out / "compare.png")


if __name__ == "__main__":
    main()
