// Compile every .py below a folder for the Python of a Pyodide, and leave the .pyc in its place:
//   node compile.mjs PYODIDE FOLDER
// Pyodide is a folder with its pyodide.mjs; the first folder on a file's way is the wheel's.

import { pathToFileURL } from "node:url";

const [pyodideFolder, folder] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${pyodideFolder}/pyodide.mjs`).href);
const python = await loadPyodide({ indexURL: pyodideFolder });
python.FS.mkdirTree("/wheels");
python.FS.mount(python.FS.filesystems.NODEFS, { root: folder }, "/wheels");
python.runPython(`
import py_compile, warnings
from pathlib import Path

warnings.simplefilter("ignore")
mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
for path in Path("/wheels").rglob("*.py"):
    place = "/".join(path.parts[3:])
    py_compile.compile(
        path, f"{path}c", f"/lib/site-packages/{place}", doraise=True, invalidation_mode=mode
    )
    path.unlink()
`);
