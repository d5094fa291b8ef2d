// The page of the studio: panels, and what they and the server tell each other.
import "uplot/dist/uPlot.min.css";
import "./studio.css";
import { takeSecret } from "./access";
import { ArrayPanel, type Part } from "./array";
import { CheckPanel } from "./check";
import { PointCard } from "./card";
import { Colouring } from "./colouring";
import { ComparePanel } from "./compare";
import { CurvesPanel, unpack } from "./curves";
import { tablePicture } from "./chart";
import { button, byId, csv, download, forgetColours, grey, make, words } from "./dom";
import { BODY_FILE, FitPanel } from "./fit";
import { Form } from "./form";
import { addressOf, designInAddress, forget, keep, keptInTab, keptUnsaved } from "./kept";
import { handIn } from "./handing";
import { PointsPanel, type Word } from "./points";
import { TouchPanel } from "./touch";
import { VerdictBar } from "./verdict";
import { LiveSwitch } from "./live";
import { JobDialogue } from "./job";
import { Link, type State } from "./link";
import { keepRecent } from "./recent";
import { takeRecordings } from "./recordings";
import { SectionPicture } from "./section";
import { sharedDesign, SharedLink } from "./shared";
import { Snapshots } from "./snapshots";
import { StudyPanel } from "./study";
import { Tabs } from "./tabs";

/** Characters of the longest change that the studio takes, of a message of 1 MB. */
const LONGEST = 300000;
const STATES: Record<State, string> = {
  open: "",
  lost: "The connection to the studio was lost and is being restored. The design is kept.",
  gone: "The studio does not answer: it has ended. Start it again with “acoustic-fem studio”. This page keeps the design and continues with it.",
  locked: "The studio does not know this browser. Open the address that it printed last in this browser, then this page continues with its design.",
};
/** The design of a page without a studio; null in a studio. */
const shared = sharedDesign();
if (!shared) takeSecret();
let session: string | null = null;
let stated: any = null;
let name = "design";
let unsaved = false;
let revision = -1;
let curveTitles: Record<string, string> = {};
let quantity = "level";
/** Changes that wait for the one under way. */
const waiting: any[] = [];
let underWay: any = null;
/** When the last change was made, ms, and how long after it an array is drawn. */
let changed = -1e4;
const CALM = 250;
let pinned: any = keptInTab()?.pinned ?? null;
/** Tells this page from another one that was doubled from it and knows the same session. */
const ownName = crypto.getRandomValues(new Uint32Array(4)).join("-");
let selected: number | null = null, other: number | null = null, pointed: number | null = null;
let fromAddress: any = null;

const form = new Form(byId("fields"), (field, value, gesture, bought) => change({ do: "set", name: field, value, gesture, bought }));
const colouring = new Colouring(recolour);
const card = new PointCard(colouring);
const colourOf = (point: number) => colouring.of(point);
const curves = new CurvesPanel(byId("plots"), () => curveTitles, colourOf, choose, hover);
const array = new ArrayPanel(byId("space"), colourOf, click, hover, shared ? null : { drag: change, resize: (size, value) => change({ do: "resize", size, value }) });
let figureWords: Record<string, Word> = {};
const table = new PointsPanel(() => figureWords, colourOf, choose, hover);
const check = new CheckPanel((part, place) => {
  array.light((each: Part) => each.part === part, [{ part, place }]);
  byId("space").scrollIntoView({ block: "nearest" });
});
const fit = new FitPanel(array, (message) => link?.send(message) ?? false, () => session);
const job = new JobDialogue(
  (message) => link?.send(message) ?? false,
  (values, source) => change({ do: "restore", values, source }),
  (chosen) => change({ do: "prototype", name: chosen }),
);
const verdict = new VerdictBar(byId("verdict-shown"), (values) => change({ do: "remedy", values }));
const compare = new ComparePanel();
const touch = new TouchPanel(
  (message) => { document.querySelector("[data-problem='touch']")!.textContent = ""; link?.send(message); },
  (point) => array.touch(point),
);
const live = new LiveSwitch((message) => link?.send(message), (message) => failed({ stage: "live", message }), () => touch.endLive());
takeRecordings(touch, () => ({ session: session ?? "", revision }));
const study = new StudyPanel(
  (message) => { document.querySelector("[data-problem='study']")!.textContent = ""; link?.send(message); },
  (number) => change({ do: "load", number }),
  () => [
    { title: "this design", value: (field) => (shownRevision.points === revision ? table.figures[field] : undefined) ?? at(stated, field) },
    ...(pinned ? [{ title: "pinned", value: (field: string) => compare.pinned(field) ?? at(pinned, field) }] : []),
  ],
);
const picture = new SectionPicture((field, value) => change({ do: "set", name: field, value }));
const snapshots = new Snapshots(
  (values) => change({ do: "restore", values, source: "the snapshot" }),
  (values) => link?.send({ do: "pin", values }),
  () => ({ name, stated, picture: array.thumbnail(), outcome: shownRevision.verdict === revision ? verdict.outcome : "", rows: shownRevision.verdict === revision ? verdict.rows : [],
    figures: shownRevision.points === revision ? table.figures : undefined }),
);
const shownRevision: Record<string, number> = {};
/** Panels that are in sight: of the others nothing is computed. */
const inSight = new Set<string>(), cardsInSight = new Set<HTMLElement>();

