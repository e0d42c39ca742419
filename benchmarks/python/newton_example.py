"""Runs one of Newton's own cloth examples, alone or with Tamis, and prints seconds a frame and contacts in its steps.

newton_example.py twist|hanging|poker_cards|rollers [--frames N] [--last N] [--attach] [--buffers VERTEX EDGE]

Exit code 1 if some step has a contact. Runs in one thread; Newton's kernels are compiled at the first run.
"""

from __future__ import annotations

import argparse
import importlib
import time
from typing import Any

import newton
import newton.viewer
import numpy as np
import numpy.typing as npt
import warp as wp

import tamis
import tamis.newton


def example_of(name: str, buffers: list[int] | None) -> Any:
    """Return the example as it is shipped, except that it captures no CUDA graph, and for the sizes of buffers."""
    module = importlib.import_module(f"newton.examples.cloth.example_cloth_{name}")
    module.Example.capture = lambda example: setattr(example, "graph", None)
    made = newton.solvers.SolverVBD.__init__

    def with_buffers(solver: Any, *given: Any, **named: Any) -> None:
        if buffers:
            sizes = ("particle_vertex_contact_buffer_size", "particle_edge_contact_buffer_size")
            named.update(zip(sizes, buffers))
        made(solver, *given, **named)

    newton.solvers.SolverVBD.__init__ = with_buffers
    parser = getattr(module.Example, "create_parser", newton.examples.create_parser)
    return module.Example(newton.viewer.ViewerNull(num_frames=1), parser().parse_args([]))


class Recorder:
    """Counts the contacts of each step of a solver, from the floats at its start to those at its end, and its seconds.

    Contacts of neighbours count. Pairs of which no vertex moves in the step do not: only the caller can part them.
    """

    def __init__(self, solver: Any) -> None:
        model = solver.model
        self.counts: list[int] = []
        self.processor, self.wall = 0.0, 0.0
        self._detector = tamis.Detector(
            tamis.Mesh(model.tri_indices.numpy().reshape(-1, 3), vertex_count=model.particle_count)
        )
        self._step = solver.step
        solver.step = self.step

    def step(self, state_in: Any, state_out: Any, *rest: Any, **named: Any) -> None:
        """Take the solver's step, timed, and count its contacts."""
        start = state_in.particle_q.numpy().copy()
        processor, wall = time.process_time(), time.perf_counter()
        self._step(state_in, state_out, *rest, **named)
        self.processor += time.process_time() - processor
        self.wall += time.perf_counter() - wall
        end = state_out.particle_q.numpy()
        moves = (start != end).any(axis=1)
        self.counts.append(int(moves[self._detector.contacts(start, end).vertices].any(axis=1).sum()))


def count_seconds(solver: Any) -> list[float]:
    """Return a list of one number, to which the solver's own detection and truncation add their seconds."""
    spent = [0.0]

    def timed(call: Any) -> Any:
        def run(*given: Any, **named: Any) -> None:
            begin = time.perf_counter()
            call(*given, **named)
            spent[0] += time.perf_counter() - begin

        return run

    for name in ("_collision_detection_penetration_free", "_penetration_free_truncation"):
        setattr(solver, name, timed(getattr(solver, name)))
    return spent


def main() -> int:
    """Run, and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("example", choices=["twist", "hanging", "poker_cards", "rollers"])
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--last", type=int, help="seconds of so many frames at the end alone")
    parser.add_argument("--attach", action="store_true")
    parser.add_argument("--buffers", type=int, nargs=2)
    given = parser.parse_args()
    wp.config.quiet = True
    wp.set_device("cpu")
    example = example_of(given.example, given.buffers)
    report = tamis.newton.attach(example.solver, threads=1).report if given.attach else None
    spent = [] if report else count_seconds(example.solver)
    recorder = Recorder(example.solver)

    def seconds() -> npt.NDArray[np.float64]:
        """Return the seconds until now: of the processor, of the clock, of detection and truncation."""
        searching = report.detection_seconds + report.truncation_seconds if report else spent[0]
        return np.array([recorder.processor, recorder.wall, searching])

    last = min(given.last or given.frames, given.frames)
    before = np.zeros(3)
    for frame in range(given.frames):
        if frame == given.frames - last:
            before = seconds()
        example.step()
    processor, wall, searching = seconds() - before
    triangles, counts = example.solver.model.tri_count, recorder.counts
    print(f"{given.example}: {processor / last:.3f} s a frame, {triangles} triangles")
    print(f"{sum(counts)} contacts in {np.count_nonzero(counts)} of {len(counts)} steps")
    print(f"detection and truncation: {searching / wall:.0%}")
    print(report or "")
    return int(any(counts))


if __name__ == "__main__":
    raise SystemExit(main())
