"""A scripted player at the real window: hands on the keys, a mind for strokes, a display."""
