// The Study panel: ranges around the design, a sweep or a search over them, main effects and the front.
import { axisOf, chart, sheet, type Axis } from "./chart";
import { button, byId, colour, csv, make, shownUnit, words } from "./dom";
import type { Field } from "./form";
import { show, type Word } from "./points";

interface Column { name: string; title: string; unit: string; labels: string[]; better: string; values: number[]; }
interface Effect { centres: number[]; mean: number[]; low: number[]; high: number[]; share: number; }
interface Failed { number: number; reason: string; values: (number | null)[]; }
/** A design that is drawn among those of the study: its value of a field or a figure, by name. */
export interface Mark { title: string; value: (name: string) => number | string | null | undefined; }
export interface Found {
  title: string; source: string; fidelity: string; waiting: number; failures: [string, number][]; number: number[];
  limits: string[]; kept: boolean[]; failed: Failed[];
  parameters: Column[]; metrics: Column[]; effects: Effect[][]; fronts: { first: number; second: number; rows: number[] }[];
}
/** Designs of the front that the table lists; metrics that a new study asks for. */
const LISTED = 12, USUAL = ["predicted_top1", "volume"];

export class StudyPanel {
  private fields: Field[] = [];
  private ranges = new Map<string, [string, string]>();
  private now: Found | null = null;
  private places: { row: number; x: number; y: number }[] = [];
  private crosses: { failed: Failed; x: number; y: number }[] = [];
  private words: Record<string, Word> = {};
  private limits = new Map<string, string>();
  constructor(private send: (message: object) => void, private load: (number: number) => void, private marks: () => Mark[]) {
    byId("study-limit-add").addEventListener("change", () => {
      const choice = byId<HTMLSelectElement>("study-limit-add"), name = choice.value;
      choice.value = "";
      if (!name || this.limits.has(name)) return;
      const now = this.marks()[0].value(name);
      this.limits.set(name, name === "verdict" ? "1" : typeof now === "number" ? String(Number(now.toPrecision(3))) : "");
      this.listLimits();
      byId("study-limits").querySelector<HTMLInputElement>(".study-range:last-child input")?.focus();
    });
    byId("study-add").addEventListener("change", () => {
      const choice = byId<HTMLSelectElement>("study-add"), field = this.fields.find((each) => each.name === choice.value);
      choice.value = "";
      if (field) this.add(field);
    });
    byId("study-run").addEventListener("click", () => this.ask(true));
    byId("study-file").addEventListener("click", () => this.ask(false));
    byId("study-csv").addEventListener("click", () => this.table());
    byId("study-png").addEventListener("click", () => this.now && sheet([...byId("study-shown").querySelectorAll("canvas")], `${this.now.title}.png`));
    for (const id of ["study-effect", "study-x", "study-y"]) byId(id).addEventListener("change", () => this.draw());
    const cloud = byId<HTMLCanvasElement>("study-front");
    cloud.addEventListener("click", (event) => { const row = this.under(event); if (row !== null) this.load(this.now!.number[row]); });
    cloud.addEventListener("pointermove", (event) => { byId("study-pointed").textContent = this.said(this.under(event)) ?? this.failure(event) ?? "\u00a0"; });
    new ResizeObserver(() => this.draw()).observe(byId("study-shown"));
  }

  learn(words: Record<string, Word>, most: number, designs: number): void {
    if (byId("study-metrics").childElementCount) return; // a page that comes back keeps what was chosen
    byId("study-designs").setAttribute("max", String(designs));
    this.words = words;
    byId("study-limit-add").replaceChildren(make("option", { value: "" }, "add a limit…"),
      ...Object.entries(words).map(([name, word]) => make("option", { value: name, title: word.definition }, word.title)));
    byId("study-metrics").replaceChildren(...Array.from({ length: most }, (_, k) => {
      const choice = make("select", { "aria-label": `figure of merit ${k + 1}` }, ...(k ? [make("option", { value: "" }, "–")] : []),
        ...Object.entries(words).map(([name, word]) => make("option", { value: name, title: word.definition }, word.title)));
      choice.value = USUAL[k] ?? "";
      return choice;
    }));
  }

