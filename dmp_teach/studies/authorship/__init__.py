"""Studies of who wrote a letter."""
