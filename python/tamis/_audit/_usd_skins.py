"""Skinned meshes of a USD stage, baked into points that move: in a stage of our own over the same layers."""

from __future__ import annotations

from typing import Any

from tamis._audit._usd_times import played


def with_baked_skins(stage: Any, roots: list[Any]) -> Any:
    """Return a stage on which no mesh below `roots` needs a skeleton: the same one where none has a skin."""
    from pxr import Sdf, Usd

    skinned = _skinned(roots)
    if not skinned:
        return stage
    layer = Sdf.Layer.CreateAnonymous("baked.usda")
    own = _opened_again(stage, layer)
    with Usd.EditContext(own, layer):
        for path in skinned:
            for above in path.GetPrefixes():  # nothing can be written within an instance
                if own.GetPrimAtPath(above).IsInstance():
                    own.GetPrimAtPath(above).SetInstanceable(False)
            _bake(own, own.GetPrimAtPath(path))
    return own


def _opened_again(stage: Any, layer: Any) -> Any:
    """Return the stage with one layer more, the strongest; the caller's stage does not know it."""
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
    """Return the paths of what holds skeletons and their meshes, above or below some prims."""
    from pxr import Usd, UsdSkel

    found: list[Any] = []
    for root in roots:
        above = UsdSkel.Root.Find(root)
        for prim in Usd.PrimRange(above.GetPrim() if above else root, Usd.TraverseInstanceProxies()):
            if prim.IsA(UsdSkel.Root) and prim.GetPath() not in found:
                found.append(prim.GetPath())
    return found


def _bake(stage: Any, root: Any) -> None:
    """Give the meshes points: at each frame that is played, as joints turn and points between two keys go on arcs."""
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
