"""What helps an author write: a new game to begin with, the formatter, schemas for editors."""