  /** The fields of the design, of which any may have a range. */
  take(fields: Field[]): void {
    this.fields = fields.filter((each) => each.kind === "number" || each.kind === "count" || each.choices.length || each.suggestions.length);
    const groups = new Map<string, HTMLElement>();
    for (const each of this.fields) {
      if (!groups.has(each.group)) groups.set(each.group, make("optgroup", { label: each.group || "array" }));
      groups.get(each.group)!.append(make("option", { value: each.name }, each.label));
    }
    byId("study-add").replaceChildren(make("option", { value: "" }, "add a range…"), ...groups.values());
    for (const name of this.ranges.keys()) if (!this.fields.some((each) => each.name === name)) this.ranges.delete(name);
    this.list();
  }

  found(found: Found): void {
    const columnsOf = (each: Found | null) => each && [each.title, ...each.parameters, ...each.metrics].map((column) => (typeof column === "string" ? column : column.name)).join();
    const goesOn = columnsOf(this.now) === columnsOf(found); // what is shown of it was chosen already
    this.now = found;
    byId("study-shown").hidden = false;
    const columns = [...found.parameters, ...found.metrics];
    const choose = (id: string, choices: Column[], value: number) => {
      const choice = byId<HTMLSelectElement>(id);
      if (goesOn) return;
      choice.replaceChildren(...choices.map((each, k) => make("option", { value: String(k) }, each.title)));
      choice.value = String(value);
    };
    choose("study-effect", found.metrics, 0);
    choose("study-x", columns, found.metrics.length > 1 ? found.parameters.length + 1 : 0);
    choose("study-y", columns, found.parameters.length);
    const kept = found.kept.filter(Boolean).length;
    const failed = found.failures.reduce((sum, [, count]) => sum + count, 0);
    byId("study-said").textContent = `${found.title}, fidelity ${found.fidelity}: ${found.number.length} designs computed` +
      `${found.waiting ? `, ${found.waiting} not yet: Run goes on` : ""}${failed ? `, ${failed} failed (${found.failures.map(([why, count]) => `${count}: ${why}`).join("; ")})` : ""}` +
      `${found.limits.length ? `; ${kept} keep the limits (${found.limits.join("; ")})` : ""}.`;
    this.draw();
  }

  restyle(): void { this.draw(); }

  private add(field: Field): void {
    if (this.ranges.has(field.name)) return;
    const value = typeof field.value === "number" ? field.value : 1, texts = field.choices.length ? field.choices : field.suggestions;
    const near = (share: number) => {
      const end = field.kind === "count" ? Math.round(value * share) : Number((value * share).toPrecision(3));
      return String(Math.min(Math.max(end, field.lowest ?? -Infinity), field.highest ?? Infinity));
    };
    this.ranges.set(field.name, texts.length ? [texts.join(", "), ""] : [near(0.7), near(1.4)]);
    this.list();
    byId("study-ranges").querySelector<HTMLInputElement>(".study-range:last-child input")?.focus();
  }

  private list(): void {
    byId("study-ranges").replaceChildren(...[...this.ranges].map(([name, ends]) => {
      const field = this.fields.find((each) => each.name === name)!, isText = field.kind === "text";
      const box = (end: 0 | 1, label: string) => {
        const input = make("input", { type: "text", class: isText ? "text" : "end", "aria-label": `${name}, ${label}`, ...(isText ? {} : { inputmode: "decimal" }) });
        input.value = ends[end];
        input.addEventListener("change", () => { ends[end] = input.value; });
        return input;
      };
      const boxes = isText ? [box(0, "values")] : [box(0, "from"), make("span", {}, "to"), box(1, "to"), make("span", { class: "unit" }, field.unit)];
      const away = button("×", () => { this.ranges.delete(name); this.list(); }, { "aria-label": `no range for ${name}` });
      return make("div", { class: "study-range", "data-range": name }, make("span", { class: "label" }, name), ...boxes, away);
    }));
  }

