"""What all ranks ask about."""

from __future__ import annotations

import pytest
from ranks import Part

import tamis


@pytest.fixture
def cloth() -> Part:
    return Part(tamis.scene("folded-cloth", 400, seed=1))
