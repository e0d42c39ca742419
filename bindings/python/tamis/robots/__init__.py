"""Robots with joints, from their URDF files, and the queries of planners about their motions.

>>> robot = tamis.robots.load("panda.urdf", srdf="panda.srdf", held={"panda_finger_joint1": 0.04})
>>> scene = tamis.robots.Scene(robot)
>>> scene.add("shelf", trimesh.load("shelf.stl"))
>>> scene.is_free(start, end)  # one edge, or thousands: True is a proof

Meshes need the package trimesh, `tamis.robots.ompl` the package ompl: ``pip install '.[robots]'`` in the clone.
"""

from tamis.robots._edges import Edges, TrajectoryAnswer
from tamis.robots._load import load
from tamis.robots._robot import Robot
from tamis.robots._scene import Scene

__all__ = ["Edges", "Robot", "Scene", "TrajectoryAnswer", "load"]
