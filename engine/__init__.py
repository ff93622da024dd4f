"""The engine: balls, tables, events and pictures, and no game."""
