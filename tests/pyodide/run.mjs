// Runs a Python file of this folder in Pyodide: node run.mjs PYODIDE PACKAGES CLONE FILE
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [pyodide, packages, clone, file] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(join(pyodide, "pyodide.mjs")).href);
const python = await loadPyodide({
  env: { HYPOTHESIS_STORAGE_DIRECTORY: "/tmp", PYTHONDONTWRITEBYTECODE: "1" },
});
for (const [place, root] of Object.entries({ "/packages": packages, "/clone": clone })) {
  python.FS.mkdir(place);
  python.FS.mount(python.FS.filesystems.NODEFS, { root }, place);
}
await python.runPythonAsync("import sys; sys.path[:0] = ['/clone', '/packages']");
await python.runPythonAsync(readFileSync(file, "utf8"), { filename: file });