  private listLimits(): void {
    byId("study-limits").replaceChildren(...[...this.limits].map(([name, bound]) => {
      const { title, unit, better, definition } = this.words[name], words = `${title} at ${better === "larger" ? "least" : "most"}`;
      const input = make("input", { type: "text", class: "end", "aria-label": words, inputmode: "decimal" });
      input.value = bound;
      input.addEventListener("change", () => { this.limits.set(name, input.value); });
      const away = button("×", () => { this.limits.delete(name); this.listLimits(); }, { "aria-label": `no limit of ${title}` });
      return make("div", { class: "study-range", "data-limit": name, title: definition }, make("span", { class: "label" }, words), input, make("span", { class: "unit" }, unit === "1" ? "" : shownUnit(unit)), away);
    }));
  }

  private ask(run: boolean): void {
    const ranges: Record<string, (number | string)[]> = {};
    const given = (text: string) => { const plain = text.replace("−", "-").replace(",", ".").trim(); return plain === "" || Number.isNaN(Number(plain)) ? text : Number(plain); };
    for (const [name, [from, to]] of this.ranges) {
      const isText = this.fields.find((each) => each.name === name)!.kind === "text";
      ranges[name] = isText ? from.split(",").map((each) => each.trim()).filter(Boolean) : [given(from), given(to)];
    }
    const metrics = [...byId("study-metrics").querySelectorAll("select")].map((each) => each.value).filter(Boolean);
    this.send({
      do: "study", run, ranges, metrics: [...new Set(metrics)], search: byId<HTMLSelectElement>("study-kind").value === "search",
      designs: Number(byId<HTMLInputElement>("study-designs").value), fidelity: byId<HTMLSelectElement>("study-fidelity").value,
      limits: Object.fromEntries([...this.limits].map(([name, bound]) => [name, given(bound)])),
    });
  }

  private draw(): void {
    const now = this.now, width = byId("study-shown").clientWidth;
    if (!now || width === 0) return;
    const metric = Number(byId<HTMLSelectElement>("study-effect").value), aim = now.metrics[metric];
    const each = Math.min(320, width), up = axisOf(now.effects[metric].flatMap((e) => [...e.low, ...e.high]), aim.title, aim.unit);
    byId("study-effects").replaceChildren(...now.parameters.map((parameter, p) => {
      const effect = now.effects[metric][p], canvas = make("canvas", { role: "img" });
      const said = `${parameter.name}: explains ${words(100 * effect.share, 2)} % of the variance`;
      canvas.setAttribute("aria-label", `${aim.title} over ${said}`);
      canvas.dataset.share = String(effect.share);
      this.effect(canvas, each, effect, axisOf(parameter.values, parameter.title, parameter.unit, parameter.labels), up);
      return make("figure", { class: "plot" }, canvas, make("figcaption", {}, said));
    }));
    this.cloud(width);
    this.best();
  }

  private effect(canvas: HTMLCanvasElement, width: number, effect: Effect, across: Axis, up: Axis): void {
    const { c, x, y } = chart(canvas, width, 200, across, up);
    c.fillStyle = c.strokeStyle = colour("--accent");
    if (effect.centres.length > 1 && !across.labels.length) {
      c.globalAlpha = 0.18;
      c.beginPath();
      effect.centres.forEach((at, k) => c.lineTo(x(at), y(effect.low[k])));
      for (let k = effect.centres.length - 1; k >= 0; k--) c.lineTo(x(effect.centres[k]), y(effect.high[k]));
      c.fill();
      c.globalAlpha = 1;
      c.lineWidth = 2;
      c.beginPath();
      effect.centres.forEach((at, k) => c.lineTo(x(at), y(effect.mean[k])));
      c.stroke();
    }
    effect.centres.forEach((at, k) => {
      if (across.labels.length) { c.globalAlpha = 0.18; c.fillRect(x(at) - 12, y(effect.high[k]), 24, y(effect.low[k]) - y(effect.high[k])); c.globalAlpha = 1; }
      dot(c, x(at), y(effect.mean[k]), 3);
    });
  }

