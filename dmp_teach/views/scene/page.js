// The view as a page of its own.

import { showPage } from "../standalone.js";
import { render } from "./scene.js";

showPage(render);
