"""Draws the contacts between two frames, coloured by time: contacts_by_time.py [START END] [--scale S] [--out PICTURE].

Without files it takes a generated scene.
"""

from __future__ import annotations

import argparse

import tamis

try:
    import matplotlib.pyplot as plt
except ModuleNotFoundError as missing:
    raise SystemExit(f"{missing}: pip install matplotlib") from None


def main() -> None:
    """Ask, and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", nargs="*", help="two mesh files")
    parser.add_argument("--scale", type=float, default=1.0, help="how much longer the motion is made")
    parser.add_argument("--size", type=float, default=3.0, help="of the dots")
    parser.add_argument("--out", default="contacts_by_time.png")
    arguments = parser.parse_args()
    if arguments.frames:
        first, last = tamis.read_frames(*arguments.frames)
        mesh, start, end = first.mesh, first.positions, last.positions
    else:
        mesh, start, end, _ = tamis.scene("colliding-bodies", 6000)
    end = start + arguments.scale * (end - start)

    contacts = tamis.Detector(mesh).contacts(start, end)
    print(f"{mesh}: {contacts}")

    figure = plt.figure(figsize=(9, 6), layout="constrained")
    axes = figure.add_subplot(projection="3d", computed_zorder=False)
    axes.plot_trisurf(*start.T, triangles=mesh.faces, color="#d5d5d5", linewidth=0, antialiased=False)
    where = contacts.points(start, end)[:, 0]
    # Early contacts are bright, late ones dark, as in the viewer.
    points = axes.scatter(*where.T, c=contacts.toi_lower, s=arguments.size, cmap="plasma_r", depthshade=False)
    figure.colorbar(points, ax=axes, shrink=0.7, label="time of impact, fraction of the step")
    axes.set_title(f"{len(contacts):,} contacts of one step, {len(mesh.faces):,} triangles")
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.savefig(arguments.out, dpi=150)


if __name__ == "__main__":
    main()
