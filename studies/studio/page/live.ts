// Live input from a sound card of the machine that the studio runs on.
import { byId, make } from "./dom";

export interface SoundCard { number: number; name: string; channels: number; default: boolean; }

export class LiveSwitch {
  constructor(private send: (message: object) => void, private failed: (message: string) => void, private end: () => void) {
    byId("live").addEventListener("click", () => this.turn(!this.on));
    byId("card").addEventListener("change", () => { if (this.on) this.turn(true); });
  }

  get on(): boolean { return byId("live").getAttribute("aria-pressed") === "true"; }

  /** Listen to a sound card, or no more; which ones there are is asked first. */
  turn(on: boolean): void {
    byId("live").setAttribute("aria-pressed", String(on));
    document.querySelector("[data-problem='live']")!.textContent = "";
    if (!on) { this.send({ do: "stop", stage: "live" }); this.end(); return; }
    const card = byId<HTMLSelectElement>("card");
    if (card.hidden) this.send({ do: "cards" });
    else this.send({ do: "listen", device: Number(card.value), full_scale: Number(byId<HTMLInputElement>("full-scale").value) });
  }

  cards(found: SoundCard[]): void {
    const card = byId<HTMLSelectElement>("card");
    card.replaceChildren(...found.map((each) => make("option", { value: String(each.number) }, `${each.name}, ${each.channels} channels`)));
    card.value = String(found.find((each) => each.default)?.number ?? found[0]?.number ?? "");
    card.hidden = found.length === 0;
    if (found.length) this.turn(true);
    else this.failed("no device that can record is there");
  }
}
