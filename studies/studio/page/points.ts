// The Points panel: how well the points can be told apart, point by point, and as a whole.
import { byId, colour, csv, hand, make, shownUnit, words } from "./dom";

export interface Figures {
  figures: Record<string, number>;
  points: { number: number; nearest: number; distance: number; level: number; phase: number; named: number; force: number; loudest: number; coverage: number }[];
  confusion: number[][]; touches: number; hardest: number[][]; overlaps: string[]; mend: string; finger: number; fidelity: string;
}
export interface Word { title: string; unit: string; definition: string; better: string; }

/** Room for the numbers beside the matrix, pixels. */
const ROOM = 22;
const COLUMNS: [string, string, (p: Figures["points"][0]) => string][] = [
  ["point", "", (p) => String(p.number)],
  ["top-1 accuracy", "%", (p) => words(100 * p.named, 3)],
  ["hardest to tell from", "", (p) => String(p.nearest)],
  ["distance", "", (p) => words(p.distance, 3)],
  ["level", "dB", (p) => words(p.level, 3)],
  ["phase", "°", (p) => words(p.phase, 3)],
  ["smallest detectable force", "nN", (p) => words(1e9 * p.force, 3)],
];

export class PointsPanel {
  private now: Figures | null = null;
  private lit: number | null = null;
  private pointed: number | null = null;
  private cell = 1;
  constructor(
    private word: () => Record<string, Word>, private colourOf: (point: number) => string,
    private choose: (point: number | null, second: boolean) => void, private hover: (point: number | null) => void,
  ) {
    const canvas = byId<HTMLCanvasElement>("confusion");
    canvas.addEventListener("pointermove", (event) => this.read(event));
    canvas.addEventListener("pointerleave", () => { byId("pointed-cell").textContent = "\u00a0"; this.hover(null); });
    canvas.addEventListener("click", (event) => { const at = this.under(event); if (at) this.choose(this.now!.points[at[0]].number, event.shiftKey); });
  }

  /** The figures of the whole design by name; empty where they are not known yet. */
  get figures(): Record<string, number> { return this.now?.figures ?? {}; }

  take(found: Figures): void { this.now = found; this.draw(); }

  light(point: number | null): void {
    this.lit = point;
    for (const row of byId("points-table").querySelectorAll("tr[data-point]")) {
      row.classList.toggle("lit", (row as HTMLElement).dataset.point === String(point));
    }
    this.matrix();
  }

  /** The point that is pointed at anywhere. */
  point(point: number | null): void {
    if (point === this.pointed) return;
    this.pointed = point;
    for (const row of byId("points-table").querySelectorAll<HTMLElement>("tr[data-point]")) row.classList.toggle("pointed", row.dataset.point === String(point));
    if (byId("confusion").clientWidth) this.matrix();
  }

  /** The colours of the points have changed. */
  recolour(): void {
    for (const row of byId("points-table").querySelectorAll<HTMLElement>("tr[data-point]")) {
      row.querySelector<HTMLElement>(".swatch")!.style.background = this.colourOf(Number(row.dataset.point));
    }
  }

  /** Row and column of the cell under the pointer. */
  private under(event: MouseEvent): [number, number] | null {
    const frame = byId("confusion").getBoundingClientRect(), count = this.now?.points.length ?? 0;
    const [j, i] = [event.clientX - frame.left, event.clientY - frame.top].map((each) => Math.floor((each - ROOM) / this.cell));
    return i >= 0 && j >= 0 && i < count && j < count ? [i, j] : null;
  }

  private read(event: MouseEvent): void {
    const at = this.under(event), now = this.now;
    if (!at || !now) return this.hover(null);
    const [from, to] = at.map((k) => now.points[k].number);
    byId("pointed-cell").textContent = `point ${from} located as ${to}: ${now.confusion[at[0]][at[1]]} of ${now.touches} touches`;
    this.hover(from);
  }

  asBuilt(found: { sensors: number; mean: number; worst: number; interval: number[]; multi_sines: number }): void {
    byId("as-built").textContent =
      `Taps and presses on ${found.sensors} as-built sensors, not calibrated: top-1 accuracy ${words(100 * found.mean, 3)} % ` +
      `(${words(100 * found.interval[0]!, 2)} to ${words(100 * found.interval[1]!, 2)} %), 5th percentile ${words(100 * found.worst, 3)} %. ` +
      `Multi-sine touches: ${words(100 * found.multi_sines, 3)} %.`;
  }

