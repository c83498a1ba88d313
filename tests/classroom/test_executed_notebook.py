"""A notebook that another program runs and saves holds no ink of a pupil's, and no pseudonym."""

from base64 import b64encode

import nbformat
import numpy as np
import pytest
from nbclient import NotebookClient

import dmp_teach as teach

INK = teach.recording_of("e")
# The name is put together, for what a cell says is the pupil's own.
SETUP = """\
import numpy as np
import dmp_teach as teach
name = "w" + "07"
ink = teach.recording_of("e")"""
CELLS = {
    "pad": """\
pad = teach.pad("a", writer=name)
for stroke in ink.strokes():
    pad.add_stroke([(t, x, y, 0.5) for t, (x, y) in zip(stroke.t, stroke.position)])
pad""",
    "explore": "teach.explore(ink)",
    "lesson": """\
panel = teach.lesson("05", pupil=name).panel()
panel.bet(np.add(panel.lesson.bet.handles, 0.1234567).tolist())
panel.reveal()
panel""",
}
VALUES = "ink", "teach.Letter.learn(ink)"
KNOBS = {"asked", "values", "character", "letter", "n_kernels", "kernel_width", "stroke"}
KNOBS |= {"goal_shifts", "goal_x", "goal_y"}


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """A notebook that nbclient has run, with what it keeps of widgets."""
    monkeypatch = pytest.MonkeyPatch()
    monkeypatch.delenv("DMP_TEACH_PICTURES_STAY_OUT")
    sources = SETUP, *CELLS.values(), *VALUES
    cells = [nbformat.v4.new_code_cell(source) for source in sources]
    notebook = nbformat.v4.new_notebook(cells=cells)
    folder = {"metadata": {"path": str(tmp_path_factory.mktemp("run"))}}
    NotebookClient(notebook, timeout=120, store_widget_state=True, resources=folder).execute()
    monkeypatch.undo()
    return notebook


def test_of_panels_it_keeps_script_look_and_knobs_alone(saved):
    kept = saved.metadata.widgets["application/vnd.jupyter.widget-state+json"]["state"].values()
    ours = [each for each in kept if "_anywidget_id" in each["state"]]
    assert len(ours) == len(CELLS)
    assert not any("buffers" in each for each in ours)
    names = {name for each in ours for name in each["state"] if not name.startswith("_")}
    assert names <= KNOBS | {"layout", "tabbable", "tooltip"}


def test_no_ink_no_bet_and_no_pseudonym_is_in_it(saved):
    text = nbformat.writes(saved)
    assert '"image/svg+xml"' not in text
    assert "Letter(" in text
    assert "w07" not in text
    for kind in ("<f4", "<f8"):
        packed = INK.strokes()[0].position.astype(kind).tobytes()
        # Three bytes are four letters, wherever a part of them begins.
        for begin in (120, 121, 122):
            assert b64encode(packed[begin : begin + 30]).decode() not in text
    handles = np.add(teach.lesson("05", pupil="w07").bet.handles, 0.1234567)
    for value in (*INK.strokes()[0].position[10:40:9].ravel(), *handles.ravel()):
        assert repr(float(value))[:9] not in text