  private column(id: string): [Column, number] {
    const chosen = Number(byId<HTMLSelectElement>(id).value), count = this.now!.parameters.length;
    return chosen < count ? [this.now!.parameters[chosen], -1] : [this.now!.metrics[chosen - count], chosen - count];
  }

  /** Rows of the front of what is shown; of one figure the best design. */
  private front(): number[] {
    const now = this.now!, [, a] = this.column("study-x"), [, b] = this.column("study-y");
    const found = now.fronts.find((each) => (each.first === a && each.second === b) || (each.first === b && each.second === a));
    if (found) return found.rows;
    const { values, better } = now.metrics[b >= 0 ? b : a >= 0 ? a : 0], sign = better === "smaller" ? -1 : 1;
    let best = -1;
    values.forEach((value, k) => { if (now.kept[k] && (best < 0 || sign * value > sign * values[best])) best = k; });
    return best < 0 ? [] : [best];
  }

  /** Another design is at hand or pinned, or its figures have come. */
  remark(): void { if (this.now && byId("study-shown").clientWidth) this.cloud(byId("study-shown").clientWidth); }

  private cloud(width: number): void {
    const now = this.now!, [a] = this.column("study-x"), [b] = this.column("study-y"), canvas = byId<HTMLCanvasElement>("study-front");
    const place = (mark: Mark, column: Column) => { const value = mark.value(column.name), at = typeof value === "string" ? column.labels.indexOf(value) : value; return typeof at === "number" && at >= 0 ? at : null; };
    const marks = this.marks().map((mark) => ({ title: mark.title, x: place(mark, a), y: place(mark, b) })).filter((mark) => mark.x !== null && mark.y !== null);
    const [p, q] = [a, b].map((column) => now.parameters.indexOf(column)), failed = p < 0 && q < 0 ? [] : now.failed;
    const of = (each: Failed, k: number) => (k < 0 ? null : each.values[k]), known = (each: number | null): each is number => each !== null;
    const across = axisOf([...a.values, ...marks.map((mark) => mark.x!), ...failed.map((each) => of(each, p)).filter(known)], a.title, a.unit, a.labels);
    const up = axisOf([...b.values, ...marks.map((mark) => mark.y!), ...failed.map((each) => of(each, q)).filter(known)], b.title, b.unit, b.labels);
    const { c, x, y } = chart(canvas, Math.min(width, 640), 340, across, up);
    const front = new Set(this.front());
    this.places = a.values.map((value, row) => ({ row, x: x(value), y: y(b.values[row]) }));
    c.fillStyle = c.strokeStyle = colour("--ink-soft");
    for (const each of this.places) {
      if (front.has(each.row)) continue;
      c.globalAlpha = now.kept[each.row] ? 0.5 : 0.35;
      dot(c, each.x, each.y, 2.5, now.kept[each.row]);
    }
    c.globalAlpha = 1;
    c.strokeStyle = colour("--bad");
    c.lineWidth = 1.2;
    // A design without figures lies where its parameters are; over a figure, at the edge.
    this.crosses = failed.map((each) => ({ failed: each, x: x(of(each, p) ?? across.low), y: y(of(each, q) ?? up.low) }));
    for (const each of this.crosses) cross(c, each.x, each.y, 3.5);
    c.fillStyle = colour("--accent");
    for (const each of this.places) if (front.has(each.row)) dot(c, each.x, each.y, 5);
    c.lineWidth = 2;
    c.font = "11px system-ui";
    c.textBaseline = "middle";
    for (const mark of marks) {
      const [px, py] = [x(mark.x!), y(mark.y!)], toLeft = px > canvas.clientWidth - 90;
      c.strokeStyle = c.fillStyle = colour("--ink");
      c.strokeRect(px - 5, py - 5, 10, 10);
      c.textAlign = toLeft ? "right" : "left";
      c.fillText(mark.title, px + (toLeft ? -9 : 9), py);
    }
    canvas.dataset.marks = marks.map((mark) => mark.title).join(", ");
    canvas.dataset.crosses = String(this.crosses.length);
    canvas.setAttribute("aria-label", `${a.values.length} designs, ${b.title} over ${a.title}; ${front.size} on the front, which the table beside lists${this.crosses.length ? `; ${this.crosses.length} without figures` : ""}`);
  }

