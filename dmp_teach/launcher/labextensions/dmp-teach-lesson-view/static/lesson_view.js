// What our launcher adds to JupyterLab: at an address of one document (/doc/tree/...) a pupil sees
// the lesson, a strip of all lessons and two buttons, and the first panel wakes by itself.
//
// A prebuilt extension of JupyterLab is a script that offers its plugin by `init` and `get`, as
// webpack's containers do; this one needs no build.

const NAME = "dmp-teach-lesson-view";

// Cells of these lines alone are run unasked: they import us, make a panel and show it. Whatever
// else a notebook from elsewhere holds waits for a press.
const WORD = "[A-Za-z_]\\w*";
const VALUE = `(?:${WORD} ?= ?)?(?:"[^"\\\\]*"|'[^'\\\\]*'|[\\w.]+)`;
const VALUES = `${VALUE}(?:, ?${VALUE})*`;
const MADE = `(?:teach\\.(?:lesson|explore|pad)|${WORD}\\.(?:panel|bet))\\((?:${VALUES})?\\)`;
const HARMLESS = new RegExp(
  `^(?:import dmp_teach as teach|(?:${WORD} = )?${MADE}(?:\\.(?:panel|bet)\\(\\))?|${WORD}|#.*|)$`,
);

// The folder's lessons have names such as 03_bump_width.ipynb.
const LESSON = /^(\d\d)_(\w+)\.ipynb$/;

// The mark of the cell with links to all lessons, for Jupyter without this extension.
const STRIP = "dmp_teach";

// The cell that says how to run the next one, and the one that tells what the bet is about.
const BEGIN = "begin";
const WHY = "why";

const config = JSON.parse(document.getElementById("jupyter-config-data")?.textContent || "{}");

/** @type {Record<string, any>} */
let shared;

const t = (/** @type {string} */ text) => config.dmpTeachTexts?.[text] ?? text;

// The address of a lesson: of Jupyter's server, or in our static site.
const addressOf = (/** @type {string} */ path) =>
  config.baseUrl + (config.dmpTeachSite ? "lab/index.html?path=" : "doc/tree/") + encodeURI(path);

const isHarmless = (/** @type {string} */ source) =>
  source.split("\n").every((line) => HARMLESS.test(line.trim()));

const isCode = (/** @type {any} */ cell) => cell.model.type === "code";

/**
 * @param {string} tag
 * @param {Record<string, any>} properties
 * @param {(Node | string)[]} children
 */
