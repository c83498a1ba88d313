// The start panel as a page of its own: its goals follow the hand.

import { showPage } from "../../views/standalone.js";
import { render } from "./explore.js";

showPage(render, {
  saved: (model) => model.set("drawing", model.get("drawing") + 1),
});
