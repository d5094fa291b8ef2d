// The tray of snapshots: designs that were kept with a picture and their figures, and the project file that holds them.
import { button, byId, hand, make } from "./dom";
import { Parallel } from "./parallel";
import type { Word } from "./points";

export interface Snapshot { name: string; stated: any; picture: string; outcome: string; rows: [string, string][]; figures?: Record<string, number>; }
export interface Project { kind: string; stated: any; pinned: any; snapshots: Snapshot[]; notes: string; }
const KEPT = "acoustic-fem-snapshots", KIND = "acoustic-fem project 1", MOST = 24;

export class Snapshots {
  private all: Snapshot[] = [];
  private parallel = new Parallel((line) => this.open(this.all.find((each) => each.name === line.name)!.stated));
  constructor(private open: (stated: any) => void, private pin: (stated: any) => void, private take: () => Snapshot) {
    try {
      const kept = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
      this.all = kept.all ?? [];
      byId<HTMLTextAreaElement>("notes").value = kept.notes ?? "";
    } catch { /* a forbidden store: the tray lives as long as the page */ }
    byId("snapshot").addEventListener("click", () => this.add(this.take()));
    byId("notes").addEventListener("change", () => this.keep());
    this.draw();
  }

  /** Write a file with the design, the pinned one, all snapshots and the notes. */
  save(stated: any, pinned: any): void {
    const project: Project = { kind: KIND, stated, pinned, snapshots: this.all, notes: byId<HTMLTextAreaElement>("notes").value };
    hand(new Blob([JSON.stringify(project)], { type: "application/json" }), `${stated.name}.afem.json`);
  }

  /** The project in the text of a file, with its snapshots in the tray; an error where it is none. */
  read(text: string): Project {
    let found: Project | null = null;
    try { found = JSON.parse(text); } catch { /* as below */ }
    if (found?.kind !== KIND || typeof found.stated !== "object" || !Array.isArray(found.snapshots)) throw new Error("This is not a project file of this studio.");
    this.all = found.snapshots.slice(0, MOST);
    byId<HTMLTextAreaElement>("notes").value = String(found.notes ?? "");
    this.keep();
    this.draw();
    return found;
  }

  learn(words: Record<string, Word>): void { this.parallel.learn(words); this.compare(); }

  /** The figures of a design have come: a snapshot of it that was taken before gets them too. */
  figured(stated: any, figures: Record<string, number>): void {
    const text = JSON.stringify(stated), without = this.all.filter((each) => !each.figures && JSON.stringify(each.stated) === text);
    for (const each of without) each.figures = figures;
    if (without.length) this.keep();
    this.compare(figures);
  }

  restyle(): void { this.parallel.draw(); }

  private compare(now: Record<string, number> | null = null): void {
    this.parallel.take(this.all.filter((each) => each.figures).map((each) => ({ name: each.name, figures: each.figures! })), now);
  }

  private add(snapshot: Snapshot): void {
    const names = new Set(this.all.map((each) => each.name));
    let name = snapshot.name;
    for (let k = 2; names.has(name); k++) name = `${snapshot.name} (${k})`;
    this.all = [{ ...snapshot, name }, ...this.all].slice(0, MOST);
    this.keep();
    this.draw();
  }

  private keep(): void {
    try { localStorage.setItem(KEPT, JSON.stringify({ all: this.all, notes: byId<HTMLTextAreaElement>("notes").value })); } catch { /* as above */ }
  }

  private draw(): void {
    this.compare();
    byId("snapshots-empty").hidden = this.all.length > 0;
    byId("snapshots").replaceChildren(...this.all.map((each, k) => {
      const picture = make("canvas", { width: "150", height: "84", "aria-hidden": "true" }), image = new Image();
      image.addEventListener("load", () => picture.getContext("2d")!.drawImage(image, 0, 0, 150, 84));
      if (each.picture.startsWith("data:image/")) image.src = each.picture;
      const name = make("input", { type: "text", "aria-label": `name of snapshot ${k + 1}` });
      name.value = each.name;
      name.addEventListener("change", () => { each.name = name.value; this.keep(); this.compare(); });
      return make("li", {}, picture, make("div", {}, name, make("p", { class: "note" }, [each.outcome, ...each.rows.map(([title, value]) => `${title} ${value}`)].filter(Boolean).join(", ")),
        button("Open", () => this.open(each.stated), { "aria-label": `open ${each.name}` }), " ",
        button("Compare", () => this.pin(each.stated), { "aria-label": `compare with ${each.name}` }), " ",
        button("×", () => { this.all = this.all.filter((other) => other !== each); this.keep(); this.draw(); }, { "aria-label": `remove ${each.name}` })));
    }));
  }
}
