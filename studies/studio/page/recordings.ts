// Recordings and recognizers that are handed in, for the panel of touches.
import { unpack } from "./curves";
import { byId } from "./dom";
import { handIn, handInFolder } from "./handing";
import type { TouchPanel } from "./touch";

/** The session and the number of the design at hand. */
export interface AtHand { session: string; revision: number; }

/** Hand in what is chosen, and hear what the studio makes of it. */
export function takeRecordings(touch: TouchPanel, atHand: () => AtHand): void {
  const problem = document.querySelector("[data-problem='touch']")!;
  const progress = document.querySelector("[data-status='touch']")!;
  const replay = async (files: File[]) => {
    problem.textContent = "";
    const manifest = files.find((each) => each.name.endsWith(".toml")), file = files.find((each) => each !== manifest);
    try {
      if (manifest) byId<HTMLInputElement>("full-scale").value = String((await (await handIn("/manifests", { name: manifest.name }, manifest)).json()).full_scale);
    } catch (error) {
      problem.textContent = (error as Error).message;
      return;
    }
    if (!file) return;
    const asked = { session: atHand().session, name: file.name, full_scale: byId<HTMLInputElement>("full-scale").value };
    byId("answer").textContent = "the recording is decoded…";
    try {
      const heard: any = unpack(await (await handIn("/recordings", asked, file)).arrayBuffer());
      if (heard.revision !== atHand().revision) throw new Error("The design was changed meanwhile: replay the recording again.");
      touch.hear(heard);
    } catch (error) {
      touch.failed();
      problem.textContent = (error as Error).message;
    }
    progress.textContent = "";
  };
  const recognizer = async (files: File[]) => {
    problem.textContent = "";
    try {
      const found = await handInFolder("/recognizers", { session: atHand().session }, files);
      byId("answer").textContent = `A recognizer of ${found.subject} on ${found.design} recognizes: ${found.labels.join(", ")}.`;
    } catch (error) {
      problem.textContent = (error as Error).message;
    }
  };
  byId("replay").addEventListener("change", (event) => {
    const input = event.target as HTMLInputElement, files = [...(input.files ?? [])];
    if (files.length) replay(files);
    input.value = "";
  });
  byId("recognizer").addEventListener("change", (event) => {
    const input = event.target as HTMLInputElement, files = [...(input.files ?? [])];
    if (files.length) recognizer(files);
    input.value = "";
  });
}