/** Changes go one at a time and in their order; of one gesture that waits, the last is kept. */
function change(message: any): void {
  changed = performance.now();
  if (JSON.stringify(message).length > LONGEST) return notice("This text is too long for a design.");
  const last = waiting.at(-1);
  if (message.gesture && message.gesture === last?.gesture) waiting[waiting.length - 1] = message;
  else waiting.push(message);
  next();
}

function next(): void {
  if (!underWay && waiting.length && link?.send(waiting[0])) underWay = waiting.shift();
}

function answered(): void {
  underWay = null;
  next();
}

/** In the picture of the array: while the panel Touch is open a click is a touch, of the contact that the target has. */
function click(point: number | null, second: boolean, reached: (reach: number) => number | null): void {
  const touched = document.body.dataset.panel === "touch" && !shared ? reached(stated?.target?.contact_radius ?? 0) : null;
  if (touched) touch.press(touched);
  choose(point, second);
}

/** A point was clicked: it is lit, or compared with the one that is lit. */
function choose(point: number | null, second: boolean): void {
  if (second && selected !== null && point !== selected) against(point);
  else select(point);
}

function against(point: number | null): void {
  other = point;
  byId<HTMLSelectElement>("other").value = point === null ? "" : String(point);
  curves.light(selected, other);
}

/** A point is pointed at, or none: it is shown everywhere. */
function hover(point: number | null): void {
  if (point === pointed) return;
  pointed = point;
  curves.point(point);
  array.point(point);
  table.point(point);
  card.show(point ?? selected);
}

function recolour(): void {
  curves.repaint();
  array.recolour();
  table.recolour();
  card.redraw();
  watch();
}

function select(point: number | null): void {
  selected = point;
  if (point === null || point === other) against(null);
  byId<HTMLSelectElement>("point").value = point === null ? "" : String(point);
  card.show(pointed ?? point);
  curves.light(point, other);
  table.light(point);
  array.light((part: Part) => point !== null && part.group === `point ${point}` && part.kind !== "sheath" && part.kind !== "spring");
}

function take(message: any): void {
  switch (message.type) {
    case "words": return learn(message);
    case "design": return design(message);
    case "refused":
      if (!form.refuse(message.name, message.message, message.allowed, message.mend)) notice(message.message);
      picture.draw();
      return answered();
    case "refused-design":
      notice(message.message);
      return answered();
    case "error":
      notice(message.message);
      return answered();
    case "moved":
      array.follow(message);
      return stale();
    case "refused-size":
      refusedSize(message);
      return answered();
    case "progress": return progress(message.stage, message.line || document.querySelector<HTMLElement>(`[data-status="${message.stage}"]`)?.dataset.said || "computing…");
    case "failed": return failed(message);
    case "figures": return void figures(message);
    case "pinned":
      pinned = message.stated;
      return keepSoon();
    case "comparison":
      byId("pin").setAttribute("aria-pressed", String(message.pinned !== null));
      if (message.pinned === null) curves.unpin();
      compare.take(message);
      return;
    case "compared":
      compare.figures(message.rows);
      return study.remark();
    case "file":
      if (message.stage === "export") exported("");
      download(message.file);
      return;
    case "validity":
      byId("validity-reason").textContent = message.reason;
      byId("solve").hidden = !message.solves;
      return;
    case "solved": return progress("solve", "");
    case "heard":
      if (live.on) touch.hearLive(message.event);
      return;
    case "job": return job.learn(message);
    case "proposals": return job.take(message);
    case "body":
      progress("body", "");
      return void fit.learn(message);
    case "fitted": return progress("fit", "");
    case "cards": return live.cards(message.cards);
    case "refused-export": notice(message.message);
  }
}

