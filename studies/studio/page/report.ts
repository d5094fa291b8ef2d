// All pages of reports: the theme, tables that fold on a narrow screen, sections that a printer needs open, and figures
// that one can point at and download. Without this script a page shows its pictures instead.
import "uplot/dist/uPlot.min.css";
import "./report.css";
import { forgetColours } from "./dom";
import { FigureDrawing, type FigureData } from "./report_figures";

const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)");
const figures: FigureDrawing[] = [];

function theme(choice: string): void {
  root.dataset.theme = choice;
  forgetColours();
  for (const figure of figures) figure.restyle();
  dispatchEvent(new Event("themechange"));
}

/** What each cell is, for a screen on which a row is a block. */
function fold(table: HTMLTableElement): void {
  // What is in a folded section has no text as it is seen: lines end where the markup says so.
  const names = [...(table.tHead?.rows[0]?.cells ?? [])].map((cell) => [...cell.childNodes].map((node) => node.textContent || " ").join("").trim());
  if (!names.length) return;
  table.classList.add("fold");
  for (const body of table.tBodies) for (const row of body.rows) {
    if (row.cells.length === names.length) [...row.cells].forEach((cell, k) => { if (names[k]) cell.dataset.name ??= names[k]; });
  }
}

theme(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => theme(dark.matches ? "dark" : "light"));
document.querySelectorAll("table").forEach(fold);

const opened = new Set<HTMLDetailsElement>();
addEventListener("beforeprint", () => {
  theme("light");
  for (const each of document.querySelectorAll<HTMLDetailsElement>("details:not([open])")) { each.open = true; opened.add(each); }
});
addEventListener("afterprint", () => {
  for (const each of opened) each.open = false;
  opened.clear();
  theme(dark.matches ? "dark" : "light");
});

const held = document.getElementById("figures");
const found: Record<string, FigureData> = held ? JSON.parse(held.textContent!) : {};
for (const place of document.querySelectorAll<HTMLElement>("figure[data-figure]")) {
  const own = found[place.dataset.figure!];
  if (own) figures.push(new FigureDrawing(place, own));
}
