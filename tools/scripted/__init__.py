"""A scripted player at the real window: hands on the keys, a mind for strokes, a display."""

FOULS_AT = (1, 5, 12)
"""Strokes that are meant to go wrong."""
