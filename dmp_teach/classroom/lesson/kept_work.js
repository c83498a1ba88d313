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
  const tab = tabStorage();
  const forget = () => {
    for (const name of Object.keys(tab ?? {}))
      if (name.startsWith(`${MARK} `) && name.endsWith(` ${pupil}`)) tab.removeItem(name);
    onForget();
  };
  const others = new BroadcastChannel(`${MARK} forget`);
  others.onmessage = ({ data }) => data === pupil && forget();
  signal?.addEventListener("abort", () => others.close());
  return {
    keep(/** @type {Values} */ work) {
      tab?.setItem(place, JSON.stringify({ variant: pupil, ...work }));
    },
    read: () => JSON.parse(tab?.getItem(place) ?? "null"),
    forget() {
      others.postMessage(pupil);
      forget();
    },
  };
}

/** Null in a frame that may keep nothing, as some programs show notebooks in. */
function tabStorage() {
  try {
    return sessionStorage;
  } catch {
    return null;
  }
}
