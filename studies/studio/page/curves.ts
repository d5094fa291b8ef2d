// The Curves panel: one plot a microphone, or a pair of them; all its curves are one path a colour on its canvas.
import uPlot from "uplot";
import { endLabels } from "./endlabels";
import { byId, colour, csv, hand, make, words } from "./dom";

export interface Curves {
  stage: string; revision: number; quantity: string; unit: string; points: number[]; heard_by: string[];
  frequency: number[]; values: Float32Array; validity: string;
}

export function unpack(message: ArrayBuffer): Curves {
  const length = new DataView(message).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(message, 4, length)));
  return { ...header, values: new Float32Array(message, 4 + length) };
}

function named(title: string, heardBy: string): string { return `${title} ${heardBy.includes("/") ? "of" : "at"} ${heardBy}`; }

const NEAR = 24, LEAST_HEIGHT = 150, TITLE = 20, LABELS = 22;

export class CurvesPanel {
  private now: Curves | null = null;
  private pinned: Curves | null = null;
  private plots: uPlot[] = [];
  private sheets: HTMLCanvasElement[] = [];
  private lit: number | null = null;
  private pointed: number | null = null;
  private other: number | null = null;
  private low = 0;
  private high = 1;
  private key = "";
  constructor(
    private place: HTMLElement, private titles: () => Record<string, string>, private colourOf: (point: number) => string,
    private choose: (point: number | null, second: boolean) => void, private hover: (point: number | null) => void,
  ) {
    byId("axis").addEventListener("change", () => this.restyle());
    new ResizeObserver(() => this.fit()).observe(place);
  }

  get revision(): number { return this.now?.revision ?? -1; }

  take(curves: Curves): void {
    if (curves.stage === "pinned") this.pinned = curves;
    else this.now = curves;
    if (this.now) this.draw();
  }

  /** What is shown is of no design that the studio knows. */
  outdate(): void { if (this.now) this.now.revision = -1; this.pinned = null; }

  unpin(): void { this.pinned = null; if (this.now) this.draw(); }
  /** Light a point, and another one that it is compared with. */
  light(point: number | null, other: number | null = null): void {
    [this.lit, this.other] = [point, other];
    this.repaint();
  }
  point(point: number | null): void {
    if (point === this.pointed) return;
    this.pointed = point;
    this.repaint();
  }
  repaint(): void { for (const plot of this.plots) plot.redraw(false); }

  restyle(): void { this.key = ""; if (this.now) this.draw(); }

  private draw(): void {
    const now = this.now!;
    byId("validity-chip").hidden = false;
    byId("validity-words").textContent = now.validity;
    this.range();
    const key = [now.quantity, now.unit, ...now.heard_by].join("|");
    if (key !== this.key) this.build(key);
    for (const plot of this.plots) plot.setData([now.frequency, now.frequency.map(() => null)], true);
    document.documentElement.dataset.painted = String(now.revision);
  }

