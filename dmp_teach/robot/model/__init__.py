"""The robot's kinematics, its solids, and how near they are."""
