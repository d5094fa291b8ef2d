// Small pictures of arrays in plan: membranes, the tubes that join them, microphones.
import { sized } from "./chart";
import { colour, make, ramp } from "./dom";

export interface Plan { points: number[][]; microphones: number[][]; lines: number[][]; }

/** A picture of an array, so wide and tall in pixels of the page; a decoration beside its name. */
export function planPicture(plan: Plan, width: number, height: number): HTMLCanvasElement {
  const canvas = make("canvas", { "aria-hidden": "true" });
  sized(canvas, width, height);
  const c = canvas.getContext("2d")!, places = [...plan.points, ...plan.microphones.map(([x, y]) => [x, y, 2])];
  const [left, right] = [Math.min(...places.map(([x, , r]) => x - r)), Math.max(...places.map(([x, , r]) => x + r))];
  const [low, high] = [Math.min(...places.map(([, y, r]) => y - r)), Math.max(...places.map(([, y, r]) => y + r))];
  const scale = 0.92 * Math.min(canvas.width / (right - left), canvas.height / (high - low));
  const at = (x: number, y: number): [number, number] => [canvas.width / 2 + scale * (x - (left + right) / 2), canvas.height / 2 - scale * (y - (low + high) / 2)];
  c.strokeStyle = colour("--ink-soft");
  c.lineWidth = devicePixelRatio;
  for (const line of plan.lines) {
    c.beginPath();
    for (const number of line) c.lineTo(...at(plan.points[number - 1][0], plan.points[number - 1][1]));
    c.stroke();
  }
  const last = Math.max(plan.points.length - 1, 1);
  plan.points.forEach(([x, y, r], k) => {
    c.beginPath();
    c.arc(...at(x, y), Math.max(r * scale, 1.5 * devicePixelRatio), 0, 7);
    c.fillStyle = ramp(k / last);
    c.fill();
  });
  c.fillStyle = colour("--good");
  for (const [x, y] of plan.microphones) {
    const [px, py] = at(x, y), side = Math.max(2.4 * scale, 4 * devicePixelRatio);
    c.fillRect(px - side / 2, py - side / 2, side, side);
  }
  return canvas;
}
