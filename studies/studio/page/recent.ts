// Designs that this browser has shown, with a picture of each; the one opened last comes first.
export interface Recent { name: string; stated: any; picture: string; }
const KEPT = "acoustic-fem-recent", MOST = 6;

export function recentDesigns(): Recent[] {
  try { return JSON.parse(localStorage.getItem(KEPT) ?? "[]"); } catch { return []; }
}

/** Keep a design in place of an earlier state of it, which has the same name. */
export function keepRecent(design: Recent): void {
  const others = recentDesigns().filter((each) => each.name !== design.name);
  try { localStorage.setItem(KEPT, JSON.stringify([design, ...others].slice(0, MOST))); } catch { /* a full or forbidden store */ }
}
