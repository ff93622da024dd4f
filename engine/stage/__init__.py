"""What a game looks like: table, balls and cue become a scene."""
