// The Array panel: the project's own glTF, drawn when something changes and at no other time. What is shown is a copy
// on a flat canvas: a renderer in software would put together one in three dimensions anew for every picture of the page.
import {
  AmbientLight, Box3, BufferGeometry, CanvasTexture, Color, DirectionalLight, Group, HemisphereLight, LineBasicMaterial, LineSegments,
  Material, Mesh, MeshBasicMaterial, MeshStandardMaterial, Object3D, PerspectiveCamera, Plane, Raycaster, Scene, SphereGeometry, Sprite,
  SpriteMaterial, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { access } from "./access";
import { byId, colour, hand, make, words } from "./dom";

export interface Part { label: string; part: string; kind: string; group: string; }
export interface Model { file: string; parts: Part[]; size: number[]; notes: string[]; }
const KINDS: Record<string, string> = {
  shell: "shells", membrane: "membranes", sheath: "tube sheaths", spring: "tube springs", housing: "microphone housings",
  board: "boards", package: "microphones",
};
/** How far kinds are lifted in an exploded view, per height of the array. */
const LIFT: Record<string, number> = { membrane: 2.2, shell: 0, sheath: -1.2, spring: 1.1, housing: 0, board: 1.6, package: 3 };

/** Width of the text of a dimension line, of the distance at which the eye sees its own height as 0.63. */
const LABEL = 0.14;

export class ArrayPanel {
  private renderer: WebGLRenderer | null = null;
  private scene = new Scene();
  private camera = new PerspectiveCamera(35, 1, 0.0005, 20);
  private controls: OrbitControls | null = null;
  private model = new Group();
  private parts = new Map<string, Part>();
  private home = new Map<Object3D, number>();
  private hidden = new Set<string>();
  private marks: Mesh[] = [];
  private lines = new Group();
  private texts = new Group();
  /** The array as it is built, however its parts are lifted: to its corners, not to boxes of its turned parts. */
  private extent = new Box3();
  private fittedTo = 0;
  private cut = new Plane(new Vector3(0, 0, -1), 0);
  private lit: (part: Part) => boolean = () => false;
  private sheet = make("canvas", { tabindex: "0", role: "img", "aria-label": "the array in three dimensions; arrow keys turn it, plus and minus zoom" });
  /** What was drawn last, without what is touched: fetched from a renderer in software it takes a tenth of a second. */
  private still = make("canvas");
  private touched: number | null = null;
  private pointed: number | null = null;
  private asked = false;
  private inSight = false;
  private owed = false;
  private size: number[] = [0, 0, 0];

  constructor(private place: HTMLElement, private colourOf: (point: number) => string,
    private choose: (point: number | null, second: boolean) => void, private hover: (point: number | null) => void) {
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
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(0.4, 1, 0.7);
    this.scene.add(new HemisphereLight(0xffffff, 0x8a929c, 1.6), new AmbientLight(0xffffff, 0.35), sun, this.model, this.lines, this.texts);
    new ResizeObserver(() => this.fit()).observe(place);
    // A picture that nobody sees costs what one costs that is seen: without a graphics card, a tenth of a second.
    new IntersectionObserver((entries) => {
      this.inSight = entries.at(-1)!.isIntersecting;
      if (this.inSight && this.owed) this.ask();
    }).observe(place);
    let down = [0, 0];
    canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointermove", (event) => { if (!event.buttons) this.name(event); });
    canvas.addEventListener("pointerleave", () => this.hover(null));
    canvas.addEventListener("click", (event) => {
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 5) this.choose(this.pointOf(this.under(event)), event.shiftKey);
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
    for (const id of ["exploded", "section"]) byId(id).addEventListener("input", () => this.arrange());
    byId("dimensions").addEventListener("change", () => { this.arrange(); this.see(); });
    byId("refit").addEventListener("click", () => this.see());
  }

  async take(model: Model): Promise<void> {
    byId("array-note").textContent = model.notes.join(" ");
    if (!this.renderer) return;
    const answer = await fetch(model.file, { headers: access() });
    if (!answer.ok) throw new Error(`${model.file}: ${answer.status}`);
    const found = await new GLTFLoader().parseAsync(await answer.arrayBuffer(), "");
    this.clear();
    this.parts = new Map(model.parts.map((part) => [part.label, part]));
    this.size = model.size;
    this.model.add(found.scene);
    this.home.clear();
    found.scene.traverse((each) => {
      if (this.parts.has(each.name)) this.home.set(each, each.position.y);
      if (!(each instanceof Mesh)) return;
      const material = (each.material as MeshStandardMaterial).clone();
      material.userData = { colour: material.color.clone(), opacity: material.opacity };
      each.material = material;
    });
    this.extent.setFromObject(this.model, true);
    this.switches(model.parts);
    // The camera stays where the designer put it, unless the array has grown or shrunk.
    const extent = Math.hypot(...model.size);
    this.arrange();
    if (Math.abs(Math.log(extent / (this.fittedTo || 1))) > 0.08) this.see();
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

  /** The colours of the points have changed. */
  recolour(): void { if (this.home.size) this.arrange(); }

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
    this.sheet.toBlob((blob) => blob && hand(blob, `${name}-array.png`));
  }

  restyle(): void { if (this.home.size) this.arrange(); else this.ask(); }

  private switches(parts: Part[]): void {
    const place = byId("kinds");
    const kinds = Object.keys(KINDS).filter((kind) => parts.some((part) => part.kind === kind));
    place.replaceChildren(...kinds.map((kind) => {
      const box = make("input", { type: "checkbox" });
      box.checked = !this.hidden.has(kind);
      box.addEventListener("change", () => { if (box.checked) this.hidden.delete(kind); else this.hidden.add(kind); this.arrange(); });
      return make("label", {}, box, ` ${KINDS[kind]} (${parts.filter((part) => part.kind === kind).length})`);
    }));
  }

  private arrange(): void {
    const away = Number(byId<HTMLInputElement>("exploded").value) / 100, height = Math.max(this.size[2], 1) / 1000;
    const share = Number(byId<HTMLInputElement>("section").value) / 100;
    const bounds = this.extent;
    this.cut.constant = bounds.isEmpty() ? 1e3 : bounds.max.z - share * (bounds.max.z - bounds.min.z) + (share === 0 ? 1 : 0);
    const accent = new Color(colour("--accent"));
    for (const [node, y] of this.home) {
      const part = this.parts.get(node.name)!;
      node.visible = !this.hidden.has(part.kind);
      node.position.y = y + away * (LIFT[part.kind] ?? 0) * height;
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
    for (const each of [...this.lines.children, ...this.texts.children] as (LineSegments | Sprite)[]) {
      if (each instanceof Sprite) each.material.map?.dispose();
      else each.geometry.dispose();
      (each.material as Material).dispose();
    }
    this.lines.clear();
    this.texts.clear();
    if (byId<HTMLInputElement>("dimensions").checked && !bounds.isEmpty()) this.measure(bounds);
    const [x, y, z] = this.size;
    if (x) byId("size").textContent = `${words(Math.max(x, y))} × ${words(Math.min(x, y))} × ${words(z)} mm`;
    this.ask();
  }

  /** Dimension lines along three edges of the array as it is shown, with what they measure, mm. */
  private measure(box: Box3): void {
    const { min, max } = box;
    this.place.dataset.measured = [max.x - min.x, max.z - min.z, max.y - min.y].map((each) => words(1000 * each, 3)).join(" ");
    const off = 0.06 * Math.max(max.x - min.x, max.z - min.z), tick = off / 4, ink = new Color(colour("--ink-soft"));
    const draw = (from: Vector3, to: Vector3, across: Vector3) => {
      const side = across.clone().setLength(tick), at = [from, to];
      for (const end of [from, to]) at.push(end.clone().sub(side), end.clone().add(side));
      this.lines.add(new LineSegments(new BufferGeometry().setFromPoints(at), new LineBasicMaterial({ color: ink })));
      const label = sprite(`${words(from.distanceTo(to) * 1000, 3)} mm`, colour("--ink"));
      label.position.copy(from).add(to).multiplyScalar(0.5).add(across.clone().setLength(off));
      this.texts.add(label);
    };
    const x = new Vector3(1, 0, 0), z = new Vector3(0, 0, 1);
    draw(new Vector3(min.x, min.y, max.z + off), new Vector3(max.x, min.y, max.z + off), z);
    draw(new Vector3(max.x + off, min.y, min.z), new Vector3(max.x + off, min.y, max.z), x);
    draw(new Vector3(max.x + off, min.y, min.z), new Vector3(max.x + off, max.y, min.z), x);
  }

  private see(): void {
    const bounds = new Box3().setFromObject(this.model);
    bounds.union(new Box3().setFromObject(this.lines));
    if (bounds.isEmpty() || !this.controls) return;
    const middle = bounds.getCenter(new Vector3()), size = bounds.getSize(new Vector3());
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const away = Math.max(size.x / (2 * tangent * this.camera.aspect), (size.z * 0.75 + size.y) / (2 * tangent)) * 1.12 + size.z / 3;
    this.camera.position.copy(middle).add(new Vector3(0, 0.78, 0.62).normalize().multiplyScalar(away));
    this.controls.target.copy(middle);
    this.controls.update();
    this.fittedTo = Math.hypot(...this.size);
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
    this.see();
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
    this.copy();
    document.documentElement.dataset.drawn = String(Number(document.documentElement.dataset.drawn ?? 0) + 1);
  }

  private copy(): void {
    const c = flat(this.sheet);
    c.drawImage(this.still, 0, 0);
    for (const [node] of this.home) {
      const part = this.parts.get(node.name)!;
      if (part.kind !== "membrane" || !node.visible) continue;
      if (part.group === `point ${this.touched}`) this.fill(c, node, 1);
      else if (part.group === `point ${this.pointed}`) this.fill(c, node, 0.6);
    }
  }

  /** Colour a part as the eye sees it, without what hides it. */
  private fill(c: CanvasRenderingContext2D, part: Object3D, opacity: number): void {
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
    c.fillStyle = colour("--accent");
    c.globalAlpha = opacity;
    c.fill();
    c.globalAlpha = 1;
  }

  private under(event: MouseEvent): Part | null {
    const frame = this.sheet.getBoundingClientRect();
    const at = new Vector2((2 * (event.clientX - frame.left)) / frame.width - 1, 1 - (2 * (event.clientY - frame.top)) / frame.height);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    for (const hit of ray.intersectObject(this.model, true)) {
      let node: Object3D | null = hit.object;
      while (node && !this.parts.has(node.name)) node = node.parent;
      if (node?.visible) return this.parts.get(node.name)!;
    }
    return null;
  }

  private pointOf(part: Part | null): number | null {
    const found = part?.group.match(/^point (\d+)$/);
    return found ? Number(found[1]) : null;
  }

  private name(event: MouseEvent): void {
    const part = this.under(event);
    byId("pointed-part").textContent = part ? part.label.replaceAll("_", " ") : "\u00a0";
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

/** A text that faces the eye. */
function sprite(text: string, ink: string): Sprite {
  const canvas = document.createElement("canvas"), c = canvas.getContext("2d")!;
  [canvas.width, canvas.height] = [256, 64];
  c.font = "40px system-ui";
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.fillStyle = ink;
  c.fillText(text, 128, 32, 250);
  const found = new Sprite(new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false, sizeAttenuation: false }));
  found.scale.set(LABEL, LABEL / 4, 1);
  return found;
}
