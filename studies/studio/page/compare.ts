// The Compare panel: this design and the pinned one, the fields that differ and the figures of both.
import { byId, make, shownUnit, words } from "./dom";
import { show, type Word } from "./points";

export interface Comparison { pinned: string | null; differences?: { name: string; unit: string; here: any; there: any }[]; }

export class ComparePanel {
  private pinned: Record<string, number> | null = null;
  private differences: NonNullable<Comparison["differences"]> = [];
  constructor(private word: () => Record<string, Word>, private here: () => Record<string, number> | null) {}

  take(found: Comparison): void {
    const on = found.pinned !== null;
    byId("compare-empty").hidden = on;
    byId("compare-tables").hidden = !on;
    if (!on) { this.pinned = null; byId("compared-figures").replaceChildren(); return; }
    byId("pinned-name").textContent = found.pinned!;
    this.differences = found.differences ?? [];
    const rows = this.differences.map((each) => make("tr", {},
      make("th", { scope: "row" }, each.name), make("td", {}, value(each.there, each.unit)), make("td", {}, value(each.here, each.unit))));
    byId("differences").replaceChildren(...(rows.length ? rows : [make("tr", {}, make("td", { colspan: "3" }, "no field differs"))]));
  }

  /** The fields that differ and the figures of both as a table, its first row as head. */
  rows(): (string | number)[][] {
    const here = this.here(), there = this.pinned;
    return [["field or figure", "unit", "pinned", "now"], ...this.differences.map((each) => [each.name, each.unit, plain(each.there), plain(each.here)]),
      ...(here && there ? Object.entries(this.word()).map(([name, word]) => [name, word.unit, there[name], here[name]]) : [])];
  }

  figures(found: Record<string, number> | null): void {
    if (found) this.pinned = found;
    const here = this.here(), there = this.pinned;
    if (!here || !there) return;
    byId("compared-figures").replaceChildren(...Object.entries(this.word()).map(([name, word]) => {
      const better = here[name] === there[name] ? "" : (here[name] > there[name]) === (word.better === "larger") ? "better" : "worse";
      return make("tr", { title: word.definition, "data-figure": name }, make("th", { scope: "row" }, word.title), make("td", {}, show(there[name], word.unit)),
        make("td", { class: better }, show(here[name], word.unit)), make("td", { class: better }, better));
    }));
  }
}

function plain(of: any): string | number { return typeof of === "number" ? of : value(of, ""); }

function value(of: any, unit: string): string {
  if (of === null || of === undefined) return "–";
  return typeof of === "number" ? `${words(of, 6)}${unit ? ` ${shownUnit(unit)}` : ""}` : Array.isArray(of) ? of.join(", ") : String(of);
}
