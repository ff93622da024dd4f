"""Random shots under the monitor: `python -m tools.soak physics --shots N`."""
