// The Body panel: the body that an array is laid on, what is chosen of it by clicks, and the fit.
import { access } from "./access";
import type { ArrayPanel } from "./array";
import { BodyView, type Chosen, type Hit, shapeOf } from "./body";
import { button, byId, make, words } from "./dom";
import { handIn } from "./handing";

/** What the studio says of a body; without a file it has none. */
interface Body { name: string; file: string | null; sha256: string; faces: number; size: number[]; findings: string[]; }
/** Endings of files of bodies. */
export const BODY_FILE = /\.(step|stp|stl|3mf|obj|ply)$/i;
const NUMBERS = ["pitch", "base", "edge", "port_step", "length_step", "seed"], CHOICES = ["seat", "tubes"];
/** What stands in the options of a design that is on no body. */
const USUAL: Record<string, any> = { unit: "mm", seat: "on", base: 0.4, edge: 0.4, port_step: 15, tubes: "as they lie", length_step: 0.5, seed: 0 };
/** Angle of a cone around the direction of a place that is clicked, degrees. */
const WITHIN = 60;

/** A number as it was typed; what is none stays the text, and the studio says what is allowed. */
function typed(id: string): number | string | null {
  const text = byId<HTMLInputElement>(id).value.replace("−", "-").replace(",", ".").trim();
  return text === "" ? null : Number.isFinite(Number(text)) ? Number(text) : text;
}

function place(at: number[], digits = 3): string { return `(${at.map((each) => words(each, digits)).join(", ")})`; }

export class FitPanel {
  private body: Body | null = null;
  private view: BodyView | null = null;
  private stated: any = null;
  private taken = "";
  private chosen: Chosen = { region: { faces: [], normal: null, above: [], least_radius: null }, forbidden: [], microphones: [] };
  private open = false;
  private asked = "";
  constructor(private array: ArrayPanel, private send: (message: object) => boolean, private session: () => string | null) {
    byId("body-file").addEventListener("change", (event) => {
      const input = event.target as HTMLInputElement, file = input.files?.[0];
      if (file) this.handIn(file);
      input.value = "";
    });
    for (const id of ["body-unit", "body-skin"]) byId(id).addEventListener("change", () => this.ask());
    byId("region-clear").addEventListener("click", () => this.choose({ region: { faces: [], normal: null, above: [], least_radius: null } }));
    byId("region-least").addEventListener("change", () => this.choose({ region: { ...this.chosen.region, least_radius: typed("region-least") as number | null } }));
    byId("region-faces").addEventListener("change", () => this.choose({ region: { ...this.chosen.region,
      faces: byId<HTMLInputElement>("region-faces").value.split(",").map(Number).filter((each) => Number.isInteger(each) && each > 0) } }));
    byId("fit-run").addEventListener("click", () => this.fit());
    byId("fit-stop").addEventListener("click", () => this.send({ do: "stop", stage: "fit" }));
    byId("fit-save").addEventListener("click", () => this.send({ do: "fitted-files" }));
  }

  /** The panel is opened, or another one. */
  opened(open: boolean): void {
    this.open = open;
    if (open && !this.asked) this.ask();
    this.show();
  }

  /** The link to a studio is new: it knows nothing of what was asked before. */
  begin(): void {
    this.asked = "";
    if (this.open) this.ask();
  }

  /** The design at hand. */
  take(stated: any): void {
    this.stated = stated;
    const surface = JSON.stringify(stated.surface ?? null);
    if (surface !== this.taken) {
      const other = JSON.parse(this.taken || "null")?.body !== stated.surface?.body;
      if (stated.surface || !this.taken) this.fill(stated.surface ?? {}); // what was chosen stays for a design on no body
      this.taken = surface;
      if (other) this.asked = "";
    }
    if (this.open && !this.asked) this.ask();
    this.clicks();
    this.report();
    this.show();
  }

  /** Hand in the file of a body. */
  async handIn(file: File): Promise<void> {
    this.problem("body", "");
    this.problem("fit", "");
    try {
      await handIn("/bodies", { session: this.session() ?? "", name: file.name }, file);
      this.ask();
    } catch (error) {
      this.problem("body", (error as Error).message);
    }
  }

  /** What the studio has read of the body. */
  async learn(found: Body): Promise<void> {
    this.body = found.file === null ? null : found;
    this.problem("body", "");
    byId("body-said").textContent = found.file === null
      ? found.name ? `Choose the file ${found.name}, which is not beside the design.` : "Choose the file of the body that the array is to lie on."
      : `${found.name}: ${found.size.map((each) => words(each)).join(" × ")} mm, ${found.faces > 1 ? `${found.faces} faces` : "one face"}. ${found.findings.join(". ")}`;
    this.drop();
    if (found.file !== null) await this.fetch(found.file);
    byId("region-card").hidden = byId("fit-card").hidden = this.view === null;
    byId<HTMLSelectElement>("body-click").value = ""; // that of the last body may not be among those of this one
    this.clicks();
    this.show();
    document.documentElement.dataset.body = found.file === null ? "" : found.name;
  }

