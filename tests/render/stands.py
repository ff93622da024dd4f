"""Tables and scenes for the renderers' tests; `tools.render_scenes` has what the tools use too."""

from tools.render_scenes import RADIUS, TABLES, bare, draw, make_stage, scatter

__all__ = ["RADIUS", "TABLES", "bare", "draw", "make_stage", "scatter"]
