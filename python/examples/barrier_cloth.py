"""A folded cloth that falls into a pile: implicit Euler with ipctk's barrier, and Tamis in the line search.

A Newton step asks twice: how far may it go (`Detector.keep_distance`), and which pairs come within reach of the barrier
on the way there. That one list, as `ipctk.Candidates`, serves every energy of the line search.
"""

from __future__ import annotations

import argparse
from typing import Any

import ipctk
import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
import scipy.sparse as sp
import scipy.sparse.linalg as solvers

import tamis
from tamis.bridge import ipctk as bridge

H = 0.01  # seconds a step
REACH = 0.001  # of the barrier, in metres
STIFFNESS = 1e7  # of the barrier
GRAVITY = 9.81
Doubles = npt.NDArray[np.float64]


class Search:
    """What a line search must know of a step: how far it may go, and the candidates for collisions on the way."""

    def __init__(self, mesh: Any) -> None:
        self.mesh = mesh
        self.detector = tamis.Detector(bridge.mesh(mesh), threads=1)

    def __call__(self, start: Doubles, end: Doubles) -> tuple[float, Any]:
        """Every pair keeps a tenth of its distance; no pair that comes within reach is left out."""
        part = self.detector.keep_distance(start, end, 0.1).lower
        near = self.detector.contacts(start, start + part * (end - start), min_separation=1.001 * REACH)
        return part, bridge.candidates(near, self.mesh)


class Springs:
    """The energy of springs along edges and across them, with derivatives; the Hessian is positive semidefinite."""

    def __init__(self, rest: Doubles, faces: npt.NDArray[np.int64], edges: npt.NDArray[np.int32]) -> None:
        corners = faces[:, [[0, 1, 2], [1, 2, 0], [2, 0, 1]]].reshape(-1, 3)  # an edge, and what lies opposite
        corners = corners[np.lexsort(np.sort(corners[:, :2]).T)]
        twin = (np.sort(corners[1:, :2]) == np.sort(corners[:-1, :2])).all(1)
        across = np.stack([corners[:-1, 2], corners[1:, 2]], 1)[twin]
        self.a, self.b = np.concatenate([edges, across]).T
        self.stiffness = np.repeat([100.0, 1.0], [len(edges), len(across)])
        self.length = np.linalg.norm(rest[self.a] - rest[self.b], axis=1)
        self.size = 3 * len(rest)
        # Entries of the Hessian never move: each goes straight to its place in a matrix of compressed rows.
        blocks = [(self.a, self.a), (self.a, self.b), (self.b, self.a), (self.b, self.b)]
        xyz = np.arange(3)
        rows = np.concatenate([np.broadcast_to(3 * i[:, None, None] + xyz[:, None], (len(i), 3, 3)) for i, _ in blocks])
        columns = np.concatenate([np.broadcast_to(3 * j[:, None, None] + xyz, (len(j), 3, 3)) for _, j in blocks])
        entries, self.place = np.unique(rows.ravel() * self.size + columns.ravel(), return_inverse=True)
        self.columns, starts = entries % self.size, np.arange(self.size + 1) * self.size
        self.starts = np.searchsorted(entries, starts)

    def _stretch(self, x: Doubles) -> tuple[Doubles, Doubles]:
        d = x[self.a] - x[self.b]
        return d, np.sqrt(np.einsum("ij,ij->i", d, d))

    def value(self, x: Doubles) -> float:
        """In joules."""
        return float(0.5 * self.stiffness @ (self._stretch(x)[1] - self.length) ** 2)

    def gradient(self, x: Doubles) -> Doubles:
        """By coordinate, one row a vertex."""
        d, length = self._stretch(x)
        force = (self.stiffness * (1 - self.length / length))[:, None] * d
        ends = np.concatenate([self.a, self.b])
        return np.stack([np.bincount(ends, np.concatenate([f, -f]), len(x)) for f in force.T], 1)

    def hessian(self, x: Doubles) -> Any:
        """What a compressed spring would push sideways is left out."""
        d, length = self._stretch(x)
        u = d / length[:, None]
        along, sideways = self.stiffness, self.stiffness * np.maximum(1 - self.length / length, 0)
        block = (along - sideways)[:, None, None] * u[:, :, None] * u[:, None, :] + sideways[:, None, None] * np.eye(3)
        entries = np.concatenate([block, -block, -block, block]).ravel()
        data = np.bincount(self.place, entries, len(self.columns))
        return sp.csr_matrix((data, self.columns, self.starts), (self.size, self.size))


