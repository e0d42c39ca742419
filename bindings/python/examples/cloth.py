"""A cloth in a hundred lines of NumPy falls on a ball, and never passes through it or itself.

Springs pull, contacts push, and Tamis bounds each step so that every pair keeps at least a tenth of its distance.
"""

from __future__ import annotations

import argparse

import numpy as np

import tamis

try:
    import matplotlib.pyplot as plt
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
except ModuleNotFoundError as missing:
    raise SystemExit(f"{missing}: pip install matplotlib") from None

GAP = 0.01  # the distance to which contacts push features apart, in the unit of the positions


def grid(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the n x n vertices of a square at height 0.55, and its triangles."""
    x, y = np.meshgrid(np.linspace(-0.7, 0.7, n), np.linspace(-0.7, 0.7, n), indexing="ij")
    a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.stack([a, a + n, a + n + 1], 1), np.stack([a, a + n + 1, a + 1], 1)])
    return np.stack([x.ravel(), y.ravel(), np.full(n * n, 0.55)], 1), faces


def ball(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices of a sphere of radius 0.4 around the origin, in n rings of 2 n, and its triangles."""
    height = np.cos(np.linspace(0.02, np.pi - 0.02, n))
    angle = np.linspace(0, 2 * np.pi, 2 * n, endpoint=False)
    z, phi = np.meshgrid(height, angle, indexing="ij")
    points = 0.4 * np.stack([np.sqrt(1 - z**2) * np.cos(phi), np.sqrt(1 - z**2) * np.sin(phi), z], -1).reshape(-1, 3)
    ring, column = np.meshgrid(np.arange(n - 1), np.arange(2 * n), indexing="ij")
    a, b = (ring * 2 * n + column).ravel(), (ring * 2 * n + (column + 1) % (2 * n)).ravel()
    return points, np.concatenate([np.stack([a, a + 2 * n, b], 1), np.stack([b, a + 2 * n, b + 2 * n], 1)])


def pull(target: np.ndarray, springs: np.ndarray, rest: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Move both ends of each spring by half of its error times the end's weight, which averages where springs meet."""
    d = target[springs[:, 1]] - target[springs[:, 0]]
    length = np.linalg.norm(d, axis=1, keepdims=True)
    move = 0.5 * (1 - rest[:, None] / length) * d
    result = target.copy()
    np.add.at(result, springs[:, 0], move * weight[springs[:, 0], None])
    np.add.at(result, springs[:, 1], -move * weight[springs[:, 1], None])
    return result


def push(x: np.ndarray, target: np.ndarray, near: tamis.Contacts, moves: np.ndarray) -> np.ndarray:
    """Move the features of each near pair apart along its normal, until their distance is GAP."""
    weights = near.weights
    before = np.einsum("ni,nij,nj->n", weights, x[near.vertices], near.normal)
    after = np.einsum("ni,nij,nj->n", weights, target[near.vertices], near.normal)
    missing = np.maximum(GAP - np.sign(before) * after, 0) * np.sign(before)
    shares = weights * moves[near.vertices]
    shares *= (missing / np.maximum((weights * shares).sum(1), 1e-9))[:, None]
    change, count = np.zeros_like(x), np.ones(len(x))
    np.add.at(change, near.vertices, shares[:, :, None] * near.normal[:, None, :])
    np.add.at(count, near.vertices, (missing != 0)[:, None])
    return target + change / np.maximum(count - 1, 1)[:, None]


def main() -> None:
    """Simulate, and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=28)
    parser.add_argument("--vertices", type=int, default=41, help="along a side of the cloth")
    parser.add_argument("--out", default="cloth.png")
    arguments = parser.parse_args()
    (cloth, cloth_faces), (sphere, sphere_faces) = grid(arguments.vertices), ball(20)
    n = len(cloth)
    x = np.concatenate([cloth, sphere])
    mesh = tamis.Mesh(np.concatenate([cloth_faces, sphere_faces + n]))
    groups = np.repeat([0, 1], [n, len(sphere)])
    detector = tamis.Detector(mesh, groups=groups, may_touch=[[True, True], [True, False]])
    moves = 1.0 - groups  # the ball stays where it is
    springs = mesh.edges[mesh.edges[:, 1] < n]
    rest = np.linalg.norm(x[springs[:, 1]] - x[springs[:, 0]], axis=1)
    weight = moves / np.maximum(np.bincount(springs.ravel(), minlength=len(x)), 1)

    velocity, h, shortest = np.zeros_like(x), 1 / 120, 1.0
    for _ in range(2 * arguments.frames):
        target = x + h * (0.99 * velocity + h * moves[:, None] * [0, 0, -9.81])
        for _ in range(20):
            target = pull(target, springs, rest, 1.5 * weight)
        for _ in range(5):
            target = push(x, target, detector.contacts(x, target, min_separation=GAP), moves)
        safe = detector.safe_step(x, target)
        assert safe.toi_lower > 0
        shortest = min(shortest, safe.toi_lower)
        new = x + safe.toi_lower * (target - x)
        velocity, x = (new - x) / h, new
    print(
        f"{2 * arguments.frames} steps, the shortest went {shortest:.3f} of the way; lowest vertex {x[:n, 2].min():.3f}"
    )

    figure = plt.figure(figsize=(8, 6), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    colors = np.where(mesh.faces[:, :1] < n, [[0.36, 0.55, 0.75]], [[0.75, 0.72, 0.68]])
    # The ball is drawn smaller: matplotlib sorts triangles, not pixels, and would show a ball of full size through.
    drawn = np.where(groups[:, None] == 1, 0.95 * x, x)
    axes.add_collection3d(Poly3DCollection(drawn[mesh.faces], facecolors=colors, edgecolors=colors, shade=True))
    axes.set(xlim=(-0.48, 0.48), ylim=(-0.48, 0.48), zlim=(-0.5, 0.3))
    axes.view_init(elev=12, azim=4)
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.savefig(arguments.out, dpi=150)


if __name__ == "__main__":
    main()
