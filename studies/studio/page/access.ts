// The secret of this page. The server gives it out once, with the page, to the browser that used the address with the code.
const KEPT = "acoustic-fem-studio-secret";
let own = "";

/** Keep the secret that came with the page, and take the code, which works once, out of the address. */
export function takeSecret(): void {
  const given = document.querySelector<HTMLMetaElement>("meta[name=secret]");
  if (given) {
    own = given.content;
    given.remove();
    try { localStorage.setItem(KEPT, own); } catch { /* a forbidden store: this page alone has it */ }
  }
  if (location.search) history.replaceState(null, "", `/${location.hash}`);
}

/** The secret, read anew each time: another page of this browser may have got a new one. */
export function secret(): string {
  try { return localStorage.getItem(KEPT) ?? own; } catch { return own; }
}

/** Headers of what this page asks for. */
export function access(): Record<string, string> { return { "x-studio-secret": secret() }; }
