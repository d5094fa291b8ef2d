// Figures of a report that one can point at: curves of all points over frequency, and matrices of pairs of points.
import uPlot from "uplot";
import { endLabels } from "./endlabels";
import { sheet, sized } from "./chart";
import { button, colour, csv, make, ramp, words } from "./dom";

interface Panel { title: string; label: string; values: number[][]; limit?: number; }
interface Curves { kind: "curves"; name: string; points: number[]; frequency: number[]; panels: Panel[]; }
interface Matrix { kind: "matrix"; name: string; points: (number | string)[]; values: (number | null)[][]; row: string; column: string; unit: string; framed: number[][]; }
export type FigureData = Curves | Matrix;

const NEAR = 24, HIGH = 250, LABELS = 22, ROOM = 30;

export class FigureDrawing {
  private holder = make("div", { class: "interactive" });
  private readout = make("p", { class: "readout", role: "status" }, "\u00a0");
  private plots: uPlot[] = [];
  private canvas: HTMLCanvasElement | null = null;
  private cell = 1;
  private lit: number | null = null;
  private width = 0;
  constructor(private place: HTMLElement, private data: FigureData) {
    const tools = make("div", { class: "figure-tools" }, this.readout, button("PNG", () => this.picture()), button("CSV", () => this.table()));
    for (const each of tools.querySelectorAll("button")) each.setAttribute("aria-label", `${each.textContent}, ${data.name}`);
    place.querySelector("figcaption")!.before(this.holder, tools);
    place.classList.add("drawn");
    // A section that is folded has no width: it is drawn once it is opened.
    new ResizeObserver(() => { if (place.clientWidth && place.clientWidth !== this.width) { this.width = place.clientWidth; this.restyle(); } }).observe(place);
  }

  restyle(): void {
    if (!this.width) return;
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.holder.replaceChildren();
    if (this.data.kind === "curves") this.curves(this.data);
    else this.matrix(this.data);
  }

  private curves(data: Curves): void {
    const across = this.width > 620 ? 2 : 1, width = Math.floor((this.width - 12 * (across - 1)) / across);
    for (const panel of data.panels) {
      const place = make("div", {}, make("h4", {}, panel.title)), all = panel.values.flat().concat(panel.limit === undefined ? [] : [panel.limit, -panel.limit]);
      this.holder.append(place);
      const low = Math.min(...all), high = Math.max(...all), room = Math.max(0.05 * (high - low), 1e-3);
      const axis = { stroke: colour("--ink-soft"), grid: { stroke: colour("--grid"), width: 1 }, ticks: { stroke: colour("--grid") }, font: "12px system-ui", labelFont: "12px system-ui", labelSize: 20 };
      const plot: uPlot = new uPlot({
        width, height: HIGH, padding: [8, LABELS, null, null], legend: { show: false }, cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
        scales: { x: { time: false, distr: 3 }, y: { range: () => [low - room, high + room] } },
        axes: [
          { ...axis, label: "frequency (Hz)", size: 34, filter: (_, ticks) => ticks, values: (_, ticks) => ticks.map((t) => (/^[125]/.test(String(t)) ? String(t) : "")) },
          { ...axis, label: panel.label, size: 54 },
        ],
        series: [{}, { paths: () => null, points: { show: false } }],
        hooks: { draw: [(u: uPlot) => this.paint(u, data, panel)], setCursor: [(u: uPlot) => this.read(u, data, panel)] },
      }, [data.frequency, data.frequency.map(() => null)], place);
      plot.over.addEventListener("mouseleave", () => this.light(null, "\u00a0"));
      plot.ctx.canvas.setAttribute("role", "img");
      plot.ctx.canvas.setAttribute("aria-label", `${panel.title}: ${panel.label} over frequency, a curve for each of ${data.points.length} points; CSV has the values`);
      this.plots.push(plot);
    }
  }

  private paint(u: uPlot, data: Curves, panel: Panel): void {
    const c = u.ctx, x = data.frequency.map((f) => u.valToPos(f, "x", true)), last = Math.max(data.points.length - 1, 1);
    c.save();
    c.lineJoin = "round";
    if (panel.limit !== undefined) {
      c.strokeStyle = colour("--bad");
      c.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
      for (const y of [panel.limit, -panel.limit].map((each) => u.valToPos(each, "y", true))) { c.beginPath(); c.moveTo(u.bbox.left, y); c.lineTo(u.bbox.left + u.bbox.width, y); c.stroke(); }
      c.setLineDash([]);
    }
    const order = panel.values.map((_, p) => p).sort((a, b) => Number(data.points[a] === this.lit) - Number(data.points[b] === this.lit));
    for (const p of order) {
      const lit = data.points[p] === this.lit;
      c.globalAlpha = this.lit === null || lit ? 1 : 0.3;
      c.strokeStyle = lit ? colour("--accent") : ramp(p / last);
      c.lineWidth = (lit ? 3 : 1.4) * devicePixelRatio;
      c.beginPath();
      panel.values[p].forEach((value, k) => c.lineTo(x[k], u.valToPos(value, "y", true)));
      c.stroke();
    }
    c.restore();
    endLabels(u, data.points, (p) => panel.values[p].at(-1)!, [this.lit]);
  }

