// Small charts on a canvas: a frame with ticks, into which others draw; and figures as PNG files.
import { colour, hand, shownUnit, words } from "./dom";

export interface Axis { low: number; high: number; title: string; labels: string[]; }
export interface Chart { c: CanvasRenderingContext2D; x: (value: number) => number; y: (value: number) => number; }

/** An axis around values, with some room; ``labels``: texts that whole numbers stand for. */
export function axisOf(values: number[], title: string, unit = "", labels: string[] = []): Axis {
  let low = Infinity, high = -Infinity;
  for (const value of values) { if (value < low) low = value; if (value > high) high = value; }
  const room = (high - low) * 0.06 || Math.abs(high) * 0.1 || 1;
  return { low: low - room, high: high + room, title: unit && unit !== "1" ? `${title} (${shownUnit(unit)})` : title, labels };
}

export function sized(canvas: HTMLCanvasElement, width: number, height: number): void {
  const scale = devicePixelRatio, wide = Math.round(width * scale), tall = Math.round(height * scale);
  if (canvas.width !== wide || canvas.height !== tall || !canvas.style.width) { // what has its size keeps its place in the page
    canvas.width = wide;
    canvas.height = tall;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  canvas.getContext("2d", { willReadFrequently: true })!.reset(); // drawn by the processor: see the curves
}

const LEFT = 58, RIGHT = 10, TOP = 8;

/** The frame of a chart in a canvas of so many pixels of the page; places are in these pixels. */
export function chart(canvas: HTMLCanvasElement, width: number, height: number, across: Axis, up: Axis): Chart {
  sized(canvas, width, height);
  const c = canvas.getContext("2d")!;
  c.scale(devicePixelRatio, devicePixelRatio);
  const slanted = across.labels.length > 0, BOTTOM = slanted ? 74 : 38;
  const x = (value: number) => LEFT + ((value - across.low) / (across.high - across.low)) * (width - LEFT - RIGHT);
  const y = (value: number) => height - BOTTOM - ((value - up.low) / (up.high - up.low)) * (height - TOP - BOTTOM);
  c.font = "11px system-ui";
  c.lineWidth = 1;
  c.strokeStyle = colour("--grid");
  c.fillStyle = colour("--ink-soft");
  c.textAlign = "center";
  c.textBaseline = "top";
  const marks = ticks(across, (width - LEFT - RIGHT) / 70);
  for (const value of marks) {
    line(c, x(value), TOP, x(value), height - BOTTOM);
    c.save();
    c.translate(x(value), height - BOTTOM + 4);
    if (slanted) { c.rotate(-Math.PI / 7); c.textAlign = "right"; }
    c.fillText(said(across, value), slanted ? 8 : 0, 0, slanted ? Math.min(95, x(value)) : 70);
    c.restore();
  }
  c.textAlign = "right";
  c.textBaseline = "middle";
  for (const value of ticks(up, (height - TOP - BOTTOM) / 34)) {
    line(c, LEFT, y(value), width - RIGHT, y(value));
    c.fillText(said(up, value), LEFT - 5, y(value), LEFT - 20);
  }
  c.fillStyle = colour("--ink");
  c.textAlign = "center";
  c.textBaseline = "bottom";
  c.fillText(across.title, (LEFT + width - RIGHT) / 2, height - 2, width - LEFT);
  c.save();
  c.translate(2, (TOP + height - BOTTOM) / 2);
  c.rotate(-Math.PI / 2);
  c.textBaseline = "top";
  c.fillText(up.title, 0, 0, height - BOTTOM);
  c.restore();
  return { c, x, y };
}

function line(c: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

function ticks(axis: Axis, most: number): number[] {
  if (axis.labels.length) return axis.labels.map((_, k) => k);
  const rough = (axis.high - axis.low) / Math.max(most, 2), power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((each) => each * power).find((each) => each >= rough)!;
  const found = [];
  for (let k = Math.ceil(axis.low / step); k * step <= axis.high; k++) found.push(k * step);
  return found;
}

function said(axis: Axis, value: number): string { return axis.labels[value] ?? words(value, 3); }

/** Rows of texts and numbers as a picture of a table, its first row as head. */
export function tablePicture(rows: (string | number)[][], name: string): void {
  const text = rows.map((row) => row.map((cell) => (typeof cell === "number" ? words(cell) : cell))), high = 22, room = 12;
  const canvas = document.createElement("canvas"), first = canvas.getContext("2d")!;
  first.font = "13px system-ui";
  const wide = text[0].map((_, k) => Math.max(...text.map((row) => first.measureText(row[k] ?? "").width)) + 2 * room);
  sized(canvas, wide.reduce((sum, each) => sum + each, 0), high * rows.length);
  const c = canvas.getContext("2d")!;
  c.scale(devicePixelRatio, devicePixelRatio);
  c.font = "13px system-ui";
  c.textBaseline = "middle";
  c.strokeStyle = colour("--grid");
  text.forEach((row, k) => {
    c.fillStyle = colour(k ? "--ink" : "--ink-soft");
    let x = room;
    row.forEach((cell, n) => { c.fillText(cell, x, (k + 0.5) * high); x += wide[n]; });
    line(c, 0, (k + 1) * high, x, (k + 1) * high);
  });
  sheet([canvas], name);
}

/** Canvases side by side on the colour of the card, as one PNG file. */
export function sheet(canvases: HTMLCanvasElement[], name: string, across = 3): void {
  const shown = canvases.filter((each) => each.width > 0 && each.height > 0);
  if (!shown.length) return;
  const wide = Math.max(...shown.map((each) => each.width)), tall = Math.max(...shown.map((each) => each.height));
  const columns = Math.min(across, shown.length), whole = document.createElement("canvas");
  whole.width = columns * wide;
  whole.height = Math.ceil(shown.length / columns) * tall;
  const c = whole.getContext("2d")!;
  c.fillStyle = colour("--card");
  c.fillRect(0, 0, whole.width, whole.height);
  shown.forEach((each, k) => c.drawImage(each, (k % columns) * wide, Math.floor(k / columns) * tall));
  whole.toBlob((blob) => blob && hand(blob, name));
}
