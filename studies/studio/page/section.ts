// The section of one resonator, drawn from the fields of the design: walls, membrane and bores, with lines of dimension
// whose numbers are fields to type into.
import { sized } from "./chart";
import { byId, colour, make, words } from "./dom";

const HEIGHT = 196, MARGIN = 60, TUBE = 2, FOOT = 34, HEAD = 30, TICK = 3, AWAY = 9;
/** Fields with a line of dimension, and what they measure. */
const DIMENSIONS: Record<string, string> = {
  "resonator.cavity_diameter": "diameter of the cavity", "resonator.cavity_height": "height of the cavity", "resonator.wall_thickness": "wall",
  "resonator.floor_thickness": "floor", "membrane.thickness": "thickness of the membrane", "membrane.rim_width": "rim of the membrane", "tube.inner_diameter": "bore of the tube",
};

export class SectionPicture {
  private stated: any = null;
  private inUse: Record<string, number | string> = {};
  private inputs = new Map<string, HTMLInputElement>();
  constructor(private set: (field: string, value: number | string) => void) {
    for (const [field, title] of Object.entries(DIMENSIONS)) {
      const input = make("input", { type: "text", class: "dimension", inputmode: "decimal", autocomplete: "off", "data-dimension": field, "aria-label": `${title}, mm`, title: `${title}, mm: type another one` });
      input.addEventListener("change", () => {
        const plain = input.value.replace("−", "-").replace(",", ".").trim();
        this.set(field, plain === "" || !Number.isFinite(Number(plain)) ? input.value : Number(plain));
      });
      input.addEventListener("keydown", (event) => { if (event.key === "Escape") { this.draw(); input.blur(); } });
      input.addEventListener("blur", () => this.draw());
      this.inputs.set(field, input);
      byId("section-holder").append(input);
    }
    new ResizeObserver(() => this.draw()).observe(byId("section-holder"));
  }

  take(stated: any, inUse: Record<string, number | string> | null): void {
    this.stated = stated;
    if (inUse) this.inUse = inUse;
    this.draw();
  }

