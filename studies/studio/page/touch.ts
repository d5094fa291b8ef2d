// The Touch panel: a simulated touch, a recording or a sound card, the microphones' signals, what the decoder answers.
import { sheet, sized } from "./chart";
import { button, byId, colour, csv, words } from "./dom";
import { Game } from "./game";
import { Timeline } from "./timeline";

export interface Heard {
  stage: "touch"; revision: number; touched: number | null; kind: string; microphones: string[]; samples: number;
  decisions: [number, string, number | null, number | null][]; touches: [number, number, number, number, number][];
  values: Float32Array; most?: number; full_scale?: number | null; paths?: { places: number[][]; gesture: string; length: number }[];
  line?: number[][]; kinds?: [number, number, number, string, number][];
}
/** An event of live listening: a decision with the samples since the one before, a fault or a notice. */
export interface LiveEvent { time: number; event?: string; state?: string; point?: number; probability?: number; samples?: number[][]; microphones?: string[]; fault?: string; text?: string; latency?: number; }
/** Signals that are shown at once, ms. */
const SHOWN = 1000, TICK = 250, AXIS = 18;
const HINT = "Click a membrane to touch it, drag to slide over the array.";

function loudest(signals: ArrayLike<number>[]): number {
  let most = 1e-9;
  for (const own of signals) for (let k = 0; k < own.length; k++) most = Math.max(most, Math.abs(own[k]));
  return most;
}

export class TouchPanel {
  private points: number[][] = [];
  private revision = -1;
  private run = 0;
  private counted = 0;
  private heard: Heard | null = null;
  private begun = 0;
  private now = -1;
  private named: number | null = null;
  private queue: Heard[] = [];
  private game = new Game(() => this.points.length, () => this.draw());
  private timeline = new Timeline((seconds) => this.seek(seconds));
  private again = false;
  private pictures = 0;
  private newly = false;
  private lightings: string[] = [];
  private planned = "";
  private shown: Heard | null = null;
  private from: number[] | null = null;
  private dragged: number[] | null = null;
  private live: { names: string[]; samples: number[][] } | null = null;
  private asked = false;
  constructor(private send: (message: object) => void, private lit: (point: number | null) => void) {
    const plan = byId<HTMLCanvasElement>("plan");
    plan.addEventListener("pointerdown", (event) => { this.dragged = this.placeOf(event); });
    plan.addEventListener("click", (event) => {
      const from = this.dragged, to = this.placeOf(event), point = this.under(event);
      this.dragged = null;
      if (from && Math.hypot(to[0] - from[0], to[1] - from[1]) > 2 * this.points[0]?.[2]) this.slide(from, to);
      else if (point) this.press(point);
    });
    byId("game").addEventListener("click", () => this.game.play());
    byId("write").addEventListener("click", () => this.write());
    byId<HTMLSelectElement>("touch-kind").addEventListener("change", (event) => {
      for (const id of ["letter", "write"]) byId(id).hidden = (event.target as HTMLSelectElement).value !== "letter";
    });
    new ResizeObserver(() => this.draw()).observe(plan.parentElement!);
  }

  take(found: { points: number[][]; fidelity: string }, revision: number): void {
    if (revision !== this.revision) this.forget();
    this.revision = revision;
    this.points = found.points;
    this.game.check();
    this.planned = "";
    byId("touch-fidelity").textContent = `Fidelity ${found.fidelity}.`;
    byId("touch-points").replaceChildren(...found.points.map((_, k) => button(String(k + 1), () => this.press(k + 1), { "aria-label": `touch point ${k + 1}` })));
    this.draw();
  }

  /** What was heard of another design is not of this one. */
  private forget(): void {
    this.queue = [];
    this.heard = this.shown = this.from = null;
    this.name(null);
    byId("answer").textContent = HINT;
    for (const each of ["pictures", "lit", "named"]) delete byId("answer").dataset[each];
    byId<HTMLCanvasElement>("waves").getContext("2d")!.clearRect(0, 0, 1e5, 1e5);
  }

  /** Nothing comes of the touch that was asked for. */
  failed(): void { if (!this.heard) byId("answer").textContent = HINT; }

  /** A recording, a slide or a letter that is played gives way to what is touched next. */
  private interrupt(): void {
    if (!this.heard || this.heard.touched !== null) return;
    this.shown = this.heard;
    this.heard = null;
    this.name(null);
  }

