// What is seen of a panel that nobody answers: a sentence that says how to wake it.

// Jupyter marks what has no kernel by a broken link, which says less than the sentence.
const LOOK = `
.dt-resting { padding: 8px 0; font: 16px var(--jp-ui-font-family, sans-serif); }
.jupyter-widgets-disconnected:has(.dt-resting)::before { display: none; }`;

export function rest(/** @type {HTMLElement} */ el) {
  const style = document.createElement("style");
  style.textContent = LOOK;
  const says = document.createElement("div");
  says.className = "dt-resting";
  says.textContent =
    "This panel is resting. Run the cell above to wake it: ▶, or Shift and Enter together.";
  el.append(style, says);
}