  draw(): void {
    const width = byId("section-holder").clientWidth, stated = this.stated;
    if (!stated || width === 0) return;
    const canvas = byId<HTMLCanvasElement>("resonator-section"), { resonator, membrane, tube } = stated;
    sized(canvas, width, HEIGHT);
    const c = canvas.getContext("2d")!;
    c.scale(devicePixelRatio, devicePixelRatio);
    const used = (name: string, own: number | null | undefined): number => own ?? Number(this.inUse[`resonator.${name}`] ?? 0);
    const radius = resonator.cavity_diameter / 2, outer = radius + resonator.wall_thickness, tall = resonator.cavity_height;
    const low = -resonator.floor_thickness, high = tall + membrane.thickness, rim = radius + membrane.rim_width, half = Math.max(outer, rim);
    const scale = Math.min((width - 2 * MARGIN) / (2 * (half + TUBE)), (HEIGHT - FOOT - HEAD) / (high - low));
    const x = (mm: number) => width / 2 + scale * mm, y = (mm: number) => HEIGHT - FOOT - scale * (mm - low);
    const box = (x0: number, y0: number, x1: number, y1: number, fill: string) => { c.fillStyle = fill; c.fillRect(x(x0), y(y1), scale * (x1 - x0), scale * (y1 - y0)); };
    const shell = colour("--edge"), air = colour("--card");
    box(-outer, low, outer, tall, shell);
    this.cavity(c, x, y, radius, tall, air, used);
    const port = used("port_height", resonator.port_height), bore = tube.inner_diameter / 2, sheath = tube.outer_diameter / 2;
    for (const side of [-1, 1]) {
      const [from, to] = [side * outer, side * (radius - 0.02 * radius)].sort((a, b) => a - b);
      box(from, port - bore, to, port + bore, air);
      const [left, right] = [side * (outer + TUBE), side * (radius + 0.4 * resonator.wall_thickness)].sort((a, b) => a - b);
      box(left, port - sheath, right, port + sheath, colour("--ink-soft"));
      box(left, port - bore, right, port + bore, air);
    }
    box(-rim, tall, rim, high, colour("--accent"));
    c.strokeStyle = colour("--ink-soft");
    const foot = y(low) + AWAY, head = y(high) - AWAY;
    const across = (from: number, to: number, at: number) => line(c, [[x(from), at, x(to), at], [x(from), at - TICK, x(from), at + TICK], [x(to), at - TICK, x(to), at + TICK]]);
    const up = (from: number, to: number, at: number) => line(c, [[at, y(from), at, y(to)], [at - TICK, y(from), at + TICK, y(from)], [at - TICK, y(to), at + TICK, y(to)]]);
    const left = x(-half) - AWAY, right = x(half) + AWAY;
    across(-radius, radius, foot);
    across(-outer, -radius, foot);
    across(radius, rim, head);
    up(low, 0, left);
    up(tall, high, right);
    up(0, tall, x(0.72 * radius));
    up(port - bore, port + bore, x(outer + TUBE) + AWAY);
    this.place("resonator.cavity_diameter", 2 * radius, x(0), foot + 11);
    this.place("resonator.wall_thickness", resonator.wall_thickness, Math.max(x(-(outer + radius) / 2), 26), foot + 11);
    this.place("membrane.rim_width", membrane.rim_width, x((radius + rim) / 2), head - 10);
    this.place("resonator.floor_thickness", resonator.floor_thickness, left - 26, y(low / 2));
    this.place("membrane.thickness", membrane.thickness, right + 26, y((tall + high) / 2));
    this.place("resonator.cavity_height", tall, x(0.72 * radius) - 26, y(tall / 2));
    this.place("tube.inner_diameter", tube.inner_diameter, Math.min(x(outer + TUBE) + AWAY + 26, width - 24), y(port));
    canvas.setAttribute("aria-label", `section of a resonator: cavity ${words(2 * radius)} mm wide and ${words(tall)} mm high, wall ${words(resonator.wall_thickness)} mm, floor ${words(resonator.floor_thickness)} mm, membrane ${words(membrane.thickness)} mm`);
  }

  /** The number of a line of dimension in the middle of a place, unless it is being typed. */
  private place(field: string, value: number, x: number, y: number): void {
    const input = this.inputs.get(field)!;
    if (document.activeElement !== input) input.value = words(value);
    Object.assign(input.style, { left: `${x - 22}px`, top: `${y - 9}px` });
  }

  /** The air of a cavity: a cylinder, a box under its collar, or a bowl. */
  private cavity(
    c: CanvasRenderingContext2D, x: (mm: number) => number, y: (mm: number) => number, radius: number, tall: number, air: string,
    used: (name: string, own: number | null | undefined) => number,
  ): void {
    const { resonator } = this.stated;
    c.fillStyle = air;
    c.beginPath();
    if (resonator.shape === "box") {
      const side = used("box_length", resonator.box_length) / 2, collar = tall - used("collar_height", resonator.collar_height);
      for (const [px, py] of [[-radius, tall], [-radius, collar], [-side, collar], [-side, 0], [side, 0], [side, collar], [radius, collar], [radius, tall]]) c.lineTo(x(px), y(py));
    } else if (resonator.shape === "dome") {
      const depth = used("dome_depth", resonator.dome_depth), ball = (radius * radius + depth * depth) / (2 * depth);
      c.lineTo(x(-radius), y(tall));
      for (let k = -24; k <= 24; k++) { const px = (radius * k) / 24; c.lineTo(x(px), y(ball - Math.sqrt(Math.max(ball * ball - px * px, 0)))); }
      c.lineTo(x(radius), y(tall));
    } else for (const [px, py] of [[-radius, tall], [-radius, 0], [radius, 0], [radius, tall]]) c.lineTo(x(px), y(py));
    c.fill();
  }
}

function line(c: CanvasRenderingContext2D, parts: [number, number, number, number][]): void {
  c.beginPath();
  for (const [x0, y0, x1, y1] of parts) { c.moveTo(x0, y0); c.lineTo(x1, y1); }
  c.stroke();
}
