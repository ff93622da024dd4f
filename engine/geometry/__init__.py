"""Curves and roots: numbers only."""