function make(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Return how often a kernel has run a cell. */
async function countRuns(/** @type {any} */ kernel) {
  const nothing = { code: "", silent: true, store_history: false };
  return (await kernel.requestExecute(nothing).done).content.execution_count;
}

/**
 * On our static site: drop the browser's copies of lessons that were corrected since. Other copies
 * keep what a pupil wrote.
 * @param {any} app
 */
async function dropCorrected({ serviceManager: { contents } }) {
  const place = `dmp_teach lessons ${config.baseUrl}`;
  const known = JSON.parse(localStorage.getItem(place) ?? "{}");
  for (const [path, version] of Object.entries(config.dmpTeachSite))
    if (known[path] && known[path] !== version) await contents.delete(path);
  localStorage.setItem(place, JSON.stringify(config.dmpTeachSite));
}

/** Draw more of the picture that is shown while a lesson loads, or take it away. */
function showComing(/** @type {number} */ part) {
  const picture = document.getElementById("dt-coming");
  picture?.style.setProperty("--dt-part", String(part));
  picture?.setAttribute("aria-valuenow", String(100 * part));
  if (part === 1) picture?.remove();
}

/** @type {WeakSet<object>} lessons that were left, and whose kernels are ended */
const ended = new WeakSet();

/**
 * End the kernel of a lesson that is left, where it holds no more than a panel whose work the page
 * keeps: school laptops have little memory.
 * @param {any} notebook
 */
async function leave({ content, sessionContext }) {
  const kernel = sessionContext?.session?.kernel;
  const panels = [...(content?.node?.querySelectorAll(".dt-panel") ?? [])];
  const isKept = () =>
    panels.every((each) => each.matches("[data-dt-kept]:not(:has(.dt-work:not([hidden])))"));
  if (!kernel || !panels.length || !isKept()) return;
  if ((await countRuns(kernel)) > 1 || !isKept()) return;
  ended.add(sessionContext);
  await sessionContext.shutdown();
}

/**
 * Run the first code cell of a lesson, unless its panel still lives from before the page's reload.
 * @param {any} app
 * @param {any} notebook
 * @returns {Promise<void>}
 */
async function wake({ commands }, notebook) {
  const { context, content, sessionContext } = notebook;
  await Promise.all([context.ready, notebook.revealed]);
  showComing(0.4);
  await sessionContext.ready;
  if (ended.delete(sessionContext)) await sessionContext.startKernel();
  // The bar has it.
  content.widgets.find((/** @type {any} */ cell) => cell.model.getMetadata(STRIP))?.hide();
  const cell = content.widgets.find(isCode);
  showComing(0.6);
  const kernel = sessionContext.session?.kernel;
  if (!kernel || !cell || !isHarmless(cell.model.sharedModel.getSource())) return;
  // In sight are the lesson's words and its panel; the code comes back with the menus.
  cell.node.dataset.dtPanel = "";
  content.widgets.find((/** @type {any} */ each) => each.model.id === BEGIN)?.hide();
  const why = content.widgets.find((/** @type {any} */ each) => each.model.id === WHY);
  if (why)
    why.node.dataset.dtWhy = t("What happened is told here, once the truth is laid over your bet.");
  // Where not all is seen at once, the panel is: the words above it are a turn of the wheel away.
  const see = () => window.innerHeight < 1000 && cell.node.scrollIntoView();
  if ((await countRuns(kernel)) > 0 && cell.model.outputs.length) return void see();
  content.activeCellIndex = content.widgets.indexOf(cell);
  cell.node.dataset.dtWaking = t("The panel wakes up …");
  see();
  await commands.execute("notebook:run-cell");
  delete cell.node.dataset.dtWaking;
  // A page that is left or loaded anew finds the panel.
  await context.save();
}

/** Run the chosen cell, or the next one below it that can be run, and choose the one after it. */
function runNext(/** @type {any} */ { shell, commands }) {
  const { content } = shell.currentWidget;
  const from = content.activeCellIndex;
  const next = content.widgets.findIndex(
    (/** @type {any} */ cell, /** @type {number} */ at) => at >= from && isCode(cell),
  );
  if (next >= 0) content.activeCellIndex = next;
  commands.execute("notebook:run-cell-and-select-next");
}

/**
 * Draw the strip: every lesson by its number, and the names of this one and of the next.
 * @param {any} app
 * @param {HTMLElement} strip
 */
async function drawLessons({ shell, commands, serviceManager }, strip) {
  const here = shell.currentWidget.context.path;
  const folder = here.slice(0, here.lastIndexOf("/") + 1);
  const { content } = await serviceManager.contents.get(folder);
  const names = content.map((/** @type {any} */ file) => file.name).filter(LESSON.test, LESSON);
  const at = names.sort().indexOf(here.slice(folder.length));
  const links = names.map((/** @type {string} */ name, /** @type {number} */ index) => {
    const [, number, words] = name.match(LESSON);
    const title = words[0].toUpperCase() + words.slice(1).replaceAll("_", " ");
    const path = folder + name;
    const href = addressOf(path);
    const onclick = (/** @type {Event} */ event) => {
      event.preventDefault();
      commands.execute("docmanager:open", { path });
    };
    const link = make("a", { href, title, onclick }, number, make("span", {}, title));
    if (index === at) link.setAttribute("aria-current", "page");
    if (at >= 0 && index === at + 1) link.className = "dt-next";
    return link;
  });
  strip.replaceChildren(...links);
  const edge = () => {
    const { scrollLeft, clientWidth, scrollWidth } = strip;
    // Links fade where there are more of them.
    strip.style.setProperty("--dt-before", scrollLeft > 1 ? "48px" : "0px");
    const isEnd = scrollLeft + clientWidth > scrollWidth - 1;
    strip.style.setProperty("--dt-after", isEnd ? "0px" : "48px");
  };
  strip.onscroll = edge;
  new ResizeObserver(edge).observe(strip);
  // The next one's name is beside it.
  links[at + 1]?.scrollIntoView({ inline: "nearest" });
  links[at]?.scrollIntoView({ inline: "nearest" });
}

/**
 * Hide or show what is JupyterLab's: menus, side bars, status bar, the notebook's tools.
 * @param {any} app
 * @param {boolean} shown
 */
function showMenus({ shell, commands }, shown) {
  document.body.toggleAttribute("data-dt-lesson", !shown);
  if (shell.isTopInSimpleModeVisible() !== shown) shell.toggleTopInSimpleModeVisibility();
  for (const side of ["left", "right"])
    if (commands.isToggled("application:toggle-side-tabbar", { side }) !== shown)
      commands.execute("application:toggle-side-tabbar", { side });
  for (const area of ["menu", "bottom"])
    for (const bar of shell.widgets(area)) bar.parent.setHidden(!shown);
  for (const each of shell.widgets("main")) each.toolbar?.setHidden(!shown);
}

/** @param {any} app */
async function lessonView(app) {
  const { Widget } = (
    await /** @type {any} */ (Object.values(shared["@lumino/widgets"])[0]).get()
  )();
  const strip = make("nav", { ariaLabel: t("Lessons") });
  const run = make("button", { type: "button", onclick: () => runNext(app) }, `▶ ${t("Run")}`);
  const menus = make("button", { type: "button", ariaPressed: "false" }, t("Menus"));
  menus.onclick = () => {
    const shown = menus.ariaPressed === "false";
    showMenus(app, shown);
    menus.ariaPressed = String(shown);
  };
  const bar = new Widget({ node: make("div", { className: "dt-lesson-bar" }, strip, run, menus) });
  bar.id = NAME;
  app.shell.add(bar, "header");
  document.head.append(make("style", { textContent: STYLE }));
  // JupyterLite shows a lesson's folder beside it.
  app.commands.commandExecuted.connect(
    (/** @type {any} */ _, /** @type {any} */ { id, result }) => {
      const collapse = () => menus.ariaPressed === "false" && app.shell.collapseLeft();
      if (id === "docmanager:show-in-file-browser") result.then(collapse);
    },
  );
  const show = () => {
    const notebook = app.shell.currentWidget;
    if (!notebook?.sessionContext) return;
    // JupyterLite takes the lesson out of the address, and a page loaded anew would be empty.
    if (config.dmpTeachSite) history.replaceState(null, "", addressOf(notebook.context.path));
    showMenus(app, menus.ariaPressed === "true");
    drawLessons(app, strip);
    wake(app, notebook).finally(() => showComing(1));
  };
  app.shell.currentChanged.connect((/** @type {any} */ _, /** @type {any} */ { oldValue }) => {
    show();
    if (oldValue && !oldValue.isDisposed) leave(oldValue);
  });
  show();
}

const STYLE = `
.dt-lesson-bar { display: flex; align-items: center; gap: 8px; min-height: 52px; padding: 0 16px;
  box-sizing: border-box; font: 15px var(--jp-ui-font-family); color: var(--jp-ui-font-color0);
  background: var(--jp-layout-color1); border-bottom: 1px solid var(--jp-border-color2); }
.dt-lesson-bar nav { display: flex; flex: 1; gap: 4px; overflow-x: auto; mask-image:
  linear-gradient(90deg, transparent, #000 var(--dt-before, 0px) calc(100% - var(--dt-after, 0px)),
  transparent); }
.dt-lesson-bar :is(a, button) { display: flex; align-items: center; justify-content: center;
  gap: 8px; flex: none; min-width: 44px; height: 44px; padding: 0 12px; box-sizing: border-box;
  font: inherit; color: inherit; background: none; border: 1px solid transparent;
  border-radius: 8px; text-decoration: none; cursor: pointer; font-variant-numeric: tabular-nums; }
.dt-lesson-bar button, .dt-lesson-bar .dt-next { border-color: #767f8a; }
.dt-lesson-bar :is(a, button):hover { background: var(--jp-layout-color2); }
.dt-lesson-bar :is(a, button):focus-visible { outline: 3px solid var(--jp-ui-font-color0);
  outline-offset: -3px; }
.dt-lesson-bar a span { display: none; }
.dt-lesson-bar :is([aria-current], .dt-next) span { display: inline; }
.dt-lesson-bar .dt-next::after { content: "→" / ""; }
.dt-lesson-bar [aria-current] { color: #fff; background: #005a8f; font-weight: 600; }
.dt-lesson-bar [aria-pressed="true"] { background: var(--jp-layout-color3); }
.jp-Notebook:has(.dt-hides) [data-dt-why] > * { display: none; }
.jp-Notebook:has(.dt-hides) [data-dt-why]::after { content: attr(data-dt-why); }
:is([data-dt-waking], .jp-Notebook:has(.dt-hides) [data-dt-why])::after { display: block;
  padding: 12px var(--jp-code-padding) 12px calc(var(--jp-cell-prompt-width) + 20px);
  font: 16px var(--jp-ui-font-family); color: var(--jp-ui-font-color1); }
[data-dt-lesson] .jp-WindowedPanel-outer { overflow-anchor: none; }
[data-dt-waking] { min-height: 100vh; }
[data-dt-waking]::after { content: attr(data-dt-waking); }
[data-dt-lesson] :is(.jp-cell-toolbar, .jp-Notebook-footer) { display: none; }
[data-dt-lesson] .jp-Collapser { visibility: hidden; }
[data-dt-lesson] [data-dt-panel] :is(.jp-Cell-inputWrapper, .jp-OutputPrompt) { display: none; }
`;

const plugin = {
  id: `${NAME}:plugin`,
  autoStart: true,
  activate: async (/** @type {any} */ app) => {
    if (config.mode !== "single-document") return;
    showComing(0.2);
    if (config.dmpTeachSite) await dropCorrected(app);
    // JupyterLite would do so later, after its folder has been opened beside the lesson.
    app.shell.mode = config.mode;
    app.restored.then(() => lessonView(app));
  },
};
const containers = /** @type {any} */ (window);
containers._JUPYTERLAB ??= {};
containers._JUPYTERLAB[NAME] = {
  init: (/** @type {Record<string, any>} */ scope) => {
    shared = scope;
  },
  get: async () => () => ({ __esModule: true, default: plugin }),
};
