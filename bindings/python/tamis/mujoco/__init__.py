"""MuJoCo: `Referee` follows a simulation, and proves each of its steps free of contacts or names the contacts.

>>> referee = tamis.mujoco.Referee(model, data)
>>> mujoco.mj_step(model, data)
>>> step = referee.check()

It needs one version of the package `mujoco` (``pip install '.[mujoco]'`` in the clone); the import fails without it.
"""

from tamis._versions import complaint

if _refused := complaint(["mujoco"], "tamis.mujoco proves the motion of"):
    raise ImportError(_refused)

from tamis.mujoco._referee import Referee
from tamis.mujoco._steps import Meeting, RefereedStep, RefereeReport

__all__ = ["Meeting", "Referee", "RefereeReport", "RefereedStep"]
