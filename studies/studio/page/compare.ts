// The Compare panel: this design and the pinned one, the fields that differ and the figures of both.
import { byId, make, shownUnit, words } from "./dom";

export interface Comparison { pinned: string | null; differences?: { name: string; unit: string; here: any; there: any }[]; }

export interface Row { name: string; title: string; unit: string; definition: string; here: any; there: any; texts: string[]; better: string; }

export class ComparePanel {
  private compared: Row[] = [];
  private differences: NonNullable<Comparison["differences"]> = [];

  take(found: Comparison): void {
    const on = found.pinned !== null;
    byId("compare-empty").hidden = on;
    byId("compare-tables").hidden = !on;
    if (!on) { this.compared = []; byId("compared-figures").replaceChildren(); return; }
    byId("pinned-name").textContent = found.pinned!;
    this.differences = found.differences ?? [];
    const rows = this.differences.map((each) => make("tr", {},
      make("th", { scope: "row" }, each.name), make("td", {}, value(each.there, each.unit)), make("td", {}, value(each.here, each.unit))));
    byId("differences").replaceChildren(...(rows.length ? rows : [make("tr", {}, make("td", { colspan: "3" }, "no field differs"))]));
  }

  /** A figure of the pinned design; undefined where it is not known. */
  pinned(name: string): number | undefined { return this.compared.find((each) => each.name === name)?.there ?? undefined; }

  /** The fields that differ and the figures of both as a table, its first row as head. */
  rows(): (string | number)[][] {
    return [["field or figure", "unit", "pinned", "now"],
      ...[...this.differences, ...this.compared].map((each) => [each.name, each.unit, plain(each.there), plain(each.here)])];
  }

  /** The figures of both, with the better one marked, as the studio has compared them. */
  figures(rows: Row[]): void {
    this.compared = rows;
    byId("compared-figures").replaceChildren(...rows.map((row) =>
      make("tr", { title: row.definition, "data-figure": row.name }, make("th", { scope: "row" }, row.title), make("td", {}, row.texts[0] || "–"),
        make("td", { class: row.better }, row.texts[1] || "–"), make("td", { class: row.better }, row.better))));
  }
}

function plain(of: any): string | number { return typeof of === "number" ? of : value(of, ""); }

function value(of: any, unit: string): string {
  if (of === null || of === undefined) return "–";
  return typeof of === "number" ? `${words(of, 6)}${unit ? ` ${shownUnit(unit)}` : ""}` : Array.isArray(of) ? of.join(", ") : String(of);
}
