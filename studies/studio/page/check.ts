// The Print panel: what the check of a design finds; a click on a finding lights its part and the place.
import { button, byId, make, shownUnit, words } from "./dom";

interface Finding { part: string; rule: string; value: number; limit: number; unit: string; verdict: "ok" | "warn" | "fail"; reason: string; place: number[] | null; relation: string; }
interface Validity { assumption: string; value: number; relation: string; limit: number; unit: string; meaning: string; holds: boolean; }
export interface Check {
  verdict: string; overlaps: string[]; mend: string; misfits: string[]; validity: Validity[];
  printing: { verdict: string; process: { title: string; source: string }; findings: Finding[] };
}
const SIGNS = { ok: "✓", warn: "!", fail: "✗" };

export class CheckPanel {
  private now: Check | null = null;
  constructor(private light: (part: string, place: number[] | null) => void) {}

  take(found: Check): void {
    this.now = found;
    const findings = found.printing.findings;
    const count = (verdict: string) => findings.filter((each) => each.verdict === verdict).length;
    byId("print-verdict").textContent =
      `${found.verdict[0].toUpperCase()}${found.verdict.slice(1)}. ${found.printing.process.title}: ${count("fail")} failed, ${count("warn")} to look at, ${count("ok")} in order.`;
    const lines = [...found.overlaps, ...found.misfits, ...(found.mend ? [found.mend] : [])];
    byId("troubles").replaceChildren(...lines.map((line) => make("li", {}, line)));
    const bad = findings.filter((each) => each.verdict !== "ok").sort((a, b) => Number(a.verdict === "warn") - Number(b.verdict === "warn"));
    byId("findings").replaceChildren(...bad.map((each) => this.row(each)));
    byId("in-order").replaceChildren(...findings.filter((each) => each.verdict === "ok").map((each) => this.row(each)));
    byId("validity").replaceChildren(...found.validity.map((each) => make("li", { class: each.holds ? "ok" : "fail" },
      make("span", { class: "sign" }, each.holds ? SIGNS.ok : SIGNS.fail),
      make("span", {}, `${each.assumption}: ${words(each.value)} ${shownUnit(each.unit)}, ${each.relation} ${words(each.limit)} ${shownUnit(each.unit)}; ${each.meaning}`))));
  }

  /** All findings and assumptions as a table, its first row as head. */
  rows(): (string | number)[][] {
    const head = ["part", "rule", "value", "relation", "limit", "unit", "verdict"], now = this.now;
    if (!now) return [head];
    return [head, ...now.printing.findings.map((each) => [each.part, each.rule, each.value, each.relation, each.limit, each.unit, each.verdict]),
      ...now.validity.map((each) => ["model", each.assumption, each.value, each.relation, each.limit, each.unit, each.holds ? "ok" : "fail"])];
  }

  private row(each: Finding): HTMLElement {
    const text = `${each.part}: ${each.rule} ${words(each.value, 3)} ${shownUnit(each.unit)}, ${each.relation} ${words(each.limit, 3)} ${shownUnit(each.unit)}`;
    const act = button(text, () => this.light(each.part, each.place), { class: "finding", title: each.reason });
    return make("li", { class: each.verdict }, make("span", { class: "sign", title: each.verdict }, SIGNS[each.verdict]), act);
  }
}
