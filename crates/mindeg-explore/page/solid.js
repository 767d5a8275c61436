// A surface in space: it is turned, meshed anew, filled or bridged, with before and after side by side; and the mesh of a whole
// map, whose parts are edited one by one.
// From the scripts of the viewer: SpaceStage, angleText, make, pageColors, unpack, showDegreeLegend.

import { keep } from "./asking.js";
import { purposeButtons, showPurposes } from "./choices.js";
import * as server from "./server.js";
import { element, several, showTrouble } from "./show.js";
import { state } from "./state.js";

/** The measures that may color triangles. */
const MEASURES = [
  { name: "min_angle", title: "Minimum angle", higher_is_better: true, range: [0, 60] },
  { name: "max_angle", title: "Maximum angle", higher_is_better: false, range: [60, 180] },
].map((measure) => ({ ...measure, unit: "degrees", logarithmic: false, goes_beyond: [false, false] }));
const measureNow = () => MEASURES.find(({ name }) => name === element("solid-metric").value);

let file = null;
/** The map that is shown in place of a surface: what the server sent of it, and the advice on it. */
let map = null;
let advice = null;
let shownNow = [];
/** The number of the last request; the answer to another one comes too late. */
let asking = 0;

/** Takes a file with a surface, and shows it in place of the boundary. */
export async function beginSolid(dropped) {
  file = dropped;
  state.solid = file.name;
  keep();
  open(file.name, "A surface in space");
  // The buttons of the map before.
  element("choose").hidden = true;
  await show("nothing");
  // Of a model, the mesh that a solver should get.
  if (file === dropped && !element("model-meshes").hidden) await show("interior");
}

/** Takes the section, for a surface or for a map. */
function open(title, facts) {
  document.body.classList.add("solid");
  element("solid").hidden = false;
  for (const id of ["solid-changes", "solid-loops", "solid-thick"]) element(id).hidden = Boolean(map);
  element("model-meshes").hidden = true;
  element("whole-purposes").hidden = !map;
  element("solid-title").textContent = map ? "What is the mesh for?" : "What should become of the surface?";
  // A map lies in the plane; a surface in space fits no format of the plane.
  const select = element("solid-format");
  for (const option of select.options) option.hidden = option.disabled = !map && option.dataset.planar === "true";
  if (select.selectedOptions[0]?.disabled) select.value = "obj";
  element("title").textContent = title;
  element("facts").textContent = facts;
}

/** Takes a map of several parts, and shows the mesh of all of them in place of the boundary. */
export async function beginWhole(chosen) {
  endSolid();
  map = chosen;
  element("whole-purposes").replaceChildren(...purposeButtons(showWhole));
  open(map.name, `The whole map · ${several(map.parts.length, "part")}`);
  await showWhole();
}

/** Shows the mesh of the map for a purpose, or else the one that is advised. */
async function showWhole(purpose) {
  const own = map;
  element("solid-words").textContent = "Working …";
  element("solid-download").hidden = true;
  showPurposes(element("whole-purposes"), advice, purpose);
  try {
    const found = await server.whole(own, purpose);
    if (map !== own) return;
    advice ??= found.advice;
    showPurposes(element("whole-purposes"), advice, found.purpose);
    shownNow = [figure("The whole map", found)];
    element("solid-meshes").replaceChildren(shownNow[0].figure);
    shownNow[0].draw();
    const words = advice?.words.find(([name]) => name === found.purpose)?.[1];
    const more = found.purpose === "solver" ? advice?.on_edges : "";
    element("solid-words").textContent = [words, more, found.words].filter(Boolean).join(" ");
    element("solid-command").textContent = found.command;
    made = { purpose: found.purpose };
    element("solid-download").hidden = false;
  } catch (error) {
    if (map !== own) return;
    element("solid-words").textContent = "";
    showTrouble(error.message);
  }
}

/** Goes back to boundaries. */
export function endSolid() {
  file = map = advice = null;
  asking += 1;
  element("whole-purposes").replaceChildren();
  state.solid = null;
  document.body.classList.remove("solid");
  element("solid").hidden = true;
  element("solid-meshes").replaceChildren();
  shownNow = [];
}

/** The change that is shown, with what was asked besides; a download is of it. */
let made = null;

const loopsChosen = () => [...element("solid-loops").querySelectorAll("input:checked")].map(({ value }) => value).join(",");

/** What the page asks besides a change. */
function wished(change) {
  const size = element("solid-size").valueAsNumber;
  if (change === "remesh") return size > 0 ? { size } : {};
  if (change === "fill") return { loops: loopsChosen(), interior: element("solid-inside").checked };
  return change === "bridge" ? { loops: loopsChosen(), interior: element("solid-inside").checked } : {};
}

