// The things to take away: the file of a mesh, the domain, the command line.

import { ask, request } from "./asking.js";
import * as server from "./server.js";
import { domainTrouble, element, showTrouble } from "./show.js";
import { state } from "./state.js";

/** Hands a file to the browser, which puts it where downloads go. */
export function hand(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

const baseName = () => (state.domain.name ?? "mesh").replace(/[^\p{L}\p{N}._-]+/gu, "-").slice(0, 80) || "mesh";

/** Offers the formats, and downloads. */
export function offerFiles(formats) {
  const select = element("format");
  select.append(...formats.map(({ name }) => new Option(name.toUpperCase(), name)));
  // Of a surface, one file is downloaded.
  element("solid-format").append(...formats.filter(({ files }) => files.length === 1).map(({ name, is_planar: isPlanar }) => {
    const option = new Option(name.toUpperCase(), name);
    option.dataset.planar = isPlanar;
    return option;
  }));
  element("solid-format").value = "obj";
  const format = () => formats.find(({ name }) => name === select.value);
  const explain = () => {
    const { description, files } = format();
    const several = files.length > 1 ? `: ${files.length} files that belong together, ${files.map((file) => `.${file}`).join(", ")}` : "";
    element("format-note").textContent = `${description}${several}.`;
  };
  select.value = state.format;
  select.addEventListener("change", () => {
    state.format = select.value;
    explain();
    // The command changes with it.
    ask();
  });
  explain();
  const load = async (view, button) => {
    button.disabled = true;
    try {
      const { name, files } = format();
      for (const [place, extension] of files.entries()) {
        const { blob, name: named } = await server.download(request(), name, view, place);
        hand(blob, named ?? `${baseName()}.${extension}`);
      }
      element("spoken").textContent = "The mesh is downloaded.";
    } catch (error) {
      showTrouble(domainTrouble(error));
    }
    button.disabled = false;
  };
  element("download").addEventListener("click", (event) => load(state.view, event.currentTarget));
  element("download-main").addEventListener("click", (event) => load(state.view, event.currentTarget));
  element("download-beside").addEventListener("click", (event) => load(state.beside, event.currentTarget));
  element("save").addEventListener("click", () => {
    const text = JSON.stringify(state.domain, null, 2) + "\n";
    hand(new Blob([text], { type: "application/json" }), `${baseName()}.json`);
  });
}

/** Copies the command; without a clipboard it is selected. */
export function offerCopy() {
  const button = element("copy");
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(element("command").textContent);
      button.textContent = "Copied";
      setTimeout(() => { button.textContent = "Copy the command"; }, 2000);
    } catch {
      getSelection().selectAllChildren(element("command"));
    }
  });
}
