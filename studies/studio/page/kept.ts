// The design as this page keeps it: over a lost link, a server that was started again, and in an address.
export interface Kept { session: string | null; stated: any; unsaved: boolean; }
const TAB = "acoustic-fem-studio", LAST = "acoustic-fem-studio-last";

export function keep(kept: Kept): void {
  try {
    sessionStorage.setItem(TAB, JSON.stringify(kept));
    if (kept.unsaved) localStorage.setItem(LAST, JSON.stringify(kept));
    else localStorage.removeItem(LAST);
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

export async function designInAddress(): Promise<any | null> {
  const found = location.hash.match(/^#design=([\w-]+)$/);
  if (!found) return null;
  history.replaceState(null, "", "/");
  try {
    const bytes = Uint8Array.from(atob(found[1].replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const open = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return JSON.parse(await new Response(open).text());
  } catch {
    return null;
  }
}