/** Shows the surface before and after a change. */
async function show(change) {
  const own = (asking += 1);
  const more = wished(change);
  element("solid-words").textContent = "Working …";
  showTrouble("");
  try {
    const found = await server.solid(file, change, more);
    if (asking !== own) return;
    if (change === "nothing") {
      element("model-meshes").hidden = !found.is_model;
      element("solid-remesh").classList.toggle("primary", !found.is_model);
      if (found.is_model) element("facts").textContent = "A whole model";
      shownNow = [figure(found.is_model ? "Boundary points alone" : "Before", found)];
      listLoops(found.loops, found.loop_vertices.map((text) => unpack(text, Uint32Array)));
    } else {
      shownNow = [shownNow[0], figure({ interior: "Points inside", remesh: "Meshed anew", fill: "Filled", bridge: "Bridged" }[change], found)];
    }
    element("solid-meshes").replaceChildren(...shownNow.map(({ figure }) => figure));
    for (const { draw } of shownNow) draw();
    element("solid-words").textContent = found.words;
    element("solid-command").textContent = found.command;
    made = { change, more };
    element("solid-download").hidden = change === "nothing" && !found.is_model;
  } catch (error) {
    if (asking !== own) return;
    element("solid-words").textContent = "";
    showTrouble(error.message);
  }
}

/** The figure of a surface, with a stage on which it is turned. */
function figure(title, found) {
  const box = make("figure", "mesh");
  const caption = make("figcaption");
  const numbers = make("p", "figures", `degree ${found.max_degree} · minimum angle ${angleText(found.min_angle)} · ${several(found.triangles, "triangle")}`);
  caption.append(make("h3", "", title), numbers);
  const stage = make("div", "stage");
  stage.tabIndex = 0;
  stage.setAttribute("role", "application");
  stage.setAttribute("aria-label", `${title}: drag or press arrows to turn`);
  stage.append(make("canvas"), make("canvas"));
  const readout = make("p", "readout");
  box.append(caption, stage, readout);
  const scene = {
    positions: unpack(found.positions, Float32Array), triangles: unpack(found.corners, Uint32Array), degrees: unpack(found.degrees, Uint32Array),
    values: { min_angle: unpack(found.min_angles, Float32Array), max_angle: unpack(found.max_angles, Float32Array) },
    worst: found.worst_triangle, maxDegreeVertex: found.max_degree_vertex,
  };
  const space = new SpaceStage(stage, scene, {
    told: (text, isSpoken) => {
      readout.textContent = text;
      if (isSpoken) element("spoken").textContent = text;
    },
    hasDots: () => true,
  });
  // A map lies in the plane.
  if (map) space.camera.face([0, 0, 1], [0, 1, 0]);
  space.color(measureNow());
  const rim = found.first_new === null ? [] : rimOf(scene.triangles.subarray(3 * found.first_new));
  space.emphasize(rim);
  stage.dataset.marked = rim.length / 2;
  const draw = () => {
    space.resize();
    space.look(pageColors());
    space.draw();
  };
  new ResizeObserver(draw).observe(stage);
  const color = () => {
    space.color(measureNow());
    space.draw();
  };
  return { figure: box, draw, color, emphasize: (edges) => {
    space.emphasize(edges);
    stage.dataset.marked = edges.length / 2;
  } };
}

/** The edges that only one of some triangles has, as pairs of vertices. */
function rimOf(triangles) {
  const edges = new Map();
  for (let i = 0; i < triangles.length; i++) {
    const ends = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]];
    const key = `${Math.min(...ends)} ${Math.max(...ends)}`;
    if (!edges.delete(key)) edges.set(key, ends);
  }
  return [...edges.values()].flat();
}

/** Marks the loops that are ticked in the picture of the surface as it is. */
function markChosen(vertices) {
  const chosen = [...element("solid-loops").querySelectorAll("input:checked")].map(({ value }) => vertices[value]);
  shownNow[0]?.emphasize(chosen.flatMap((loop) => [...loop].flatMap((vertex, i) => [vertex, loop[(i + 1) % loop.length]])));
}

function listLoops(loops, vertices) {
  element("solid-loops").replaceChildren(...(loops.length ? [make("p", "note", "Loops of the boundary; without a choice, all are filled:")] : [make("p", "note", "The surface is closed.")]),
    ...loops.slice(0, 50).map((words, index) => {
      const label = make("label");
      const box = make("input");
      Object.assign(box, { type: "checkbox", value: String(index) });
      box.addEventListener("change", () => markChosen(vertices));
      label.append(box, ` ${words}`);
      return label;
    }));
  element("solid-fill").disabled = element("solid-inside").disabled = !loops.length;
  element("solid-bridge").disabled = loops.length < 2;
}

/** Makes the buttons work; `hand(blob, name)` gives a file to the browser, `onEnd` goes on with the boundary. */
export function startSolid(hand, onEnd) {
  element("solid-metric").append(...MEASURES.map(({ name, title }) => new Option(title, name)), new Option("nothing", ""));
  element("solid-metric").addEventListener("change", () => {
    for (const { color } of shownNow) color();
  });
  for (const change of ["nothing", "interior", "remesh", "fill", "bridge"]) element(`solid-${change}`).addEventListener("click", () => show(change));
  element("solid-end").addEventListener("click", () => {
    endSolid();
    onEnd();
  });
  element("solid-download").addEventListener("click", async () => {
    showTrouble("");
    try {
      const format = element("solid-format").value;
      const { blob, name } = await (map ? server.wholeFile(map, made.purpose, format) : server.solidFile(file, made.change, format, made.more));
      hand(blob, name ?? "surface.obj");
    } catch (error) {
      showTrouble(error.message);
    }
  });
}
