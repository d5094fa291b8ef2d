// The dialogue of a job: what the sensor is for, the designs that are proposed for it, prototypes and recent designs.
import { button, byId, make, shownText } from "./dom";
import { planPicture, type Plan } from "./plan";
import { recentDesigns, type Recent } from "./recent";

interface PlaceWords { title: string; points: number; microphones: number; size: string | null; around: number | null; }
interface Words { places: Record<string, PlaceWords>; printers: Record<string, string>; printer: string; target: string; contacts: string[]; prototypes: Record<string, Plan>; }
interface Proposed { strength: string; outcome: string; points: number; rows: [string, string, string][]; reasons: string[]; plan: Plan; stated: any; }
export interface Proposals { question: string; problem: string; designs: Proposed[]; }

export class JobDialogue {
  private words: Words | null = null;
  private dialogue = byId<HTMLDialogElement>("job");
  constructor(
    private send: (message: object) => boolean, private open: (stated: any, source: string) => void, private prototype: (name: string) => void,
  ) {
    byId("new").addEventListener("click", () => { this.dialogue.showModal(); if (!this.words) this.send({ do: "job" }); else this.gallery(); });
    byId("job-close").addEventListener("click", () => this.dialogue.close());
    byId("job-place").addEventListener("change", () => this.usual());
    byId("job-stop").addEventListener("click", () => this.send({ do: "stop", stage: "proposals" }));
    byId<HTMLFormElement>("job-form").addEventListener("submit", (event) => { event.preventDefault(); this.ask(); });
  }

  learn(words: Words): void {
    this.words = words;
    const fill = (id: string, found: [string, string][], chosen: string) => {
      byId(id).replaceChildren(...found.map(([value, title]) => make("option", { value }, title)));
      byId<HTMLSelectElement>(id).value = chosen;
    };
    fill("job-place", Object.entries(words.places).map(([name, place]) => [name, place.title]), "flat");
    fill("job-printer", Object.entries(words.printers), words.printer);
    const [contact, force] = words.target.split(" ");
    fill("job-contact", words.contacts.map((each) => [each, each]), contact);
    byId<HTMLInputElement>("job-force").value = force;
    this.usual();
    this.gallery();
  }

  progress(line: string): void {
    byId("job-progress").textContent = line;
    byId<HTMLButtonElement>("job-propose").disabled = line !== "";
    byId<HTMLButtonElement>("job-stop").disabled = line === "";
  }

  failed(message: string): void { this.progress(""); byId("job-problem").textContent = message; }

  take(found: Proposals): void {
    this.progress("");
    byId("job-problem").textContent = found.problem;
    byId("job-found").replaceChildren(...found.designs.map((each) => this.card(each)));
    byId("job-found").querySelector<HTMLElement>("button")?.focus();
  }

  /** The usual values of a place stand in the fields that were left open. */
  private usual(): void {
    const place = this.words!.places[byId<HTMLSelectElement>("job-place").value];
    const hints: Record<string, string> = { points: String(place.points), microphones: String(place.microphones), size: place.size ?? "any", around: place.around === null ? "flat" : String(place.around) };
    for (const [name, hint] of Object.entries(hints)) byId<HTMLInputElement>(`job-${name}`).placeholder = hint;
    byId<HTMLInputElement>("job-around").disabled = place.around === null;
  }

  private ask(): void {
    const text = (name: string) => byId<HTMLInputElement>(`job-${name}`).value.trim(), asked: Record<string, unknown> = {};
    for (const name of ["place", "points", "size", "printer"]) if (text(name)) asked[name] = text(name);
    for (const name of ["microphones", "budget", "around"]) {
      if (!text(name) || byId<HTMLInputElement>(`job-${name}`).disabled) continue;
      const value = Number(text(name).replace(",", "."));
      asked[name] = Number.isFinite(value) ? value : text(name);
    }
    asked.target = `${text("contact")} ${text("force")} N`;
    byId("job-problem").textContent = "";
    byId("job-found").replaceChildren();
    if (this.send({ do: "propose", name: text("name") || "design", asked })) this.progress("begins");
  }

  private card(each: Proposed): HTMLElement {
    const name = `${each.strength}: ${each.outcome}`;
    const list = make("dl", {}, ...each.rows.flatMap(([title, value, remark]) => [make("dt", { title: remark }, title), make("dd", {}, shownText(value))]));
    const reasons = make("ul", {}, ...each.reasons.map((reason) => make("li", {}, shownText(reason))));
    const pick = button("Open this design", () => { this.dialogue.close(); this.open(each.stated, "the proposal"); }, { class: "pick", "aria-label": `open the design that is ${each.strength}` });
    return make("li", { "data-outcome": each.outcome.replaceAll(" ", "-") }, make("strong", {}, name), planPicture(each.plan, 250, 110), make("p", { class: "note" }, `${each.points} points`), list, reasons, pick);
  }

  private gallery(): void {
    const tile = (name: string, picture: HTMLElement, act: () => void) => {
      const found = button("", () => { this.dialogue.close(); act(); }, { class: "tile" });
      found.append(picture, make("span", {}, name));
      return found;
    };
    const recent = (each: Recent) => {
      const picture = make("canvas", { width: "150", height: "84", "aria-hidden": "true" }), image = new Image();
      image.addEventListener("load", () => picture.getContext("2d")!.drawImage(image, 0, 0, 150, 84));
      image.src = each.picture;
      return tile(each.name, picture, () => this.open(each.stated, "a recent design"));
    };
    const found = recentDesigns();
    byId("job-recent-title").hidden = found.length === 0;
    byId("job-recent").replaceChildren(...found.map(recent));
    byId("job-prototypes").replaceChildren(...Object.entries(this.words!.prototypes).map(([name, plan]) => tile(name, planPicture(plan, 150, 84), () => this.prototype(name))));
  }
}