/** A size that is not allowed, with the nearest one that is. */
function refusedSize({ size, message, nearest }: { size: string; message: string; nearest: number | null }): void {
  array.refuseSize(size);
  const mend = nearest === null ? [] : [button(`Set ${words(nearest)} mm`, () => change({ do: "resize", size, value: nearest }), { class: "mend" })];
  byId("size-refusal").replaceChildren(make("span", {}, message), ...mend);
}

function progress(stage: string, line: string): void {
  if (stage === "proposals") return job.progress(line);
  const place = document.querySelector(`[data-status="${stage}"]`);
  if (place) place.textContent = line;
  if (stage === "fit") fit.progress(line);
  if (stage === "solve") byId("solve").textContent = line ? "Stop" : "Solve in 3-D";
  if (stage === "study") {
    byId<HTMLButtonElement>("study-run").disabled = line !== "";
    byId<HTMLButtonElement>("study-stop").disabled = line === "";
  }
}

function failed(message: any): void {
  if (message.stage === "proposals") return job.failed(message.message);
  progress(message.stage, "");
  if (message.stage === "touch") touch.failed();
  if (message.stage === "body") fit.failed();
  const place = message.stage === "curves" ? byId("curves-note") : document.querySelector(`[data-problem="${message.stage}"]`);
  if (place) place.textContent = message.message;
  else notice(message.message);
  if (message.stage === "export") exported(message.message);
  else if (message.stage === "live") { byId("live").setAttribute("aria-pressed", "false"); touch.endLive(); }
  else shownRevision[message.stage] = -1;
  stale();
}

/** Figures of the points have come: what is coloured by them follows, and the card. */
function refigured(): void { if (colouring.isByFigure) recolour(); else card.redraw(); }

/** Until no change has been made for a moment: drawing an array would hold up the curves of a slider that is dragged. */
async function calm(): Promise<void> {
  while (performance.now() - changed < CALM || array.isDragged) await new Promise((go) => setTimeout(go, CALM / 2));
}

/** Models are fetched one after the other: the one asked for last is the one that stays. */
let fetched: Promise<void> = Promise.resolve();

async function figures(message: any): Promise<void> {
  const { stage, found } = message;
  if (message.revision < (shownRevision[stage] ?? -1)) return;
  if (stage === "model") {
    const own = fetched.then(calm).then(() => array.take(found, message.revision));
    fetched = own.catch(() => {});
    try {
      await own;
      recentSoon();
    } catch {
      return failed({ stage, message: "The array could not be fetched from the studio. Change the design to draw it again." });
    }
  }
  if (stage === "points") { colouring.take(found); table.take(found); refigured(); if (message.revision === revision) snapshots.figured(stated, found.figures); study.remark(); }
  if (stage === "as_built") { colouring.asBuilt(found); table.asBuilt(found); refigured(); }
  if (stage === "verdict") verdict.take(found);
  if (stage === "check") check.take(found);
  if (stage === "surface") touch.take(found, message.revision);
  if (stage === "study") study.found(found);
  if (message.running) return; // a study of which this is a part
  shownRevision[stage] = message.revision;
  progress(stage, "");
  const problem = document.querySelector(`[data-problem="${stage}"]`);
  if (problem) problem.textContent = "";
  document.documentElement.dataset[`shown_${stage}`] = String(message.revision);
  stale();
}

function learn(message: any): void {
  curveTitles = message.curves;
  const choice = byId<HTMLSelectElement>("quantity");
  choice.replaceChildren(...Object.entries(curveTitles).map(([value, title]) => make("option", { value }, title)));
  choice.value = quantity;
  byId<HTMLSelectElement>("prototypes").replaceChildren(
    make("option", { value: "" }, "prototypes…"), ...message.prototypes.map((each: string) => make("option", {}, each)),
  );
  figureWords = message.figures;
  snapshots.learn(figureWords);
  if (message.new) begin();
  study.learn(message.metrics, message.most_metrics, message.most_designs);
  byId("exports").replaceChildren(...Object.entries<any>(message.exports).map(([file, each]) => make("li", {},
    button(file, () => ask(file), { "data-export": file }), make("span", {}, ` ${each.title}; ${each.takes}`))));
  const before = message.new && !keptInTab() ? keptUnsaved() : null;
  if (before && !fromAddress) offer(before);
  fromAddress = null;
  want();
}

