"""Panels of the same kind on one page, and keys that are JupyterLab's."""

import pytest

from tests.browser.test_lab import notebook_of

PANELS = ["explore()", "explore()", "pad('a')", "pad('D')"]
NAMES = """() => {
    const named = document.querySelectorAll(".dt-panel [id], .dt-scene [id]");
    const all = [...named].map(node => node.id);
    const groups = {};
    for (const [i, bar] of document.querySelectorAll(".dt-panel fieldset").entries())
        for (const input of bar.querySelectorAll("input[type=radio]"))
            (groups[input.name] ??= new Set()).add(i);
    return {
        ids: all.length,
        twice: all.filter((id, i) => all.indexOf(id) !== i),
        shared: Object.keys(groups).filter(name => groups[name].size > 1),
    };
}"""
MARKED = "bars => bars.map(bar => bar.querySelector('input:checked')?.value)"
UNSAVED = "() => window.jupyterapp.shell.currentWidget.context.model.dirty"


@pytest.fixture
def page(open_notebook, lab):
    sources = [f"import dmp_teach as teach\nteach.{panel}" for panel in PANELS]
    (lab.folder / "two.ipynb").write_text(notebook_of(*sources))
    page = open_notebook("two.ipynb")
    for kind in ("explore", "pad"):
        page.locator(f".dt-{kind}").nth(1).scroll_into_view_if_needed()
        page.wait_for_function(
            f"document.querySelectorAll('.dt-{kind}[data-dt-drawing]').length === 2"
        )
    return page


def test_each_panel_keeps_its_names_and_its_mark_to_itself(page):
    found = page.evaluate(NAMES)
    assert found["ids"] > 15
    assert (found["twice"], found["shared"]) == ([], [])
    bars = page.locator(".dt-choice.dt-letters")
    assert bars.evaluate_all(MARKED) == ["a", "a", "a", "D"]
    letter = page.locator(".dt-explore").nth(1).get_by_role("radio", name="the letter P")
    letter.evaluate("input => input.click()")
    title = "document.querySelectorAll('.dt-explore')[1].querySelector('.dt-paper title')"
    page.wait_for_function(f"{title}.textContent.includes('letter P:')")
    assert bars.evaluate_all(MARKED) == ["a", "P", "a", "D"]
    label = page.locator(".dt-explore").nth(1).get_by_text("How many bumps")
    label.click()
    assert label.evaluate("label => label.control === document.activeElement")


def test_ctrl_s_in_a_panel_saves_the_notebook_and_a_letter_stays_in_it(page):
    cells = page.locator(".jp-Notebook .jp-Cell").count()
    page.evaluate("() => { window.jupyterapp.shell.currentWidget.context.model.dirty = true; }")
    slider = page.locator(".dt-knobs").first.get_by_role("slider", name="How many bumps")
    for key in ("a", "b", "d", "d"):
        slider.press(key)
    page.wait_for_timeout(300)
    assert page.locator(".jp-Notebook .jp-Cell").count() == cells
    assert page.evaluate(UNSAVED)
    slider.press("Control+s")
    page.wait_for_function(f"() => !({UNSAVED})()")
