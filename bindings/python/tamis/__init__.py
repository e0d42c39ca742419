"""Tamis: every contact between moving, deforming triangle meshes, and a proof that all other pairs are free.

>>> import tamis
>>> detector = tamis.Detector(tamis.Mesh(faces, vertex_count=len(start)))
>>> contacts = detector.contacts(start, end)

`Detector` answers questions about a mesh, step after step; `contacts` answers one in a single line; `narrow_phase`
decides a list of pairs. A `Path`, such as `RigidPath`, is motion on curves. A `World` holds bodies, each with a motion
of its own. `read_mesh`, `read_frames` and `scene` return meshes to try it on.
"""

from typing import TYPE_CHECKING, NoReturn

from tamis import _loading
from tamis._answers import EarliestContact, SafeStep, TruncatedStep
from tamis._audit._audit import audit
from tamis._audit._auditor import Auditor, StepReport
from tamis._audit._gltf import read_gltf
from tamis._audit._recorded import Motion
from tamis._audit._report import AuditReport
from tamis._audit._tables import AuditFrame, AuditFrames, AuditKind, AuditPair, AuditPairs
from tamis._audit._usd import read_usd
from tamis._detector._detector import Detector, contacts
from tamis._errors import Busy, Cancelled, Error, FileError, InvalidMesh, InvalidOptions, InvalidPath, InvalidStep
from tamis._files import MeshFile, read_frames, read_mesh, write_mesh
from tamis._kinds import PairKind
from tamis._mesh import Mesh
from tamis._pages import Page
from tamis._pair_distance import distance_of, safe_step
from tamis._pairs import PairResult, Pairs, narrow_phase
from tamis._paths._function_path import FunctionPath
from tamis._paths._path import BezierPath, CatmullRomPath, Path
from tamis._paths._rigid_path import (
    RigidPath,
    chain_between,
    interpolated_chain,
    nlerp_deviation,
    pose_at,
    pose_of,
    turned_chain,
)
from tamis._renamed import missing as _missing
from tamis._scenes import Scene, scene, scene_names, simulate, simulated_scenes
from tamis._statistics import Statistics
from tamis._tables._contacts import Contact, Contacts
from tamis._tables._near import Intersection, Intersections, NearPair, NearPairs
from tamis._weld import weld
from tamis._world._bodies import Deforming, Shape
from tamis._world._edges import EdgeAnswers, FirstBadEdge, FreeRoadmap
from tamis._world._linkage import Linkage
from tamis._world._tables import (
    BodyContact,
    BodyContacts,
    BodyIntersection,
    BodyIntersections,
    BodyNearPair,
    BodyNearPairs,
    BodyStep,
    EarliestBodyContact,
    EarliestMany,
)
from tamis._world._world import World

__version__: str = _loading.VERSION


if not TYPE_CHECKING:  # type checkers report any other name themselves

    def __getattr__(name: str) -> NoReturn:
        raise _missing("module 'tamis'", name)


__all__ = [
    "AuditFrame",
    "AuditFrames",
    "AuditKind",
    "AuditPair",
    "AuditPairs",
    "AuditReport",
    "Auditor",
    "BezierPath",
    "BodyContact",
    "BodyContacts",
    "BodyIntersection",
    "BodyIntersections",
    "BodyNearPair",
    "BodyNearPairs",
    "BodyStep",
    "Busy",
    "Cancelled",
    "CatmullRomPath",
    "Contact",
    "Contacts",
    "Deforming",
    "Detector",
    "EarliestBodyContact",
    "EarliestContact",
    "EarliestMany",
    "EdgeAnswers",
    "Error",
    "FileError",
    "FirstBadEdge",
    "FreeRoadmap",
    "FunctionPath",
    "Intersection",
    "Intersections",
    "InvalidMesh",
    "InvalidOptions",
    "InvalidPath",
    "InvalidStep",
    "Linkage",
    "Mesh",
    "MeshFile",
    "Motion",
    "NearPair",
    "NearPairs",
    "Page",
    "PairKind",
    "PairResult",
    "Pairs",
    "Path",
    "RigidPath",
    "SafeStep",
    "Scene",
    "Shape",
    "Statistics",
    "StepReport",
    "TruncatedStep",
    "World",
    "audit",
    "chain_between",
    "contacts",
    "distance_of",
    "interpolated_chain",
    "narrow_phase",
    "nlerp_deviation",
    "pose_at",
    "pose_of",
    "read_frames",
    "read_gltf",
    "read_mesh",
    "read_usd",
    "safe_step",
    "scene",
    "scene_names",
    "simulate",
    "simulated_scenes",
    "turned_chain",
    "weld",
    "write_mesh",
]