/** The studio knows nothing of what was shown here: its numbers of designs begin anew. */
function begin(): void {
  for (const stage of Object.keys(shownRevision)) delete shownRevision[stage];
  curves.outdate();
  fit.begin();
  progress("fit", "");
  if (live.on) failed({ stage: "live", message: "The studio was started again: press Live to listen." });
  if (pinned) link?.send({ do: "pin", values: pinned });
}

function design(message: any): void {
  session = message.session;
  revision = message.revision;
  unsaved = message.unsaved;
  if (message.form) {
    stated = message.stated;
    name = message.design_name;
    form.build(message.form, message.addable, message.removable);
    points(message.form);
    study.take(message.form);
  } else {
    form.settle();
    form.update(message.values);
    for (const [field, value] of Object.entries(message.values)) put(stated, field, value);
    if ("name" in message.values) name = message.values.name;
    if (Object.keys(message.values).some((each) => each.endsWith(".points"))) points(null);
  }
  byId("size-refusal").replaceChildren();
  form.offer(message.sizes);
  if (message.hints) form.hint(message.hints.without_effect, message.hints.in_use);
  picture.take(stated, message.hints?.in_use ?? null);
  if (!shared) fit.take(stated);
  byId("name").textContent = name;
  byId("unsaved").hidden = !unsaved;
  document.title = `${unsaved ? "● " : ""}${name} – acoustic-fem studio`;
  byId<HTMLButtonElement>("undo").disabled = !message.undo;
  byId<HTMLButtonElement>("redo").disabled = !message.redo;
  document.documentElement.dataset.revision = String(revision);
  keepSoon();
  stale();
  answered();
}

let recalling = 0;
/** The design is among the recent ones once its picture has stood for a second. */
function recentSoon(): void {
  if (shared) return;
  clearTimeout(recalling);
  recalling = window.setTimeout(() => { if (shownRevision.model === revision) keepRecent({ name, stated, picture: array.thumbnail() }); }, 1000);
}

let keeping = 0;
function keepSoon(): void {
  if (shared) return;
  clearTimeout(keeping);
  keeping = window.setTimeout(() => keep({ session, stated, unsaved, pinned }), 150);
}

/** The value of a field in what a design states; undefined where it states none. */
function at(place: any, field: string): any {
  for (const step of field.split(".")) place = place?.[step];
  return place;
}

function put(place: any, field: string, value: any): void {
  const steps = field.split(".");
  const last = steps.pop()!;
  for (const step of steps) {
    place = place?.[step];
    if (place === undefined || place === null) return; // of a table that follows another one
  }
  place[last] = value;
}

function points(fields: any[] | null): void {
  const count = (stated?.lines ?? []).reduce((sum: number, line: any) => sum + line.points, 0);
  const choice = byId<HTMLSelectElement>("point");
  if (choice.options.length !== count + 1 || fields) {
    choice.replaceChildren(
      make("option", { value: "" }, "all points"),
      ...Array.from({ length: count }, (_, k) => make("option", { value: String(k + 1) }, `point ${k + 1}`)),
    );
    byId<HTMLSelectElement>("other").replaceChildren(make("option", { value: "" }, "–"), ...[...choice.options].slice(1).map((each) => each.cloneNode(true)));
    colouring.size(count);
    pointed = null;
    select(selected !== null && selected <= count ? selected : null);
  }
}

/** What is shown of an earlier design is grey. */
function stale(): void {
  grey(byId("plots"), curves.revision !== revision);
  for (const [stage, place] of [["model", "space"], ["points", "points-shown"], ["points", "compared-figures"], ["points", "point-card"], ["as_built", "as-built-shown"], ["verdict", "verdict-shown"], ["check", "print-shown"], ["surface", "touch-shown"]]) {
    grey(byId(place), shownRevision[stage] !== revision && !(stage === "model" && array.isMoved));
  }
}

/** What is in sight is computed, and what it is coloured by. */
function watch(): void {
  inSight.clear();
  for (const each of cardsInSight) for (const stage of each.dataset.stage!.split(" ")) inSight.add(stage);
  if (colouring.wantsBuilt) inSight.add("as_built");
  want();
}

function want(): void { link?.send({ do: "want", stages: [...inSight], quantity }); }

function notice(text: string, ...more: HTMLElement[]): void {
  byId("notice").replaceChildren(make("span", {}, text), ...more, button("×", () => { byId("notice").hidden = true; }, { "aria-label": "close" }));
  byId("notice").hidden = false;
}

