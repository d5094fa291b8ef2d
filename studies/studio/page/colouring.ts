// The colour of every point: that of its number, or of a figure, alike in the array, the curves and the table.
import { byId, make, ramp, words } from "./dom";
import type { Figures } from "./points";

type Point = Figures["points"][0];
interface Choice { title: string; unit: string; value: (point: Point, built: number[] | null) => number | null; low?: number; high?: number; }

/** Figures of a point that the card lists and that colour it, by name. */
export const CHOICES: Record<string, Choice> = {
  number: { title: "point", unit: "", value: (point) => point.number },
  as_built: { title: "as-built accuracy", unit: "%", value: (point, built) => (built ? 100 * built[point.number - 1] : null), low: 90, high: 100 },
  named: { title: "accuracy as designed", unit: "%", value: (point) => 100 * point.named, low: 90, high: 100 },
  loudest: { title: "level at 100 Hz, loudest microphone", unit: "dB", value: (point) => point.loudest },
  force: { title: "smallest detectable force", unit: "nN", value: (point) => 1e9 * point.force },
  coverage: { title: "coverage of its area", unit: "%", value: (point) => 100 * point.coverage, high: 100 },
};

export class Colouring {
  private points: Point[] = [];
  private built: number[] | null = null;
  private count = 0;
  private chosen = "number";
  private low = 1;
  private high = 1;
  constructor(private changed: () => void) {
    const choice = byId<HTMLSelectElement>("colour-by");
    choice.replaceChildren(...Object.entries(CHOICES).map(([name, { title }]) => make("option", { value: name }, title)));
    choice.addEventListener("change", () => { this.chosen = choice.value; this.measure(); this.changed(); });
  }

  /** Whether the colours wait for the figures of as-built sensors. */
  get wantsBuilt(): boolean { return this.chosen === "as_built"; }

  /** Whether the colours are those of a figure, not of the numbers. */
  get isByFigure(): boolean { return this.chosen !== "number"; }

  take(found: Figures): void { this.points = found.points; this.count = found.points.length; this.measure(); }

  asBuilt(found: { per_point: number[] }): void { this.built = found.per_point; this.measure(); }

  /** How many points there are, which is known before their figures. */
  size(count: number): void {
    if (count === this.count) return;
    this.count = count;
    this.points = [];
    this.built = null;
    this.measure();
  }

  /** The figures of a point with their titles, as the card shows them; those that are known. */
  figures(number: number): [string, string][] {
    const point = this.points.find((each) => each.number === number);
    if (!point) return [];
    const found = Object.entries(CHOICES).filter(([name]) => name !== "number").map(([, each]): [string, string] => {
      const value = each.value(point, this.built);
      return [each.title, value === null ? "" : `${words(value, 3)} ${each.unit}`];
    });
    return [...found, ["hardest to tell from", `point ${point.nearest}`] as [string, string]].filter(([, text]) => text);
  }

  /** Colour of a point, "rgb(…)". */
  of(number: number): string {
    const choice = CHOICES[this.chosen], point = this.points.find((each) => each.number === number);
    // The pinned design may have more points than this one.
    const value = this.chosen === "number" ? (number <= this.count ? number : null) : point ? choice.value(point, this.built) : null;
    return value === null ? "rgb(128,128,128)" : ramp((value - this.low) / (this.high - this.low || 1));
  }

  private measure(): void {
    const { value, low, high } = CHOICES[this.chosen];
    if (this.chosen === "number") [this.low, this.high] = [1, Math.max(this.count, 1)];
    else {
      const values = this.points.map((point) => value(point, this.built)).filter((each): each is number => each !== null);
      this.low = Math.min(...values, low ?? Infinity);
      this.high = Math.max(...values, high ?? -Infinity);
    }
    this.legend();
  }

  legend(): void {
    const { title, unit } = CHOICES[this.chosen], place = byId("legend");
    place.hidden = !Number.isFinite(this.low) || this.count === 0;
    const stops = Array.from({ length: 9 }, (_, k) => ramp(k / 8)).join(",");
    const bar = make("span", { class: "bar" }), text = (value: number) => `${words(value, 3)}${unit ? ` ${unit}` : ""}`;
    bar.style.background = `linear-gradient(to right, ${stops})`;
    place.replaceChildren(make("span", {}, title), make("span", { class: "ends" }, make("span", { id: "legend-low" }, text(this.low)), bar, make("span", { id: "legend-high" }, text(this.high))));
  }
}
