"""Simple solids for the contacts of each link.

Each is (kind, size, xyz, rpy) in the link's frame [m, rad]. A box has three sides, a cylinder a
radius and a length along its z, a sphere a radius.
"""

from math import pi

ALONG_X, ALONG_Y, ALONG_Z = (0, pi / 2, 0), (pi / 2, 0, 0), (0, 0, 0)

COLLISIONS: dict[str, tuple] = {
    "base_link": (
        ("cylinder", (0.287, 0.29), (0, 0, 0.145), ALONG_Z),
        ("box", (0.34, 0.36, 0.344), (0, 0, 0.187), ALONG_Z),
    ),
    "r_wheel_link": (("cylinder", (0.0602, 0.05), (0, 0, 0), ALONG_Y),),
    "l_wheel_link": (("cylinder", (0.0602, 0.05), (0, 0, 0), ALONG_Y),),
    "torso_fixed_link": (("box", (0.136, 0.31, 0.46), (-0.1, 0, 0.212), ALONG_Z),),
    "torso_lift_link": (
        ("box", (0.2655, 0.342, 0.308), (-0.0525, 0, 0.449), ALONG_Z),
        ("box", (0.246, 0.342, 0.267), (-0.0625, 0, 0.162), ALONG_Z),
        ("cylinder", (0.052, 0.08), (0.1195, 0, 0.255), ALONG_Z),
    ),
    "head_pan_link": (
        ("cylinder", (0.125, 0.116), (0, 0, 0.055), ALONG_Z),
        ("box", (0.163, 0.032, 0.116), (0.1165, 0.127, 0.055), ALONG_Z),
        ("box", (0.163, 0.032, 0.116), (0.1165, -0.127, 0.055), ALONG_Z),
    ),
    "head_tilt_link": (("cylinder", (0.055, 0.21), (0, 0, 0), ALONG_Y),),
    "shoulder_pan_link": (
        ("cylinder", (0.052, 0.10), (0, 0, 0.002), ALONG_Z),
        ("cylinder", (0.0606, 0.074), (0.117, -0.0375, 0.06), ALONG_Y),
        ("box", (0.09, 0.08, 0.09), (0.05, -0.01, 0.04), ALONG_Z),
    ),
    "shoulder_lift_link": (
        ("cylinder", (0.0597, 0.070), (0, 0.0355, 0), ALONG_Y),
        ("cylinder", (0.052, 0.13), (0.107, 0, 0), ALONG_X),
    ),
    "upperarm_roll_link": (
        ("cylinder", (0.052, 0.11), (0.007, 0, 0), ALONG_X),
        ("cylinder", (0.052, 0.070), (0.133, -0.0355, 0), ALONG_Y),
    ),
    "elbow_flex_link": (
        ("cylinder", (0.052, 0.070), (0, 0.0355, 0), ALONG_Y),
        ("cylinder", (0.052, 0.12), (0.106, 0, 0), ALONG_X),
    ),
    "forearm_roll_link": (
        ("cylinder", (0.052, 0.09), (0.013, 0, 0), ALONG_X),
        ("cylinder", (0.052, 0.082), (0.1245, -0.046, 0), ALONG_Y),
    ),
    "wrist_flex_link": (
        ("cylinder", (0.052, 0.066), (0, 0.034, 0), ALONG_Y),
        ("cylinder", (0.054, 0.08), (0.0765, 0, 0), ALONG_X),
    ),
    "wrist_roll_link": (("cylinder", (0.0519, 0.0425), (-0.00175, 0, 0), ALONG_X),),
    "gripper_link": (("box", (0.122, 0.126, 0.079), (-0.093, 0, 0), ALONG_Z),),
    "r_gripper_finger_link": (("box", (0.06, 0.0143, 0.0263), (0.001, -0.00855, 0), ALONG_Z),),
    "l_gripper_finger_link": (("box", (0.06, 0.0143, 0.0263), (0.001, 0.00855, 0), ALONG_Z),),
    "estop_link": (("cylinder", (0.018, 0.04), (0, 0, 0.007), ALONG_Z),),
    "laser_link": (("cylinder", (0.035, 0.026), (-0.01, 0, 0.048), ALONG_Z),),
    "pen_link": (("cylinder", (0.005, 0.115), (0, 0, 0.0255), ALONG_Z),),
    "pen_tip": (("sphere", (0.0015,), (0, 0, -0.0015), ALONG_Z),),
}
