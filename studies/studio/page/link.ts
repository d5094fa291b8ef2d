// The websocket to the server: opened again when it is lost, and half-open links are found by pings.
import { secret } from "./access";

export type State = "open" | "lost" | "gone" | "locked";
const PING_EVERY = 3000, PONG_WITHIN = 6000;
/** Code of a websocket that the studio closes because the page has no secret, or an old one. */
const REFUSED = 1008;

export class Link {
  private socket: WebSocket | null = null;
  private asked = 0;
  private answered = true;
  private admitted = false;
  private tries = 0;
  constructor(
    private hello: () => object,
    private text: (message: any) => void,
    private binary: (message: ArrayBuffer) => void,
    private state: (state: State) => void,
  ) {
    setInterval(() => this.watch(), PING_EVERY);
    this.open();
  }

  send(message: object): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private open(): void {
    const socket = new WebSocket(`ws://${location.host}/session`);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.answered = true;
    this.admitted = false;
    socket.onopen = () => {
      socket.send(JSON.stringify({ ...this.hello(), secret: secret() }));
    };
    socket.onmessage = (event) => {
      if (!this.admitted) {
        this.admitted = true;
        this.tries = 0;
        this.state("open");
      }
      this.answered = true;
      if (typeof event.data === "string") this.text(JSON.parse(event.data));
      else this.binary(event.data);
    };
    socket.onclose = (event) => this.lost(socket, event.code === REFUSED ? "locked" : "lost");
  }

  private watch(): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    // Browsers let pages that nobody looks at ask once a minute: what counts is how long an answer takes.
    if (this.answered) {
      this.answered = false;
      this.asked = performance.now();
      this.send({ do: "ping" });
    } else if (performance.now() - this.asked > PONG_WITHIN) this.lost(this.socket);
  }

  private lost(socket: WebSocket, state: State = "lost"): void {
    if (socket !== this.socket) return;
    this.socket = null;
    socket.onclose = socket.onmessage = null;
    socket.close();
    this.state(state);
    this.tries += 1;
    setTimeout(() => this.again(), Math.min(250 * 2 ** this.tries, 4000));
  }

  private async again(): Promise<void> {
    try {
      const answer = await fetch("/studio.css", { method: "HEAD", cache: "no-store" });
      if (answer.ok) return this.open();
      this.state("locked");
    } catch {
      this.state("gone");
    }
    this.tries += 1;
    setTimeout(() => this.again(), 2000);
  }
}
