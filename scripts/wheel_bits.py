"""Prints a hash of every contact of each generated scene, as the installed module finds them: the same with every wheel."""

import hashlib

import tamis

for name in tamis.scene_names():
    scene = tamis.scene(name, 300)
    found = tamis.Detector(scene.mesh).contacts(scene.start, scene.end)
    digest = hashlib.sha256()
    for column in ("kind", "vertices", "toi_lower", "toi_upper", "normal"):
        digest.update(getattr(found, column).tobytes())
    print(f"{name}: {len(found)} contacts, {digest.hexdigest()[:16]}")
