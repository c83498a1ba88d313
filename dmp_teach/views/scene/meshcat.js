// Meshcat's viewer script and the commands that it hears, as Python has packed them.

import { gunzip } from "../gunzip.js";

/** @typedef {ArrayBufferView | ArrayBuffer} Bytes */

/** @type {any} what all copies of this module on a page share */
const PAGE = globalThis;

/**
 * Meshcat's viewer script, run once per page; neither its names nor a loader of the page's can
 * meet.
 */
export function loadMeshcat(/** @type {Bytes} */ value) {
  PAGE.__dtMeshcat ??= gunzip(value).then(runMeshcat);
  return PAGE.__dtMeshcat;
}

function runMeshcat(/** @type {Uint8Array<ArrayBuffer>} */ code) {
  PAGE.__dtMeshcatExports = {};
  const before = "(function (exports, module, define) {";
  const after = "\n})(globalThis.__dtMeshcatExports);";
  const url = URL.createObjectURL(new Blob([before, code, after], { type: "text/javascript" }));
  const script = Object.assign(document.createElement("script"), { src: url });
  return new Promise((resolve, reject) => {
    script.onload = () => resolve(PAGE.__dtMeshcatExports.MeshCat);
    script.onerror = () => reject(new Error("meshcat's viewer script could not be run"));
    document.head.append(script);
  }).finally(() => {
    URL.revokeObjectURL(url);
    script.remove();
  });
}

/** The commands of a bundle: before each its length in 4 bytes. */
export function commandsOf(/** @type {Uint8Array} */ bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const commands = [];
  for (let at = 0; at < bytes.length; ) {
    const length = view.getUint32(at, true);
    commands.push(bytes.subarray(at + 4, at + 4 + length));
    at += 4 + length;
  }
  return commands;
}
