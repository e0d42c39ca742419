"""MuJoCo: `Referee` follows a simulation, and proves each of its steps free of contacts or names the contacts.

>>> referee = tamis.mujoco.Referee(model, data)
>>> mujoco.mj_step(model, data)
>>> step = referee.check()

It needs the package `mujoco` (``pip install '.[mujoco]'`` in the clone); the import fails without a tested version.
"""

from tamis._versions import check_range

FIRST, LAST = "3.14.0", "4.0.0"  # the oldest and the newest version that was tested
check_range("mujoco", FIRST, LAST, "tamis.mujoco")

from tamis.mujoco._referee import Referee  # noqa: E402
from tamis.mujoco._steps import Meeting, RefereedStep, RefereeReport  # noqa: E402

__all__ = ["Meeting", "Referee", "RefereeReport", "RefereedStep"]
