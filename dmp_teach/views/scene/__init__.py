"""The 3-D scene: live, as a file, as a picture."""
