"""What stands in the room."""
