// What a saved notebook keeps of a panel, in the place of its script: a sentence.

// Jupyter marks what has no kernel by a broken link, which says less than the sentence.
const LOOK = `
.dt-resting { padding: 8px 0; font: 16px var(--jp-ui-font-family, sans-serif); }
.jupyter-widgets-disconnected:has(.dt-resting)::before { display: none; }`;

/** @param {{ el: HTMLElement }} widget */
function render({ el }) {
  const style = document.createElement("style");
  style.textContent = LOOK;
  const says = document.createElement("div");
  says.className = "dt-resting";
  says.textContent =
    "This panel is resting. Run the cell above to wake it: ▶, or Shift and Enter together.";
  el.append(style, says);
}

export default { render };
