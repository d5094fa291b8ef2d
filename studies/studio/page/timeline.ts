// The line of time below the array: what was located when, apart from each other, and how far the replay has come.
import { sized } from "./chart";
import { byId, colour, words } from "./dom";
import type { Heard } from "./touch";

const TALL = 34, BAR = 16;

export class Timeline {
  private seconds = 0;
  constructor(seek: (seconds: number) => void) {
    byId("timeline").addEventListener("click", (event) => {
      const frame = byId("timeline").getBoundingClientRect();
      if (this.seconds) seek(((event.clientX - frame.left) / frame.width) * this.seconds);
    });
  }

  /** Draw what is played, or was; nothing for none. */
  draw(heard: Heard | null, now: number | null): void {
    const canvas = byId<HTMLCanvasElement>("timeline"), width = canvas.parentElement!.clientWidth;
    canvas.hidden = heard === null;
    if (!heard || !width) return;
    const end = this.seconds = heard.samples / 1000, at = (time: number) => (time / end) * width;
    sized(canvas, width, TALL);
    const c = canvas.getContext("2d")!;
    c.scale(devicePixelRatio, devicePixelRatio);
    c.fillStyle = colour("--grid");
    c.fillRect(0, 0, width, BAR);
    c.font = "11px system-ui";
    c.textBaseline = "middle";
    c.textAlign = "center";
    for (const path of heard.paths ?? []) {
      if (path.length <= 0) continue;
      c.fillStyle = colour("--good");
      const [from, to] = [path.places[0][0], path.places.at(-1)![0]];
      c.fillRect(at(from), BAR, Math.max(at(to - from), 2), 3);
    }
    for (const [start, stop, point] of heard.touches) {
      const from = at(start), wide = Math.max(at(stop) - from, 2);
      c.globalAlpha = now !== null && start > now ? 0.45 : 1;
      c.fillStyle = colour("--accent");
      c.fillRect(from, 0, wide, BAR);
      c.fillStyle = colour("--card");
      if (wide > 14) c.fillText(String(point), from + wide / 2, BAR / 2);
    }
    c.globalAlpha = 1;
    c.fillStyle = colour("--ink-soft");
    c.textAlign = "left";
    c.fillText(now === null ? "" : `${words(Math.round(10 * now) / 10)} s`, 0, TALL - 6);
    c.textAlign = "right";
    c.fillText(`${words(Math.round(10 * end) / 10)} s`, width, TALL - 6);
    if (now !== null) { c.fillStyle = colour("--ink"); c.fillRect(at(now) - 1, 0, 2, BAR + 4); }
    canvas.setAttribute("aria-label", `${heard.touches.length} touches located within ${words(end, 3)} s; the line below says which`);
  }
}
