// The section of one resonator, drawn from the fields of the design: walls, membrane and bores with their measures.
import { sized } from "./chart";
import { byId, colour, words } from "./dom";

const HEIGHT = 176, MARGIN = 52;

export class SectionPicture {
  private stated: any = null;
  private inUse: Record<string, number | string> = {};
  constructor() { new ResizeObserver(() => this.draw()).observe(byId("section-holder")); }

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
    const scale = Math.min((width - 2 * MARGIN) / (2 * half), (HEIGHT - 44) / (high - low));
    const x = (mm: number) => width / 2 + scale * mm, y = (mm: number) => HEIGHT - 20 - scale * (mm - low);
    const box = (x0: number, y0: number, x1: number, y1: number, fill: string) => { c.fillStyle = fill; c.fillRect(x(x0), y(y1), scale * (x1 - x0), scale * (y1 - y0)); };
    const shell = colour("--edge"), air = colour("--card");
    box(-outer, low, outer, tall, shell);
    this.cavity(c, x, y, radius, tall, air, used);
    const port = used("port_height", resonator.port_height), bore = tube.inner_diameter / 2, sheath = tube.outer_diameter / 2;
    for (const side of [-1, 1]) {
      const [from, to] = [side * outer, side * (radius - 0.02 * radius)].sort((a, b) => a - b);
      box(from, port - bore, to, port + bore, air);
      const [left, right] = [side * (outer + 2), side * (radius + 0.4 * resonator.wall_thickness)].sort((a, b) => a - b);
      box(left, port - sheath, right, port + sheath, colour("--ink-soft"));
      box(left, port - bore, right, port + bore, air);
    }
    box(-rim, tall, rim, high, colour("--accent"));
    c.font = "11px system-ui";
    c.fillStyle = c.strokeStyle = colour("--ink");
    c.textAlign = "center";
    c.fillText(`cavity ${words(2 * radius)} × ${words(tall)} mm`, x(0), y(tall / 2) + 4);
    c.fillText(`membrane ${words(membrane.thickness)} mm, on a rim of ${words(membrane.rim_width)} mm`, width / 2, y(high) - 5);
    c.fillText(`wall ${words(resonator.wall_thickness)}, floor ${words(resonator.floor_thickness)}, bore ${words(tube.inner_diameter)} mm`, width / 2, HEIGHT - 5);
    canvas.setAttribute("aria-label", `section of a resonator: cavity ${words(2 * radius)} mm wide and ${words(tall)} mm high, wall ${words(resonator.wall_thickness)} mm, floor ${words(resonator.floor_thickness)} mm, membrane ${words(membrane.thickness)} mm`);
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
