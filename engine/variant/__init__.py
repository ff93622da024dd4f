"""Variant files: TOML becomes frozen, checked values here and nowhere else."""
