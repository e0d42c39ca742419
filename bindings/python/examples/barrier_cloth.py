"""A folded cloth falls into a pile: implicit Euler with ipctk's barrier, and Tamis in the line search.

A Newton step asks two questions: how far may it go (`Detector.safe_step`), and which pairs come within reach of the
barrier on the way there? The pairs, as `ipctk.Candidates`, serve every energy that the line search computes.
"""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np
import numpy.typing as npt

import tamis

try:
    import ipctk
    import matplotlib.pyplot as plt
    import scipy.sparse as sp

    from tamis.bridge import ipctk as bridge
except ModuleNotFoundError as missing:
    raise SystemExit(f"{missing}: pip install ipctk matplotlib scipy") from None

H = 0.005  # s, a step
GRAVITY = 9.81  # m/s^2
DENSITY = 0.2  # kg/m^2
STRETCHING = 100.0  # N/m: the stiffness of each edge's spring
BENDING = 0.02  # N/m: the stiffness that pulls each vertex to the mean of its neighbours
REACH = 0.001  # m: the barrier acts at smaller distances (ipctk's dhat)
STIFFNESS = 1e7  # of the barrier
Doubles = npt.NDArray[np.float64]


class Search:
    """Answers a line search about a step: how far it may go, and the candidates for collisions on the way there."""

    def __init__(self, mesh: Any, threads: int = 0) -> None:
        self.mesh = mesh
        self.detector = tamis.Detector(bridge.mesh(mesh), threads=threads)

    def __call__(self, start: Doubles, end: Doubles) -> tuple[float, Any]:
        """Return the safe fraction of the step, on which every pair keeps a tenth of its distance, and the candidates.

        These are all pairs that come within reach of the barrier on that part of the step.
        """
        part = self.detector.safe_step(start, end, 0.1).toi_lower
        pairs = self.detector.contacts(start, start + part * (end - start), min_separation=1.001 * REACH)
        return part, bridge.candidates(pairs, self.mesh)


class Cloth:
    """The energy that a step of implicit Euler minimises, without contacts: inertia, springs along edges, bending."""

    def __init__(self, flat: Doubles, edges: npt.NDArray[np.int32]) -> None:
        n, self.size = len(flat), flat.size
        numbers = np.repeat(np.arange(len(edges)), 2)
        self.difference = sp.csr_array((np.tile([1.0, -1.0], len(edges)), (numbers, edges.ravel())), (len(edges), n))
        self.length = self._stretch(flat)[1]
        self.mass = DENSITY / n  # of a vertex; the cloth has a square metre
        ends, others = np.concatenate([edges, edges[:, ::-1]]).T
        beside = sp.csr_array((np.ones(len(ends)), (ends, others)), shape=(n, n))
        curvature = sp.diags_array(beside.sum(1)) - beside
        curvature = curvature[np.abs(curvature @ flat).max(1) < 1e-9]  # only rows of inner vertices
        self.bending = BENDING * (curvature.T @ curvature)
        constant = sp.kron(self.bending + self.mass / H**2 * sp.eye_array(n), sp.eye_array(3), "coo")
        # The places of the Hessian's entries never change. A matrix of signs adds each spring's 3 x 3 block to them.
        rows, columns = np.concatenate([ends, ends]), np.concatenate([ends, others])
        x, y = np.indices((3, 3))
        entries = ((3 * rows[:, None, None] + x) * self.size + 3 * columns[:, None, None] + y).ravel()
        entries = np.concatenate([entries, constant.row.astype(int) * self.size + constant.col])
        places, place = np.unique(entries, return_inverse=True)
        own = 9 * len(edges)
        signs = np.repeat([1.0, -1.0], 2 * own), (place[: 4 * own], np.tile(np.arange(own), 4))
        self.gather = sp.csr_array(signs, shape=(len(places), own))
        self.constant = np.bincount(place[4 * own :], constant.data, len(places))
        self.columns = (places % self.size).astype(np.int32)
        self.starts = np.searchsorted(places, np.arange(self.size + 1) * self.size).astype(np.int32)

    def _stretch(self, x: Doubles) -> tuple[Doubles, Doubles]:
        d = self.difference @ x
        return d, np.sqrt(np.einsum("ij,ij->i", d, d))

    def value(self, x: Doubles, target: Doubles) -> float:
        """Return the energy in joules; `target`: the positions to which inertia and gravity alone would lead."""
        stretched = self._stretch(x)[1] - self.length
        moved = x - target
        inertia, bent = self.mass / H**2 * np.vdot(moved, moved), np.vdot(x, self.bending @ x)
        return float(inertia + STRETCHING * stretched @ stretched + bent) / 2

    def gradient(self, x: Doubles, target: Doubles) -> Doubles:
        """Return the gradient, shape (n, 3)."""
        d, length = self._stretch(x)
        force = (STRETCHING * (1 - self.length / length))[:, None] * d
        result: Doubles = self.mass / H**2 * (x - target) + self.bending @ x + self.difference.T @ force
        return result

    def hessian(self, x: Doubles) -> Any:
        """Return a positive definite approximation of the Hessian, without the sideways push of compressed springs."""
        d, length = self._stretch(x)
        u = d / length[:, None]
        sideways = np.maximum(1 - self.length / length, 0)
        own = (1 - sideways)[:, None, None] * u[:, :, None] * u[:, None, :] + sideways[:, None, None] * np.eye(3)
        return sp.csr_array((self.gather @ (STRETCHING * own.ravel()) + self.constant, self.columns, self.starts))


