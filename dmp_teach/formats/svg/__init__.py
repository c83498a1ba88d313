"""Drawings: SVG."""
