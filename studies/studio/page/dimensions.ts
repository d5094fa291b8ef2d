// Dimension lines of the array in three dimensions: drawn on the picture as the eye sees them, so that they have one
// size at every zoom, with numbers to type into.
import { type PerspectiveCamera, Vector3 } from "three";
import { colour, make, words } from "./dom";

/** A size with the parallel edges along which it may be drawn; the one that the eye sees outermost is. */
export interface Span { size: string; title: string; edges: [Vector3, Vector3][]; value: number; }
/** Pixels of the page: from the array to a line, from the line to its number, half a tick, half a number. */
const AWAY = 18, TO_TEXT = 17, TICK = 4, SHORT = 40, HALF = [27, 10];
/** Pixels beside and below an array that its lines and their numbers take. */
export const OUTSIDE = [AWAY + TO_TEXT + 2 * HALF[0] - HALF[1], AWAY + TO_TEXT + HALF[1]];
interface Place { x: number; y: number; }
interface Seen extends Place { behind: boolean; }

export class Dimensions {
  private spans: Span[] = [];
  private middle = new Vector3();
  private inputs = new Map<string, HTMLInputElement>();
  constructor(private place: HTMLElement, private set: ((size: string, value: number | string) => void) | null, private redraw: () => void) {}

  /** What is measured; nothing where no lines are wanted. */
  measure(spans: Span[], middle: Vector3): void {
    [this.spans, this.middle] = [spans, middle];
    for (const [size, input] of this.inputs) input.hidden = !spans.some((each) => each.size === size);
    for (const { size, title, value } of spans) {
      const input = this.inputs.get(size) ?? this.input(size);
      input.title = this.set ? `${title}, mm: type another one` : `${title}, mm`;
      input.setAttribute("aria-label", `${title}, mm`);
      input.dataset.shown = words(value);
      if (document.activeElement !== input) input.value = input.dataset.shown;
    }
  }

  /** A number that was refused stays where it can be corrected. */
  refuse(size: string): void { this.inputs.get(size)?.setAttribute("aria-invalid", "true"); }

  private input(size: string): HTMLInputElement {
    const input = make("input", { type: "text", class: "dimension", inputmode: "decimal", autocomplete: "off", "data-size": size });
    input.readOnly = !this.set;
    const back = () => { input.removeAttribute("aria-invalid"); input.value = input.dataset.shown!; };
    input.addEventListener("change", () => {
      const plain = input.value.replace("−", "-").replace(",", ".").trim();
      input.removeAttribute("aria-invalid");
      this.set?.(size, plain === "" || !Number.isFinite(Number(plain)) ? input.value : Number(plain));
    });
    input.addEventListener("keydown", (event) => { if (event.key === "Escape") { back(); input.blur(); } });
    input.addEventListener("blur", () => { back(); this.redraw(); });
    this.inputs.set(size, input);
    this.place.append(input);
    return input;
  }

  /** Draw the lines over a picture of the array, and put their numbers beside them. */
  draw(c: CanvasRenderingContext2D, camera: PerspectiveCamera, withNumbers = false): void {
    const width = this.place.clientWidth, height = this.place.clientHeight, taken: Place[] = [];
    if (!this.spans.length || !width) return;
    const seen = (point: Vector3): Seen => {
      const { x, y, z } = point.clone().project(camera);
      return { x: (0.5 + 0.5 * x) * width, y: (0.5 - 0.5 * y) * height, behind: z > 1 };
    };
    const centre = seen(this.middle);
    c.save();
    c.setTransform(c.canvas.width / width, 0, 0, c.canvas.height / height, 0, 0);
    for (const span of this.spans) {
      const outermost = ([p, q]: Seen[], [r, s]: Seen[]) => Math.hypot(r.x + s.x - 2 * centre.x, r.y + s.y - 2 * centre.y) - Math.hypot(p.x + q.x - 2 * centre.x, p.y + q.y - 2 * centre.y);
      const [a, b] = span.edges.map((edge) => edge.map(seen)).sort(outermost)[0], input = this.inputs.get(span.size)!;
      input.style.visibility = a.behind || b.behind ? "hidden" : "";
      if (a.behind || b.behind) continue;
      const length = Math.hypot(b.x - a.x, b.y - a.y), outward = { x: (a.x + b.x) / 2 - centre.x, y: (a.y + b.y) / 2 - centre.y };
      // Across the line and away from the array; of a line that points at the eye, straight away from the array.
      const [across, far] = length > 6 ? [{ x: (a.y - b.y) / length, y: (b.x - a.x) / length }, 1] : [outward, Math.hypot(outward.x, outward.y) || 1];
      const side = across.x * outward.x + across.y * outward.y < 0 ? -1 : 1;
      const out = { x: (side * across.x) / far, y: (side * across.y) / far }, away = span.size === "pitch" ? 0 : AWAY;
      const at = (end: Place, by: number): [number, number] => [end.x + by * out.x, end.y + by * out.y];
      for (const [ink, thick] of [["--card", 3.5], ["--ink-soft", 1.2]] as const) {
        c.strokeStyle = colour(ink);
        c.lineWidth = thick;
        c.beginPath();
        c.moveTo(...at(a, away));
        c.lineTo(...at(b, away));
        const from = away && length > SHORT ? 4 : away - TICK; // lines that lead out to a short one would hide it
        for (const end of [a, b]) { c.moveTo(...at(end, from)); c.lineTo(...at(end, away + TICK)); }
        c.stroke();
      }
      const [x, y] = at({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, away + TO_TEXT + Math.abs(out.x) * (HALF[0] - HALF[1]));
      const inside = (value: number, half: number, end: number) => Math.min(Math.max(value, half + 2), end - half - 2);
      const label = { x: inside(x, HALF[0], width), y: inside(y, HALF[1], height) };
      while (taken.some((each) => Math.abs(each.x - label.x) < 2 * HALF[0] && Math.abs(each.y - label.y) < 2 * HALF[1]) && label.y > 0) label.y -= HALF[1];
      taken.push(label);
      Object.assign(input.style, { left: `${label.x - HALF[0]}px`, top: `${label.y - HALF[1]}px` });
      if (!withNumbers) continue;
      c.font = "12px system-ui";
      [c.textAlign, c.textBaseline, c.fillStyle] = ["center", "middle", colour("--card")];
      c.fillRect(label.x - HALF[0], label.y - HALF[1], 2 * HALF[0], 2 * HALF[1]);
      c.fillStyle = colour("--ink");
      c.fillText(input.dataset.shown!, label.x, label.y);
    }
    c.restore();
  }
}
