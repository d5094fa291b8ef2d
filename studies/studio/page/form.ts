// The Design panel: every field with what it means, a slider for numbers, refusals where they belong.
import { button, make, words } from "./dom";

export interface Field {
  name: string; group: string; label: string; kind: "number" | "count" | "text" | "flag" | "list"; unit: string;
  allowed: string; lowest: number | null; highest: number | null; choices: string[]; suggestions: string[];
  optional: boolean; description: string; value: any;
}
type Setter = (name: string, value: any, gesture?: string, bought?: boolean) => void;
interface Row { field: Field; row: HTMLElement; show: (value: any) => void; }
const STEPS = 1000;

export class Form {
  private rows = new Map<string, Row>();
  private dragged = "";
  private gestures = 0;
  private sizes: Record<string, number[]> = {};
  private bought = true; // sliders go from one size that can be bought to the next
  constructor(private place: HTMLElement, private set: Setter) {}

  build(fields: Field[], addable: Record<string, object>, removable: string[]): void {
    const focused = this.place.contains(document.activeElement) ? document.activeElement!.id : "";
    const open = new Set([...this.place.querySelectorAll("details[open]")].map((each) => (each as HTMLElement).dataset.group));
    const first = this.rows.size === 0;
    this.rows.clear();
    this.place.replaceChildren(this.choice());
    const groups = new Map<string, HTMLElement>();
    for (const field of fields) {
      if (!groups.has(field.group)) {
        const title = make("summary", {}, titleOf(field.group));
        if (removable.includes(field.group)) title.append(button("remove", () => this.set(field.group, null), { class: "remove", "aria-label": `remove ${field.group}` }));
        const group = make("details", { "data-group": field.group, "aria-label": titleOf(field.group) }, title);
        group.open = first ? ["resonator", "membrane", "tube"].includes(field.group) : open.has(field.group);
        groups.set(field.group, group);
        this.place.append(group);
      }
      const row = this.row(field);
      this.rows.set(field.name, row);
      groups.get(field.group)!.append(row.row);
    }
    const add = make("select", { id: "add-table", "aria-label": "add a table that the design does not state" },
      make("option", { value: "" }, "add a table…"), ...Object.keys(addable).map((name) => make("option", { value: name }, titleOf(name))));
    add.addEventListener("change", () => { if (add.value) this.set(add.value, addable[add.value]); add.value = ""; });
    this.place.append(make("p", {}, add));
    if (focused) document.getElementById(focused)?.focus(); // what was at hand stays at hand
  }

  private choice(): HTMLElement {
    const only = make("input", { type: "checkbox", id: "bought-only" });
    only.checked = this.bought;
    only.addEventListener("change", () => {
      this.bought = only.checked;
      for (const row of this.rows.values()) if (this.sizes[row.field.name]) row.show(row.field.value);
    });
    const meaning = "sliders of tubes and membranes stop at sizes that can be bought, and wire and sheath follow the bore";
    return make("p", { class: "choice", title: meaning }, only, make("label", { for: "bought-only" }, "Parts that can be bought"));
  }

  /** Sizes that can be bought, by field; they change with the spring and the sheath at hand. */
  offer(sizes: Record<string, number[]>): void {
    const before = this.sizes;
    this.sizes = sizes;
    for (const [name, row] of this.rows) {
      if (name !== this.dragged && String(before[name]) !== String(sizes[name])) row.show(row.field.value);
    }
  }

  /** Stops of a field's slider; none where every value goes. */
  private stops(field: Field): number[] | null {
    const known = this.bought ? this.sizes[field.name] ?? [] : [];
    const inside = known.filter((size) => size >= (field.lowest ?? -Infinity) && size <= (field.highest ?? Infinity));
    return inside.length > 1 ? inside : null;
  }

  update(values: Record<string, any>): void {
    for (const [name, value] of Object.entries(values)) {
      const row = this.rows.get(name);
      if (!row) continue;
      row.field.value = value;
      if (name !== this.dragged) row.show(value);
    }
  }

