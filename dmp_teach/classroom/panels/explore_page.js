// The start panel as a page of its own: its goals follow the hand.

import { showPage } from "../../views/standalone.js";
import { renderExplore } from "./explore.js";

showPage(renderExplore, {
  saved: (model) => model.set("drawing", model.get("drawing") + 1),
});
