"""Broad phases with ipctk's names, which change nothing: Tamis has its own."""


class BroadPhase:
    """Accepted where ipctk takes one, and ignored."""


class BruteForce(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class HashGrid(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class LBVH(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class SpatialHash(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class SweepAndPrune(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""
