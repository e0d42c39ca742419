"""A cloth of pybullet with self-collision falls on a ball; counts its contacts and intersections, and times both.

pybullet_cloth.py [--steps N]

Exit code 1 if there are any.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pybullet

import tamis

VERTICES_A_SIDE = 31
RATE = 240  # steps a second


def square() -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
    """Return the vertices and triangles of a square of one metre."""
    n = VERTICES_A_SIDE
    x, y = np.meshgrid(np.linspace(-0.5, 0.5, n), np.linspace(-0.5, 0.5, n), indexing="ij")
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(n * n)], axis=1)
    a = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
    faces = np.stack([a, a + n, a + 1, a + 1, a + n, a + n + 1], axis=1).reshape(-1, 3)
    return vertices, faces.astype(np.int32)


def make_scene() -> tuple[int, npt.NDArray[np.int32]]:
    """Make a cloth above a ball and a floor; return the cloth's number in pybullet, and its triangles."""
    vertices, faces = square()
    pybullet.connect(pybullet.DIRECT)
    pybullet.resetSimulation(pybullet.RESET_USE_DEFORMABLE_WORLD)
    pybullet.setGravity(0, 0, -10)
    pybullet.setTimeStep(1 / RATE)
    ball = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=0.15)
    pybullet.createMultiBody(0, ball, basePosition=[0.02, 0.01, 0.2])
    floor = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[2, 2, 0.1])
    pybullet.createMultiBody(0, floor, basePosition=[0, 0, -0.1])
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "cloth.obj"
        lines = ["v {:g} {:g} {:g}".format(*v) for v in vertices] + ["f {} {} {}".format(*f) for f in faces + 1]
        file.write_text("\n".join(lines) + "\n")
        cloth = pybullet.loadSoftBody(
            str(file),
            basePosition=[0, 0, 0.6],
            scale=1,
            mass=0.5,
            useNeoHookean=0,
            useBendingSprings=1,
            useMassSpring=1,
            springElasticStiffness=40,
            springDampingStiffness=0.1,
            springDampingAllDirections=1,
            useSelfCollision=1,
            frictionCoeff=0.5,
            useFaceContact=1,
            collisionMargin=0.003,
        )
    return cloth, faces


def positions_of(cloth: int) -> npt.NDArray[np.float64]:
    """Return where the vertices of a cloth are now, shape (n, 3)."""
    return np.array(pybullet.getMeshData(cloth, -1, flags=pybullet.MESH_DATA_SIMULATION_MESH)[1])


def main() -> int:
    """Run, and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--steps", type=int, default=480)
    steps = parser.parse_args().steps
    cloth, faces = make_scene()
    frames, spent = [positions_of(cloth)], 0.0
    for _ in range(steps):
        begin = time.process_time()
        pybullet.stepSimulation()
        spent += time.process_time() - begin
        frames.append(positions_of(cloth))
    begin = time.process_time()
    report = tamis.audit(np.stack(frames), faces=faces, threads=1)
    asked = time.process_time() - begin
    with_contacts = sum(step.contacts > 0 for step in report.steps)
    bad = sum(frame.intersections > 0 for frame in report.frames)
    print(f"contacts in {with_contacts} of {steps} steps, by rings {report.rings}; intersections in {bad} frames")
    if report.first_bad:
        print(f"the first bad frame is {report.first_bad.frame}")
    print(f"{1e3 * spent / steps:.1f} ms a step, {1e3 * asked / steps:.2f} to check it")
    return int(not report.is_free)


if __name__ == "__main__":
    raise SystemExit(main())