function offer(before: any): void {
  notice(
    `“${before.stated?.name}” was not saved when its page was closed.`,
    button("Go on with it", () => { change({ do: "restore", values: before.stated, source: "the design that was kept" }); byId("notice").hidden = true; }),
    button("Forget it", () => { forget(); byId("notice").hidden = true; }),
  );
}

function theme(choice: string): void {
  document.documentElement.dataset.theme = choice;
  forgetColours();
  colouring.legend();
  picture.draw();
  byId("theme").setAttribute("aria-pressed", String(choice === "dark"));
  curves.restyle();
  array.restyle();
  table.restyle();
  touch.restyle();
  study.restyle();
  fit.restyle();
  snapshots.restyle();
}

/** Open a project file, or a design file with its file of places and its body if it has any. */
async function upload(files: File[]): Promise<void> {
  const body = files.find((each) => BODY_FILE.test(each.name)), json = files.find((each) => each.name.endsWith(".json"));
  const file = files.find((each) => each !== body && each !== json) ?? json;
  try {
    if (body) await fit.handIn(body);
    if (!file) return;
    const source = [...file.name].slice(0, 100).join("");
    if (file === json) {
      const { stated: values, pinned: other } = snapshots.read(await file.text());
      change({ do: "restore", values, source, saved: true });
      if (other) link?.send({ do: "pin", values: other });
      return;
    }
    const places = json ? JSON.stringify([await file.text(), await json.text()]) : null;
    const asked = { name: file.name, ...(json ? { places: json.name } : {}) };
    const found = await (await handIn("/designs", asked, places ?? file)).json();
    if (found.note) notice(found.note);
    change({ do: "restore", values: found.stated, source, saved: true });
  } catch (error) {
    notice((error as Error).message);
  }
}

function save(): void {
  if (!link?.send({ do: "export", name: "design.toml" })) notice("The studio does not answer, so nothing was saved yet. This page keeps the design.");
}

function ask(file: string): void {
  if (file === "design.toml") return save();
  byId<HTMLButtonElement>("stop-export").disabled = false;
  document.querySelector("[data-problem='export']")!.textContent = "";
  link?.send({ do: "export", name: file, fidelity: byId<HTMLSelectElement>("fidelity").value });
}

function exported(problem: string): void {
  byId<HTMLButtonElement>("stop-export").disabled = true;
  progress("export", "");
  document.querySelector("[data-problem='export']")!.textContent = problem;
}

function takeCurves(message: ArrayBuffer): void {
  const found: any = unpack(message);
  if (found.stage === "touch") { if (found.revision === revision) touch.hear(found); else touch.failed(); return; }
  if (found.quantity !== quantity) return;
  curves.take(found);
  byId("curves-note").textContent = "";
  stale();
}

let link: { send: (message: object) => boolean } | null = null;
const open = () => new Link(
  () => {
    const kept = fromAddress ? { session: null, stated: fromAddress, unsaved: true } : stated ? { session, stated, unsaved } : keptInTab();
    // Nobody knows whether a change that was under way arrived: one that can be made twice is made again.
    if (["set", "restore", "prototype", "load"].includes(underWay?.do)) waiting.unshift(underWay);
    underWay = null;
    return { do: "hello", page: ownName, session: kept?.session ?? null, values: kept?.stated ?? null, saved: kept ? !kept.unsaved : false };
  },
  take,
  takeCurves,
  (state) => {
    byId("lost").hidden = state === "open";
    byId("lost").textContent = STATES[state];
    document.body.classList.toggle("away", state !== "open");
  },
);

