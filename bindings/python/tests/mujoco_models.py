"""Models of MuJoCo for tests."""

from __future__ import annotations

from typing import Any

import mujoco


def loaded(xml: str) -> tuple[Any, Any]:
    """Return the model, and its data in the first state."""
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data
