// Elements of the page. Texts are set as text, never as markup: names and descriptions come from files.
type Child = Node | string;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element ${id}`);
  return found as T;
}

export function button(text: string, act: () => void, attributes: Record<string, string> = {}): HTMLButtonElement {
  const found = make("button", { type: "button", ...attributes }, text);
  found.addEventListener("click", act);
  return found;
}

/** A number as people read it: four significant digits, no exponent where it can be avoided. */
export function words(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(digits - 1).replace("-", "−");
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

export function shownUnit(unit: string): string { return unit.replace("um", "µm").replace("^2", "²").replace("^3", "³"); }

/** A text of the studio with its units as people write them: µN for uN. */
export function shownText(text: string): string { return text.replace(/(\d) u(?=[NmVA]\b)/g, "$1 µ"); }

/** Hand out what lies at an address of this page or of the studio. */
export function download(address: string, name = ""): void {
  const place = make("a", { href: address, download: name, hidden: "" });
  document.body.append(place); // some browsers follow no link outside the page
  place.click();
  place.remove();
}

export function hand(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  download(address, name);
  setTimeout(() => URL.revokeObjectURL(address), 60000); // no browser says when it has taken it
}

export function csv(rows: (string | number)[][], name: string): void {
  const quoted = (cell: string | number) => {
    if (typeof cell === "number") return String(cell);
    const text = /^[=+@\t\r-]/.test(cell) ? `'${cell}` : cell; // a spreadsheet would take a text of a file for a formula
    return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  hand(new Blob([rows.map((row) => row.map(quoted).join(",")).join("\n") + "\n"], { type: "text/csv" }), name);
}

const greying = new Map<HTMLElement, number>();

/** Grey, once that lasts: what is grey for a moment alone would be drawn twice more for nothing. */
export function grey(place: HTMLElement, on: boolean): void {
  if (on && greying.has(place)) return;
  clearTimeout(greying.get(place));
  greying.delete(place);
  if (on) greying.set(place, window.setTimeout(() => place.classList.add("stale"), 250));
  else place.classList.remove("stale");
}

const colours = new Map<string, string>();

export function colour(name: string): string {
  let found = colours.get(name);
  if (found === undefined) colours.set(name, found = getComputedStyle(document.documentElement).getPropertyValue(name).trim());
  return found;
}

/** Another theme has others. */
export function forgetColours(): void { colours.clear(); }

const RAMP = [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]];

/** Colour of a point: viridis, without the ends that vanish on the background. */
export function ramp(share: number): string {
  const dark = document.documentElement.dataset.theme === "dark";
  const at = (dark ? 0.22 + 0.78 * share : 0.86 * share) * (RAMP.length - 1);
  const low = Math.min(Math.floor(at), RAMP.length - 2);
  const mixed = RAMP[low].map((value, k) => Math.round(value + (at - low) * (RAMP[low + 1][k] - value)));
  return `rgb(${mixed.join(",")})`;
}
