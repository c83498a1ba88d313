// What a saved notebook keeps of a panel, in the place of its script: a sentence.

import { rest } from "../../views/rest.js";

/** @param {{ el: HTMLElement }} widget */
function render({ el }) {
  rest(el);
}

export default { render };
