import numpy as np
import tamis

corners = np.array([[x, y, z] for x in (0, 1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)])
sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
rod = tamis.Shape(tamis.Mesh([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]), corners)
world = tamis.World()
world.add(rod, tamis.pose_of([0, -np.pi / 2, 0], [1.2, 1.2, -0.5]))  # the post stands
upper, lower = world.add(rod), world.add(rod)
world.set_may_touch([upper, lower], False)                           # they meet in the elbow


def joint(place, start, end):
    return tamis.interpolated_chain([place, [0, 0, start]], [place, [0, 0, end]])


still = np.zeros((1, 4, 3))                                          # as many links for each body


def motion(start, end):
    shoulder, elbow = joint([0, 0, 0], start[0], end[0]), joint([1, 0, 0], start[1], end[1])
    return [np.concatenate([shoulder, still]), np.concatenate([shoulder, elbow])]


home, high, folded = (0.0, 0.0), (1.5, 0.0), (0.0, 2.5)
edges = [(home, high), (home, folded), (folded, high)]
first = world.earliest_many([upper, lower], [motion(*edge) for edge in edges])
touching = dict(zip(first.touching.tolist(), first.contacts))
for i, free in enumerate(first.is_free):
    print("free" if free else f"free until {first.toi_lower[i]:.3f}: then bodies {touching[i].bodies} meet")
