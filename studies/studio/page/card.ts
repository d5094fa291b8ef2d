// The card of the point that is pointed at or lit: its colour and its figures.
import { byId, make } from "./dom";
import type { Colouring } from "./colouring";

export class PointCard {
  private shown: number | null = null;
  constructor(private colouring: Colouring) {}

  show(point: number | null): void {
    this.shown = point;
    const place = byId("point-card");
    place.hidden = point === null;
    if (point === null) return;
    const swatch = make("span", { class: "swatch" });
    swatch.style.background = this.colouring.of(point);
    place.dataset.point = String(point);
    place.replaceChildren(
      make("strong", {}, swatch, `point ${point}`),
      make("dl", {}, ...this.colouring.figures(point).flatMap(([title, value]) => [make("dt", {}, title), make("dd", {}, value)])),
    );
  }

  redraw(): void { this.show(this.shown); }
}
