// Work outlives a restart of the kernel, and goes with the tab; what is forgotten in one tab is
// forgotten in all, and in every lesson.

/** @typedef {Record<string, any>} Values */

const MARK = "dmp_teach";

/**
 * The work of a pupil in a lesson, as the browser keeps it.
 * @param {Values} spec
 * @param {() => void} onForget
 * @param {AbortSignal} [signal]
 */
export function keptWork({ key, pupil }, onForget, signal) {
  const place = `${MARK} ${location.pathname} ${key} ${pupil}`;
  const forget = () => {
    for (const name of Object.keys(sessionStorage))
      if (name.startsWith(`${MARK} `) && name.endsWith(` ${pupil}`))
        sessionStorage.removeItem(name);
    onForget();
  };
  const others = new BroadcastChannel(`${MARK} forget`);
  others.onmessage = ({ data }) => data === pupil && forget();
  signal?.addEventListener("abort", () => others.close());
  return {
    keep(/** @type {Values} */ work) {
      sessionStorage.setItem(place, JSON.stringify({ variant: pupil, ...work }));
    },
    read: () => JSON.parse(sessionStorage.getItem(place) ?? "null"),
    forget() {
      others.postMessage(pupil);
      forget();
    },
  };
}
