"""Matches of random shots through the referee, with no physics."""
