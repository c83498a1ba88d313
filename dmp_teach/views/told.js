// A widget whose traits come by messages, which no program saves in a notebook (`unsaved.py`).

import { rest } from "./rest.js";
import { followTheme } from "./theme.js";
import { Traits } from "./traits.js";

/** @typedef {import("./dom.js").Model} Model */
/** @typedef {import("./dom.js").Widget} Widget */

// After so long [ms] Python is asked, or the panel says that it rests.
const ASK = 300;
const REST = 2000;

/**
 * What anywidget wants of a module, which calls it for each model.
 * @param {(widget: Widget) => any} render
 */
export function told(render) {
  return () => {
    const traits = new Traits();
    const asker = Math.random();
    /** @type {() => void} */
    let wake;
    const awake = new Promise((resolve) => {
      wake = () => resolve(true);
    });
    const initialize = (/** @type {{ model: Model }} */ { model }) => {
      const asking = setTimeout(() => ask(model, asker), ASK);
      const hear = (/** @type {any} */ message, /** @type {DataView[]} */ buffers) => {
        if (message.kind !== "traits" || (message.asker ?? asker) !== asker) return;
        const values = JSON.parse(message.json, (_, value) =>
          value?.buffer === undefined ? value : buffers[value.buffer],
        );
        // Where another window of the notebook has asked, its knobs are shown in this one, too.
        const knobs = message.knobs?.asked > traits.values.asked ? message.knobs : {};
        traits.take({ ...values, ...knobs });
        for (const [name, value] of Object.entries(knobs)) model.set(name, value);
        if (!message.isWhole) return;
        clearTimeout(asking);
        follow(model, traits);
        wake();
      };
      model.on("msg:custom", /** @type {any} */ (hear));
    };
    return {
      initialize,
      async render(/** @type {Widget} */ { model, el, host, signal }) {
        const resting = setTimeout(() => rest(el), REST);
        await awake;
        clearTimeout(resting);
        el.replaceChildren();
        followTheme(el, signal);
        // The still pictures of panels hide.
        document.body.dataset.dtLives = "";
        return render({ model: traits.model(model, signal), el, host, signal });
      },
    };
  };
}

function ask(/** @type {Model} */ model, /** @type {number} */ asker) {
  try {
    model.send({ kind: "traits", asker });
  } catch (error) {
    console.warn(error);
  }
}

/** Traits that Jupyter keeps, too, may be changed by its other widgets. */
function follow(/** @type {Model} */ model, /** @type {Traits} */ traits) {
  for (const name of Object.keys(traits.values)) {
    if (model.get(name) === undefined) continue;
    model.on(`change:${name}`, () => traits.take({ [name]: model.get(name) }));
  }
}
