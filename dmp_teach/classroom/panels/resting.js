// What a saved notebook keeps of a panel, in the place of its script: a sentence.

/** @param {{ el: HTMLElement }} widget */
function render({ el }) {
  el.textContent = "This panel is resting. Run the cell above to wake it: Shift and Enter.";
}

export default { render };
