"""The one version of MuJoCo whose motion this package knows."""

WRITTEN_FOR = "4.0.0"


def complaint(installed: str) -> str:
    """Return what is wrong with a version; empty if nothing is."""
    if installed == WRITTEN_FOR:
        return ""
    return (
        f"MuJoCo {installed} is installed, and tamis.mujoco proves the motion of {WRITTEN_FOR}: "
        f"pip install mujoco=={WRITTEN_FOR}"
    )