  /** The body cannot be read; that before is no longer the one that a fit would take. */
  failed(): void {
    this.body = null;
    this.drop();
    byId("region-card").hidden = byId("fit-card").hidden = true;
    this.show();
  }

  /** How far the fit is; empty once it has ended. */
  progress(line: string): void {
    byId<HTMLButtonElement>("fit-run").disabled = line !== "";
    byId<HTMLButtonElement>("fit-stop").disabled = line === "";
    document.querySelector('[data-status="fit"]')!.textContent = line;
  }

  restyle(): void { this.show(); }

  private async fetch(address: string): Promise<void> {
    try {
      const answer = await fetch(address, { headers: access() });
      if (!answer.ok) throw new Error();
      const { corners, facets, faces } = shapeOf(await answer.arrayBuffer());
      if (this.body?.file === address) this.view = new BodyView(faces, corners, facets);
    } catch {
      this.problem("body", "The body could not be fetched from the studio. Choose its file again.");
    }
  }

  private drop(): void {
    this.array.offer(null);
    this.view?.dispose();
    this.view = null;
  }

  /** Have the body read, in the unit and of the skin that are given. */
  private ask(): void {
    this.asked = byId<HTMLSelectElement>("body-unit").value + byId<HTMLInputElement>("body-skin").value;
    this.problem("body", "");
    if (!this.send({ do: "body", unit: byId<HTMLSelectElement>("body-unit").value, skin: typed("body-skin") })) this.asked = "";
  }

  /** The options of a design stand in the fields. */
  private fill(surface: any): void {
    const value = (name: string) => surface[name] ?? USUAL[name] ?? "";
    byId<HTMLSelectElement>("body-unit").value = value("unit");
    byId<HTMLInputElement>("body-skin").value = String(value("skin"));
    for (const name of NUMBERS) byId<HTMLInputElement>(`fit-${name}`).value = String(value(name));
    for (const name of CHOICES) byId<HTMLSelectElement>(`fit-${name}`).value = value(name);
    byId<HTMLInputElement>("fit-points").value = surface.body && !surface.pitch ? this.stated.lines.map((line: any) => line.points).join(", ") : "";
    const region = surface.region ?? {};
    byId<HTMLInputElement>("region-least").value = String(region.least_radius ?? "");
    this.chosen = {
      region: { faces: region.faces ?? [], normal: region.normal ?? null, above: region.above ?? [], least_radius: region.least_radius ?? null },
      forbidden: surface.forbidden ?? [], microphones: surface.microphones ?? [],
    };
  }

  private choose(changed: Partial<Chosen>): void {
    this.chosen = { ...this.chosen, ...changed };
    if (changed.region && changed.region.least_radius === null) byId<HTMLInputElement>("region-least").value = "";
    this.show();
  }

  /** What a click may do: faces are chosen of a body that has several. */
  private clicks(): void {
    const choice = byId<HTMLSelectElement>("body-click"), before = choice.value, several = (this.body?.faces ?? 1) > 1;
    const offered: [string, string][] = [
      ...(several ? [["faces", "chooses its face"]] as [string, string][] : []), ["direction", "chooses what faces the same way"],
      ...(several ? [["forbidden", "forbids its face to microphones"]] as [string, string][] : []),
      ...(this.stated?.microphones ?? []).map((name: string) => [`microphone ${name}`, `places microphone ${name}`]),
    ];
    choice.replaceChildren(...offered.map(([value, title]) => make("option", { value }, title)));
    if (offered.some(([value]) => value === before)) choice.value = before;
  }

  private click(hit: Hit): void {
    const mode = byId<HTMLSelectElement>("body-click").value, { region, forbidden, microphones } = this.chosen;
    const toggled = (faces: number[]) => (faces.includes(hit.face) ? faces.filter((each) => each !== hit.face) : [...faces, hit.face].sort((a, b) => a - b));
    const rounded = (at: number[], unit: number) => at.map((each) => Math.round(each * unit) / unit);
    if (mode === "faces") this.choose({ region: { ...region, faces: toggled(region.faces) } });
    else if (mode === "forbidden") this.choose({ forbidden: toggled(forbidden) });
    else if (mode === "direction") this.choose({ region: { ...region, normal: { towards: rounded(hit.normal, 1e3), within: region.normal?.within ?? WITHIN } } });
    else {
      const name = mode.slice("microphone ".length);
      this.choose({ microphones: [...microphones.filter((each) => each.name !== name), { name, at: rounded(hit.at, 10) }].sort((a, b) => a.name.localeCompare(b.name)) });
    }
  }

