"""The rule language: scripts that read like a rulebook become decisions."""
