"""A letter, learned and written again."""
