"""MATLAB's files: Character Trajectories and LASA."""
