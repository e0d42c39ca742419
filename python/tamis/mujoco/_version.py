"""The one version of MuJoCo that this package supports."""

WRITTEN_FOR = "4.0.0"


def complaint(installed: str) -> str:
    """Return why a version is not supported; empty if it is."""
    if installed == WRITTEN_FOR:
        return ""
    return (
        f"MuJoCo {installed} is installed, and tamis.mujoco proves the motion of {WRITTEN_FOR}: "
        f"pip install mujoco=={WRITTEN_FOR}"
    )