  private draw(): void {
    const now = this.now!;
    byId("figures").replaceChildren(...Object.entries(now.figures).map(([name, value]) => {
      const word = this.word()[name];
      return make("div", { title: word.definition, "data-figure": name }, make("dt", {}, word.title), make("dd", {}, show(value, word.unit)));
    }));
    byId("points-fidelity").textContent = `Fidelity ${now.fidelity}.`;
    byId("hardest").textContent = `Hardest to tell apart: ${now.hardest.map((pair) => pair.join(" and ")).join("; ")}.`;
    const trouble = now.overlaps.length ? `Cannot be built: ${now.overlaps.join("; ")}${now.mend ? `; ${now.mend}` : ""}` : "";
    byId("overlaps").textContent = trouble;
    const head = make("tr", {}, ...COLUMNS.map(([title, unit]) => make("th", { scope: "col" }, unit ? `${title} (${unit})` : title)));
    const rows = now.points.map((point) => {
      const row = make("tr", { "data-point": String(point.number), tabindex: "0" }, ...COLUMNS.map(([, , text]) => make("td", {}, text(point))));
      const swatch = make("span", { class: "swatch" });
      swatch.style.background = this.colourOf(point.number);
      row.firstElementChild!.prepend(swatch);
      const act = (second = false) => this.choose(this.lit === point.number ? null : point.number, second);
      row.addEventListener("click", (event) => act(event.shiftKey));
      row.addEventListener("pointerenter", () => this.hover(point.number));
      row.addEventListener("pointerleave", () => this.hover(null));
      row.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); act(); } });
      return row;
    });
    byId("points-table").replaceChildren(make("thead", {}, head), make("tbody", {}, ...rows));
    this.light(this.lit);
  }

  private matrix(): void {
    const now = this.now, canvas = byId<HTMLCanvasElement>("confusion");
    if (!now) return;
    const count = now.confusion.length, cell = this.cell = Math.max(Math.floor(340 / count), 3), room = ROOM;
    const scale = devicePixelRatio;
    canvas.width = canvas.height = (count * cell + room) * scale;
    canvas.style.width = canvas.style.height = `${count * cell + room}px`;
    const c = canvas.getContext("2d")!;
    c.scale(scale, scale);
    c.font = "10px system-ui";
    c.textAlign = "center";
    c.textBaseline = "middle";
    const every = Math.ceil(count / 14);
    for (let i = 0; i < count; i++) {
      c.fillStyle = colour("--ink-soft");
      if (i % every === 0) {
        c.fillText(String(now.points[i].number), room + (i + 0.5) * cell, room / 2);
        c.fillText(String(now.points[i].number), room / 2, room + (i + 0.5) * cell);
      }
      for (let j = 0; j < count; j++) {
        const share = now.confusion[i][j] / now.touches;
        // The few percent beside the diagonal are what is looked for: the root makes them visible.
        c.globalAlpha = share === 0 ? 0.07 : 0.25 + 0.75 * Math.sqrt(share);
        c.fillStyle = share === 0 ? colour("--ink-soft") : i === j ? colour("--good") : colour("--bad");
        c.fillRect(room + j * cell, room + i * cell, cell - 1, cell - 1);
        c.globalAlpha = 1;
        if (cell >= 24 && share > 0) {
          c.fillStyle = colour(i === j && share > 0.5 ? "--card" : "--ink");
          c.fillText(words(100 * share, 2), room + (j + 0.5) * cell, room + (i + 0.5) * cell);
        }
      }
    }
    for (const [number, ink] of [[this.pointed, "--ink"], [this.lit, "--accent"]] as const) {
      const index = now.points.findIndex((point) => point.number === number);
      if (index < 0) continue;
      c.strokeStyle = colour(ink);
      c.lineWidth = 2;
      c.strokeRect(room, room + index * cell, count * cell - 1, cell - 1);
    }
    const wrong = now.points.filter((point) => point.named < 1).length;
    canvas.setAttribute("aria-label", `predicted confusion of ${count} points; ${wrong} of them are not always assigned to the correct point; the table beside has the figures`);
  }

  restyle(): void { this.matrix(); this.recolour(); }

  table(name: string): void {
    if (!this.now) return;
    const keys = ["number", "named", "nearest", "distance", "level", "phase", "force", "loudest", "coverage"] as const;
    csv([["point", "top-1 accuracy", "hardest to tell from", "distance", "level (dB)", "phase (degrees)", "smallest detectable force (N)", "level at 100 Hz, loudest microphone (dB)", "coverage of its area",
      ...this.now.points.map((point) => `assigned to ${point.number}, of ${this.now!.touches} touches`)],
      ...this.now.points.map((point, k) => [...keys.map((key) => point[key]), ...this.now!.confusion[k]])], `${name}-points.csv`);
  }

  picture(name: string): void { byId<HTMLCanvasElement>("confusion").toBlob((blob) => blob && hand(blob, `${name}-confusion.png`)); }
}

export function show(value: number, unit: string): string {
  const small = unit === "N" && value !== 0 && Math.abs(value) < 1e-3; // forces are as small as nothing else
  if (small) return Math.abs(value) < 1e-6 ? `${words(1e9 * value)} nN` : `${words(1e6 * value)} µN`;
  return `${words(value)}${unit && unit !== "1" ? ` ${shownUnit(unit)}` : ""}`;
}