  private range(): void {
    let low = Infinity, high = -Infinity;
    for (const curves of [this.now, this.comparable()]) {
      for (const value of curves?.values ?? []) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    const room = Math.max((high - low) * 0.05, 0.1);
    [this.low, this.high] = [low - room, high + room];
  }

  /** The pinned curves, where they are of the same quantity. */
  private comparable(): Curves | null {
    return this.pinned && this.pinned.quantity === this.now?.quantity ? this.pinned : null;
  }

  private build(key: string): void {
    this.key = key;
    for (const plot of this.plots) plot.destroy();
    this.place.replaceChildren();
    const now = this.now!;
    const title = this.titles()[now.quantity] ?? now.quantity;
    this.plots = now.heard_by.map((name, m) => {
      const holder = make("figure", { class: "plot" }, make("figcaption", {}, named(title, name)));
      this.place.append(holder);
      const axis = { stroke: colour("--ink-soft"), grid: { stroke: colour("--grid"), width: 1 }, ticks: { stroke: colour("--grid") }, font: "12px system-ui", labelFont: "12px system-ui", labelSize: 20 };
      const plot = new uPlot({
        width: this.width(), height: this.height(), padding: [null, LABELS, null, null],
        legend: { show: false }, cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
        scales: { x: { time: false, distr: byId<HTMLSelectElement>("axis").value === "linear" ? 1 : 3 }, y: { range: () => [this.low, this.high] } },
        axes: [
          { ...axis, label: "frequency (Hz)", size: 34, filter: (_, ticks) => ticks, values: (_, ticks) => ticks.map((t) => (byId<HTMLSelectElement>("axis").value === "linear" || /^[125]/.test(String(t)) ? String(t) : "")) },
          { ...axis, label: `${title.split(",")[0]} (${now.unit})`, size: 54 },
        ],
        series: [{}, { paths: () => null, points: { show: false } }],
        hooks: {
          draw: [(u: uPlot) => this.paint(u, m)],
          setCursor: [(u: uPlot) => this.read(u, m)],
        },
      }, [now.frequency, now.frequency.map(() => null)], holder);
      plot.over.addEventListener("click", (event) => this.choose(this.near(plot, m)?.point ?? null, event.shiftKey));
      plot.over.addEventListener("mouseleave", () => { byId("pointed-curve").textContent = "\u00a0"; this.hover(null); });
      plot.ctx.canvas.setAttribute("role", "img");
      plot.ctx.canvas.setAttribute("aria-label", `${named(title, name)} over frequency, a curve for each of ${now.points.length} points; CSV has the values`);
      return plot;
    });
  }

  private across(): number {
    const inside = this.place.clientWidth, count = this.now?.heard_by.length ?? 1;
    return count === 1 ? 1 : inside > 1100 && count > 2 ? 3 : inside > 560 ? 2 : 1;
  }

  private width(): number {
    const inside = this.place.clientWidth, across = this.across();
    return Math.max(Math.floor((inside - 12 * (across - 1)) / across), 220);
  }

  /** Height of a plot: all rows of them fill the place, where that is high enough. */
  private height(): number {
    const rows = Math.ceil((this.now?.heard_by.length ?? 1) / this.across());
    return Math.max(Math.floor(this.place.clientHeight / Math.min(rows, 2)) - TITLE - 4, LEAST_HEIGHT);
  }

  private fit(): void {
    const width = this.width();
    const height = this.height();
    for (const plot of this.plots) if (plot.width !== width || plot.height !== height) plot.setSize({ width, height });
  }

  private paint(u: uPlot, m: number): void {
    const { left, top, width, height } = u.bbox, sheet = this.sheets[m] ??= make("canvas");
    sheet.width = width;
    sheet.height = height;
    // Drawn by the processor and handed on whole: a renderer in software takes ten times as long for the paths.
    const c = sheet.getContext("2d", { willReadFrequently: true })!;
    c.translate(-left, -top);
    c.lineJoin = "round";
    for (const curves of [this.comparable(), this.now]) {
      if (!curves || m >= curves.heard_by.length) continue;
      c.setLineDash(curves === this.now ? [] : [5 * devicePixelRatio, 4 * devicePixelRatio]);
      const x = curves.frequency.map((f) => u.valToPos(f, "x", true));
      const zero = u.valToPos(0, "y", true), one = u.valToPos(1, "y", true) - zero;
      const stroke = (p: number) => {
        const start = (p * curves.heard_by.length + m) * x.length;
        c.beginPath();
        for (let k = 0; k < x.length; k++) c.lineTo(x[k], zero + one * curves.values[start + k]);
        c.stroke();
      };
      curves.points.forEach((number, p) => {
        if (number === this.lit || number === this.pointed || number === this.other) return;
        c.globalAlpha = this.lit === null ? (curves === this.now ? 1 : 0.6) : 0.22;
        c.lineWidth = 1.4 * devicePixelRatio;
        c.strokeStyle = this.colourOf(number);
        stroke(p);
      });
      for (const [number, ink] of [[this.other, "--ink"], [this.pointed, ""], [this.lit, "--accent"]] as const) {
        const at = number === null ? -1 : curves.points.indexOf(number);
        if (at < 0) continue;
        c.globalAlpha = 1;
        c.lineWidth = 3 * devicePixelRatio;
        c.strokeStyle = ink ? colour(ink) : this.colourOf(number!);
        stroke(at);
      }
    }
    u.ctx.drawImage(sheet, left, top);
    const now = this.now!, count = now.frequency.length;
    endLabels(u, now.points, (p) => now.values[(p * now.heard_by.length + m) * count + count - 1], [this.lit, this.pointed, this.other]);
  }

  private near(u: uPlot, m: number): { point: number; at: number; value: number } | null {
    const now = this.now, { left, top } = u.cursor;
    if (!now || left === undefined || top === undefined || left < 0) return null;
    const frequency = u.posToVal(left, "x");
    let at = 0;
    for (let k = 0; k < now.frequency.length; k++) if (Math.abs(Math.log(now.frequency[k] / frequency)) < Math.abs(Math.log(now.frequency[at] / frequency))) at = k;
    let best = null, least = NEAR;
    now.points.forEach((point, p) => {
      const value = now.values[(p * now.heard_by.length + m) * now.frequency.length + at];
      const away = Math.abs(u.valToPos(value, "y") - top);
      if (away < least) { least = away; best = { point, at, value }; }
    });
    return best;
  }

  /** Say what is under the pointer; of two points that are compared, also how far they are apart there. */
  private read(u: uPlot, m: number): void {
    const found = this.near(u, m), now = this.now;
    if (!found || !now) return;
    this.hover(found.point);
    const at = (point: number) => now.values[(now.points.indexOf(point) * now.heard_by.length + m) * now.frequency.length + found.at];
    const apart = this.lit && this.other ? `; point ${this.lit} less point ${this.other}: ${words(at(this.lit) - at(this.other))} ${now.unit}` : "";
    byId("pointed-curve").textContent =
      `point ${found.point} at ${now.heard_by[m]}: ${words(found.value)} ${now.unit} at ${words(now.frequency[found.at], 3)} Hz${apart}`;
  }

  table(name: string): void {
    const now = this.now;
    if (!now) return;
    const rows: (string | number)[][] = [["frequency (Hz)", ...now.points.flatMap((p) => now.heard_by.map((h) => `point ${p} at ${h} (${now.unit})`))]];
    now.frequency.forEach((f, k) => {
      rows.push([f, ...Array.from({ length: now.points.length * now.heard_by.length }, (_, c) => Number(now.values[c * now.frequency.length + k].toPrecision(7)))]);
    });
    csv(rows, `${name}-${now.quantity}.csv`);
  }

  picture(name: string): void {
    const now = this.now;
    if (!now || !this.plots.length) return;
    const title = this.titles()[now.quantity], scale = devicePixelRatio, head = 24 * scale;
    const canvases = this.plots.map((plot) => plot.ctx.canvas);
    const whole = make("canvas", { width: String(Math.max(...canvases.map((c) => c.width))), height: String(canvases.reduce((sum, c) => sum + c.height + head, 0)) });
    const c = whole.getContext("2d")!;
    c.fillStyle = colour("--card");
    c.fillRect(0, 0, whole.width, whole.height);
    let top = 0;
    canvases.forEach((each, m) => {
      c.fillStyle = colour("--ink");
      c.font = `${14 * scale}px system-ui`;
      c.fillText(`${name}: ${named(title, now.heard_by[m])}`, 12 * scale, top + 17 * scale);
      c.drawImage(each, 0, top + head);
      top += each.height + head;
    });
    whole.toBlob((blob) => blob && hand(blob, `${name}-${now.quantity}.png`));
  }
}