  press(point: number): void {
    const kind = byId<HTMLSelectElement>("touch-kind").value, place = this.points[point - 1];
    if (kind === "letter") this.write();
    else if (kind !== "slide") {
      this.interrupt();
      byId("answer").textContent = `point ${point} is touched…`;
      this.send({ do: "touch", point, kind });
    } else if (!this.from) {
      this.from = place;
      byId("answer").textContent = `A slide from point ${point} to… (choose a second one)`;
    } else {
      this.slide(this.from, place);
    }
  }

  private write(): void {
    const letter = byId<HTMLInputElement>("letter").value.toUpperCase();
    this.interrupt();
    byId("answer").textContent = `a finger writes ${letter}…`;
    this.send({ do: "touch", kind: "letter", letter });
  }

  private slide(from: number[], to: number[]): void {
    this.from = null;
    this.interrupt();
    byId("answer").textContent = "a finger slides over the array…";
    this.send({ do: "touch", kind: "slide", start: from.slice(0, 2), end: to.slice(0, 2) });
  }

  // -- live from a sound card
  /** What a sound card hears, as it comes. */
  hearLive(event: LiveEvent): void {
    if (event.samples) {
      this.live ??= { names: event.microphones!, samples: event.microphones!.map(() => []) };
      event.samples.forEach((each, m) => { this.live!.samples[m] = [...this.live!.samples[m], ...each].slice(-SHOWN); });
      this.name(event.state === "touch" ? event.point! : null);
      byId("answer").textContent = this.named ? `point ${this.named} (${words(100 * event.probability!, 2)} %)` : event.state!;
    } else if (event.fault || event.text) byId("answer").textContent = event.text ?? event.fault!;
    if (event.event === "up") this.game.whack([event.point!]);
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.draw(); });
  }

  /** Another membrane is named, or none; whether it is news. */
  private name(point: number | null): boolean {
    if (point === this.named) return false;
    this.named = point;
    this.lit(point);
    return true;
  }

  endLive(): void { this.live = null; this.name(null); this.draw(); }

  /** What was heard, played in real time, one after the other. */
  hear(heard: Heard): void {
    this.interrupt();
    this.queue.push(heard);
    if (!this.heard) this.next();
  }

  restyle(): void { this.draw(); }

  private next(): void {
    this.heard = this.queue.shift() ?? null;
    if (!this.heard) return;
    this.begun = performance.now();
    byId("touch-played").textContent = this.said(this.heard);
    this.pictures = 0;
    this.lightings = [];
    this.counted = 0;
    this.again = false;
    const run = ++this.run;
    requestAnimationFrame(() => this.frame(run));
  }

  private frame(run: number): void {
    const heard = this.heard;
    if (!heard || run !== this.run) return; // another one is played by now
    const end = heard.samples / 1000;
    this.now = Math.min((performance.now() - this.begun) / 1000, end);
    this.pictures += 1;
    let last: Heard["decisions"][0] | null = null;
    for (const each of heard.decisions) if (each[0] <= this.now) last = each; else break;
    const named = last && last[1] === "touch" ? last[2] : null;
    if (this.newly) this.lightings.push(words(this.now, 5)); // the picture before this one showed it
    this.newly = this.name(named) && named !== null;
    this.draw();
    if (heard.touched === null && !this.again) this.count(heard); // played again it is no other try of the game
    if (this.now < end) requestAnimationFrame(() => this.frame(run));
    else this.finish(heard, (performance.now() - this.begun) / 1000);
  }

  /** Touches of a recording hit or miss as they end. */
  private count(heard: Heard): void {
    for (const [, stop, point] of heard.touches.slice(this.counted)) {
      if (stop > this.now) return;
      this.counted += 1;
      this.game.whack([point]);
    }
  }

  /** Go on from another time of what is played, or play it again from there. */
  private seek(seconds: number): void {
    if (!this.heard && this.shown) {
      this.queue.unshift(this.shown);
      this.next();
    }
    this.begun = performance.now() - 1000 * seconds;
    this.again = true;
  }

  private finish(heard: Heard, seconds: number): void {
    const told = heard.touches.map(([start, stop, point, probability]) =>
      `point ${point} from ${words(start, 3)} to ${words(stop, 3)} s (${words(100 * probability, 2)} %)`);
    const begin = heard.touched === null ? `${heard.kind === "slide" ? "A slide" : heard.kind === "letter" ? "A letter" : heard.kind}: ` : `A ${heard.kind} on point ${heard.touched}; located: `;
    const paths = (heard.paths ?? []).filter((each) => each.length > 0).map((each) => `${each.gesture}, ${words(each.length, 3)} mm`);
    byId("answer").textContent = begin + (told.length ? told.join(", ") : "no touch was detected") + (paths.length ? `; path: ${paths.join("; ")}` : "");
    if (heard.kinds) byId("answer").textContent += `; recognized: ${heard.kinds.map((each) => `${each[3]} (${words(100 * each[4], 2)} %)`).join(", ") || "nothing"}`;
    else if (heard.line) byId("answer").textContent += "; to recognize the letter, load a recognizer of this array";
    byId("answer").dataset.pictures = String(Math.round(this.pictures / seconds));
    byId("answer").dataset.lit = this.lightings.join(",");
    byId("answer").dataset.named = heard.touches.map((each) => each[2]).join(",");
    if (heard.touched !== null && !this.again) this.game.whack(heard.touches.map((each) => each[2]));
    // What was named last stays lit until the next touch.
    const last = heard.touches.at(-1);
    this.name(last ? last[2] : null);
    this.heard = null;
    this.shown = heard;
    this.draw();
    this.next();
  }

  // -- pictures
  private place(canvas: HTMLCanvasElement): { at: (x: number, y: number) => [number, number]; scale: number } {
    const xs = this.points.map((p) => p[0]), ys = this.points.map((p) => p[1]), room = Math.max(...this.points.map((p) => p[2])) * 1.4;
    const [left, right, low, high] = [Math.min(...xs) - room, Math.max(...xs) + room, Math.min(...ys) - room, Math.max(...ys) + room];
    const scale = Math.min(canvas.width / (right - left), canvas.height / (high - low));
    const dx = (canvas.width - scale * (right - left)) / 2, dy = (canvas.height - scale * (high - low)) / 2;
    return { at: (x, y) => [dx + scale * (x - left), canvas.height - dy - scale * (y - low)], scale };
  }

  private draw(): void {
    this.plan();
    this.waves();
    this.timeline.draw(this.live ? null : this.heard ?? this.shown, this.heard ? this.now : null);
  }

  private plan(): void {
    const canvas = byId<HTMLCanvasElement>("plan"), width = canvas.parentElement!.clientWidth;
    if (!this.points.length || width === 0) return;
    const xs = this.points.map((p) => p[0]), ys = this.points.map((p) => p[1]);
    const heard = this.live ? null : this.heard ?? this.shown;
    const shown = [width, devicePixelRatio, document.documentElement.dataset.theme, this.named, this.game.mole, this.heard?.touched, (heard?.paths || heard?.line) && this.now].join();
    if (shown === this.planned) return;
    this.planned = shown;
    const shape = (Math.max(...ys) - Math.min(...ys) + 12) / (Math.max(...xs) - Math.min(...xs) + 12);
    const tall = Math.round(Math.min(Math.max(width * shape, 110), 380));
    sized(canvas, width, tall);
    const c = canvas.getContext("2d")!, { at, scale } = this.place(canvas);
    c.textAlign = "center";
    c.textBaseline = "middle";
    this.points.forEach(([x, y, radius], k) => {
      const [px, py] = at(x, y), number = k + 1;
      c.beginPath();
      c.arc(px, py, Math.max(radius * scale, 6 * devicePixelRatio), 0, 7);
      c.fillStyle = number === this.named ? colour("--accent") : colour("--button");
      c.fill();
      c.lineWidth = (number === this.game.mole ? 5 : 1) * devicePixelRatio;
      c.strokeStyle = number === this.game.mole ? colour("--good") : colour("--ink-soft");
      c.stroke();
      if (this.heard && number === this.heard.touched) {
        c.beginPath();
        c.arc(px, py, Math.max(radius * scale, 6 * devicePixelRatio) + 5 * devicePixelRatio, 0, 7);
        c.lineWidth = 2 * devicePixelRatio;
        c.strokeStyle = colour("--ink");
        c.stroke();
      }
      c.fillStyle = number === this.named ? colour("--card") : colour("--ink");
      c.font = `${Math.max(Math.min(radius * scale, 14 * devicePixelRatio), 9 * devicePixelRatio)}px system-ui`;
      c.fillText(String(number), px, py);
    });
    this.paths(c, at, scale);
  }

  /** What the waves are drawn of: live samples, else those of what was heard. */
  private waveforms(): { names: string[]; of: (m: number) => ArrayLike<number>; until: number; most: number } | null {
    if (this.live) return { names: this.live.names, of: (m) => this.live!.samples[m], until: this.live.samples[0].length, most: loudest(this.live.samples) };
    const heard = this.heard ?? this.shown;
    if (!heard) return null;
    const of = (m: number) => heard.values.subarray(m * heard.samples, (m + 1) * heard.samples);
    return { names: heard.microphones, of, until: this.heard ? Math.floor(this.now * 1000) : heard.samples, most: heard.most ??= loudest([heard.values]) };
  }

  /** Paths as far as they have come, with how sure they are. */
  private paths(c: CanvasRenderingContext2D, at: (x: number, y: number) => [number, number], scale: number): void {
    const heard = this.heard ?? this.shown;
    if (this.live || !heard) return;
    c.fillStyle = colour("--accent");
    for (const [time, x, y, share] of heard.line ?? []) {
      if (this.heard && time > this.now) break;
      c.globalAlpha = Math.min(share, 1);
      const side = Math.max(scale, 2 * devicePixelRatio), [px, py] = at(x, y);
      c.fillRect(px - side / 2, py - side / 2, side, side);
    }
    c.globalAlpha = 1;
    c.strokeStyle = c.fillStyle = colour("--accent");
    c.lineWidth = 3 * devicePixelRatio;
    for (const path of heard.paths ?? []) {
      const come = path.places.filter((place) => !this.heard || place[0] <= this.now), last = come.at(-1);
      if (!last) continue;
      if (path.length > 0) { // a slide is a line where it was detected; a contact that stays is a spot
        c.beginPath();
        come.forEach(([, x, y, , detected], k) => { if (detected && k && come[k - 1][4]) c.lineTo(...at(x, y)); else c.moveTo(...at(x, y)); });
        c.stroke();
      }
      c.globalAlpha = path.length > 0 ? 0.25 : 0.4;
      c.beginPath();
      c.arc(...at(last[1], last[2]), Math.max(last[3] * scale, 4 * devicePixelRatio), 0, 7);
      c.fill();
      c.globalAlpha = 1;
    }
  }

  private waves(): void {
    const canvas = byId<HTMLCanvasElement>("waves"), found = this.waveforms();
    const width = canvas.parentElement!.clientWidth;
    if (!found || width === 0) return;
    const { names, of, until, most } = found, count = names.length, row = 64;
    sized(canvas, width, row * count + AXIS);
    const c = canvas.getContext("2d")!;
    const from = Math.max(0, until - SHOWN), step = canvas.width / SHOWN, high = row * devicePixelRatio;
    this.times(c, canvas.width, row * count * devicePixelRatio, from);
    c.font = `${12 * devicePixelRatio}px system-ui`;
    names.forEach((name, m) => {
      const own = of(m), middle = (m + 0.5) * high;
      c.strokeStyle = colour("--grid");
      c.lineWidth = 1;
      c.beginPath();
      c.moveTo(0, middle);
      c.lineTo(canvas.width, middle);
      c.stroke();
      c.strokeStyle = colour("--accent");
      c.lineWidth = 1.3 * devicePixelRatio;
      c.beginPath();
      for (let k = from; k < until; k++) c.lineTo((k - from) * step, middle - (own[k] / most) * high * 0.44);
      c.stroke();
      c.fillStyle = colour("--ink-soft");
      c.fillText(`${name}, ±${words(most, 2)} Pa`, 6 * devicePixelRatio, m * high + 14 * devicePixelRatio);
    });
  }

  /** The axis of time below the waves, s; of live input it says how far it has come. */
  private times(c: CanvasRenderingContext2D, width: number, top: number, from: number): void {
    c.font = `${11 * devicePixelRatio}px system-ui`;
    c.fillStyle = colour("--ink-soft");
    c.strokeStyle = colour("--grid");
    c.lineWidth = devicePixelRatio;
    for (let ms = Math.ceil(from / TICK) * TICK; ms <= from + SHOWN; ms += TICK) {
      const at = ((ms - from) / SHOWN) * width;
      c.beginPath();
      c.moveTo(at, 0);
      c.lineTo(at, top);
      c.stroke();
      c.textAlign = ms - from < TICK / 4 ? "left" : from + SHOWN - ms < TICK / 4 ? "right" : "center";
      c.fillText(`${words(ms / 1000)} s`, at, top + 12 * devicePixelRatio);
    }
    c.textAlign = "left";
  }

  /** What plays, in words: whose signals, which noise. */
  private said(heard: Heard): string {
    if (heard.touched === null && heard.kind !== "slide" && heard.kind !== "letter") return `Plays the recording ${heard.kind}, ${heard.full_scale ? `with a full scale of ${words(heard.full_scale)} Pa` : "which holds pascals"}.`;
    return "Plays the sensor as designed, with the noise of its microphones and without sound of the room.";
  }

  /** The signals that are shown, Pa, with the point that is named meanwhile. */
  table(name: string): void {
    const found = this.waveforms(), decisions = this.live ? [] : (this.heard ?? this.shown)?.decisions ?? [];
    if (!found) return;
    let at = -1;
    const rows = Array.from({ length: found.until }, (_, k) => {
      while (at + 1 < decisions.length && decisions[at + 1][0] <= k / 1000) at += 1;
      return [k / 1000, ...found.names.map((_, m) => found.of(m)[k]), (at >= 0 && decisions[at][1] === "touch" && decisions[at][2]) || ""];
    });
    csv([["time (s)", ...found.names.map((each) => `${each} (Pa)`), "located point"], ...rows], `${name}-touch.csv`);
  }

  picture(name: string): void { sheet([byId<HTMLCanvasElement>("plan"), byId<HTMLCanvasElement>("waves")], `${name}-touch.png`, 1); }

  /** Where in plan the mouse is, mm. */
  private placeOf(event: MouseEvent): number[] {
    const canvas = byId<HTMLCanvasElement>("plan"), frame = canvas.getBoundingClientRect(), { at, scale } = this.place(canvas);
    const [ox, oy] = at(0, 0), x = (event.clientX - frame.left) * (canvas.width / frame.width), y = (event.clientY - frame.top) * (canvas.height / frame.height);
    return [(x - ox) / scale, (oy - y) / scale];
  }

  private under(event: MouseEvent): number | null {
    const canvas = byId<HTMLCanvasElement>("plan"), frame = canvas.getBoundingClientRect(), { at, scale } = this.place(canvas);
    const x = (event.clientX - frame.left) * (canvas.width / frame.width), y = (event.clientY - frame.top) * (canvas.height / frame.height);
    let best: number | null = null, least = Infinity;
    this.points.forEach(([px, py, radius], k) => {
      const [cx, cy] = at(px, py), away = Math.hypot(cx - x, cy - y);
      if (away < Math.max(radius * scale, 6 * devicePixelRatio) * 1.3 && away < least) { least = away; best = k + 1; }
    });
    return best;
  }

  /** The signals that are shown, as sound: at their own pitch, at the loudness that the loudspeaker can. */
  async sound(): Promise<void> {
    const heard = this.heard ?? this.shown;
    if (!heard) return;
    const finer = 8, context = new AudioContext(), buffer = context.createBuffer(Math.min(heard.microphones.length, 2), heard.samples * finer, 8000);
    for (let m = 0; m < buffer.numberOfChannels; m++) {
      const own = heard.values.subarray(m * heard.samples, (m + 1) * heard.samples), to = buffer.getChannelData(m);
      let most = 1e-9;
      for (const value of own) most = Math.max(most, Math.abs(value));
      for (let k = 0; k < to.length; k++) {
        const at = k / finer, low = Math.floor(at), next = Math.min(low + 1, own.length - 1);
        to[k] = (own[low] + (at - low) * (own[next] - own[low])) / most;
      }
    }
    const source = context.createBufferSource();
    source.buffer = buffer;
    source.connect(context.destination);
    source.onended = () => context.close();
    source.start();
  }
}
