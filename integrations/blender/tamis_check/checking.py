# SPDX-License-Identifier: GPL-3.0-or-later
"""Goes through the frames of a scene, and asks Tamis about each frame and each step between two frames."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .library import Trouble, tamis
from .recording import Selection, Topology, besides_meshes, frame_of, readable, topology_of

# The number of vertices of the first feature, by tamis.AuditKind: vf, ee, ve, vv, ef.
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
    faces: dict[str, np.ndarray] = field(default_factory=dict)  # of each object that was checked

    def __str__(self) -> str:
        if self.problem:
            return self.problem
        counts = [(self.intersections, "intersection"), (self.contacts, "contact")]
        return f"{', '.join(_counted(n, word) for n, word in counts if n)}: {self.who}"


def _counted(n: int, word: str) -> str:
    return f"{n} {word}" if n == 1 else f"{n} {word}s"


@dataclass
class Findings:
    """The findings so far."""

    frames: int = 0
    steps: int = 0
    bad: dict[int, BadFrame] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)  # objects that were not, or not wholly, asked about

    def __str__(self) -> str:
        if not self.frames:
            return "no frame was checked"
        frames, verb = _counted(self.frames, "frame"), "is" if len(self.bad) == 1 else "are"
        said = f"{len(self.bad)} of {frames} {verb} bad, the first is {min(self.bad, default=0)}"
        if not self.bad:
            said = f"{frames} and {_counted(self.steps, 'step')}, all free: proven"
        return said + (f"; not looked at: {', '.join(self.left_out)}" if self.left_out else "")


class Check:
    """One run over the frames. `run` yields after each frame; `findings` are complete until there."""

    def __init__(self, context: Any, frames: range, separation: float, rings: int) -> None:
        objects, left_out = readable(list(context.selected_objects))
        if not objects:
            raise Trouble("no mesh is selected: select the cloth, and what it must not pass through")
        if len(frames) == 0:
            raise Trouble("the last frame comes before the first: give them in their order")
        self.selection, self.frames = Selection(context.scene, context.view_layer, objects), frames
        self._separation, self._rings = separation, rings
        self._tamis = tamis()
        self._topology: Topology | None = None
        self._corners = np.empty(0)
        self._auditor: Any = None
        self._triangles: dict[int, set[int]] = {}
        self.findings = Findings(left_out=left_out)

    def run(self) -> Iterator[int]:
        """Ask about one frame after the other."""
        for frame in self.frames:
            self._ask(frame, *self.selection.at(frame))
            yield frame
        if not self.findings.frames:
            raise Trouble("what is selected has no faces and no edges in any frame: select meshes that have some")

    def _ask(self, frame: int, objects: list[Any], depsgraph: Any) -> None:
        hidden = [name for name in self.selection.names if name not in {thing.name_full for thing in objects}]
        left_out = [f"{name} where it is hidden" for name in hidden] + besides_meshes(objects, depsgraph)
        self.findings.left_out += [name for name in left_out if name not in self.findings.left_out]
        positions, corners = frame_of(objects, depsgraph)
        if not self._is_of(objects, corners):
            self._begin(frame, topology_of(objects, depsgraph), corners)
        if self._auditor is None:
            return
        self.findings.frames += 1
        step = self._auditor.add(positions, name=str(frame))
        self.findings.steps += step.frame.has_step
        pairs = step.pairs
        near = (pairs.rings >= 0) & (pairs.rings <= self._rings)
        pairs = pairs[~near]
        if step.problem or len(pairs):
            self.findings.bad[frame] = self._bad_frame(frame, step.problem, pairs, positions)

    def _is_of(self, objects: list[Any], corners: np.ndarray) -> bool:
        """Tell whether these are the faces and edges that are asked about."""
        names = [thing.name_full for thing in objects]
        return self._topology is not None and names == self._topology.names and np.array_equal(corners, self._corners)

    def _begin(self, frame: int, topology: Topology, corners: np.ndarray) -> None:
        if self._topology is not None:
            self.findings.notes.append(f"frame {frame}: the meshes have other faces from here on; no step leads there")
        self._topology, self._corners, self._auditor = topology, corners, None
        if topology.is_empty:
            return
        mesh = self._tamis.Mesh(topology.triangles, sum(topology.vertex_counts), topology.loose_edges)
        self._auditor = self._tamis.Auditor(
            mesh, objects=topology.vertices_of(), min_separation=self._separation, ring_limit=max(10, self._rings)
        )
        self._triangles = {}
        for number, triangle in enumerate(topology.triangles.tolist()):
            for vertex in triangle:
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
        """Return the faces from which triangles are cut, by object."""
        topology = self._topology
        owner = np.searchsorted(topology.first_vertices, topology.triangles[triangles, 0], side="right") - 1
        faces = topology.face_of_triangle[triangles]
        return {name: np.unique(faces[owner == i]) for i, name in enumerate(topology.names)}
