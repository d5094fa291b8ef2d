// The Design panel: every field with what it means, a slider for numbers, refusals where they belong.
import { button, make, words } from "./dom";
import { nearest, next, scaleFor, type Scale } from "./steps";

export interface Field {
  name: string; group: string; label: string; kind: "number" | "count" | "text" | "flag" | "list"; unit: string;
  allowed: string; lowest: number | null; highest: number | null; choices: string[]; suggestions: string[];
  optional: boolean; description: string; value: any;
}
type Setter = (name: string, value: any, gesture?: string, bought?: boolean) => void;
interface Row { field: Field; row: HTMLElement; show: (value: any) => void; }
const STEPS = 1000;
const KEYS: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

export class Form {
  private rows = new Map<string, Row>();
  private dragged = "";
  private gestures = 0;
  /** Ways of the sliders, which stay where they are while a value moves within them. */
  private scales = new Map<string, Scale>();
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

  /** Fields that do not count for the design are hidden, and a default shows the value that stands for it. */
  hint(without: string[], inUse: Record<string, number | string>): void {
    const hidden = new Set(without);
    for (const [name, { row, field }] of this.rows) {
      row.hidden = hidden.has(name);
      if (!field.optional) continue;
      const used = inUse[name], control = row.querySelector<HTMLElement>(".value")!;
      const said = used === undefined ? "default" : typeof used === "number" ? `(${words(used)})` : used;
      if (control instanceof HTMLSelectElement) control.options[0].textContent = used === undefined ? "default" : `default: ${used}`;
      else control.setAttribute("placeholder", said);
    }
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
    row.row.hidden = false;
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
    if (field.suggestions.length && (field.value === null || field.suggestions.includes(field.value))) return this.known(field, id);
    if (field.kind === "flag") {
      const flag = make("input", { id, class: "value", type: "checkbox" });
      flag.addEventListener("change", () => this.set(field.name, flag.checked));
      return { elements: [flag], show: (value) => { flag.checked = value; } };
    }
    if (field.kind === "text" || field.kind === "list") return this.textual(field, id);
    return this.numeric(field, id);
  }

  /** A name that the package knows, such as that of a material, or none. */
  private known(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    const choice = make("select", { id, class: "value" }, ...(field.optional ? [make("option", { value: "" }, "default")] : []),
      ...field.suggestions.map((each) => make("option", {}, each)));
    choice.addEventListener("change", () => this.set(field.name, choice.value || null));
    return { elements: [choice], show: (value) => { choice.value = value ?? ""; } };
  }

  private textual(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    const text = make("input", { id, class: "value text", type: "text", autocomplete: "off", spellcheck: "false" });
    const numbers = field.kind === "list" && (field.value ?? []).some((each: any) => typeof each === "number");
    text.addEventListener("change", () => {
      const list = text.value.split(",").map((each) => each.trim()).filter(Boolean);
      const plain = text.value === "" && field.optional ? null : text.value;
      this.set(field.name, field.kind === "text" || plain === null ? plain : numbers ? list.map(Number) : list);
    });
    return { elements: [text], show: (value) => { text.dataset.shown = text.value = Array.isArray(value) ? value.join(", ") : value ?? ""; } };
  }

  private numeric(field: Field, id: string): { elements: HTMLElement[]; show: (value: any) => void } {
    const number = make("input", { id, class: "value", type: "text", inputmode: "decimal", autocomplete: "off" });
    const slider = make("input", {
      type: "range", min: "0", max: String(STEPS), class: "slider", "aria-label": `${titleOf(field.group)} ${field.label}, slider`,
    });
    const ticks = make("datalist", { id: `${id}-sizes` }), ends = make("span", { class: "slider-ends", "aria-hidden": "true" });
    slider.setAttribute("list", ticks.id);
    let gesture = "";
    number.addEventListener("change", () => {
      const given = number.value.replace("−", "-").replace(",", ".").trim();
      if (given === "" && field.optional) this.set(field.name, null);
      else this.set(field.name, given === "" || !Number.isFinite(Number(given)) ? number.value : Number(given));
    });
    const give = (value: number, bought: boolean) => {
      if (!gesture) gesture = `${field.name}-${++this.gestures}-${Date.now()}`;
      number.value = String(value);
      slider.setAttribute("aria-valuetext", `${value} ${field.unit}`);
      this.set(field.name, value, gesture, bought);
    };
    slider.addEventListener("input", () => {
      this.dragged = field.name;
      const stops = this.stops(field);
      give(stops ? stops[Number(slider.value)] : this.scales.get(field.name)!.value(Number(slider.value) / STEPS), stops !== null);
    });
    slider.addEventListener("change", () => {
      gesture = "";
      this.dragged = "";
      if (!this.rows.get(field.name)?.row.classList.contains("refused")) show(field.value);
    });
    // A key goes to the next size or the next value that differs, however wide the way of the slider is.
    slider.addEventListener("keydown", (event) => {
      const steps = KEYS[event.key];
      if (!steps || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      if (!event.repeat) gesture = "";
      const now = Number(number.value), stops = this.stops(field);
      if (!Number.isFinite(now)) return;
      const value = stops ? stops[Math.min(Math.max(nearest(stops, now) + Math.sign(steps), 0), stops.length - 1)] : next(field, now, steps);
      if (value === now) return;
      slider.value = stops ? String(stops.indexOf(value)) : String(Math.round(this.scales.get(field.name)!.share(value) * STEPS));
      give(value, stops !== null);
    });
    slider.addEventListener("keyup", () => { gesture = ""; });
    const show = (value: any) => {
      number.dataset.shown = number.value = value === null || value === undefined ? "" : String(value);
      slider.disabled = typeof value !== "number";
      if (typeof value !== "number") return;
      const stops = this.stops(field);
      slider.max = String(stops ? stops.length - 1 : STEPS);
      slider.setAttribute("aria-valuetext", `${value} ${field.unit}`);
      if (ticks.childElementCount !== (stops ?? []).length) ticks.replaceChildren(...(stops ?? []).map((_, k) => make("option", { value: String(k) })));
      const scale = scaleFor(field, value, this.scales.get(field.name));
      this.scales.set(field.name, scale);
      const [from, to] = stops ? [stops[0], stops.at(-1)!] : [scale.from, scale.to];
      ends.replaceChildren(make("span", {}, words(from, 3)), make("span", {}, words(to, 3)));
      slider.value = stops ? String(nearest(stops, value)) : String(Math.round(scale.share(value) * STEPS));
    };
    return { elements: [number, slider, ticks, ends], show };
  }
}

function titleOf(group: string): string {
  if (group === "") return "array";
  return group.replace(/^lines\.(\d+)/, (_, k) => `line ${Number(k) + 1}`).replaceAll("_", " ").replaceAll(".", ": ");
}
