"""The part of ipctk's interface for continuous collision detection: the same names and orders of arguments.

>>> import tamis.compat.ipctk as ipctk  # instead of: import ipctk

Broad phases are accepted and ignored: Tamis has its own, and the answer is about all pairs. Narrow phases decide only
how much of its distance every pair keeps; Tamis decides contacts exactly. The rest of ipctk (distances, barriers,
potentials, friction) is not here: import ipctk for it, and give it a mesh of its own. `tamis.bridge.ipctk` converts
near pairs and contacts for it.
"""

from typing import Any

from tamis.compat.ipctk._broad_phase import LBVH, BroadPhase, BruteForce, HashGrid, SpatialHash, SweepAndPrune
from tamis.compat.ipctk._mesh import CollisionMesh, edges
from tamis.compat.ipctk._narrow_phase import AdditiveCCD, NarrowPhaseCCD, TightInclusionCCD
from tamis.compat.ipctk._steps import (
    Candidates,
    compute_collision_free_stepsize,
    has_intersections,
    is_step_collision_free,
)
from tamis.compat.ipctk._threads import get_num_threads, set_num_threads

__all__ = [
    "LBVH",
    "AdditiveCCD",
    "BroadPhase",
    "BruteForce",
    "Candidates",
    "CollisionMesh",
    "HashGrid",
    "NarrowPhaseCCD",
    "SpatialHash",
    "SweepAndPrune",
    "TightInclusionCCD",
    "compute_collision_free_stepsize",
    "edges",
    "get_num_threads",
    "has_intersections",
    "is_step_collision_free",
    "set_num_threads",
]


def __getattr__(name: str) -> Any:
    if name.startswith("_"):
        raise AttributeError(name)
    raise AttributeError(
        f"tamis.compat.ipctk has no {name}: if ipctk has it, import ipctk beside this, and give it an "
        "ipctk.CollisionMesh made from the same positions, edges and faces; tamis.bridge.ipctk hands pairs over"
    )
