"""What a notebook keeps of ink when it is saved: nothing, whatever the browser sends."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

import dmp_teach
from dmp_teach.classroom import saving
from dmp_teach.classroom.panels.pad import pad
from dmp_teach.launcher.notebook_privacy import RESTING_SCRIPT, without_ink
from dmp_teach.views.scene.view import SceneView

WIDGETS = "application/vnd.jupyter.widget-state+json"


def state_of(widget):
    """A widget's state as a browser could save it, all of it; bytes as text."""
    state = {name: f"{value!r}" for name, value in widget.get_state().items()}
    state["_anywidget_id"] = widget.get_state()["_anywidget_id"]
    return {
        "model_name": "AnyModel",
        "model_module": "anywidget",
        "state": state,
        "buffers": [{"data": "SECRET"}],
    }


def notebook(outputs=(), **widgets):
    cell = {
        "cell_type": "code",
        "source": "pad",
        "metadata": {},
        "execution_count": 1,
        "outputs": list(outputs),
    }
    kept = {WIDGETS: {"version_major": 2, "version_minor": 0, "state": widgets}}
    return {
        "type": "notebook",
        "content": {"cells": [cell], "metadata": {"widgets": kept}, "nbformat": 4},
    }


@pytest.fixture
def written():
    panel = pad()
    for stroke in dmp_teach.recording_of("a").strokes():
        panel.add_stroke(
            [(t, x, y, 0.5) for t, (x, y) in zip(stroke.t, stroke.position, strict=True)]
        )
    return panel


def test_of_our_panels_a_sentence_is_kept_and_no_ink_and_other_widgets_stay_as_they_are(written):
    other = {
        "model_name": "IntSliderModel",
        "state": {"value": 5, "_anywidget_id": "elsewhere.Slider"},
    }
    model = notebook(a=state_of(written), b=state_of(SceneView()), c=other)
    without_ink(model=model, path="a.ipynb", contents_manager=None)
    kept = model["content"]["metadata"]["widgets"][WIDGETS]["state"]
    for panel in (kept["a"], kept["b"]):
        assert panel["state"]["_esm"] == RESTING_SCRIPT
        assert all(name.startswith("_") for name in panel["state"])
        assert "SECRET" not in json.dumps(panel)
    assert kept["a"]["state"]["_anywidget_id"] == "dmp_teach.classroom.panels.pad.Pad"
    assert kept["c"] == other


def test_pictures_of_ink_are_not_kept_and_other_pictures_are(written):
    ours = {"image/svg+xml": written.recording._repr_svg_(), "text/plain": repr(written.recording)}
    lines = {"image/svg+xml": ours["image/svg+xml"].splitlines(keepends=True)}
    theirs = {"image/svg+xml": "<svg><path/></svg>"}
    model = notebook(
        [{"output_type": "execute_result", "data": data} for data in (dict(ours), lines, theirs)]
    )
    without_ink(model=model)
    kept = [output["data"] for output in model["content"]["cells"][0]["outputs"]]
    assert kept == [{"text/plain": ours["text/plain"]}, {}, {"image/svg+xml": "<svg><path/></svg>"}]


JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["state", "a", "_b"]), inner, max_size=3)
    ),
    max_leaves=20,
)


@given(JSON, JSON)
def test_wherever_the_state_of_a_panel_stands_it_is_emptied_and_nothing_else_is_touched(
    around, ink
):
    panel = {
        "state": {"_anywidget_id": "dmp_teach.classroom.panels.pad.Pad", "ink": [ink, "SECRET"]}
    }
    model = {"type": "notebook", "content": {"x": [around, {"deep": panel}], "y": around}}
    before = json.dumps(around)
    without_ink(model=model)
    assert "SECRET" not in json.dumps(model)
    assert json.dumps(around) == before


@pytest.mark.parametrize(
    "model", [{}, {"type": "file", "content": "SECRET"}, {"type": "notebook", "content": None}]
)
def test_what_is_no_notebook_stays_as_it_is(model):
    before = dict(model)
    without_ink(model=model)
    assert model == before


def test_the_old_path_that_hubs_may_name_works_with_a_warning(written):
    model = notebook(a=state_of(written))
    again = json.loads(json.dumps(model))
    without_ink(model)
    with pytest.warns(DeprecationWarning, match=r"dmp_teach\.launcher\.notebook_privacy"):
        saving.without_ink(again, path="a.ipynb", contents_manager=None)
    assert again == model
