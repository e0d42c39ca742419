#!/usr/bin/env python3
"""evidence.py [--edges N] [--plans N] [--cases NAME...] [--out FOLDER] [--picture FILE]: the tables of docs/planners.md.

Random edges between valid configurations: proven by Tamis, sampled by coal (its wheel from PyPI) and FCL (Debian's libfcl-dev, if
it is there) at 10, 100 and 1000 states, all on the same meshes and one thread. Then plans by OMPL, whose edges Tamis proves or OMPL
samples. The truth comes from sampler.cpp, by another route. Needs requirements.txt, the module tamis, g++ and libeigen3-dev.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import pathlib
import subprocess
import sys
import time
import typing

import numpy as np
import scenes

HERE = pathlib.Path(__file__).resolve().parent
PREFIX = scenes.DATA.parents[2]
OURS = "Tamis"
COLUMNS = (("solved", "d"), ("collide", "d"), ("seconds", ".2f"), ("length", ".2f"))


def build(out: pathlib.Path) -> list[pathlib.Path]:
    """Compile the samplers: with FCL if it is installed, and with coal's wheel, which knows the truth."""
    libraries = {
        "sampler_fcl": ["-DWITH_FCL", "-lfcl", "-lccd", "-loctomap", "-loctomath"],
        "sampler_coal": ["-isystem", PREFIX / "include", PREFIX / "lib/libcoal.so", f"-Wl,-rpath,{PREFIX}/lib"],
    }
    programs = []
    for name, packages in libraries.items():
        command = ["g++", "-std=c++20", "-O3", "-DNDEBUG", "-isystem", "/usr/include/eigen3", HERE / "sampler.cpp", "-o", out / name]
        if subprocess.run([str(c) for c in [*command, *packages]], stderr=subprocess.DEVNULL).returncode == 0:
            programs.append(out / name)
        else:
            print(f"evidence: no {name}: libfcl-dev and libeigen3-dev, and coal of requirements.txt make it", file=sys.stderr)
    if not programs or programs[-1].name != "sampler_coal":
        sys.exit("evidence: without coal there is no truth")
    return programs


def write_scene(file: pathlib.Path, case: scenes.Case, starts: np.ndarray, ends: np.ndarray) -> None:
    """Write joints, bodies, pairs that count and edges as sampler.cpp reads them: whole numbers and doubles of 8 bytes."""
    parts: list[bytes] = []

    def put(kind: type, *numbers: typing.Any) -> None:
        parts.append(np.concatenate([np.ravel(n) for n in numbers]).astype(kind).tobytes())

    joints, bodies, dimension = [], [], 0
    for robot in case.scene.robots:
        first = len(joints)
        for joint in robot._joints:
            center = robot._joints[joint.parent].center if joint.parent >= 0 else np.zeros(3)
            parent = first + joint.parent if joint.parent >= 0 else -1
            joints.append((parent, joint.turns, dimension + joint.coordinate, joint.factor, joint.offset,
                           joint.center - center, joint.axis))  # fmt: skip
        bodies += [(first + link.joint if link.joint >= 0 else -1, link.shape) for link in robot._solid]
        dimension += len(robot.joints)
    links = len(bodies)
    bodies += [(-1, shape) for _, shape in case.obstacles]
    put(np.int64, len(joints))
    for parent, turns, coordinate, factor, offset, shift, axis in joints:
        put(np.int64, (parent, turns, coordinate))
        put(float, (factor, offset), shift, axis)
    put(np.int64, len(bodies))
    for joint, shape in bodies:
        put(np.int64, (joint, len(shape.points), len(shape.mesh.faces)))
        put(float, shape.points)
        put(np.int64, shape.mesh.faces)
    pairs = pairs_of(case, links, len(bodies))
    put(np.int64, len(pairs), pairs, (dimension, len(starts)))
    put(float, starts, ends)
    file.write_bytes(b"".join(parts))


def pairs_of(case: scenes.Case, links: int, bodies: int) -> np.ndarray:
    """Return the pairs of bodies that count: links with links that are not ignored, and with obstacles."""
    never, first = set(), 0
    for robot in case.scene.robots:
        number = {name: first + i for i, name in enumerate(robot.links)}
        never |= {frozenset((number[a], number[b])) for a, b in robot.ignored_pairs}
        first += len(number)
    return np.array([(a, b) for a in range(links) for b in range(a + 1, bodies) if frozenset((a, b)) not in never])


@dataclasses.dataclass
class Row:
    """What one method says of a case's edges."""

    case: str
    method: str
    free: int
    passed: int  # free by this method, and collides
    refused: int  # not free by this method, and free
    microseconds: float


def edges(case: scenes.Case, count: int, out: pathlib.Path, samplers: list[pathlib.Path]) -> tuple[list[Row], dict[str, int]]:
    starts, ends = scenes.edges_of(case, count)
    write_scene(out / "scene", case, starts, ends)
    case.scene.is_free(starts[:100], ends[:100])
    begin = time.process_time()  # a busy machine changes it less than the time of day
    ours = case.scene.is_free(starts, ends)
    seconds = time.process_time() - begin
    methods, flags = [], []
    for sampler in samplers:
        printed = subprocess.run([sampler, out / "scene", out / "flags"], check=True, stdout=subprocess.PIPE, text=True).stdout
        methods += [line.split("\t") for line in printed.splitlines()]
        flags += list(np.fromfile(out / "flags", np.uint8).reshape(-1, count))
    truth = flags[-1]
    answers = [(OURS, seconds, ours)]
    answers += [(name, float(spent), flags[i] == 0) for i, (name, spent) in enumerate(methods[:-1])]
    rows = [
        Row(case.name, name, int(free.sum()), int((free & (truth == 1)).sum()), int((~free & (truth == 0)).sum()), 1e6 * spent / count)
        for name, spent, free in answers
    ]
    return rows, {"edges": count, "collide": int((truth == 1).sum()), "open": int((truth == 2).sum())}


