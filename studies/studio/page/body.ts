// The body that an array is laid on, as the picture shows it: its faces, what is chosen of them, places of microphones.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Group, type Intersection, Mesh, MeshBasicMaterial, MeshStandardMaterial, SphereGeometry, Vector3,
} from "three";
import { colour } from "./dom";
import { toScene } from "./dragging";

export interface Cone { towards: number[]; within: number; }
export interface Half { point: number[]; normal: number[]; }
/** What a design states of the region: all of it must hold. */
export interface RegionOfBody { faces: number[]; normal: Cone | null; above: Half[]; least_radius: number | null; }
export interface Wish { name: string; at: number[]; }
export interface Chosen { region: RegionOfBody; forbidden: number[]; microphones: Wish[]; }
/** A place on the body: its face, where it is and where it faces, mm. */
export interface Hit { face: number; at: number[]; normal: number[]; }

/** Colour of a body where nothing is chosen, as models have it. */
const PLAIN = "#c9c4ba";

/** The shape of a body as the studio sends it. */
export function shapeOf(content: ArrayBuffer): { corners: Float32Array; facets: Uint32Array; faces: Uint32Array } {
  const [corners, facets] = new Uint32Array(content, 0, 2), start = 8 + 12 * corners;
  return {
    corners: new Float32Array(content, 8, 3 * corners), facets: new Uint32Array(content, start, 3 * facets),
    faces: new Uint32Array(content, start + 12 * facets, facets),
  };
}

export class BodyView {
  readonly group = new Group();
  private mesh: Mesh<BufferGeometry, MeshStandardMaterial>;
  private normals: Float32Array;
  private middles: Float32Array;
  private areas: Float32Array;
  private marks: Mesh[] = [];
  constructor(private faces: Uint32Array, corners: Float32Array, facets: Uint32Array) {
    const count = facets.length / 3, places = new Float32Array(9 * count);
    this.normals = new Float32Array(3 * count);
    this.middles = new Float32Array(3 * count);
    this.areas = new Float32Array(count);
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    for (let k = 0; k < count; k++) {
      [a, b, c].forEach((each, n) => {
        each.fromArray(corners, 3 * facets[3 * k + n]);
        toScene(each.toArray()).toArray(places, 9 * k + 3 * n);
      });
      a.clone().add(b).add(c).divideScalar(3).toArray(this.middles, 3 * k);
      const across = b.clone().sub(a).cross(c.clone().sub(a));
      this.areas[k] = across.length() / 2;
      across.normalize().toArray(this.normals, 3 * k);
    }
    const shape = new BufferGeometry();
    shape.setAttribute("position", new BufferAttribute(places, 3));
    shape.setAttribute("color", new BufferAttribute(new Float32Array(9 * count), 3));
    shape.setAttribute("normal", new BufferAttribute(this.smooth(facets, corners.length / 3), 3));
    this.mesh = new Mesh(shape, new MeshStandardMaterial({ vertexColors: true, roughness: 0.7, transparent: true, side: DoubleSide }));
    this.mesh.renderOrder = -1; // behind the parts that stand on it
    this.group.add(this.mesh);
  }

  /** Normals at the corners of all facets: those of facets that meet at less than 35 degrees are one surface. */
  private smooth(facets: Uint32Array, corners: number): Float32Array {
    const starts = new Uint32Array(corners + 1), around = new Uint32Array(facets.length), found = new Float32Array(3 * facets.length);
    for (const corner of facets) starts[corner + 1]++;
    for (let k = 0; k < corners; k++) starts[k + 1] += starts[k];
    const next = starts.slice();
    facets.forEach((corner, k) => { around[next[corner]++] = Math.floor(k / 3); });
    const own = new Vector3(), other = new Vector3(), sum = new Vector3();
    facets.forEach((corner, k) => {
      own.fromArray(this.normals, 3 * Math.floor(k / 3));
      sum.set(0, 0, 0);
      for (let n = starts[corner]; n < starts[corner + 1]; n++) {
        other.fromArray(this.normals, 3 * around[n]);
        if (own.dot(other) > 0.82) sum.addScaledVector(other, this.areas[around[n]]);
      }
      toScene(sum.normalize().toArray()).normalize().toArray(found, 3 * k);
    });
    return found;
  }

  /** Facets that the region has; all conditions must hold. */
  private inside(region: RegionOfBody): (k: number) => boolean {
    const faces = new Set(region.faces), cone = region.normal, towards = cone ? new Vector3().fromArray(cone.towards).normalize() : null;
    const least = cone ? Math.cos((Math.PI * cone.within) / 180) : -1, own = new Vector3();
    const halves = region.above.map((each) => ({ point: new Vector3().fromArray(each.point), normal: new Vector3().fromArray(each.normal) }));
    return (k) => {
      if (faces.size && !faces.has(this.faces[k])) return false;
      if (towards && own.fromArray(this.normals, 3 * k).dot(towards) < least) return false;
      return halves.every((each) => own.fromArray(this.middles, 3 * k).sub(each.point).dot(each.normal) >= 0);
    };
  }

  /** Colour what is chosen, and how much of the surface that is. */
  paint(chosen: Chosen, seeThrough: boolean): number {
    const inside = this.inside(chosen.region), forbidden = new Set(chosen.forbidden);
    const [own, other, never] = [colour("--good"), PLAIN, colour("--bad")].map((name) => new Color(name));
    const colours = this.mesh.geometry.getAttribute("color");
    let area = 0, all = 0;
    for (let k = 0; k < this.areas.length; k++) {
      const taken = inside(k), shown = taken ? own : forbidden.has(this.faces[k]) ? never : other;
      all += this.areas[k];
      if (taken) area += this.areas[k];
      for (let n = 0; n < 3; n++) colours.setXYZ(3 * k + n, shown.r, shown.g, shown.b);
    }
    colours.needsUpdate = true;
    this.mesh.material.opacity = seeThrough ? 0.4 : 1;
    this.mesh.material.depthWrite = !seeThrough;
    this.mark(chosen.microphones);
    return area / all;
  }

  /** Places where microphones are wanted. */
  private mark(wishes: Wish[]): void {
    for (const each of this.marks) { each.removeFromParent(); each.geometry.dispose(); }
    const size = this.mesh.geometry.boundingSphere?.radius ?? (this.mesh.geometry.computeBoundingSphere(), this.mesh.geometry.boundingSphere!.radius);
    this.marks = wishes.map((each) => {
      const found = new Mesh(new SphereGeometry(0.03 * size, 16, 12), new MeshBasicMaterial({ color: colour("--ink") }));
      found.position.copy(toScene(each.at));
      found.name = each.name;
      this.group.add(found);
      return found;
    });
  }

  /** The facet that a ray has hit; null for a mark. */
  hit(found: Intersection): Hit | null {
    if (found.object !== this.mesh || found.faceIndex === undefined || found.faceIndex === null) return null;
    const { x, y, z } = found.point.clone().sub(this.group.position), k = found.faceIndex;
    return { face: this.faces[k], at: [1000 * x, -1000 * z, 1000 * y], normal: [...this.normals.subarray(3 * k, 3 * k + 3)] };
  }

  /** Free what it holds. */
  dispose(): void {
    this.group.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mark([]);
  }
}
