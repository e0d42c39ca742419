"""Chooses the meshes of a USD stage that are audited."""

from __future__ import annotations

from typing import Any


def shown_meshes(stage: Any, roots: list[Any]) -> tuple[list[Any], list[str]]:
    """Return the meshes below some paths that are rendered, and the paths of other geometry, each with the reason.

    Proxies and guides lie where the meshes lie that they stand for. So these, and invisible meshes, are taken only if a
    path in `roots` names them, or one above them that is of their kind.
    """
    from pxr import Usd, UsdGeom

    meshes, left_out = {}, {}
    for root in roots:
        prims = iter(Usd.PrimRange(stage.GetPrimAtPath(root), Usd.TraverseInstanceProxies()))
        for prim in prims:
            why = _why_left_out(prim, stage.GetPrimAtPath(root))
            if prim.IsA(UsdGeom.PointInstancer):
                prims.PruneChildren()  # its children are the prototypes of its instances
            if why:
                left_out[prim.GetPath()] = f"{prim.GetPath()} ({why})"
            elif prim.IsA(UsdGeom.Mesh):
                meshes[prim.GetPath()] = UsdGeom.Mesh(prim)
    return list(meshes.values()), list(left_out.values())


def _why_left_out(prim: Any, root: Any) -> str:
    from pxr import UsdGeom

    if prim.IsA(UsdGeom.PointInstancer):
        return "point instancer"
    if not prim.IsA(UsdGeom.Gprim):
        return ""
    tokens = UsdGeom.Tokens
    purpose, named = UsdGeom.Imageable(prim).ComputePurpose(), root and UsdGeom.Imageable(root)
    if purpose not in (tokens.default_, tokens.render) and not (named and named.ComputePurpose() == purpose):
        return str(purpose)
    if _is_never_visible(prim) and not (named and _is_never_visible(root)):
        return "invisible"
    return "" if prim.IsA(UsdGeom.Mesh) else f"{prim.GetTypeName()}, no mesh"


def _is_never_visible(prim: Any) -> bool:
    from pxr import Usd, UsdGeom

    while prim and not prim.IsPseudoRoot():
        shown = UsdGeom.Imageable(prim).GetVisibilityAttr()
        times = shown.GetTimeSamples() or [Usd.TimeCode.Default()]
        if shown and all(shown.Get(time) == UsdGeom.Tokens.invisible for time in times):
            return True
        prim = prim.GetParent()
    return False
