// The page without a studio: what a studio has sent of one design is in the page itself, and nothing can be changed.
import { byId, hand } from "./dom";

export interface Shared { about: { made: string; version: string }; toml: string; messages: any[]; curves: Record<string, string>; }

/** What the page holds; null in a studio. The form is shown, but takes nothing. */
export function sharedDesign(): Shared | null {
  const place = document.getElementById("shared");
  if (!place) return null;
  const found: Shared = JSON.parse(place.textContent!);
  for (const tab of document.querySelectorAll("[role=tab][data-live]")) tab.remove(); // the keys go over those that are left
  for (const place of ["fields", "section-holder"]) byId(place).inert = true;
  byId("made").hidden = false;
  byId("made").textContent = `to look at only; made on ${found.about.made} with acoustic-fem ${found.about.version}. Save downloads the design file, which a studio opens.`;
  return found;
}

/** In place of the link to a studio: it answers with what the page holds. */
export class SharedLink {
  constructor(private shared: Shared, take: (message: any) => void, private curves: (message: ArrayBuffer) => void) {
    for (const message of shared.messages) take(message);
  }

  send(message: any): boolean {
    if (message.do === "want") {
      const bytes = Uint8Array.from(atob(this.shared.curves[message.quantity]), (c) => c.charCodeAt(0));
      this.curves(bytes.buffer);
    } else if (message.do === "export" && message.name === "design.toml") {
      hand(new Blob([this.shared.toml], { type: "application/toml" }), `${this.shared.messages.find((each) => each.type === "design").design_name}.toml`);
    } else return false;
    return true;
  }
}
