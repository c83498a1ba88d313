"""The robot's kinematics, masses and shapes, and how near its parts are."""
