"""The motion under gravity and contact (pybullet)."""
