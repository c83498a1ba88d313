"""Run in a page's Python, and in ours without what a page has not: all but physics must work."""

import asyncio

import pytest

import dmp_teach as teach
from dmp_teach.lessons import lessons
from tests.classroom.browser import send


async def write_with(panel):
    """The robot writes what a panel shows, and stops when it is told to."""
    panel.write()
    assert panel.work["state"] == "working"
    while panel.work["state"] == "working":
        await asyncio.sleep(0.001)
    first = panel.motion
    panel.n_kernels = 12
    panel.write()
    send(panel, {"kind": "stop"})
    while panel.work["state"] == "working":
        await asyncio.sleep(0.001)
    assert first is not None
    assert panel.motion is first
    return first


async def main(folder):
    letter = teach.Letter.learn(teach.recording_of("a"))
    assert teach.score(teach.recording_of("a"), teach.recording_of("a", "slanted")).parts
    teach.pad()
    for number in lessons():
        teach.lesson(number).panel()
    teach.figures.draw_kernel_types().savefig(folder / "figure.png")
    motion = await write_with(teach.explore())
    view = teach.view(motion)
    assert view.html(folder / "view.html").read_text(encoding="utf-8")
    for suffix in (".json", ".inkml", ".svg"):
        path = teach.write_recording(letter.write(), folder / f"a{suffix}")
        assert teach.read_recording(path).strokes()
    with pytest.raises(teach.MissingPartError, match="pybullet"):
        teach.simulate(motion)
    with pytest.raises(teach.MissingPartError, match="pybullet"):
        view.png(folder / "view.png")
    with pytest.raises(teach.MissingPartError, match="rosbags"):
        teach.write_rosbag(motion, folder / "a.bag")
    with pytest.raises(teach.MissingPartError, match="zxing-cpp"):
        teach.write_stamp(letter, folder / "stamp.svg")
    print("All works in a page.")
