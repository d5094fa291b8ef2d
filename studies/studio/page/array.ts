// The Array panel: the project's own glTF, drawn when something changes and at no other time. What is shown is a copy
// on a flat canvas: a renderer in software would put together one in three dimensions anew for every picture of the page.
import {
  AmbientLight, Box3, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, type Intersection, Material, Mesh, MeshBasicMaterial,
  MeshStandardMaterial, Object3D, PerspectiveCamera, Plane, Quaternion, Raycaster, Scene, SphereGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { access } from "./access";
import type { BodyView, Hit } from "./body";
import { Dimensions, OUTSIDE } from "./dimensions";
import { byId, colour, hand, make, words } from "./dom";
import { Dragging, type Hold, type Moved, toScene } from "./dragging";

export interface Part { label: string; part: string; kind: string; group: string; }
export interface Model { file: string; parts: Part[]; size: number[]; notes: string[]; }
const KINDS: Record<string, string> = {
  shell: "shells", membrane: "membranes", sheath: "tube sheaths", spring: "tube springs", housing: "microphone housings",
  board: "boards", package: "microphones", base: "base plate", body: "body",
};
/** How far kinds are lifted in an exploded view, per height of the array. */
const LIFT: Record<string, number> = { membrane: 2.2, shell: 0, sheath: -1.2, spring: 1.1, housing: 0, board: 1.6, package: 3 };

/** Kinds of parts that are dragged, by what the readout says of them. */
const DRAGGED: Record<string, string> = {
  membrane: "drag it to move it", housing: "drag it to another place or side", board: "drag it to another place or side",
  package: "drag it to another place or side", sheath: "drag its end to change its length", spring: "drag its end to change its length",
};
/** What can be changed in the picture; null where it is only looked at. */
export interface Changes { drag: (message: object) => void; resize: (size: string, value: number | string) => void; }
/** A body that is chosen from: what a click on it does, and what is said of a place. */
export interface Choosing { body: BodyView; alone: boolean; click: (hit: Hit) => void; words: (hit: Hit) => string; }
interface Home { position: Vector3; turn: Quaternion; }

export class ArrayPanel {
  private renderer: WebGLRenderer | null = null;
  private scene = new Scene();
  private camera = new PerspectiveCamera(35, 1, 0.0005, 20);
  private controls: OrbitControls | null = null;
  private model = new Group();
  private parts = new Map<string, Part>();
  private home = new Map<Object3D, Home>();
  private hidden = new Set<string>();
  private marks: Mesh[] = [];
  private dimensions: Dimensions;
  private dragging: Dragging | null = null;
  /** Where the parts are that were dragged, until the array is drawn anew. */
  private moved: Moved | null = null;
  /** The array as it is built, however its parts are lifted: to its corners, not to boxes of its turned parts. */
  private extent = new Box3();
  private fittedTo = 0;
  private fittedAt = new Vector3();
  /** The designer has chosen how the array is seen. */
  private turned = false;
  private cut = new Plane(new Vector3(0, 0, -1), 0);
  private lit: (part: Part) => boolean = () => false;
  private choosing: Choosing | null = null;
  private sheet = make("canvas", { tabindex: "0", role: "img", "aria-label": "the array in three dimensions; arrow keys turn it, plus and minus zoom" });
  /** What was drawn last, without what is touched: fetched from a renderer in software it takes a tenth of a second. */
  private still = make("canvas");
  private touched: number | null = null;
  private pointed: number | null = null;
  /** The colours of the membranes are newer than the still picture; the timer draws it anew. */
  private recoloured = false;
  private later = 0;
  private asked = false;
  private inSight = false;
  private owed = false;
  private size: number[] = [0, 0, 0];

  constructor(private place: HTMLElement, private colourOf: (point: number) => string,
    private choose: (point: number | null, second: boolean, reached: (reach: number) => number | null) => void, private hover: (point: number | null) => void, changes: Changes | null) {
    this.dimensions = new Dimensions(place, changes?.resize ?? null, () => this.ask());
    try {
      this.renderer = new WebGLRenderer({ antialias: true });
    } catch {
      place.append(make("p", { class: "problem" }, "This browser draws nothing in three dimensions (WebGL is off)."));
      return;
    }
    const canvas = this.sheet;
    place.prepend(canvas);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.localClippingEnabled = true;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.ask());
    this.controls.addEventListener("start", () => { this.turned = true; });
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(0.4, 1, 0.7);
    this.scene.add(new HemisphereLight(0xffffff, 0x8a929c, 1.6), new AmbientLight(0xffffff, 0.35), sun, this.model);
    new ResizeObserver(() => this.fit()).observe(place);
    // A picture that nobody sees costs what one costs that is seen: without a graphics card, a tenth of a second.
    new IntersectionObserver((entries) => {
      this.inSight = entries.at(-1)!.isIntersecting;
      if (this.inSight && this.owed) this.ask();
    }).observe(place);
    if (changes) {
      const turn = (on: boolean) => { this.controls!.enabled = on; };
      this.dragging = new Dragging(place, canvas, this.camera, () => this.model.position, (event) => this.hold(event), turn, changes.drag, () => this.copy());
    }
    let down = [0, 0];
    canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointermove", (event) => { if (!event.buttons) this.name(event); });
    canvas.addEventListener("pointerleave", () => this.hover(null));
    canvas.addEventListener("click", (event) => {
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) >= 5) return;
      const place = this.onBody(event);
      if (place) this.choosing!.click(place);
      else this.choose(this.pointOf(this.under(event)?.part ?? null), event.shiftKey, (reach) => this.reached(event, reach));
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
    for (const id of ["exploded", "section"]) byId(id).addEventListener("input", () => this.arrange());
    byId("dimensions").addEventListener("change", () => { this.arrange(); this.see(); });
    byId("refit").addEventListener("click", () => this.see());
  }

  /** True while a part is dragged: what is drawn of an earlier place would take it out of the hand. */
  get isDragged(): boolean { return this.dragging?.active ?? false; }

  /** True while parts are shown where they were dragged, ahead of the model. */
  get isMoved(): boolean { return this.moved !== null; }

  async take(model: Model, revision: number): Promise<void> {
    byId("array-note").textContent = model.notes.join(" ");
    if (!this.renderer) return;
    const answer = await fetch(model.file, { headers: access() });
    if (!answer.ok) throw new Error(`${model.file}: ${answer.status}`);
    const found = await new GLTFLoader().parseAsync(await answer.arrayBuffer(), "");
    if (this.moved && revision < this.moved.revision) return; // it would take the parts back
    if (this.moved?.revision === revision) this.model.position.add(toScene(this.moved.shift));
    if (this.choosing) this.model.position.set(0, 0, 0); // an array stands where its body is
    this.moved = null;
    this.clear();
    this.parts = new Map(model.parts.map((part) => [part.label, part]));
    this.size = model.size;
    this.model.add(found.scene);
    this.home.clear();
    found.scene.traverse((each) => {
      if (this.parts.has(each.name)) this.home.set(each, { position: each.position.clone(), turn: each.quaternion.clone() });
      if (!(each instanceof Mesh)) return;
      const material = (each.material as MeshStandardMaterial).clone();
      material.userData = { colour: material.color.clone(), opacity: material.opacity };
      each.material = material;
    });
    // Sizes leave out the heads of boards; the rest of a board lies in the seat of its housing.
    this.model.updateMatrixWorld(true);
    this.extent.makeEmpty();
    for (const node of this.home.keys()) if (!["board", "body"].includes(this.parts.get(node.name)!.kind)) this.extent.expandByObject(node, true);
    this.switches(model.parts);
    // The camera stays where the designer put it, unless the array has grown, shrunk or gone elsewhere.
    const extent = Math.hypot(...model.size), away = 1000 * this.extent.getCenter(new Vector3()).distanceTo(this.fittedAt);
    this.arrange();
    if (Math.abs(Math.log(extent / (this.fittedTo || 1))) > 0.08 || away > 0.2 * extent) this.see();
  }

  /** Show a body to choose from, or no longer. */
  offer(choosing: Choosing | null): void {
    if (!choosing && !this.choosing) return;
    const before = this.choosing, look = before?.body !== choosing?.body || before?.alone !== choosing?.alone;
    before?.body.group.removeFromParent();
    this.choosing = choosing;
    if (!this.renderer) return;
    if (choosing) this.scene.add(choosing.body.group);
    this.arrange();
    if (look) this.see();
  }

  /** The parts are where they were dragged; tubes are lines until they are drawn anew. */
  follow(moved: Moved): void {
    this.dragging?.say(moved);
    this.moved = moved.words || this.moved ? moved : null;
    this.arrange();
  }

  light(test: (part: Part) => boolean, places: { part: string; place: number[] | null }[] = []): void {
    this.lit = test;
    for (const mark of this.marks) { mark.removeFromParent(); mark.geometry.dispose(); }
    this.marks = [];
    for (const [node] of this.home) {
      for (const { part, place } of places) {
        if (!place || this.parts.get(node.name)?.part !== part) continue;
        const mark = new Mesh(new SphereGeometry(0.35, 12, 8), new MeshBasicMaterial({ color: colour("--bad"), depthTest: false, transparent: true }));
        mark.position.set(place[0], place[1], place[2]);
        mark.renderOrder = 5;
        node.add(mark);
        this.marks.push(mark);
      }
    }
    this.arrange();
  }

  /** A membrane is touched, or none: coloured on the picture that is there, within one picture of the page. */
  touch(point: number | null): void {
    this.touched = point;
    if (!this.inSight) this.owed = true;
    else if (!this.asked && this.renderer) this.copy();
  }

  /** The point that is pointed at anywhere. */
  point(point: number | null): void {
    if (point === this.pointed) return;
    this.pointed = point;
    if (this.inSight && !this.asked && this.renderer) this.copy();
  }

  /** The colours of the points have changed: filled on the picture that is there, then drawn in three dimensions. */
  recolour(): void {
    if (!this.home.size) return;
    if (!this.inSight || this.asked || !this.renderer) return this.arrange();
    this.recoloured = true;
    this.copy();
    window.clearTimeout(this.later);
    this.later = window.setTimeout(() => this.arrange(), 150);
  }

  /** A small picture of the array as it is shown, as an address that holds it; empty where nothing is drawn yet. */
  thumbnail(): string {
    if (!this.renderer || !this.fittedTo) return "";
    const { width, height } = this.still, small = make("canvas", { width: "300", height: "168" }), c = small.getContext("2d")!;
    c.fillStyle = colour("--card");
    c.fillRect(0, 0, 300, 168);
    const scale = Math.min(300 / width, 168 / height);
    c.drawImage(this.still, (300 - scale * width) / 2, (168 - scale * height) / 2, scale * width, scale * height);
    return small.toDataURL("image/jpeg", 0.7);
  }

  picture(name: string): void {
    this.draw();
    this.copy(true); // the numbers of dimension lines are not on the canvas
    this.sheet.toBlob((blob) => blob && hand(blob, `${name}-array.png`));
  }

  restyle(): void { if (this.home.size) this.arrange(); else this.ask(); }

  private switches(parts: Part[]): void {
    const place = byId("kinds");
    const there = new Set(parts.map((part) => part.kind)), kinds = [...Object.keys(KINDS).filter((kind) => there.delete(kind)), ...there];
    place.replaceChildren(...kinds.map((kind) => {
      const box = make("input", { type: "checkbox" });
      box.checked = !this.hidden.has(kind);
      box.addEventListener("change", () => { if (box.checked) this.hidden.delete(kind); else this.hidden.add(kind); this.arrange(); });
      return make("label", {}, box, ` ${KINDS[kind] ?? kind} (${parts.filter((part) => part.kind === kind).length})`);
    }));
  }

  private arrange(): void {
    const away = Number(byId<HTMLInputElement>("exploded").value) / 100, height = Math.max(this.size[2], 1) / 1000;
    const share = Number(byId<HTMLInputElement>("section").value) / 100;
    const bounds = this.extent;
    this.cut.constant = bounds.isEmpty() ? 1e3 : bounds.max.z - share * (bounds.max.z - bounds.min.z) + (share === 0 ? 1 : 0);
    const accent = new Color(colour("--accent"));
    const carried = this.carried();
    for (const [node, { position, turn }] of this.home) {
      const part = this.parts.get(node.name)!, carry = carried.get(part.group);
      node.visible = !this.hidden.has(part.kind) && !(this.choosing && (this.choosing.alone || part.kind === "body")) && !(this.moved && part.group.startsWith("tube "));
      node.position.copy(position);
      node.quaternion.copy(turn);
      if (carry) {
        node.position.sub(carry.from).applyQuaternion(carry.turn).add(carry.to);
        node.quaternion.premultiply(carry.turn);
      }
      node.position.y += away * (LIFT[part.kind] ?? 0) * height;
      const lit = this.lit(part), point = part.kind === "membrane" ? this.pointOf(part) : null;
      const own = point === null ? null : new Color(this.colourOf(point));
      node.traverse((each) => {
        if (!(each instanceof Mesh) || this.marks.includes(each)) return;
        const material = each.material as MeshStandardMaterial;
        material.clippingPlanes = share === 0 ? [] : [this.cut];
        material.color.copy(lit ? accent : own ?? material.userData.colour);
        material.emissive.copy(lit ? accent : new Color(0));
        material.emissiveIntensity = lit ? 0.5 : 0;
        material.opacity = lit || own ? 1 : material.userData.opacity;
      });
    }
    this.measure();
    const [x, y, z] = this.size;
    if (x) byId("size").textContent = `${words(Math.max(x, y))} × ${words(Math.min(x, y))} × ${words(z)} mm`;
    this.ask();
  }

  /** Where parts that were dragged are carried from and to, by their group. */
  private carried(): Map<string, { from: Vector3; to: Vector3; turn: Quaternion }> {
    const found = new Map<string, { from: Vector3; to: Vector3; turn: Quaternion }>();
    if (!this.moved) return found;
    for (const [node, { position, turn }] of this.home) {
      const { kind, group } = this.parts.get(node.name)!, number = this.pointOf(this.parts.get(node.name)!);
      const place = kind === "shell" && number ? this.moved.points[number - 1] : kind === "housing" ? this.moved.microphones[group.replace("microphone ", "")] : undefined;
      if (!place) continue;
      const before = new Vector3(0, 0, 1).applyQuaternion(turn), after = toScene(place.slice(3)).normalize();
      found.set(group, { from: position, to: toScene(place), turn: new Quaternion().setFromUnitVectors(before, after) });
    }
    return found;
  }

  /** Dimension lines along three edges of the array as it is built, and between its first two points, mm. */
  private measure(): void {
    const { min, max } = this.extent, [x, y, z] = this.size;
    if (!byId<HTMLInputElement>("dimensions").checked || this.extent.isEmpty() || this.moved || this.choosing?.alone) return this.dimensions.measure([], this.extent.min);
    this.place.dataset.measured = [max.x - min.x, max.z - min.z, max.y - min.y].map((each) => words(1000 * each, 3)).join(" ");
    const at = (x: number, y: number, z: number) => new Vector3(x, y, z), ends = [min, max];
    /** The four edges of the box along an axis, by the two other coordinates of each. */
    const edges = (edge: (a: Vector3, b: Vector3) => [Vector3, Vector3]) => ends.flatMap((a) => ends.map((b) => edge(a, b)));
    const spans = [
      { size: "x", title: "length along x", edges: edges((a, b) => [at(min.x, a.y, b.z), at(max.x, a.y, b.z)]), value: x },
      { size: "y", title: "length along y", edges: edges((a, b) => [at(a.x, b.y, min.z), at(a.x, b.y, max.z)]), value: y },
      { size: "z", title: "height", edges: edges((a, b) => [at(a.x, min.y, b.z), at(a.x, max.y, b.z)]), value: z },
    ];
    const [first, second] = [1, 2].map((number) => [...this.home].find(([node]) => { const part = this.parts.get(node.name)!; return part.kind === "membrane" && part.group === `point ${number}`; }));
    if (first && second) {
      const [from, to] = [first, second].map(([, home]) => home.position.clone().add(this.model.position));
      spans.push({ size: "pitch", title: "pitch, from point 1 to point 2", edges: [[from, to]], value: 1000 * from.distanceTo(to) });
    }
    this.dimensions.measure(spans, this.extent.getCenter(new Vector3()));
  }

  /** What the dimension line of a size says of a number that is not allowed. */
  refuseSize(size: string): void { this.dimensions.refuse(size); }

  private see(): void {
    const bounds = new Box3().setFromObject(this.choosing?.alone ? this.choosing.body.group : this.model);
    if (this.choosing) bounds.expandByObject(this.choosing.body.group);
    if (bounds.isEmpty() || !this.controls) return;
    const middle = bounds.getCenter(new Vector3()), size = bounds.getSize(new Vector3());
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    // The lines are outside, and as wide on a narrow screen as on any other.
    const outside = byId<HTMLInputElement>("dimensions").checked ? OUTSIDE : [0, 0];
    const [across, up] = [this.place.clientWidth, this.place.clientHeight].map((each, k) => 1.12 * each / Math.max(each - 2 * outside[k], each / 3));
    const away = Math.max(across * size.x / (2 * tangent * this.camera.aspect), up * (size.z * 0.75 + size.y) / (2 * tangent)) + size.z / 3;
    this.camera.position.copy(middle).add(new Vector3(0, 0.78, 0.62).normalize().multiplyScalar(away));
    this.controls.target.copy(middle);
    this.controls.update();
    this.fittedTo = Math.hypot(...this.size);
    this.extent.getCenter(this.fittedAt);
    this.turned = false;
    this.ask();
  }

  private fit(): void {
    const width = this.place.clientWidth, height = this.place.clientHeight;
    if (!this.renderer || width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const { width: wide, height: tall } = this.renderer.domElement;
    for (const each of [this.sheet, this.still]) Object.assign(each, { width: wide, height: tall });
    Object.assign(this.sheet.style, { width: `${width}px`, height: `${height}px` });
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.turned || this.moved) this.ask();
    else this.see();
  }

  private ask(): void {
    this.owed = !this.inSight;
    if (this.asked || this.owed) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.draw(); });
  }

  private draw(): void {
    if (!this.renderer) return;
    this.renderer.setClearColor(new Color(colour("--card")));
    this.renderer.render(this.scene, this.camera);
    flat(this.still).drawImage(this.renderer.domElement, 0, 0);
    this.recoloured = false;
    this.copy();
    document.documentElement.dataset.drawn = String(Number(document.documentElement.dataset.drawn ?? 0) + 1);
  }

  private copy(withNumbers = false): void {
    const c = flat(this.sheet);
    c.drawImage(this.still, 0, 0);
    for (const [node] of this.home) {
      const part = this.parts.get(node.name)!;
      if (part.kind !== "membrane" || !node.visible) continue;
      if (this.recoloured) this.fill(c, node, this.colourOf(this.pointOf(part)!));
      if (part.group === `point ${this.touched}`) this.fill(c, node, colour("--accent"));
      else if (part.group === `point ${this.pointed}`) this.fill(c, node, colour("--accent"), 0.6);
    }
    document.documentElement.dataset.coloured = String(Number(document.documentElement.dataset.coloured ?? 0) + Number(this.recoloured));
    if (this.moved) this.trace(c, this.moved);
    this.dimensions.draw(c, this.camera, withNumbers);
    this.dragging?.draw(c, 14 * (this.sheet.width / this.place.clientWidth));
  }

  /** The courses of tubes that are drawn anew soon. */
  private trace(c: CanvasRenderingContext2D, moved: Moved): void {
    c.save();
    c.strokeStyle = colour("--ink-soft");
    c.lineWidth = 2.5 * (this.sheet.width / this.place.clientWidth);
    c.beginPath();
    for (const course of moved.tubes) {
      course.forEach((point, k) => {
        const { x, y } = toScene(point).add(this.model.position).project(this.camera), at: [number, number] = [(0.5 + 0.5 * x) * this.sheet.width, (0.5 - 0.5 * y) * this.sheet.height];
        if (k) c.lineTo(...at); else c.moveTo(...at);
      });
    }
    c.stroke();
    c.restore();
  }

  /** Colour a part as the eye sees it, without what hides it. */
  private fill(c: CanvasRenderingContext2D, part: Object3D, style: string, opacity = 1): void {
    c.beginPath();
    part.traverse((each) => {
      if (!(each instanceof Mesh)) return;
      const { index, attributes: { position } } = each.geometry as BufferGeometry, corners = index?.count ?? position.count;
      for (let k = 0; k < corners; k += 3) {
        const at = [0, 1, 2].map((n) => new Vector3().fromBufferAttribute(position, index ? index.getX(k + n) : k + n).applyMatrix4(each.matrixWorld));
        if (at.some((corner) => this.cut.distanceToPoint(corner) < 0)) continue;
        const seen = at.map((corner) => corner.project(this.camera)).map(({ x, y }) => [(0.5 + 0.5 * x) * this.sheet.width, (0.5 - 0.5 * y) * this.sheet.height]);
        const [[x0, y0], [x1, y1], [x2, y2]] = seen; // all the same way round: the far side of the part makes no holes
        if ((x1 - x0) * (y2 - y0) < (x2 - x0) * (y1 - y0)) seen.reverse();
        c.moveTo(seen[0][0], seen[0][1]);
        c.lineTo(seen[1][0], seen[1][1]);
        c.lineTo(seen[2][0], seen[2][1]);
      }
    });
    c.fillStyle = style;
    c.globalAlpha = opacity;
    c.fill();
    c.globalAlpha = 1;
  }

  private ray(event: MouseEvent): Raycaster {
    const frame = this.sheet.getBoundingClientRect();
    const at = new Vector2((2 * (event.clientX - frame.left)) / frame.width - 1, 1 - (2 * (event.clientY - frame.top)) / frame.height);
    const ray = new Raycaster();
    this.camera.updateMatrixWorld(); // drawing brings all up to date, and the pointer may be earlier than the next picture
    this.scene.updateMatrixWorld();
    ray.setFromCamera(at, this.camera);
    return ray;
  }

  /** Parts under the pointer that are shown, the nearest first. */
  private *hits(event: MouseEvent): Generator<{ part: Part; hit: Intersection }> {
    for (const hit of this.ray(event).intersectObject(this.model, true)) {
      let node: Object3D | null = hit.object;
      while (node && !this.parts.has(node.name)) node = node.parent;
      const part = node && this.parts.get(node.name);
      if (node?.visible && part) yield { part, hit };
    }
  }

  private under(event: MouseEvent): { part: Part; hit: Intersection } | null {
    for (const found of this.hits(event)) if (found.part.kind !== "body") return found; // one looks through the body
    return null;
  }

  /** The point that a finger touches at the pointer, which reaches so far from there, mm: its membrane is the nearest. */
  private reached(event: MouseEvent, reach: number): number | null {
    const { value: first } = this.hits(event).next(), own = first && this.pointOf(first.part);
    if (!first || own) return own ?? null;
    const away = ([node]: [Object3D, Home]) => 1000 * (node.getWorldPosition(new Vector3()).distanceTo(first.hit.point) - this.radiusOf(node));
    const membranes = [...this.home].filter(([node]) => this.parts.get(node.name)!.kind === "membrane");
    const nearest = membranes.reduce((best, each) => (away(each) < away(best) ? each : best));
    return away(nearest) <= reach ? this.pointOf(this.parts.get(nearest[0].name)!) : null;
  }

  private radiusOf(membrane: Object3D): number {
    const size = new Box3().setFromObject(membrane, true).getSize(new Vector3());
    return Math.max(size.x, size.y, size.z) / 2;
  }

  /** The place of the body under the pointer that is chosen from, unless a part is in front of it. */
  private onBody(event: MouseEvent): Hit | null {
    if (!this.choosing) return null;
    const [first] = this.ray(event).intersectObject(this.choosing.body.group, true), part = this.under(event);
    return first && !(part && part.hit.distance < first.distance) ? this.choosing.body.hit(first) : null;
  }

  /** The part under the pointer, if it can be dragged; it moves across the normal of the membrane that is nearest to it. */
  private hold(event: MouseEvent): Hold | null {
    const found = this.under(event);
    if (!found || !DRAGGED[found.part.kind]) return null;
    const at = found.hit.point, away = (node: Object3D) => node.getWorldPosition(new Vector3()).distanceTo(at);
    const membranes = [...this.home.keys()].filter((node) => this.parts.get(node.name)!.kind === "membrane");
    const nearest = membranes.reduce((best, node) => (away(node) < away(best) ? node : best));
    return { group: found.part.group, at, normal: new Vector3(0, 0, 1).applyQuaternion(nearest.quaternion) };
  }

  private pointOf(part: Part | null): number | null {
    const found = part?.group.match(/^point (\d+)$/);
    return found ? Number(found[1]) : null;
  }

  private name(event: MouseEvent): void {
    const place = this.onBody(event);
    if (place) {
      byId("pointed-part").textContent = `\u00b7 ${this.choosing!.words(place)}`;
      this.sheet.style.cursor = "pointer";
      return this.hover(null);
    }
    const part = this.under(event)?.part ?? null, movable = part && this.dragging && byId<HTMLInputElement>("movable").checked ? DRAGGED[part.kind] : undefined;
    byId("pointed-part").textContent = part ? "\u00b7 " + part.label.replaceAll("_", " ") + (movable ? `: ${movable}` : "") : "\u00a0";
    this.sheet.style.cursor = movable ? "move" : "grab";
    this.hover(this.pointOf(part));
  }

  private key(event: KeyboardEvent): void {
    const turn: Record<string, [number, number]> = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    const zoom = event.key === "+" ? 0.9 : event.key === "-" ? 1.1 : 1;
    const by = turn[event.key] ?? [0, 0];
    if (zoom === 1 && !by[0] && !by[1]) return;
    event.preventDefault();
    const from = this.camera.position.clone().sub(this.controls!.target);
    const length = from.length() * zoom, up = Math.acos(from.y / from.length()) + by[1], around = Math.atan2(from.x, from.z) + by[0];
    this.turned = true;
    const polar = Math.min(Math.max(up, 0.02), 3.1);
    this.camera.position.copy(this.controls!.target).add(new Vector3(
      length * Math.sin(polar) * Math.sin(around), length * Math.cos(polar), length * Math.sin(polar) * Math.cos(around),
    ));
    this.controls!.update();
    this.ask();
  }

  private clear(): void {
    this.model.traverse((each) => {
      if (each instanceof Mesh) { each.geometry.dispose(); (each.material as Material).dispose(); }
    });
    this.model.clear();
    this.marks = [];
  }
}

/** Drawn by the processor: see the curves. */
function flat(canvas: HTMLCanvasElement): CanvasRenderingContext2D { return canvas.getContext("2d", { willReadFrequently: true })!; }
