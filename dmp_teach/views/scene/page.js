// The view as a page of its own.

import { showPage } from "../standalone.js";
import { renderScene } from "./scene.js";

showPage(renderScene);
