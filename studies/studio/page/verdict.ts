// The bar on top: whether the design works, the worst reasons, and a button for each remedy.
import { button, make, shownText } from "./dom";

type Remedy = { line: string; words: string; changes: Record<string, unknown> };
type Reason = { rule: string; outcome: string; words: string; remedy: Remedy | null };
type Found = { outcome: string; reasons: Reason[]; rows: [string, string, string][]; clipped: string[] };

const SHOWN = 3;

export class VerdictBar {
  outcome = "";
  rows: [string, string][] = [];
  constructor(private place: HTMLElement, private apply: (changes: Record<string, unknown>) => void) {}

  take(found: Found): void {
    this.outcome = found.outcome;
    this.rows = found.rows.map(([name, value]) => [name, shownText(value)]);
    this.place.dataset.outcome = found.outcome.replaceAll(" ", "-");
    const reasons = found.reasons.slice(0, SHOWN).map(({ words, remedy }) => {
      const line = make("li", {}, `${shownText(words)}. `);
      if (remedy) line.append(button("Fix", () => this.apply(remedy.changes), { title: remedy.line }), make("span", { class: "note" }, ` ${remedy.line}`));
      return line;
    });
    const more = found.reasons.slice(SHOWN).map((reason) => reason.rule);
    if (more.length) reasons.push(make("li", {}, `also: ${more.join(", ")}`));
    reasons.push(...found.clipped.map((line) => make("li", { class: "note" }, shownText(line))));
    this.place.replaceChildren(
      make("strong", {}, found.outcome),
      make("ul", {}, ...reasons),
      make("dl", {}, ...found.rows.flatMap(([name, value, remark]) => [make("dt", { title: remark }, name), make("dd", {}, shownText(value))])),
    );
  }
}
