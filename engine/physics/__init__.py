"""How balls move, meet and stop."""
