"""MuJoCo: `Referee` follows a simulation, and proves each of its steps free of contacts or names the contacts.

>>> referee = tamis.mujoco.Referee(model, data)
>>> mujoco.mj_step(model, data)
>>> step = referee.check()

It needs one version of the package `mujoco` (`_version.WRITTEN_FOR`): ``pip install '.[mujoco]'`` in the clone.
"""

from tamis.mujoco._version import WRITTEN_FOR, complaint

try:
    import mujoco as _mujoco
except ImportError:
    raise ImportError(f"MuJoCo is not installed: pip install mujoco=={WRITTEN_FOR}") from None
if complaint(_mujoco.__version__):
    raise ImportError(complaint(_mujoco.__version__))

from tamis.mujoco._referee import Referee
from tamis.mujoco._steps import Meeting, RefereedStep, RefereeReport

__all__ = ["Meeting", "Referee", "RefereeReport", "RefereedStep"]
