// Parallel coordinates: a line for each snapshot and for the design at hand, over figures that are chosen.
import { sized } from "./chart";
import { byId, colour, make } from "./dom";
import { show, type Word } from "./points";

export interface Line { name: string; figures: Record<string, number>; }
/** Figures that are shown at first. */
const USUAL = ["predicted_top1", "noise_equivalent_force", "coverage", "length", "cost"];
const TALL = 220, SIDE = 70, TOP = 42, FOOT = 20, NEAR = 9;

export class Parallel {
  private lines: Line[] = [];
  private now: Record<string, number> = {};
  private word: Record<string, Word> = {};
  private chosen = new Set(USUAL);
  private pointed: Line | null = null;
  private places: { line: Line; at: [number, number][] }[] = [];
  constructor(private open: (line: Line) => void) {
    const canvas = byId<HTMLCanvasElement>("parallel");
    canvas.addEventListener("pointermove", (event) => { this.point(this.under(event)); });
    canvas.addEventListener("pointerleave", () => this.point(null));
    canvas.addEventListener("click", (event) => { const line = this.under(event); if (line) this.open(line); });
    new ResizeObserver(() => this.draw()).observe(byId("parallel-shown").parentElement!);
  }

  /** Titles, units and better directions of all figures. */
  learn(word: Record<string, Word>): void {
    this.word = word;
    byId("parallel-axes").replaceChildren(...Object.entries(word).map(([name, { title, definition }]) => {
      const box = make("input", { type: "checkbox", "data-axis": name });
      box.checked = this.chosen.has(name);
      box.addEventListener("change", () => { if (box.checked) this.chosen.add(name); else this.chosen.delete(name); this.draw(); });
      return make("label", { title: definition }, box, ` ${title}`);
    }));
  }

  /** The snapshots whose figures are known; those of the design at hand, empty where they are not. */
  take(lines: Line[], now: Record<string, number> | null): void {
    this.lines = lines;
    if (now) this.now = now;
    this.draw();
  }

  draw(): void {
    const axes = Object.keys(this.word).filter((name) => this.chosen.has(name));
    const own = { name: "the design at hand", figures: this.now };
    const all = [...this.lines, own].filter((line) => axes.some((name) => Number.isFinite(line.figures[name])));
    byId("parallel-shown").hidden = this.lines.length === 0;
    const canvas = byId<HTMLCanvasElement>("parallel"), width = byId("parallel-shown").clientWidth;
    this.places = [];
    if (!width) return;
    sized(canvas, width, TALL);
    if (!axes.length) return;
    const c = canvas.getContext("2d")!;
    c.scale(devicePixelRatio, devicePixelRatio);
    c.font = "11px system-ui";
    c.textAlign = "center";
    const x = (k: number) => (axes.length === 1 ? width / 2 : SIDE + (k * (width - 2 * SIDE)) / (axes.length - 1));
    const room = axes.length === 1 ? width - 20 : Math.min((width - 2 * SIDE) / (axes.length - 1), 2 * SIDE) - 8;
    const heights = axes.map((name, k) => this.axis(c, all, name, x(k), room));
    for (const line of all) {
      const at = axes.map((name, k): [number, number] | null => (Number.isFinite(line.figures[name]) ? [x(k), heights[k](line.figures[name])] : null));
      const isNow = line === own;
      c.strokeStyle = c.fillStyle = colour(isNow ? "--accent" : "--ink-soft");
      c.lineWidth = line === this.pointed ? 4 : 2;
      c.beginPath();
      let joined = false;
      for (const place of at) { if (place && joined) c.lineTo(...place); else if (place) c.moveTo(...place); joined = place !== null; }
      c.stroke();
      for (const place of at) if (place) { c.beginPath(); c.arc(place[0], place[1], 3.5, 0, 7); c.fill(); }
      if (!isNow) this.places.push({ line, at: at.filter((place) => place !== null) });
    }
    canvas.setAttribute("aria-label", `${this.lines.length} snapshots over ${axes.map((name) => this.word[name].title).join(", ")}; the list above opens them`);
  }

  /** One axis with its title and its ends, the better one on top; where a value lies on it. */
  private axis(c: CanvasRenderingContext2D, all: Line[], name: string, x: number, room: number): (value: number) => number {
    const { title, unit, better } = this.word[name];
    const values = all.map((line) => line.figures[name]).filter(Number.isFinite);
    let low = Math.min(...values), high = Math.max(...values);
    if (low === high) [low, high] = [low - Math.abs(low || 1) / 2, high + Math.abs(high || 1) / 2];
    const [foot, top] = better === "smaller" ? [high, low] : [low, high];
    c.strokeStyle = colour("--edge");
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(x, TOP);
    c.lineTo(x, TALL - FOOT);
    c.stroke();
    c.fillStyle = colour("--ink");
    wrapped(title, room, c).slice(0, 2).forEach((text, k) => c.fillText(text, x, 11 + 12 * k, room));
    c.fillStyle = colour("--ink-soft");
    if (new Set(values).size === 1) c.fillText(show(Number(values[0].toPrecision(3)), unit), x, TOP - 6, room);
    else if (values.length) { c.fillText(show(Number(top.toPrecision(3)), unit), x, TOP - 6, room); c.fillText(show(Number(foot.toPrecision(3)), unit), x, TALL - 6, room); }
    return (value) => TALL - FOOT - ((value - foot) / (top - foot)) * (TALL - FOOT - TOP);
  }

  private point(line: Line | null): void {
    if (line === this.pointed) return;
    this.pointed = line;
    const said = line && [...this.chosen].filter((name) => Number.isFinite(line.figures[name])).map((name) => `${this.word[name].title} ${show(line.figures[name], this.word[name].unit)}`);
    byId("parallel-pointed").textContent = said ? `${line!.name}: ${said.join(", ")}` : "\u00a0";
    this.draw();
  }

  /** The line next to the pointer, between its axes as well. */
  private under(event: MouseEvent): Line | null {
    const frame = byId("parallel").getBoundingClientRect(), px = event.clientX - frame.left, py = event.clientY - frame.top;
    let best: Line | null = null, least = NEAR;
    for (const { line, at } of this.places) {
      for (let k = 0; k < at.length; k++) {
        const [x0, y0] = at[k], [x1, y1] = at[Math.min(k + 1, at.length - 1)], square = (x1 - x0) ** 2 + (y1 - y0) ** 2;
        const t = square ? Math.min(Math.max(((px - x0) * (x1 - x0) + (py - y0) * (y1 - y0)) / square, 0), 1) : 0;
        const away = Math.hypot(px - x0 - t * (x1 - x0), py - y0 - t * (y1 - y0));
        if (away < least) { least = away; best = line; }
      }
    }
    return best;
  }
}

/** A text in lines that fit into a width. */
function wrapped(text: string, room: number, c: CanvasRenderingContext2D): string[] {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const last = lines.at(-1);
    if (last !== undefined && c.measureText(`${last} ${word}`).width <= room) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines.length > 2 ? [lines[0], lines.slice(1).join(" ")] : lines;
}
