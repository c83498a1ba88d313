// The sheet of a lesson: more lines than a letter has, and the bet that is drawn on it.

import { make } from "../../views/dom.js";
import { Handles } from "../panels/handles.js";
import { Paper, pixels } from "../panels/paper.js";

/** @typedef {import("../panels/layout.js").Place} Place */

export class LessonPaper extends Paper {
  /** @param {any} listeners those of `Paper`, and of the bet */
  constructor(listeners) {
    super(listeners);
    this.extras = make("g");
    this.kept = make("path", { class: "dt-bet-line" });
    this.bet = new Handles(listeners);
    this.node.insertBefore(this.extras, this.marks);
    this.node.append(this.kept, this.bet.node);
  }

  redraw() {
    if (!this.size[0] || !this.scene) return;
    super.redraw();
    const view = this.view();
    const {
      extras = [],
      beads = [],
      dots = [],
      bet = [],
      handles = [],
    } = /** @type {any} */ (this.scene);
    const path = (/** @type {Place[]} */ places) =>
      places.length > 1 ? `M${pixels(places, view).join("L")}` : "";
    const places = dots.map((/** @type {{ at: Place[] }} */ { at }) => view.px(at[0]));
    this.extras.replaceChildren(
      ...extras.map((/** @type {{ points: Place[], kind: string }} */ { points, kind }) =>
        make("path", { class: `dt-extra dt-${kind}`, d: path(points) }),
      ),
      ...beads.map((/** @type {Place} */ place) => circle(view, place, "dt-bead", 4)),
      ...dots.flatMap((/** @type {{ at: Place[], kind: string, label: string }} */ dot) => {
        const [x, y] = view.px(dot.at[0]);
        // Words stand at the left of a dot that has another one at its right.
        const isTaken = places.some(
          (/** @type {Place} */ [u, v]) => u > x && u < x + 24 && Math.abs(v - y) < 14,
        );
        const beside = isTaken ? { x: x - 14, "text-anchor": "end" } : { x: x + 14 };
        const words = make("text", { class: "dt-small", y: y + 5, ...beside }, dot.label ?? "");
        return [circle(view, dot.at[0], `dt-dot dt-dot-${dot.kind}`, 6), words];
      }),
    );
    this.kept.setAttribute("d", path(bet));
    this.bet.draw(handles, { ...view, area: [16, 16, view.w - 16, view.h - 16] });
  }

  /** A sheet may have no goal. */
  drawRings(/** @type {any} */ view) {
    if (this.scene.goals.length) super.drawRings(view);
    else this.rings.replaceChildren();
  }
}

function circle(
  /** @type {import("../panels/layout.js").View} */ view,
  /** @type {Place} */ place,
  /** @type {string} */ kind,
  /** @type {number} */ r,
) {
  const [cx, cy] = view.px(place);
  return make("circle", { class: kind, cx: cx.toFixed(1), cy: cy.toFixed(1), r });
}
