"""Published figures against the simulator: `python -m tools.validate FILE... [--json]`."""
