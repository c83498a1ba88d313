// A challenge of a teacher's own, on the card of the lessons.

import { hear, keepKeys, make } from "../../views/dom.js";
import { t, useTexts } from "../../views/texts.js";
import { told } from "../../views/told.js";
import { asleepBox, watch } from "../panels/robot.js";
import { Card } from "./card.js";

/** @param {import("../../views/dom.js").Widget} widget */
function render({ model, el }) {
  useTexts(model.get("texts"));
  const root = keepKeys(make("div", { class: "dt-panel dt-lesson dt-challenge" }));
  /** @type {any} as `Parts` of a panel */
  const parts = { asleep: asleepBox(t("The check does not answer.")) };
  const send = (/** @type {object} */ message) => {
    parts.waits();
    try {
      model.send(message);
    } catch (error) {
      console.warn(error);
    }
  };
  const spec = { bet: {}, challenge: model.get("words") };
  const card = new Card(spec, { send, write: null, bet: () => null });
  root.append(card.node, parts.asleep);
  el.append(root);
  const redraw = () => card.show(model.get("progress"), model.get("card"));
  hear(model, { card: redraw });
  const stopWatching = watch(model, root, parts);
  redraw();
  return stopWatching;
}

export default told(render);
