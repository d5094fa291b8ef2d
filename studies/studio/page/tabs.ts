// The rail of panels: one is open at a time, and the array stays beside it.
import { byId } from "./dom";

const KEPT = "acoustic-fem-panel";

export class Tabs {
  private tabs = [...document.querySelectorAll<HTMLButtonElement>("[role=tab]")];
  constructor(private opened: (name: string) => void = () => {}) {
    for (const tab of this.tabs) tab.addEventListener("click", () => this.open(tab.id.slice(4)));
    byId("tab-design").parentElement!.addEventListener("keydown", (event) => this.key(event));
    let kept: string | null = null;
    try { kept = sessionStorage.getItem(KEPT); } catch { /* a forbidden store: the first panel is open */ }
    if (kept && document.getElementById(`tab-${kept}`)) this.open(kept);
  }

  /** Open a panel by its name, such as "touch". */
  open(name: string): void {
    for (const tab of this.tabs) {
      const own = tab.id === `tab-${name}`;
      tab.setAttribute("aria-selected", String(own));
      tab.tabIndex = own ? 0 : -1;
      byId(tab.getAttribute("aria-controls")!).hidden = !own;
    }
    document.body.dataset.panel = name;
    this.opened(name);
    try { sessionStorage.setItem(KEPT, name); } catch { /* as above */ }
  }

  private key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const now = this.tabs.findIndex((tab) => tab.getAttribute("aria-selected") === "true");
    const next = this.tabs[(now + step + this.tabs.length) % this.tabs.length];
    this.open(next.id.slice(4));
    next.focus();
  }
}
