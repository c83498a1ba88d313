"""What is looked at: the 3-D scene, as a live view, a file and a picture."""
