"""What holds for every physics test: fresh kernels, and the monitor on whatever is simulated."""

import pytest

from engine.physics.monitor import examine
from engine.physics.simulate import Simulation, _kernel


@pytest.fixture(autouse=True, scope="session")
def fresh_kernels():
    """Drop what was compiled from other sources before any kernel runs."""
    _kernel()


@pytest.fixture(autouse=True, scope="module")
def monitor():
    """Every trace that a test of this folder asks for keeps the rules, asserted or not.

    Only the exact solver promises that; the report's two do not.
    """
    told = Simulation.trace

    def watched(simulation):
        trace = told(simulation)
        if simulation._world.models.solver == "stepwise":
            faults = examine(trace, simulation._world).faults()
            assert not faults, faults
        return trace

    Simulation.trace = watched
    yield
    Simulation.trace = told
