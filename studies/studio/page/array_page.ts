// The page that shows an array without a studio: the picture of the studio, with the model in the page itself.
import "./studio.css";
import { ArrayPanel, type Model, type Part } from "./array";
import { byId, forgetColours, ramp } from "./dom";

const { name, model }: { name: string; model: Model } = JSON.parse(byId("model").textContent!);
const count = Math.max(...model.parts.map((part) => Number(part.group.match(/^point (\d+)$/)?.[1] ?? 0)), 1);
let selected: number | null = null;
const array = new ArrayPanel(byId("space"), (point) => ramp((point - 1) / Math.max(count - 1, 1)), (point) => light(point), () => {}, null);

function light(point: number | null): void {
  selected = point === selected ? null : point;
  array.light((part: Part) => selected !== null && part.group === `point ${selected}`);
}

function theme(choice: string): void {
  document.documentElement.dataset.theme = choice;
  forgetColours();
  byId("theme").setAttribute("aria-pressed", String(choice === "dark"));
  array.restyle();
}

const dark = matchMedia("(prefers-color-scheme: dark)");
theme(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => theme(dark.matches ? "dark" : "light"));
byId("theme").addEventListener("click", () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
byId("array-png").addEventListener("click", () => array.picture(name));
array.take(model, 0);