  private best(): void {
    const now = this.now!, [, shown] = this.column("study-y"), lead = now.metrics[shown >= 0 ? shown : 0], sign = lead.better === "smaller" ? 1 : -1;
    const rows = [...this.front()].sort((p, q) => sign * (lead.values[p] - lead.values[q]));
    const columns = [...now.metrics, ...now.parameters];
    const head = make("tr", {}, make("th", { scope: "col" }, "design"), ...columns.map((each) => make("th", { scope: "col" }, each.title)));
    byId("study-best").replaceChildren(make("thead", {}, head), make("tbody", {}, ...rows.slice(0, LISTED).map((row) => make("tr", { "data-design": String(now.number[row]) },
      make("td", {}, button(`${now.number[row]}`, () => this.load(now.number[row]), { "aria-label": `load design ${now.number[row]}` })),
      ...columns.map((each) => make("td", {}, each.labels[each.values[row]] ?? show(each.values[row], each.unit)))))));
  }

  private under(event: MouseEvent): number | null {
    const frame = byId("study-front").getBoundingClientRect(), x = event.clientX - frame.left, y = event.clientY - frame.top;
    let best: number | null = null, least = 12;
    for (const each of this.places) {
      const away = Math.hypot(each.x - x, each.y - y);
      if (away < least) { least = away; best = each.row; }
    }
    return best;
  }

  /** Why the design whose cross is under the pointer has no figures. */
  private failure(event: MouseEvent): string | null {
    const frame = byId("study-front").getBoundingClientRect(), px = event.clientX - frame.left, py = event.clientY - frame.top;
    const found = this.crosses.find((each) => Math.hypot(each.x - px, each.y - py) < 8);
    return found ? `design ${found.failed.number}: ${found.failed.reason}` : null;
  }

  private said(row: number | null): string | null {
    if (row === null) return null;
    const columns = [...this.now!.metrics, ...this.now!.parameters];
    return `design ${this.now!.number[row]}: ${columns.map((each) => `${each.title} ${each.labels[each.values[row]] ?? show(each.values[row], each.unit)}`).join(", ")}`;
  }

  private table(): void {
    const now = this.now;
    if (!now) return;
    const columns = [...now.parameters, ...now.metrics];
    csv([["design", ...columns.map((each) => (each.unit ? `${each.name} (${each.unit})` : each.name))],
      ...now.number.map((number, row) => [number, ...columns.map((each) => each.labels[each.values[row]] ?? each.values[row])])], `${now.title}.csv`);
  }
}

function dot(c: CanvasRenderingContext2D, x: number, y: number, radius: number, filled = true): void {
  c.beginPath();
  c.arc(x, y, radius, 0, 7);
  if (filled) c.fill();
  else c.stroke();
}

function cross(c: CanvasRenderingContext2D, x: number, y: number, size: number): void {
  c.beginPath();
  for (const sign of [-1, 1]) { c.moveTo(x - size, y - sign * size); c.lineTo(x + size, y + sign * size); }
  c.stroke();
}