def folded(cells: int, layers: int = 6, gap: float = 0.03) -> tuple[Doubles, Doubles, npt.NDArray[np.int64]]:
    """A square metre of cells x cells, laid in layers at an angle to its edges; the same flat; its triangles."""
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


class Cloth:
    """The folded cloth, on a floor of two triangles that stays where it is."""

    def __init__(self, cells: int, search: Any = Search) -> None:
        pose, flat, faces = folded(cells)
        floor = np.array([[-1.0, -1, 0], [2, -1, 0], [2, 2, 0], [-1, 2, 0]])
        self.count = len(pose)
        self.x = np.concatenate([pose, floor])
        self.velocity = np.zeros_like(self.x)
        self.faces = np.concatenate([faces, np.array([[0, 1, 2], [0, 2, 3]]) + self.count])
        self.mesh = ipctk.CollisionMesh(self.x, ipctk.edges(self.faces), self.faces)
        self.springs = Springs(flat, faces, ipctk.edges(faces))
        self.mass = 0.2 / self.count  # kilograms a vertex
        self.barrier = ipctk.BarrierPotential(REACH, STIFFNESS)
        self.collisions = ipctk.NormalCollisions()
        self.search = search(self.mesh)
        self.newton_steps = 0

    def energy(self, x: Doubles, target: Doubles) -> float:
        """What a step minimises: inertia, springs, and the barrier of the present collisions."""
        moved = x[: self.count] - target
        potential = self.springs.value(x[: self.count]) + self.barrier(self.collisions, self.mesh, x)
        return float(0.5 * self.mass * np.vdot(moved, moved) + H * H * potential)

    def direction(self, x: Doubles, target: Doubles) -> Doubles:
        """Newton's, of all vertices; the floor's rest."""
        n = self.count
        force = self.springs.gradient(x[:n]) + self.barrier.gradient(self.collisions, self.mesh, x).reshape(-1, 3)[:n]
        gradient = self.mass * (x[:n] - target) + H * H * force
        stiff = self.barrier.hessian(self.collisions, self.mesh, x, ipctk.PSDProjectionMethod.CLAMP)
        stiff = stiff.T[: 3 * n, : 3 * n]  # symmetric: columns are rows
        matrix = H * H * (self.springs.hessian(x[:n]) + stiff) + self.mass * sp.eye_array(3 * n, format="csr")
        jacobi = sp.diags_array(1 / matrix.diagonal())
        found, _ = solvers.cg(matrix, -gradient.ravel(), rtol=1e-2, M=jacobi)
        return np.concatenate([found.reshape(-1, 3), np.zeros((len(x) - n, 3))])

    def step(self) -> None:
        """Implicit Euler: Newton's method until it moves vertices by less than a centimetre a second."""
        x, n = self.x.copy(), self.count
        target = x[:n] + H * self.velocity[:n] - [0, 0, H * H * GRAVITY]
        self.collisions.build(self.mesh, x, REACH)
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
    cloth = Cloth(arguments.cells)
    for _ in range(arguments.steps):
        cloth.step()
    nearest = np.sqrt(cloth.collisions.compute_minimum_distance(cloth.mesh, cloth.x))
    print(f"{arguments.steps} steps, {cloth.newton_steps} of Newton's; {len(cloth.collisions)} collisions, ", end="")
    print(f"the nearest {1000 * nearest:.2f} mm apart; height {cloth.x[:, 2].max():.3f} m")

    figure = plt.figure(figsize=(8, 6), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    x = cloth.x[: cloth.count]
    axes.plot_trisurf(*x.T, triangles=cloth.faces[:-2], color=(0.36, 0.55, 0.75), edgecolor=(0.2, 0.3, 0.45), lw=0.2)
    axes.view_init(elev=12, azim=-80)
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.savefig(arguments.out, dpi=150)


if __name__ == "__main__":
    main()
