// The design as this page keeps it: over a lost link, a server that was started again, and in an address.
export interface Kept { session: string | null; stated: any; unsaved: boolean; pinned?: any; }
const TAB = "acoustic-fem-studio", LAST = "acoustic-fem-studio-last";
/** Characters of the longest design that an address holds. */
const LONGEST = 256 * 1024;

export function keep(kept: Kept): void {
  try {
    sessionStorage.setItem(TAB, JSON.stringify(kept));
    if (kept.unsaved) localStorage.setItem(LAST, JSON.stringify(kept));
    else if (keptUnsaved()?.session === kept.session) localStorage.removeItem(LAST); // not that of another page
  } catch { /* a full or forbidden store: the server has the design */ }
}

export function keptInTab(): Kept | null { return read(sessionStorage, TAB); }
export function keptUnsaved(): Kept | null { return read(localStorage, LAST); }
export function forget(): void { try { localStorage.removeItem(LAST); } catch { /* as above */ } }

function read(store: Storage, name: string): Kept | null {
  try { return JSON.parse(store.getItem(name) ?? "null"); } catch { return null; }
}

/** An address that holds the design behind its #, which no browser sends anywhere. */
export async function addressOf(stated: any): Promise<string> {
  const packed = new Blob([JSON.stringify(stated)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  const text = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  return `${location.origin}/#design=${text}`;
}

/** The design in the address of the page; null where there is none, an error where what is there is none. */
export async function designInAddress(): Promise<any | null> {
  if (!location.hash.startsWith("#design=")) return null;
  const packed = location.hash.slice(8);
  history.replaceState(null, "", "/");
  const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
  const open = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  for (let part = await open.read(); !part.done; part = await open.read()) {
    text += part.value;
    if (text.length > LONGEST) { await open.cancel(); throw new Error("no design is as long"); }
  }
  const found = JSON.parse(text);
  if (typeof found !== "object" || Array.isArray(found)) throw new Error("no table");
  return found;
}
