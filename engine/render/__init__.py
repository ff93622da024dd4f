"""Renderers that turn a scene into pixels: wireframe, painter's, scanline z-buffer."""
