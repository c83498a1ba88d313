"""The motion for a real Fetch, as a ROS 1 bag."""
