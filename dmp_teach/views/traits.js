// Traits that are kept in the browser, as a widget's model has them.

/** @typedef {import("./dom.js").Model} Model */
/** @typedef {Record<string, any>} Values */

export class Traits {
  constructor() {
    /** @type {Values} */
    this.values = {};
    /** @type {Record<string, Set<() => void>>} */
    this.listeners = {};
  }

  /** Take values, every one before anybody hears of them. */
  take(/** @type {Values} */ values) {
    const changed = Object.keys(values).filter((name) => values[name] !== this.values[name]);
    Object.assign(this.values, values);
    for (const name of changed)
      for (const listener of [...(this.listeners[`change:${name}`] ?? [])]) listener();
  }

  /**
   * A model of them; what listens to it ends with the signal.
   * @param {Pick<Model, "save_changes" | "send"> & { set?(name: string, value: any): void }} python
   *   what is done where one is set, or Python is told
   * @param {AbortSignal} [signal]
   * @returns {Model}
   */
  model({ set, save_changes, send }, signal) {
    return {
      get: (name) => this.values[name],
      set: (name, value) => {
        set?.(name, value);
        this.take({ [name]: value });
      },
      on: (events, listener) => {
        for (const event of events.split(" ")) {
          this.listeners[event] ??= new Set();
          this.listeners[event].add(listener);
          signal?.addEventListener("abort", () => this.listeners[event].delete(listener));
        }
      },
      save_changes,
      send,
    };
  }
}
