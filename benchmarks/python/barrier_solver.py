"""Times the example barrier_cloth with Tamis in its line search, and with ipctk's own: barrier_solver.py --out TABLE.

All simulate the same falling cloth in one thread, in turns of one step. After each step, not timed, ipctk builds the
collisions of that pose by itself. The solver must have the same pairs; the largest difference of squared distances is
printed.
"""

from __future__ import annotations

import argparse
import importlib.util
import pathlib
import time
from collections import defaultdict
from collections.abc import Callable
from functools import partial
from typing import Any

import ipctk
import numpy as np

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "bindings" / "python" / "examples" / "barrier_cloth.py"
_SPEC = importlib.util.spec_from_file_location("barrier_cloth", EXAMPLE)
example: Any = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(example)


class Own:
    """ipctk's line search: one list of candidates of the whole step, for the narrow phase and for the collisions."""

    def __init__(self, mesh: Any, narrow: Any) -> None:
        self.mesh, self.narrow = mesh, narrow

    def __call__(self, start: np.ndarray, end: np.ndarray) -> tuple[float, Any]:
        """Return the safe fraction of the step and the candidates, as the example's `Search`."""
        candidates = ipctk.Candidates()
        candidates.build(self.mesh, start, end, example.REACH / 2)
        return candidates.compute_collision_free_stepsize(self.mesh, start, end, 0.0, self.narrow), candidates


class Timed:
    """A scene, with the seconds of its steps and of its searches."""

    def __init__(self, name: str, cells: int, search: Callable[[Any], Any]) -> None:
        self.name, self.seconds = name, defaultdict(float)
        self.scene = example.Scene(cells, search)
        self.scene.search = self.timed("search", self.scene.search)
        self.step = self.timed("step", self.scene.step)

    def timed(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        """Return a function that also adds the seconds of each call to `seconds[name]`."""

        def call(*arguments: Any) -> Any:
            begin = time.perf_counter()
            answer = function(*arguments)
            self.seconds[name] += time.perf_counter() - begin
            return answer

        return call

    def collisions(self, own: bool) -> dict[Any, float]:
        """Return squared distances by kind and vertices of the solver's collisions, or (own) of those ipctk finds."""
        scene, found = self.scene, self.scene.collisions
        if own:
            found = ipctk.NormalCollisions()
            found.build(scene.mesh, scene.x, example.REACH)
        edges, faces = scene.mesh.edges, scene.mesh.faces
        each = [found[i] for i in range(len(found))]
        names = [(type(c).__name__, *sorted(c.vertex_ids(edges, faces))) for c in each]
        return {n: c.compute_distance(c.dof(scene.x, edges, faces)) for n, c in zip(names, each)}

    def error(self) -> float:
        """Return the largest difference of squared distances between the solver's collisions and ipctk's own."""
        ours, theirs = self.collisions(False), self.collisions(True)
        assert ours.keys() == theirs.keys(), f"{self.name}: {len(ours)} collisions, of ipctk alone {len(theirs)}"
        return max((abs(ours[name] - theirs[name]) for name in ours), default=0.0)


def run(cells: int, steps: int, narrow: dict[str, Any]) -> list[str]:
    """Simulate with all searches, and return the rows of the table."""
    searches = {"Tamis": partial(example.Search, threads=1)} | {n: partial(Own, narrow=p) for n, p in narrow.items()}
    scenes = [Timed(name, cells, search) for name, search in searches.items()]
    worst = 0.0
    for _ in range(steps):
        for one in scenes:
            one.step()
            worst = max(worst, one.error())
    print(f"{2 * cells**2} triangles: squared distances of collisions differ by {worst:.1e} at most", flush=True)
    best = min(one.seconds["step"] for one in scenes[1:])
    rows = []
    for one in scenes:
        total, search = one.seconds["step"], one.seconds["search"]
        rows.append(
            f"| {2 * cells**2:,} | {one.name} | {one.scene.newton_steps} | {total:.2f} | {100 * search / total:.0f}% "
            f"| {total / best:.2f} | {len(one.scene.collisions):,} |"
        )
        print(rows[-1], flush=True)
    return rows


def main() -> None:
    """Print the table, and write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, nargs="+", default=[36, 48])
    parser.add_argument("--steps", type=int, default=30)
    parser.add_argument("--without", choices=["TightInclusionCCD", "AdditiveCCD"], help="the slow one, say")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    ipctk.set_num_threads(1)
    ipctk.set_logger_level(ipctk.LoggerLevel.error)
    names = [name for name in ("AdditiveCCD", "TightInclusionCCD") if name != arguments.without]
    lines = ["| triangles | line search | Newton steps | seconds | of it search | to the best of ipctk | collisions |"]
    lines += ["|--:|---|--:|--:|--:|--:|--:|"]
    for cells in arguments.cells:
        lines += run(cells, arguments.steps, {name: getattr(ipctk, name)() for name in names})
    if arguments.out:
        arguments.out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
