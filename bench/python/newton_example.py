"""One of Newton's own cloth examples, by itself or with Tamis: seconds a frame, and every contact of every step.

newton_example.py twist|hanging|poker_cards|rollers [--frames N] [--attach] [--buffers VERTEX EDGE]

Exit code 1 if some step touches. One thread; Newton's kernels are compiled at the first run.
"""

from __future__ import annotations

import argparse
import importlib
import time
from typing import Any

import newton
import newton.viewer
import numpy as np
import warp as wp

import tamis
import tamis.newton


def example_of(name: str, buffers: list[int] | None) -> Any:
    """Return the example as it is shipped, but for what it would capture and for the sizes of buffers."""
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
    """Takes the floats that each step of a solver starts and ends with."""

    def __init__(self, solver: Any) -> None:
        self.ways: list[tuple[Any, Any]] = []
        self.seconds = 0.0
        self._step = solver.step
        solver.step = self.step

    def step(self, state_in: Any, state_out: Any, *rest: Any, **named: Any) -> None:
        """Step, and remember."""
        start = state_in.particle_q.numpy().copy()
        begin = time.process_time()
        self._step(state_in, state_out, *rest, **named)
        self.seconds += time.process_time() - begin
        self.ways.append((start, state_out.particle_q.numpy().copy()))


def contacts_of(model: Any, ways: list[tuple[Any, Any]]) -> list[int]:
    """Count the contacts of each step, of neighbours, too."""
    mesh = tamis.Mesh(model.tri_indices.numpy().reshape(-1, 3), vertex_count=model.particle_count)
    detector = tamis.Detector(mesh)
    return [len(detector.contacts(start, end)) for start, end in ways]


def main() -> int:
    """Run, and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("example", choices=["twist", "hanging", "poker_cards", "rollers"])
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--attach", action="store_true")
    parser.add_argument("--buffers", type=int, nargs=2)
    given = parser.parse_args()
    wp.config.quiet = True
    wp.set_device("cpu")
    example = example_of(given.example, given.buffers)
    attachment = tamis.newton.attach(example.solver, threads=1) if given.attach else None
    recorder = Recorder(example.solver)
    for _ in range(given.frames):
        example.step()
    counts = contacts_of(example.solver.model, recorder.ways)
    print(
        f"{given.example}: {recorder.seconds / given.frames:.3f} s a frame, {example.solver.model.tri_count} triangles"
    )
    print(f"{sum(counts)} contacts in {np.count_nonzero(counts)} of {len(counts)} steps")
    if attachment:
        print(attachment.report)
    return int(any(counts))


if __name__ == "__main__":
    raise SystemExit(main())
