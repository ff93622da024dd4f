"""What the records prove of a game's rules, what they do not, and pictures of what differs."""
