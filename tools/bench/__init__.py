"""How fast everything is, measured: `python -m tools.bench physics|rules|render [--json]`."""