  private read(u: uPlot, data: Curves, panel: Panel): void {
    const { left, top } = u.cursor;
    if (left === undefined || top === undefined || left < 0) return;
    const at = u.valToIdx(u.posToVal(left, "x"));
    const away = panel.values.map((curve) => Math.abs(u.valToPos(curve[at], "y") - top)), nearest = away.indexOf(Math.min(...away));
    if (away[nearest] > NEAR) return this.light(null, "\u00a0");
    this.light(data.points[nearest], `point ${data.points[nearest]}, ${panel.title}: ${words(panel.values[nearest][at])} at ${words(data.frequency[at], 3)} Hz`);
  }

  private light(point: number | null, text: string): void {
    this.readout.textContent = text;
    if (point === this.lit) return;
    this.lit = point;
    for (const plot of this.plots) plot.redraw(false);
  }

  private matrix(data: Matrix): void {
    const canvas = this.canvas = make("canvas", { role: "img", "aria-label": `${data.name} of ${data.points.length} points; CSV has the values` });
    this.holder.append(canvas);
    const count = data.points.length, names = data.points.map(String), wide = Math.max(ROOM, 7 * Math.max(...names.map((name) => name.length)) + 12);
    const cell = this.cell = Math.max(Math.min(Math.floor((Math.min(this.width, 560) - wide) / count), 44), 2), side = wide + count * cell;
    sized(canvas, side, side);
    const c = canvas.getContext("2d")!, shown = data.values.flat().filter((value): value is number => value !== null && value > 0);
    const place = (value: number) => Math.log(value), low = place(Math.min(...shown)), high = place(Math.max(...shown));
    c.scale(devicePixelRatio, devicePixelRatio);
    c.font = "11px system-ui";
    [c.textAlign, c.textBaseline] = ["center", "middle"];
    const every = Math.ceil((count * 16) / (count * cell)) || 1;
    for (let i = 0; i < count; i++) {
      c.fillStyle = colour("--ink-soft");
      if (i % every === 0) {
        c.fillText(names[i], wide + (i + 0.5) * cell, wide / 2, cell * every);
        c.fillText(names[i], wide / 2, wide + (i + 0.5) * cell, wide);
      }
      for (let j = 0; j < count; j++) {
        const value = data.values[i][j], share = value === null || value <= 0 ? null : (place(value) - low) / (high - low || 1);
        c.fillStyle = share === null ? colour("--page") : ramp(share);
        c.fillRect(wide + j * cell, wide + i * cell, cell - (cell > 4 ? 1 : 0), cell - (cell > 4 ? 1 : 0));
        if (share === null || cell < 28) continue;
        c.fillStyle = share > 0.55 ? "#111" : "#fff";
        c.fillText(words(value!, 2), wide + (j + 0.5) * cell, wide + (i + 0.5) * cell, cell - 2);
      }
    }
    c.strokeStyle = colour("--accent");
    c.lineWidth = 2.5;
    for (const [i, j] of data.framed) for (const [row, column] of [[i, j], [j, i]]) c.strokeRect(wide + column * cell, wide + row * cell, cell - 1, cell - 1);
    canvas.onpointerleave = () => { this.readout.textContent = "\u00a0"; };
    canvas.onpointermove = (event) => {
      const frame = canvas.getBoundingClientRect(), scale = side / frame.width;
      const [j, i] = [event.clientX - frame.left, event.clientY - frame.top].map((each) => Math.floor((scale * each - wide) / this.cell));
      const value = data.values[i]?.[j];
      this.readout.textContent = value === undefined || value === null ? "\u00a0" : `${data.row} ${names[i]}, ${data.column} ${names[j]}: ${words(value, 3)}${data.unit}`;
    };
  }

  private picture(): void { sheet(this.plots.length ? this.plots.map((plot) => plot.ctx.canvas) : [this.canvas!], `${this.data.name}.png`, 2); }

  private table(): void {
    const data = this.data;
    if (data.kind === "matrix") return csv([[`${data.row} \\ ${data.column}`, ...data.points], ...data.values.map((row, k) => [data.points[k], ...row.map((value) => value ?? "")])], `${data.name}.csv`);
    const head = data.panels.flatMap((panel) => data.points.map((point) => `point ${point}, ${panel.title}, ${panel.label}`));
    csv([["frequency (Hz)", ...head], ...data.frequency.map((f, k) => [f, ...data.panels.flatMap((panel) => panel.values.map((curve) => curve[k]))])], `${data.name}.csv`);
  }
}
