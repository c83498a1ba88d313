"""Recordings in every format, and the strokes in them."""