  private words(hit: Hit): string {
    const mode = byId<HTMLSelectElement>("body-click").value, several = (this.body?.faces ?? 1) > 1;
    const what = { faces: this.chosen.region.faces.includes(hit.face) ? "click to leave it out" : "click to choose it", forbidden: this.chosen.forbidden.includes(hit.face) ? "click to allow microphones" : "click to forbid microphones",
      direction: "click to choose what faces the same way" }[mode] ?? `click to place ${mode}`;
    return `${several ? `face ${hit.face}` : "body"}: ${what}`;
  }

  /** The body with what is chosen, while the panel is open, and what is chosen in words. */
  private show(): void {
    const on = this.open && this.view !== null;
    if (!on) return this.array.offer(null);
    const alone = this.stated?.layout?.frozen?.body !== this.body!.sha256;
    const share = this.view!.paint(this.chosen, !alone);
    this.array.offer({ body: this.view!, alone, click: (hit) => this.click(hit), words: (hit) => this.words(hit) });
    const { region, forbidden, microphones } = this.chosen;
    byId("region-said").textContent = `${region.faces.length ? `Face${region.faces.length > 1 ? "s" : ""} ${region.faces.join(", ")}` : region.normal || region.above.length ? "All faces" : "The whole body"}${region.normal || region.above.length ? ", as far as the conditions below hold" : ""}: ${words(100 * share, 2)} % of the surface.`;
    byId<HTMLInputElement>("region-faces").value = region.faces.join(", ");
    byId("region-said").dataset.faces = region.faces.join(",");
    const remove = (act: () => void, label: string) => button("×", act, { "aria-label": `remove: ${label}` });
    const parts: HTMLElement[] = [];
    if (region.normal) {
      const within = make("input", { type: "text", id: "region-within", inputmode: "decimal", size: "4", value: String(region.normal.within), "aria-label": "largest angle, degrees" }), cone = region.normal;
      within.addEventListener("change", () => this.choose({ region: { ...region, normal: { ...cone, within: typed("region-within") as number ?? WITHIN } } }));
      parts.push(make("li", {}, "faces within ", within, `° of ${place(cone.towards)} `, remove(() => this.choose({ region: { ...region, normal: null } }), "the direction")));
    }
    region.above.forEach((each, k) => parts.push(make("li", {}, `above the plane at ${place(each.point)} towards ${place(each.normal)} `,
      remove(() => this.choose({ region: { ...region, above: region.above.filter((_, n) => n !== k) } }), `plane ${k + 1}`))));
    if (forbidden.length) parts.push(make("li", {}, `no microphones on face ${forbidden.join(", ")} `, remove(() => this.choose({ forbidden: [] }), "forbidden faces")));
    for (const each of microphones) parts.push(make("li", {}, `microphone ${each.name} near ${place(each.at)} mm `, remove(() => this.choose({ microphones: microphones.filter((other) => other !== each) }), `place of microphone ${each.name}`)));
    byId("region-parts").replaceChildren(...parts);
  }

  private fit(): void {
    this.problem("fit", "");
    const surface: Record<string, unknown> = { unit: byId<HTMLSelectElement>("body-unit").value, skin: typed("body-skin"), ...this.chosen };
    for (const name of NUMBERS) surface[name] = typed(`fit-${name}`) ?? USUAL[name] ?? null;
    for (const name of CHOICES) surface[name] = byId<HTMLSelectElement>(`fit-${name}`).value;
    const text = byId<HTMLInputElement>("fit-points").value.trim(), points = text === "" ? null : text.split(",").map((each) => Number(each));
    if (points?.some((each) => !Number.isInteger(each))) return this.problem("fit", `“${text}” must be a whole number for each line, with commas between them.`);
    if (!points && surface.pitch === null) return this.problem("fit", "Give a pitch, or the number of points.");
    if (this.send({ do: "fit", surface, points })) this.progress("begins");
  }

  /** Findings of the fit that the design at hand has; they are kept with its places. */
  private report(): void {
    const frozen = this.stated.layout?.frozen;
    byId("fit-save").hidden = !frozen;
    byId("fit-findings").replaceChildren(...(frozen?.findings ?? []).map((each: string) => make("li", {}, each)));
    const furthest = frozen?.cells?.length ? Math.max(...frozen.cells.map((cell: any) => cell.distances.at(-1))) : null;
    byId("fit-said").textContent = frozen ? `${frozen.points.length} points are laid on the body without overlaps.${furthest === null ? "" : ` No place of the region is further than ${words(furthest, 2)} mm from a membrane.`}` : "";
  }

  private problem(stage: string, line: string): void { document.querySelector(`[data-problem="${stage}"]`)!.textContent = line; }
}
