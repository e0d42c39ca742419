# SPDX-License-Identifier: GPL-3.0-or-later
"""Goes through the frames of a scene, and asks Tamis about each frame and about each step between two."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .library import Trouble, tamis
from .recording import Topology, frame_of, instancers, readable, topology_of

# How many vertices the first feature of each kind of pair has: vf, ee, ve, vv, ef, as in tamis.AuditKind.
_FIRST = (1, 2, 1, 1, 2)
_INTERSECTION = 4


@dataclass
class BadFrame:
    """A frame with intersections, or the end of a step with contacts."""

    frame: int
    intersections: int = 0
    contacts: int = 0
    problem: str = ""
    who: str = ""
    features: list[tuple[bool, np.ndarray]] = field(default_factory=list)  # of an intersection? where its vertices are
    faces: dict[str, np.ndarray] = field(default_factory=dict)  # by object

    def __str__(self) -> str:
        if self.problem:
            return self.problem
        counts = [(self.intersections, "intersections"), (self.contacts, "contacts")]
        return f"{', '.join(f'{n} {word}' for n, word in counts if n)}: {self.who}"


@dataclass
class Findings:
    """What was found so far."""

    frames: int = 0
    steps: int = 0
    bad: dict[int, BadFrame] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)  # objects of which something was not asked about

    def __str__(self) -> str:
        said = f"{len(self.bad)} of {self.frames} frames are bad, the first is {min(self.bad, default=0)}"
        if not self.bad:
            said = f"{self.frames} frames and {self.steps} steps, all free: proven"
        return said + (f"; not looked at: {', '.join(self.left_out)}" if self.left_out else "")


class Check:
    """One run over the frames; `run` yields after each, and may be left at any time: `findings` has what was done."""

    def __init__(self, scene: Any, selected: list[Any], frames: range, separation: float, rings: int) -> None:
        objects, left_out = readable(selected)
        if not objects:
            raise Trouble("no mesh is selected: select the cloth, and what it must not pass through")
        if len(frames) == 0:
            raise Trouble("the last frame comes before the first: give them in their order")
        self._scene, self._objects, self._frames = scene, objects, frames
        self._separation, self._rings = separation, rings
        self._tamis = tamis()
        self._topology: Topology | None = None
        self._auditor: Any = None
        self._triangles: dict[int, set[int]] = {}
        self.findings = Findings(left_out=left_out)

    def run(self, view_layer: Any) -> Iterator[int]:
        """Ask about one frame after the other."""
        for frame in self._frames:
            self._scene.frame_set(frame)
            view_layer.update()
            self._ask(frame, view_layer.depsgraph)
            yield frame

    def _ask(self, frame: int, depsgraph: Any) -> None:
        positions, corners = frame_of(self._objects, depsgraph)
        if self._topology is None or not np.array_equal(corners, self._corners):
            self._begin(frame, depsgraph, corners)
        step = self._auditor.add(positions, name=str(frame))
        self.findings.frames += 1
        self.findings.steps += step.frame.has_step
        pairs = step.pairs
        near = (pairs.rings >= 0) & (pairs.rings <= self._rings)
        pairs = pairs[~near]
        if step.problem or len(pairs):
            self.findings.bad[frame] = self._bad_frame(frame, step.problem, pairs, positions)

    def _begin(self, frame: int, depsgraph: Any, corners: np.ndarray) -> None:
        if self._topology is not None:
            self.findings.notes.append(f"frame {frame}: the meshes have other faces from here on; no step leads there")
        self._topology = topology = topology_of(self._objects, depsgraph)
        self._corners = corners
        instances = [f"instances of {name}" for name in instancers(self._objects, depsgraph)]
        self.findings.left_out += [name for name in instances if name not in self.findings.left_out]
        mesh = self._tamis.Mesh(topology.triangles, sum(topology.vertex_counts), topology.loose_edges)
        self._auditor = self._tamis.Auditor(
            mesh, objects=topology.vertices_of(), min_separation=self._separation, ring_limit=max(10, self._rings)
        )
        self._triangles = {}
        for number, corners in enumerate(topology.triangles.tolist()):
            for vertex in corners:
                self._triangles.setdefault(vertex, set()).add(number)

    def _bad_frame(self, frame: int, problem: str, pairs: Any, positions: np.ndarray) -> BadFrame:
        bad = BadFrame(frame, problem=problem)
        bad.intersections = int((pairs.kind == _INTERSECTION).sum())
        bad.contacts = len(pairs) - bad.intersections
        bad.who = "; ".join(sorted({" and ".join(sorted(set(pair.objects))) for pair in pairs}))
        chosen: set[int] = set()
        for kind, row in zip(pairs.kind.tolist(), pairs.vertices.tolist()):
            vertices = [v for v in row if v >= 0]
            for feature in (vertices[: _FIRST[kind]], vertices[_FIRST[kind] :]):
                bad.features.append((kind == _INTERSECTION, positions[feature]))
                chosen |= set.intersection(*(self._triangles.get(v, set()) for v in feature))
        bad.faces = self._faces_of(sorted(chosen))
        return bad

    def _faces_of(self, triangles: list[int]) -> dict[str, np.ndarray]:
        """Faces that triangles are cut from, by object."""
        topology = self._topology
        owner = np.searchsorted(topology.first_vertices, topology.triangles[triangles, 0], side="right") - 1
        faces = topology.face_of_triangle[triangles]
        return {topology.names[i]: np.unique(faces[owner == i]) for i in np.unique(owner).tolist()}
