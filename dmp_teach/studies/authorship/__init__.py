"""Whose letter is it."""
