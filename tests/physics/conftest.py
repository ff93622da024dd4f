"""Kernels that tests call directly are no staler than those of a shot."""

import pytest

from engine.physics.simulate import _kernels


@pytest.fixture(autouse=True, scope="session")
def fresh_kernels():
    """Drop what was compiled from other sources before any kernel runs."""
    _kernels()
