"""Bakes the skinned meshes of a USD stage into moving points, in a second stage over the same layers."""

from __future__ import annotations

from typing import Any

from tamis._audit._usd_times import played


def with_baked_skins(stage: Any, roots: list[Any]) -> Any:
    """Return a stage on which no mesh below `roots` needs a skeleton: the same stage if none has a skin."""
    from pxr import Sdf, Usd

    skinned = _skinned(roots)
    if not skinned:
        return stage
    layer = Sdf.Layer.CreateAnonymous("baked.usda")
    own = _opened_again(stage, layer)
    with Usd.EditContext(own, layer):
        for path in skinned:
            for above in path.GetPrefixes():  # prims within an instance cannot be written
                if own.GetPrimAtPath(above).IsInstance():
                    own.GetPrimAtPath(above).SetInstanceable(False)
            _bake(own, own.GetPrimAtPath(path))
    return own


def _opened_again(stage: Any, layer: Any) -> Any:
    """Return a second stage over the same layers, with `layer` as the strongest; the caller's stage is unchanged."""
    from pxr import Sdf, Usd

    session = Sdf.Layer.CreateAnonymous("session.usda")
    session.subLayerPaths.append(layer.identifier)
    if stage.GetSessionLayer():
        session.subLayerPaths.append(stage.GetSessionLayer().identifier)
    root, context, mask = stage.GetRootLayer(), stage.GetPathResolverContext(), stage.GetPopulationMask()
    own = Usd.Stage.OpenMasked(root, session, context, mask, Usd.Stage.LoadNone)
    own.MuteAndUnmuteLayers(list(stage.GetMutedLayers()), [])
    own.SetLoadRules(stage.GetLoadRules())
    own.SetInterpolationType(stage.GetInterpolationType())
    return own


def _skinned(roots: list[Any]) -> list[Any]:
    """Return the paths of the UsdSkel roots above or below some prims."""
    from pxr import Usd, UsdSkel

    found: list[Any] = []
    for root in roots:
        above = UsdSkel.Root.Find(root)
        for prim in Usd.PrimRange(above.GetPrim() if above else root, Usd.TraverseInstanceProxies()):
            if prim.IsA(UsdSkel.Root) and prim.GetPath() not in found:
                found.append(prim.GetPath())
    return found


def _bake(stage: Any, root: Any) -> None:
    """Write the points of the meshes at each frame of the stage: joints turn, points move on arcs between keys."""
    from pxr import Usd, UsdSkel

    cache, root = UsdSkel.Cache(), UsdSkel.Root(root)
    cache.Populate(root, Usd.PrimDefaultPredicate)
    for binding in cache.ComputeSkelBindings(root, Usd.PrimDefaultPredicate):
        animation = UsdSkel.Animation(cache.GetSkelQuery(binding.GetSkeleton()).GetAnimQuery().GetPrim())
        if animation:
            _write_frames(stage, animation)
    UsdSkel.BakeSkinning(root)


def _write_frames(stage: Any, animation: Any) -> None:
    attributes = [
        animation.GetTranslationsAttr(),
        animation.GetRotationsAttr(),
        animation.GetScalesAttr(),
        animation.GetBlendShapeWeightsAttr(),
    ]
    times = played(stage, sorted({time for attribute in attributes for time in attribute.GetTimeSamples()}))
    for attribute in attributes:
        if attribute.ValueMightBeTimeVarying():
            for time, value in [(time, attribute.Get(time)) for time in times]:
                attribute.Set(value, time)