def solve(matrix: Any, right: Doubles) -> Doubles:
    """Solve by conjugate gradients until the residual is a tenth of `right`, or a direction has negative curvature.

    The result is a direction of descent in both cases.
    """
    inverse = 1 / np.abs(matrix.diagonal())
    x, way, residual, last = np.zeros_like(right), np.zeros_like(right), right.copy(), np.inf
    while residual @ residual > 0.01 * (right @ right):
        scaled = inverse * residual
        now = residual @ scaled
        way = scaled + now / last * way
        last, product = now, matrix @ way
        curvature = way @ product
        if curvature <= 0:
            return x if x.any() else way
        x += now / curvature * way
        residual -= now / curvature * product
    return x


def folded(cells: int, layers: int = 6, gap: float = 0.03) -> tuple[Doubles, Doubles, npt.NDArray[np.int64]]:
    """Return the pose of a square metre folded into layers at an angle to its edges, its flat pose, its faces."""
    s, t = (part.ravel() for part in np.meshgrid(*2 * [np.linspace(0, 1, cells + 1)], indexing="ij"))
    along, across = 0.95 * s + 0.3 * t, 0.95 * t - 0.3 * s
    radius = gap / 2
    straight = (along.max() - (layers - 1) * np.pi * radius) / layers
    layer = np.minimum(along // (straight + np.pi * radius), layers - 1)
    on = along - layer * (straight + np.pi * radius)
    turn = np.maximum(on - straight, 0) / radius
    x = np.minimum(on, straight) + radius * np.sin(turn)
    z = layer * gap + radius * (1 - np.cos(turn)) + 0.5 * gap
    pose = np.stack([np.where(layer % 2 == 0, x, straight - x), across, z], 1)
    i = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = (part.ravel() for part in (i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]))
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return pose, np.stack([along, across, 0 * z], 1), faces


class Scene:
    """The folded cloth above a fixed floor of two triangles."""

    def __init__(self, cells: int, search: Any = Search) -> None:
        pose, flat, faces = folded(cells)
        floor = np.array([[-1.0, -1, 0], [2, -1, 0], [2, 2, 0], [-1, 2, 0]])
        self.count = len(pose)  # vertices of the cloth; those of the floor follow
        self.x = np.concatenate([pose, floor])
        self.velocity = np.zeros_like(self.x)
        self.faces = np.concatenate([faces, np.array([[0, 1, 2], [0, 2, 3]]) + self.count])
        self.mesh = ipctk.CollisionMesh(self.x, ipctk.edges(self.faces), self.faces)
        self.cloth = Cloth(flat, ipctk.edges(faces))
        self.barrier = ipctk.BarrierPotential(REACH, STIFFNESS)
        self.collisions = ipctk.NormalCollisions()  # at the positions x
        self.collisions.build(self.mesh, self.x, REACH)
        self.search = search(self.mesh)
        self.newton_steps = 0

    def energy(self, x: Doubles, target: Doubles) -> float:
        """Return the energy that a step minimises."""
        return self.cloth.value(x[: self.count], target) + float(self.barrier(self.collisions, self.mesh, x))

    def direction(self, x: Doubles, target: Doubles) -> Doubles:
        """Return Newton's direction for all vertices; the floor's are zero."""
        n = self.count
        pushed = self.barrier.gradient(self.collisions, self.mesh, x).reshape(-1, 3)[:n]
        gradient = self.cloth.gradient(x[:n], target) + pushed
        stiff = self.barrier.hessian(self.collisions, self.mesh, x)
        matrix = self.cloth.hessian(x[:n]) + stiff.T[: 3 * n, : 3 * n]  # symmetric: its columns are rows
        return np.concatenate([solve(matrix, -gradient.ravel()).reshape(-1, 3), np.zeros((len(x) - n, 3))])

    def step(self) -> None:
        """Take a step of implicit Euler, by Newton's method until it moves vertices by less than 0.01 m/s."""
        x, n = self.x.copy(), self.count
        target = x[:n] + H * self.velocity[:n] - [0, 0, H * H * GRAVITY]
        before = self.energy(x, target)
        while True:
            move = self.direction(x, target)
            if np.abs(move).max() < 0.01 * H:
                break
            self.newton_steps += 1
            part, candidates = self.search(x, x + move)
            while True:
                new = x + part * move
                self.collisions.build(candidates, self.mesh, new, REACH)
                after = self.energy(new, target)
                if after <= before:
                    break
                part /= 2
            x, before = new, after
        self.velocity, self.x = (x - self.x) / H, x


def main() -> None:
    """Simulate, and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--steps", type=int, default=25)
    parser.add_argument("--cells", type=int, default=36, help="along a side of the cloth; two triangles each")
    parser.add_argument("--out", default="barrier_cloth.png")
    arguments = parser.parse_args()
    scene = Scene(arguments.cells)
    for _ in range(arguments.steps):
        scene.step()
    nearest = np.sqrt(scene.collisions.compute_minimum_distance(scene.mesh, scene.x))
    print(f"{arguments.steps} steps, {scene.newton_steps} of Newton's; {len(scene.collisions)} collisions, ", end="")
    print(f"the nearest {1000 * nearest:.2f} mm apart; height {scene.x[:, 2].max():.3f} m")

    figure = plt.figure(figsize=(8, 4), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    x, triangles = scene.x[: scene.count], scene.faces[:-2]
    axes.plot_trisurf(*x.T, triangles=triangles, color=(0.36, 0.55, 0.75), edgecolor=(0.2, 0.3, 0.45), lw=0.2)
    axes.view_init(elev=14, azim=-60)
    axes.set_box_aspect(np.ptp(x, axis=0), zoom=1.6)
    axes.set_axis_off()
    figure.savefig(arguments.out, dpi=150)


if __name__ == "__main__":
    main()
