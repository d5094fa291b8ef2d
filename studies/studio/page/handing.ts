// Files that are handed in to the studio.
import { access } from "./access";

/** What the studio answers to something that is handed in; or that it is not taken, and why. */
export async function handIn(address: string, asked: Record<string, string>, body: BodyInit): Promise<Response> {
  let why = "The studio does not answer.";
  try {
    const answer = await fetch(`${address}?${new URLSearchParams(asked)}`, { method: "POST", body, headers: access() });
    if (answer.ok) return answer;
    why = `The studio rejected it (${answer.status}).`;
    why = (await answer.json()).message;
  } catch { /* gone, or an answer without a reason */ }
  throw new Error(why);
}

/** What is made of the files of a folder, which are handed in together. */
export async function handInFolder(address: string, asked: Record<string, string>, files: File[]): Promise<any> {
  const packed: Record<string, string> = {};
  for (const file of files) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    let text = "";
    for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
    packed[file.name] = btoa(text);
  }
  return (await handIn(address, asked, JSON.stringify(packed))).json();
}
