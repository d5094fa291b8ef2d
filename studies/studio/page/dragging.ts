// Parts that are dragged in the picture of the array: what the pointer holds and where it has taken it.
import { Plane, type PerspectiveCamera, Raycaster, Vector2, Vector3 } from "three";
import { byId, colour, make } from "./dom";

/** Where all parts are after a drag, in millimetres of the design; see parts_in_space. */
export interface Moved {
  gesture: string; revision: number; words: string; refused: string; shift: number[];
  points: number[][]; microphones: Record<string, number[]>; tubes: number[][][];
}
/** A part under the pointer: what it belongs to, its place and the direction away from what it stands on. */
export interface Hold { group: string; at: Vector3; normal: Vector3; }

/** Pixels that a pointer goes before it drags. */
const SLACK = 5;
/** How long the reason of a refusal stays after a drag, ms. */
const STAY = 6000;

/** Metres with y up, as glTF has them, from millimetres with z up. */
export function toScene([x, y, z]: number[]): Vector3 { return new Vector3(x / 1000, z / 1000, -y / 1000); }

function toDesign({ x, y, z }: Vector3): number[] { return [1000 * x, -1000 * z, 1000 * y]; }

export class Dragging {
  /** True while a part is dragged. */
  active = false;
  private hold: Hold | null = null;
  private plane = new Plane();
  private down: [number, number] = [0, 0];
  private now: [number, number] = [0, 0];
  private held = 0;
  private gesture = "";
  private refused = "";
  private note = make("div", { id: "drag-note", role: "status", hidden: "" });
  private leaving = 0;

  /** `take`: what is under the pointer and can be dragged; `turn`: lets the array be turned, or not. */
  constructor(
    private place: HTMLElement, private sheet: HTMLCanvasElement, private camera: PerspectiveCamera, private origin: () => Vector3,
    private take: (event: PointerEvent) => Hold | null, private turn: (on: boolean) => void, private send: (message: object) => void, private redraw: () => void,
  ) {
    place.append(this.note);
    place.addEventListener("pointerdown", (event) => this.begin(event), { capture: true }); // before the controls that turn
    sheet.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) sheet.addEventListener(end, () => this.end());
    addEventListener("keydown", (event) => { if (event.key === "Escape" && this.active) { this.ask([0, 0, 0]); this.end(); } });
  }

  private begin(event: PointerEvent): void {
    if (event.target !== this.sheet || event.button !== 0 || !byId<HTMLInputElement>("movable").checked) return;
    this.hold = this.take(event);
    if (!this.hold) return;
    this.turn(false);
    this.sheet.setPointerCapture(event.pointerId);
    this.down = this.now = [event.clientX, event.clientY];
    this.plane.setFromNormalAndCoplanarPoint(this.hold.normal, this.hold.at);
    this.gesture = `drag-${++this.held}-${Date.now()}`;
  }

  private move(event: PointerEvent): void {
    if (!this.hold) return;
    if (!this.active && Math.hypot(event.clientX - this.down[0], event.clientY - this.down[1]) < SLACK) return;
    this.active = true;
    this.now = [event.clientX, event.clientY];
    const frame = this.sheet.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * (event.clientX - frame.left)) / frame.width - 1, 1 - (2 * (event.clientY - frame.top)) / frame.height), this.camera);
    const to = ray.ray.intersectPlane(this.plane, new Vector3());
    if (to) this.ask(toDesign(to.sub(this.hold.at)), event.shiftKey);
    this.redraw();
  }

  private ask(by: number[], row = false): void {
    const at = toDesign(this.hold!.at.clone().sub(this.origin()));
    this.send({ do: "drag", part: this.hold!.group, by, at, row, gesture: this.gesture });
  }

  private end(): void {
    if (!this.hold) return;
    this.turn(true);
    this.hold = null;
    this.active = false;
    clearTimeout(this.leaving);
    this.leaving = window.setTimeout(() => { this.note.hidden = true; }, this.refused ? STAY : STAY / 4);
    this.redraw();
  }

  /** Say what follows a drag, or why it goes no further. */
  say({ words, refused }: Moved): void {
    clearTimeout(this.leaving);
    if (!this.active) this.leaving = window.setTimeout(() => { this.note.hidden = true; }, STAY);
    this.refused = refused;
    this.note.hidden = false;
    this.note.classList.toggle("refused", refused !== "");
    this.note.replaceChildren(...(words ? [make("strong", {}, words)] : []), ...(refused ? [make("span", {}, refused)] : []));
    const frame = this.place.getBoundingClientRect(), [x, y] = [this.now[0] - frame.left, this.now[1] - frame.top];
    const left = Math.min(Math.max(x + 16, 4), frame.width - this.note.offsetWidth - 4), below = y + 20 + this.note.offsetHeight < frame.height;
    Object.assign(this.note.style, { left: `${left}px`, top: `${below ? y + 20 : Math.max(y - 20 - this.note.offsetHeight, 4)}px` });
  }

  /** Where the part would be that goes no further. */
  draw(c: CanvasRenderingContext2D, radius: number): void {
    if (!this.active || !this.refused) return;
    const frame = this.sheet.getBoundingClientRect(), scale = this.sheet.width / frame.width;
    c.save();
    c.strokeStyle = colour("--bad");
    c.lineWidth = 2 * scale;
    c.setLineDash([6 * scale, 4 * scale]);
    c.beginPath();
    c.arc((this.now[0] - frame.left) * scale, (this.now[1] - frame.top) * scale, radius, 0, 7);
    c.stroke();
    c.restore();
  }
}
