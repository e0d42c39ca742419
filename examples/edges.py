import numpy as np
import tamis

corners = np.array([[x, y, z] for x in (0, 1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)])
sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
rod = tamis.Shape(tamis.Mesh([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]), corners)
world = tamis.World()
world.add(rod, tamis.pose_of([0, -np.pi / 2, 0], [1.2, 1.2, -0.5]))  # the post stands
upper, lower = world.add(rod), world.add(rod)
world.set_may_touch([upper, lower], False)

arm = tamis.Linkage(
    parents=[-1, 0],                      # shoulder and elbow; -1: the world carries the joint
    places=tamis.pose_of(np.zeros((2, 3)), [[0, 0, 0], [1, 0, 0]]),  # each in its parent's frame
    kinds=["turning", "turning"],
    axes=[[0, 0, 1], [0, 0, 1]],
    coordinates=[0, 1],                   # which number of a configuration moves each
    bodies=[upper, lower],                # their numbers, from add
    carriers=[0, 1],                      # which joint carries each body
)
home, high, folded = (0.0, 0.0), (1.5, 0.0), (0.0, 2.5)
print(world.edges_are_free(arm, [home, home, folded], [high, folded, high]))
answer = world.last_valid(arm, [home], [high])
print(f"free until {answer.fraction[0]:.3f}: then bodies {answer.bodies[0]} meet")
print(world.first_bad_edge(arm, [high, folded, home, high]).edge)
