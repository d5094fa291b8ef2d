// Sliders of numbers: a way that stays where it is, and steps that always change a value.
export interface Range { kind: string; lowest: number | null; highest: number | null; }
export interface Scale { from: number; to: number; value: (share: number) => number; share: (x: number) => number; }

/** How much the value of a slider goes down and up from the one that it begins with. */
const SPAN = 4;

/** Two digits, rounded so that the bound lies outside the value. */
function bound(x: number, up: boolean): number {
  const step = 10 ** (Math.floor(Math.log10(x)) - 1);
  return Number(((up ? Math.ceil(x / step) : Math.floor(x / step)) * step).toPrecision(6));
}

/** The smallest step of a value, in its third digit; of a whole number one. */
function stepOf(field: Range, value: number): number {
  if (field.kind === "count") return 1;
  if (value !== 0) return 10 ** (Math.floor(Math.log10(Math.abs(value)) + 1e-9) - 2);
  const span = field.lowest !== null && field.highest !== null ? field.highest - field.lowest : 1;
  return 10 ** (Math.floor(Math.log10(span)) - 2);
}

function clamp(x: number, from: number, to: number): number { return Math.min(Math.max(x, from), to); }

/** The value next to another one, up or down by so many steps; the same only at a bound of its field. */
export function next(field: Range, value: number, steps: number): number {
  const step = stepOf(field, value), way = Math.sign(steps), place = value / step;
  // From a value between two steps the nearest one that way is the first.
  const first = way > 0 ? Math.floor(place + 1e-6) + 1 : Math.ceil(place - 1e-6) - 1;
  let found = Number(((first + way * (Math.abs(steps) - 1)) * step).toPrecision(6));
  // Below a power of ten steps are finer: zero is not reached by one.
  if (value !== 0 && Math.sign(found) !== Math.sign(value) && field.lowest !== null && field.lowest >= 0) found = Number((value * 0.99).toPrecision(3));
  return clamp(found, field.lowest ?? -Infinity, field.highest ?? Infinity);
}

/** A slider's way: from a fourth to four times of a value, or from bound to bound where it may be zero or negative. */
export function scaleOf(field: Range, now: number): Scale {
  const { lowest: low, highest: high } = field;
  const whole = (x: number) => (field.kind === "count" ? Math.round(x) : x);
  if (now > 0 && !(low !== null && low < 0) && !(high !== null && high <= 1)) {
    const from = Math.max(low ?? 0, whole(bound(now / SPAN, false)), field.kind === "count" ? 1 : 1e-9);
    const to = Math.max(Math.min(high ?? Infinity, whole(bound(now * SPAN, true))), field.kind === "count" ? Math.min(6, high ?? 6) : 0, from * 1.0001);
    const span = Math.log(to / from);
    const round = (x: number) => { const step = stepOf(field, x); return Number((Math.round(x / step) * step).toPrecision(6)); };
    return { from, to, value: (share) => clamp(round(from * Math.exp(share * span)), from, to), share: (x) => clamp(Math.log(Math.max(x, 1e-12) / from) / span, 0, 1) };
  }
  const from = low ?? Math.min(0, 2 * now), to = high ?? Math.max(1, 2 * now), grain = (to - from) / 200;
  const even = (x: number) => (field.kind === "count" ? Math.round(x) : Number((Math.round(x / grain) * grain).toPrecision(6)));
  return { from, to, value: (share) => clamp(even(from + share * (to - from)), from, to), share: (x) => clamp((x - from) / (to - from || 1), 0, 1) };
}

/** A way for a value: the one that is there, unless the value lies beyond it. */
export function scaleFor(field: Range, value: number, kept: Scale | undefined): Scale {
  return kept && value >= kept.from && value <= kept.to ? kept : scaleOf(field, value);
}

export function nearest(stops: number[], value: number): number {
  const apart = stops.map((size) => Math.abs(Math.log(size / Math.max(value, 1e-9))));
  return apart.indexOf(Math.min(...apart));
}
