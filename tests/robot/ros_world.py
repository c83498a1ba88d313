"""A real ROS 1 on loopback, where Debian's packages are.

A master, a player, and a listener in the system's Python.
"""

import base64
import json
import socket
import subprocess
from pathlib import Path

import psutil

PYTHON = "/usr/bin/python3"
HAS_ROS = (
    Path("/usr/bin/roscore").exists()
    and Path("/usr/bin/rosbag").exists()
    and not subprocess.call(
        [PYTHON, "-c", "import rospy"], stderr=subprocess.DEVNULL, env={"PATH": "/usr/bin:/bin"}
    )
)
ALONE = ["unshare", "--user", "--map-root-user", "--net"]
"""A network of one's own, of loopback alone: the C++ player listens on every address."""

WORLD = """
import base64, fcntl, json, os, signal, socket, struct, subprocess, sys, threading, time
bag, port, alone, *topics = sys.argv[1:]
# Loopback is down in a new network: ifr_name lo, IFF_UP | IFF_RUNNING, SIOCSIFFLAGS.
if alone == "True":
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line:
        fcntl.ioctl(line, 0x8914, struct.pack("16sh14x", b"lo", 0x41))
import rospy

heard, all_heard = {}, threading.Event()

def hear(message, topic):
    header = message._connection_header
    data = base64.b64encode(message._buff).decode()
    latched = header.get("latching") == "1"
    heard[topic] = dict(type=header["type"], md5=header["md5sum"], latched=latched, data=data)
    if len(heard) == len(topics):
        all_heard.set()

def answers():
    with socket.socket() as caller:
        return caller.connect_ex(("127.0.0.1", int(port))) == 0

quiet = dict(stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
core = subprocess.Popen(["/usr/bin/roscore", "-p", port], **quiet)
try:
    while not answers():
        time.sleep(0.1)
    rospy.init_node("listener", disable_signals=True)
    for topic in topics:
        rospy.Subscriber(topic, rospy.AnyMsg, hear, topic)
    subprocess.call(["/usr/bin/rosbag", "play", "--quiet", bag], **quiet)
    all_heard.wait(10)
    rospy.signal_shutdown("heard")
finally:
    core.send_signal(signal.SIGINT)  # ends its own children
    core.wait()
print(json.dumps(heard))
"""


def play_on_a_real_roscore(bag, topics, home):
    """What a listener receives while a bag is played: type, md5 sum, latch and data by topic."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    env = {
        "PATH": "/usr/bin:/bin",
        "HOME": str(home),
        "ROS_HOME": str(home),
        "ROS_LOG_DIR": str(home),
    }
    env |= {"ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_IP": "127.0.0.1"}
    alone = subprocess.call([*ALONE, "true"], env=env, stderr=subprocess.DEVNULL) == 0
    command = [*(ALONE if alone else []), PYTHON, "-c", WORLD, str(bag), port, str(alone), *topics]
    world = subprocess.Popen(
        command, env=env, cwd=home, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    try:
        out, errors = world.communicate(timeout=50)
    finally:
        if world.poll() is None:
            for process in [*psutil.Process(world.pid).children(recursive=True), world]:
                process.kill()
            world.communicate()
    assert world.returncode == 0, errors
    heard = json.loads(out.splitlines()[-1])
    return {
        topic: message | {"data": base64.b64decode(message["data"])}
        for topic, message in heard.items()
    }