def plans(case: scenes.Case, count: int) -> dict[str, dict[str, float]]:
    """Plan between random configurations that no free edge joins: with proven edges, and as OMPL samples them by default."""
    from ompl import geometric as og
    from ompl import util

    from tamis.robots import ompl

    util.setLogLevel(util.LogLevel.LOG_ERROR)
    scene, found = case.scene, {}
    starts, ends = scenes.edges_of(dataclasses.replace(case, length=2 * case.length), 40 * count, seed=3)
    hard = np.flatnonzero(~scene.is_free(starts, ends))[:count]
    for method in ("proven", "sampled"):
        times, lengths, bad, solved = [], [], 0, 0
        for i in hard:
            setup = ompl.simple_setup(scene) if method == "proven" else sampled(scene)
            ompl.set_start_and_goal(setup, scene, starts[i], ends[i])
            setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
            begin = time.process_time()
            if not setup.solve(20.0) or not setup.haveExactSolutionPath():
                continue
            setup.simplifySolution(2.0)
            times.append(time.process_time() - begin)
            path = setup.getSolutionPath()
            solved += 1
            lengths.append(path.length())
            bad += not scene.first_bad_edge(ompl.waypoints_of(path, scene)).is_free
        found[method] = {"queries": len(hard), "solved": solved, "collide": bad,
                         "seconds": float(np.median(times)), "length": float(np.median(lengths))}  # fmt: skip
    return found


def sampled(scene: typing.Any) -> typing.Any:
    """Return OMPL's own setup: states at 1% of the space's extent."""
    from ompl import geometric as og

    from tamis.robots import ompl

    setup = og.SimpleSetup(ompl.space_of(scene))
    setup.setStateValidityChecker(lambda state: bool(scene.is_valid(ompl.configuration_of(state, scene))))
    return setup


def tables(rows: list[Row], facts: dict[str, typing.Any]) -> str:
    """Return the page's tables: of edges how many colliding ones pass, with microseconds an edge, and of plans."""
    methods = list(dict.fromkeys(row.method for row in rows))
    lines = ["| colliding edges passed (us an edge) | " + " | ".join(methods) + " |", "|---|" + "--:|" * len(methods)]
    for name, fact in facts.items():
        of = {row.method: row for row in rows if row.case == name}
        cells = [f"{of[m].passed:,} ({of[m].microseconds:,.0f})" if m in of else "" for m in methods]
        lines.append(f"| {name}: {fact['collide']:,} of {fact['edges']:,} collide | " + " | ".join(cells) + " |")
    refused = sum(row.refused for row in rows if row.method == OURS)
    lines += ["", f"Tamis refuses {refused} edges that are free by the truth, which leaves {sum(f['open'] for f in facts.values())} open.", ""]
    lines += ["| plans: proven, sampled | solved | collide | median s | median length |", "|---|--:|--:|--:|--:|"]
    for name, fact in facts.items():
        if fact.get("plans"):
            both = [fact["plans"][method] for method in ("proven", "sampled")]
            cells = (", ".join(f"{plan[key]:{form}}" for plan in both) for key, form in COLUMNS)
            lines.append(f"| {name}, {both[0]['queries']} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def picture(rows: list[Row], file: pathlib.Path) -> None:
    """Draw, for each scene, how many colliding edges a method passes, over its time an edge."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    names = list(dict.fromkeys(row.case for row in rows))
    figure, axes = plt.subplots(1, len(names), figsize=(3 * len(names), 3.2), sharey=True, squeeze=False)
    for axis, name in zip(axes[0], names):
        for package, colour in ((OURS, "#d9480f"), ("coal", "#1c7ed6"), ("FCL", "#5f6b76")):
            own = [row for row in rows if row.case == name and row.method.startswith(package)]
            axis.plot([r.microseconds / 1e3 for r in own], [r.passed for r in own], "o-", color=colour, label=package)
            for row in own[: 0 if package == OURS else None]:
                states, away = row.method.split(", ")[1].split()[0], (4, 4) if package == "coal" else (4, -11)
                axis.annotate(states, (row.microseconds / 1e3, row.passed), away, textcoords="offset points", fontsize=7, color=colour)
        axis.set(title=name, xscale="log", xlabel="ms an edge")
        axis.set_yscale("symlog", linthresh=1)
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("colliding edges passed")
    axes[0][0].set_ylim(-0.2)
    axes[0][-1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--edges", type=int, default=10000)
    parser.add_argument("--plans", type=int, default=20)
    parser.add_argument("--cases", nargs="*", default=["shelf", "slot", "two_arms", "hand"], choices=list(scenes.CASES))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/evidence"))
    parser.add_argument("--picture", type=pathlib.Path)
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    samplers = build(given.out)
    for name in given.cases:
        case = scenes.CASES[name]()
        rows, fact = edges(case, given.edges, given.out, samplers)
        facts = {**fact, "plans": plans(case, given.plans) if given.plans else {}}
        (given.out / f"{name}.json").write_text(json.dumps({"rows": [dataclasses.asdict(r) for r in rows], "facts": facts}))
        print(tables(rows, {case.name: facts}), flush=True)
    kept = [json.loads((given.out / f"{name}.json").read_text()) for name in scenes.CASES if (given.out / f"{name}.json").exists()]
    rows = [Row(**row) for part in kept for row in part["rows"]]
    (given.out / "tables.md").write_text(tables(rows, {part["rows"][0]["case"]: part["facts"] for part in kept}))
    if given.picture:
        picture(rows, given.picture)


if __name__ == "__main__":
    main()