byId("undo").addEventListener("click", () => change({ do: "undo" }));
byId("redo").addEventListener("click", () => change({ do: "redo" }));
byId("save").addEventListener("click", save);
byId("project").addEventListener("click", () => snapshots.save(stated, pinned));
byId("pin").addEventListener("click", () => link?.send({ do: "pin", on: byId("pin").getAttribute("aria-pressed") !== "true" }));
byId("address").addEventListener("click", async () => {
  const address = await addressOf(stated);
  try {
    await navigator.clipboard.writeText(address);
    notice("The address of this design was copied. It opens in a browser that has opened this studio before.");
  } catch {
    notice(address);
  }
});
byId("theme").addEventListener("click", () => {
  const next = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  localStorage.setItem("acoustic-fem-theme", next);
  theme(next);
});
byId<HTMLSelectElement>("quantity").addEventListener("change", (event) => { quantity = (event.target as HTMLSelectElement).value; want(); });
byId<HTMLSelectElement>("point").addEventListener("change", (event) => {
  const value = (event.target as HTMLSelectElement).value;
  select(value ? Number(value) : null);
});
byId<HTMLSelectElement>("other").addEventListener("change", (event) => against(Number((event.target as HTMLSelectElement).value) || null));
byId<HTMLSelectElement>("prototypes").addEventListener("change", (event) => {
  const choice = event.target as HTMLSelectElement;
  if (choice.value) change({ do: "prototype", name: choice.value });
  choice.value = "";
});
byId<HTMLInputElement>("open").addEventListener("change", (event) => {
  const files = [...((event.target as HTMLInputElement).files ?? [])];
  if (files.length) upload(files);
  (event.target as HTMLInputElement).value = "";
});
byId("curves-csv").addEventListener("click", () => curves.table(name));
byId("curves-png").addEventListener("click", () => curves.picture(name));
document.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  // In a text that is being typed they are the browser's own.
  const inText = event.target instanceof HTMLInputElement && event.target.type === "text" && event.target.value !== event.target.dataset.shown;
  if (key === "s") { event.preventDefault(); save(); }
  else if (inText) return;
  else if (key === "z" && !event.shiftKey) { event.preventDefault(); change({ do: "undo" }); }
  else if (key === "y" || (key === "z" && event.shiftKey)) { event.preventDefault(); change({ do: "redo" }); }
});
/** The design in the address; what is broken is said. */
async function addressed(): Promise<any | null> {
  try {
    return await designInAddress();
  } catch {
    notice("The address does not hold a readable design. It may have been cut off.");
    return null;
  }
}
window.addEventListener("hashchange", async () => {
  const found = await addressed();
  if (found) change({ do: "restore", values: found, source: "the address" });
});
const dark = matchMedia("(prefers-color-scheme: dark)");
theme(localStorage.getItem("acoustic-fem-theme") ?? (dark.matches ? "dark" : "light"));
dark.addEventListener("change", () => { if (!localStorage.getItem("acoustic-fem-theme")) theme(dark.matches ? "dark" : "light"); });

byId("points-png").addEventListener("click", () => table.picture(name));
byId("points-csv").addEventListener("click", () => table.table(name));
byId("print-png").addEventListener("click", () => tablePicture(check.rows(), `${name}-print.png`));
byId("print-csv").addEventListener("click", () => csv(check.rows(), `${name}-print.csv`));
byId("compare-page").addEventListener("click", () => ask("comparison.html"));
byId("compare-png").addEventListener("click", () => tablePicture(compare.rows(), `${name}-compare.png`));
byId("compare-csv").addEventListener("click", () => csv(compare.rows(), `${name}-compare.csv`));
byId("stop-check").addEventListener("click", () => { link?.send({ do: "stop", stage: "check" }); progress("check", "stopped"); });
byId("stop-export").addEventListener("click", () => link?.send({ do: "stop", stage: "export" }));
byId("study-stop").addEventListener("click", () => link?.send({ do: "stop", stage: "study" }));
byId("solve").addEventListener("click", () => {
  document.querySelector("[data-problem='solve']")!.textContent = "";
  link?.send(byId("solve").textContent === "Stop" ? { do: "stop", stage: "solve" } : { do: "solve" });
});
byId("sound").addEventListener("click", () => touch.sound());
byId("touch-png").addEventListener("click", () => touch.picture(name));
byId("touch-csv").addEventListener("click", () => touch.table(name));
for (const card of document.querySelectorAll("main section, aside section")) {
  for (const each of card.querySelectorAll("button[id$='-png'], button[id$='-csv'], button[id^='stop-']")) {
    each.setAttribute("aria-label", `${each.textContent}, ${card.querySelector("h2")!.textContent}`);
  }
}
byId("array-png").addEventListener("click", () => array.picture(name));
new Tabs((opened) => fit.opened(opened === "body"));
const watcher = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (entry.isIntersecting) cardsInSight.add(entry.target as HTMLElement);
    else cardsInSight.delete(entry.target as HTMLElement);
  }
  watch();
}, { rootMargin: "100px" });
for (const card of document.querySelectorAll("[data-stage]")) watcher.observe(card);
(async () => {
  if (shared) {
    link = new SharedLink(shared, take, takeCurves);
    return want();
  }
  fromAddress = await addressed();
  link = open();
})();
