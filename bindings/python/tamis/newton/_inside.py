"""The functions of Newton that `attach` replaces or relies on. Another version is welcome if these are the same."""

from __future__ import annotations

PACKAGE = "newton"
TESTED = "1.8.0"
# The fingerprints of tamis._versions. `step` is here, as nothing may move particles after the last iteration.
KNOWN = {
    "_src/solvers/vbd/solver_vbd.py": {
        "SolverVBD.step": "165072e3069b68c6",
        "SolverVBD._collision_detection_penetration_free": "805ab3a6419253fc",
        "SolverVBD._penetration_free_truncation": "b75a82a6da1a85d5",
        "SolverVBD._initialize_particles": "f6f601f456ce5a5d",
        "SolverVBD._solve_particle_iteration": "4093faa299206b6c",
        "SolverVBD.rebuild_bvh": "8f03f4e73cd90c37",
    },
    "_src/solvers/vbd/particle_vbd_kernels.py": {
        "apply_truncation_ts": "37a6d982ebb65062",
    },
    "_src/geometry/tri_mesh_collision.py": {
        "TriMeshCollisionInfo": "6bf5744ee790a091",
    },
}