  /** What was said of earlier values holds no more, and a value that was refused is not the design's. */
  settle(refused = ""): void {
    for (const row of this.place.querySelectorAll<HTMLElement>(".refused, .concerned")) {
      const own = this.rows.get(row.dataset.name!);
      if (own && row.classList.contains("refused") && ![refused, this.dragged].includes(own.field.name)) own.show(own.field.value);
      row.classList.remove("refused", "concerned");
      row.querySelector(".refusal")?.replaceChildren();
      row.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid");
    }
  }

  /** Show a refusal at its field; false where there is no such field. */
  refuse(name: string, message: string, allowed: string, mend: number | null): boolean {
    this.settle(name);
    const row = this.rows.get(name);
    if (!row) return false;
    row.row.closest("details")!.open = true;
    row.row.classList.add("refused");
    row.row.querySelector(".value")?.setAttribute("aria-invalid", "true");
    const said = row.row.querySelector(".refusal")!;
    said.append(make("span", {}, message));
    if (allowed && !message.includes(allowed)) said.append(make("span", {}, ` The field alone: ${allowed}.`));
    if (mend !== null) {
      const unit = row.field.unit ? ` ${row.field.unit}` : "";
      said.append(button(`Set ${words(mend, 6)}${unit}`, () => this.set(name, mend), { class: "mend" }));
    }
    said.scrollIntoView({ block: "nearest" });
    const named = message.match(/(?:^|: )([a-z_]+(?:\.[\w-]+)+)/);
    if (named && named[1] !== name) this.rows.get(named[1])?.row.classList.add("concerned");
    return true;
  }

  focus(name: string): void {
    const row = this.rows.get(name);
    if (!row) return;
    row.row.closest("details")!.open = true;
    row.row.scrollIntoView({ block: "center" });
    row.row.querySelector<HTMLElement>(".value")?.focus();
  }

  private row(field: Field): Row {
    const id = `field-${field.name}`;
    const hint = [field.description, field.allowed].filter(Boolean).join("; ");
    const row = make("div", { class: "field", "data-name": field.name, title: `${field.name}: ${hint}` });
    const label = make("label", { for: id }, field.label);
    row.append(label);
    const parts = this.control(field, id);
    row.append(...parts.elements);
    if (field.unit) row.append(make("span", { class: "unit" }, field.unit));
    row.append(make("p", { class: "hint", id: `${id}-hint` }, hint), make("p", { class: "refusal", role: "alert" }));
    parts.elements[0].setAttribute("aria-describedby", `${id}-hint`);
    parts.show(field.value);
    return { field, row, show: parts.show };
  }

  private control(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    if (field.choices.length) {
      const choice = make("select", { id, class: "value" }, ...field.choices.map((each) => make("option", {}, each)));
      choice.addEventListener("change", () => this.set(field.name, choice.value));
      return { elements: [choice], show: (value) => { choice.value = value; } };
    }
    if (field.kind === "flag") {
      const flag = make("input", { id, class: "value", type: "checkbox" });
      flag.addEventListener("change", () => this.set(field.name, flag.checked));
      return { elements: [flag], show: (value) => { flag.checked = value; } };
    }
    if (field.kind === "text" || field.kind === "list") return this.textual(field, id);
    return this.numeric(field, id);
  }

  private textual(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    const text = make("input", { id, class: "value text", type: "text", autocomplete: "off", spellcheck: "false" });
    if (field.optional) text.placeholder = "default";
    const numbers = field.kind === "list" && (field.value ?? []).some((each: any) => typeof each === "number");
    text.addEventListener("change", () => {
      const list = text.value.split(",").map((each) => each.trim()).filter(Boolean);
      const plain = text.value === "" && field.optional ? null : text.value;
      this.set(field.name, field.kind === "text" || plain === null ? plain : numbers ? list.map(Number) : list);
    });
    const elements: HTMLElement[] = [text];
    if (field.suggestions.length) {
      text.setAttribute("list", `${id}-known`);
      elements.push(make("datalist", { id: `${id}-known` }, ...field.suggestions.map((value) => make("option", { value }))));
    }
    return { elements, show: (value) => { text.dataset.shown = text.value = Array.isArray(value) ? value.join(", ") : value ?? ""; } };
  }

