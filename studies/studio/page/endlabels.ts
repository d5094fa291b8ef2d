// Numbers of points at the right ends of their curves, as many as have room.
import type uPlot from "uplot";
import { colour } from "./dom";

const HIGH = 11;

/** Write the numbers of curves at their right ends; those that are lit first, then the outermost, then the others. */
export function endLabels(u: uPlot, points: number[], end: (index: number) => number, lit: (number | null)[]): void {
  const c = u.ctx, { left, width } = u.bbox, room = HIGH * devicePixelRatio, taken: number[] = [];
  const order = points.map((_, p) => p);
  const rank = (p: number) => (lit.includes(points[p]) ? 0 : p === 0 || p === points.length - 1 ? 1 : 2);
  order.sort((a, b) => rank(a) - rank(b) || a - b);
  c.save();
  c.font = `${10 * devicePixelRatio}px system-ui`;
  c.textBaseline = "middle";
  c.textAlign = "left";
  for (const p of order) {
    const y = u.valToPos(end(p), "y", true);
    if (taken.some((each) => Math.abs(each - y) < room)) continue;
    taken.push(y);
    c.fillStyle = colour(rank(p) === 0 ? "--accent" : "--ink-soft");
    c.fillText(String(points[p]), left + width + 4 * devicePixelRatio, y);
  }
  c.restore();
}
