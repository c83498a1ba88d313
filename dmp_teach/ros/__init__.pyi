from .bag import write_rosbag as write_rosbag