  private numeric(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    const number = make("input", { id, class: "value", type: "text", inputmode: "decimal", autocomplete: "off" });
    const slider = make("input", {
      type: "range", min: "0", max: String(STEPS), class: "slider", "aria-label": `${titleOf(field.group)} ${field.label}, slider`,
    });
    if (field.optional) number.placeholder = "default";
    const ticks = make("datalist", { id: `${id}-sizes` });
    slider.setAttribute("list", ticks.id);
    let scale = scaleOf(field, field.value);
    let gesture = "";
    number.addEventListener("change", () => {
      const given = number.value.replace("−", "-").replace(",", ".").trim();
      if (given === "" && field.optional) this.set(field.name, null);
      else this.set(field.name, given === "" || !Number.isFinite(Number(given)) ? number.value : Number(given));
    });
    slider.addEventListener("input", () => {
      if (!gesture) gesture = `${field.name}-${++this.gestures}-${Date.now()}`;
      this.dragged = field.name;
      const stops = this.stops(field);
      const value = stops ? stops[Number(slider.value)] : scale.value(Number(slider.value) / STEPS);
      number.value = String(value);
      slider.setAttribute("aria-valuetext", `${value} ${field.unit}`);
      this.set(field.name, value, gesture, stops !== null);
    });
    slider.addEventListener("change", () => {
      gesture = "";
      this.dragged = "";
      if (!this.rows.get(field.name)?.row.classList.contains("refused")) show(field.value);
    });
    const show = (value: any) => {
      number.dataset.shown = number.value = value === null || value === undefined ? "" : String(value);
      slider.disabled = typeof value !== "number";
      if (typeof value !== "number") return;
      const stops = this.stops(field);
      slider.max = String(stops ? stops.length - 1 : STEPS);
      slider.setAttribute("aria-valuetext", `${value} ${field.unit}`);
      if (ticks.childElementCount !== (stops ?? []).length) ticks.replaceChildren(...(stops ?? []).map((_, k) => make("option", { value: String(k) })));
      if (stops) {
        slider.value = String(nearest(stops, value));
        return;
      }
      const share = scale.share(value);
      if (!(share > 0.02 && share < 0.98) || document.activeElement !== slider) scale = scaleOf(field, value);
      slider.value = String(Math.round(scale.share(value) * STEPS));
    };
    return { elements: [number, slider, ticks], show };
  }
}

interface Scale { value: (share: number) => number; share: (value: number) => number; }

/** A slider's way around a value: a third to three times of it, or from bound to bound where it may be zero. */
function scaleOf(field: Field, now: any): Scale {
  const value = typeof now === "number" ? now : 0;
  const low = field.lowest, high = field.highest;
  const round = (x: number) => {
    if (field.kind === "count") return Math.round(x);
    const step = 10 ** (Math.floor(Math.log10(Math.max(Math.abs(value), 1e-9))) - 2);
    return Number((Math.round(x / step) * step).toPrecision(6));
  };
  if (value > 0 && !(low !== null && low < 0) && !(high !== null && high <= 1)) {
    const from = Math.max(low ?? 0, value / 3, 1e-9), to = Math.min(high ?? Infinity, Math.max(value * 3, field.kind === "count" ? 6 : 0));
    const span = Math.log(Math.max(to / from, 1.0001));
    return { value: (share) => clamp(round(from * Math.exp(share * span)), from, to), share: (x) => clamp(Math.log(x / from) / span, 0, 1) };
  }
  const from = low ?? Math.min(0, 2 * value), to = high ?? Math.max(1, 2 * value);
  const even = (x: number) => Number((Math.round(x / ((to - from) / 200)) * ((to - from) / 200)).toPrecision(6));
  return {
    value: (share) => clamp(field.kind === "count" ? Math.round(from + share * (to - from)) : even(from + share * (to - from)), from, to),
    share: (x) => clamp((x - from) / (to - from || 1), 0, 1),
  };
}

function nearest(stops: number[], value: number): number {
  const apart = stops.map((size) => Math.abs(Math.log(size / Math.max(value, 1e-9))));
  return apart.indexOf(Math.min(...apart));
}

function clamp(x: number, from: number, to: number): number { return Math.min(Math.max(x, from), to); }

function titleOf(group: string): string {
  if (group === "") return "array";
  return group.replace(/^lines\.(\d+)/, (_, k) => `line ${Number(k) + 1}`).replaceAll("_", " ").replaceAll(".", ": ");
}
