// Whack a mole: a mole is hit when the decoder names its point, whoever touched: the mouse, a recording or a finger.
import { byId, words } from "./dom";

const MOLES = 10;

export class Game {
  mole: number | null = null;
  private hit = 0;
  private left = 0;
  private begun = 0;
  constructor(private points: () => number, private show: () => void) {}

  play(): void {
    [this.hit, this.left, this.begun] = [0, MOLES, performance.now()];
    this.pop();
  }

  /** A touch was heard, of which these points were named. */
  whack(named: number[]): void {
    if (this.mole === null) return;
    if (named.includes(this.mole)) this.hit += 1;
    this.left -= 1;
    if (this.left > 0) return this.pop();
    this.end(`${this.hit} of ${MOLES} moles hit in ${words((performance.now() - this.begun) / 1000, 3)} s`);
  }

  /** The array may have become smaller. */
  check(): void { if (this.mole !== null && this.mole > this.points()) this.end("the array has other points now"); }

  private pop(): void {
    const before = this.mole, count = this.points();
    if (count < 2) return;
    while (this.mole === before) this.mole = 1 + Math.floor(Math.random() * count);
    byId("score").dataset.mole = String(this.mole);
    byId("score").textContent = `The mole is at point ${this.mole}. Hit: ${this.hit}; still to come: ${this.left}.`;
    this.show();
  }

  private end(said: string): void {
    this.mole = null;
    delete byId("score").dataset.mole;
    byId("score").textContent = `Over: ${said}.`;
    this.show();
  }
}
