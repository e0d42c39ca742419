import pathlib

import trimesh
from ompl import geometric as og

import tamis
from tamis import robots
from tamis.robots import ompl

# the Panda of the package example-robot-data; put your own files here
folder = pathlib.Path(trimesh.__file__).parents[1] / "cmeel.prefix/share/example-robot-data/robots/panda_description"
panda = robots.load(folder / "urdf/panda.urdf", srdf=folder / "srdf/panda.srdf", held={"panda_finger_joint1": 0.04})
scene = robots.Scene(panda)
scene.add("box", trimesh.creation.box((0.3, 0.05, 0.5)), tamis.pose_of([0, 0, 0.0], [0.5, 0, 0.4]))

start, goal = [-0.8, 0.3, 0, -2.0, 0, 2.3, 0.785], [0.8, 0.3, 0, -2.0, 0, 2.3, 0.785]
straight = scene.last_valid(start, goal)
print(f"straight: free until {straight.fraction[0]:.3f}, then {' and '.join(sorted(straight.pairs[0]))} meet")

setup = ompl.simple_setup(scene)
ompl.set_start_and_goal(setup, scene, start, goal)
setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
setup.solve(10.0)
waypoints = ompl.waypoints_of(setup.getSolutionPath(), scene)
print(f"planned: every edge proven: {scene.first_bad_edge(waypoints).is_free}")
