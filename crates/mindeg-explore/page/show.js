// Puts what the server says into the page.
// From the viewer's script: DEGREE_COLORS, angleText, percent, make and the charts.

import { listedPoints, showCurve } from "./curve.js";
import { namedPlaces } from "./names.js";
import { canRedo, canUndo, selection, shown, state } from "./state.js";

export const element = (id) => document.getElementById(id);
export const several = (count, thing) => (count === 1 ? `1 ${thing}` : `${count} ${thing}s`);

/** What a mesh beside the wanted one is called. */
export const NAMES = { wanted: "Without points inside", least: "Least degree", delaunay: "Delaunay", interior: "Points inside" };

/** The degree that the reader asks for, or the one that the mesh of the goal has. */
const wantedDegree = () => state.goal.max_degree ?? shown.wantedDegree;

export function showDomain(domain) {
  const { name, vertices, holes, triangles, lines, region_count: regions } = domain;
  // A surface that stands before it keeps its own.
  if (document.body.classList.contains("solid")) return;
  element("title").textContent = name ?? "A domain";
  const counted = [`${vertices} ${regions ? "" : "boundary "}vertices`, `${several(triangles, "triangle")} without points inside`];
  if (holes) counted.splice(1, 0, holes === 1 ? "1 hole" : `${holes} holes`);
  if (lines.length) counted.splice(-1, 0, several(lines.length, "line"));
  if (regions) counted.splice(-1, 0, several(regions, "region"));
  element("facts").textContent = counted.join(" · ");
  shown.places = namedPlaces(domain);
  element("names-choice").hidden = !shown.places.length;
  showNotes(domain.notes);
}

/** What was changed of a domain, when it was read and now; several sentences are folded. */
function showNotes(notes) {
  const lines = [...shown.sourceNotes, ...notes].map((text) => make("p", "note", text));
  if (lines.length < 2) return element("notes").replaceChildren(...lines);
  const folded = make("details");
  folded.append(make("summary", "", `${lines.length} notes on this domain`), ...lines);
  element("notes").replaceChildren(folded);
}

export function showUndo() {
  element("undo").disabled = !canUndo();
  element("redo").disabled = !canRedo();
}

/** What the keys of lists in a domain's JSON hold. */
const THINGS = { holes: "hole", sides: "side", corners: "corner", ring: "point", lines: "line", regions: "region", points: "point", sizes: "size", vertices: "vertex" };

/** What the field of an option is called. */
export const fieldName = (key) => `${key[0].toUpperCase()}${key.slice(1).replaceAll("_", " ")}`;

/**
 * A text in the words of the page: `holes[3].sides[0]` is side 1 of hole 4, an option of points inside has the name of its
 * field, and what JSON found is what not to give.
 */
export function inWords(text) {
  return text.replace(/\binterior\.([a-z_]+)(?![a-z_[.])/g, (_, key) => fieldName(key))
    .replace(/\bfound (?:the (?:number|text) )?(.+?), expected (.+)/g, "give $2, not $1").replace(/(?:\b[a-z_]+(?:\[\d+\])?\.)*\b[a-z_]+\[\d+\](?:\.[a-z_]+(?:\[\d+\])?)*/g, (path) => path.split(".")
    .filter((key) => key !== "polygon" && key !== "interior").reverse()
    .map((key) => key.replace(/^([a-z_]+)\[(\d+)\]$/, (_, list, index) => `${THINGS[list] ?? list} ${Number(index) + 1}`).replaceAll("_", " "))
    .join(" of "));
}

/** What is wrong with a domain, and where. */
export function domainTrouble({ message, path }) {
  return inWords(path && !message.includes(path) ? `${message} (at ${path})` : message);
}

/** What is wrong; nothing if there is no message. */
export function showTrouble(message) {
  element("trouble").hidden = !message;
  element("trouble-text").textContent = message;
}

/** Whether the meshes are those of a domain before: the one that is asked about has a fault. */
export function showOld(isOld) {
  element("meshes").classList.toggle("old", isOld);
}

const captionOf = ({ view, max_degree: degree }) => (view === "wanted" ? `Degree ${degree}` : `${NAMES[view]}: ${view === "least" ? "" : "degree "}${degree}`);

/** The figures of a mesh in its caption. */
export function showMesh(stage, mesh) {
  const { figure } = stage;
  // While a corner is dragged, drafts and meshes come in turn: what is said of one would flicker.
  const isHeld = Boolean(selection.drag);
  figure.querySelector("h3").textContent = isHeld ? NAMES[mesh.view] : captionOf(mesh);
  offerDownload(stage, true);
  const searching = mesh.is_last && !isHeld ? "" : " …";
  const parts = [make("span", "", "minimum angle "), make("strong", "", angleText(mesh.min_angle) + searching)];
  element("marks-legend").hidden = !shown.meshes.interior?.marks?.length;
  if (mesh.share_of_delaunay !== null && stage.view !== "delaunay" && stage.view !== "interior") {
    parts.push(make("span", "", ` · ${percent(mesh.share_of_delaunay)} of Delaunay’s`));
  }
  figure.querySelector(".figures").replaceChildren(...parts);
  figure.querySelector(".words-of").textContent = isHeld ? "While you drag, drafts are shown." : mesh.words;
}

/** The mesh of a view is looked for: until it is there, its place has no figures, least of all those of another mesh. */
export function showWaiting(figure, view) {
  figure.querySelector("h3").textContent = NAMES[view] ?? "";
  figure.querySelector(".words-of").textContent = "";
  figure.querySelector(".figures").textContent = "Working …";
}

/** Of another domain nothing is known yet. */
export function showNothing() {
  Object.assign(shown, { meshes: {}, forgotten: {}, advice: null, curve: null, degree: null, limit: null });
  for (const figure of document.querySelectorAll("#meshes .mesh")) showWaiting(figure, figure.dataset.stage === "main" ? state.view : state.beside);
  for (const figures of document.querySelectorAll("#purposes .figures")) figures.textContent = "";
  for (const id of ["advice", "degree-words", "limit-words", "suggestions", "curve-note"]) element(id).textContent = "…";
  for (const id of ["curve", "degrees"]) element(id).replaceChildren();
  for (const id of ["show-degree", "show-limit"]) element(id).hidden = true;
}

/** Offers the file of the mesh in a picture; where the page has none, the command that makes it stands in its place. */
function offerDownload({ id, figure }, isThere) {
  figure.classList.toggle("missing", !isThere);
  for (const button of figure.querySelectorAll(".jumps button")) button.hidden = !isThere;
  if (id !== "main") return;
  for (const name of ["download", "format", "format-note"]) element(name).hidden = !isThere;
  element("copy").classList.toggle("primary", !isThere);
  if (!isThere) element("terminal").open = true;
}

/** A picture without a mesh, and why it has none. */
function showNoMesh(stage, message) {
  offerDownload(stage, false);
  stage.worst = null;
  delete shown.meshes[stage.view];
  delete shown.forgotten[stage.view];
  stage.figure.querySelector("h3").textContent = stage.view === "wanted" ? "No such mesh" : `${NAMES[stage.view]}: no mesh`;
  stage.figure.querySelector(".figures").textContent = "";
  stage.figure.querySelector(".words-of").textContent = message;
}

/** What is wrong with the whole domain. The last meshes stay, or come back, and no picture waits for one. */
export function showRefused(stages, line) {
  showTrouble(domainTrouble(line));
  showOld(true);
  for (const stage of stages) {
    const { view } = stage;
    if (shown.meshes[view]) continue;
    const mesh = shown.forgotten[view];
    if (!mesh) {
      // Without a place it is no fault of the domain: the answer took too long, say.
      showNoMesh(stage, line.path ? "The domain has a fault, so it has no mesh." : inWords(line.message));
      continue;
    }
    shown.meshes[view] = mesh;
    stage.worst = mesh.worst;
    showMesh(stage, mesh);
  }
}

/** Why a part has no answer, where its answer would stand. */
export function showPartRefused(stages, part, said) {
  const message = inWords(said);
  const stage = stages.find(({ view }) => view === part);
  if (stage) showNoMesh(stage, message);
  else if (part === "curve") {
    shown.curve = null;
    element("curve").replaceChildren();
    element("degrees").replaceChildren();
    element("curve").closest("figure").hidden = true;
    element("curve-note").textContent = `Not compared: ${message}.`;
  } else if (part === "degree") element("degree-words").textContent = message;
  else if (part === "limit") element("limit-words").textContent = message;
  else if (part === "suggestions") element("suggestions").replaceChildren(make("p", "", message));
  else if (part === "command") element("command").textContent = message;
}

export function showCurveNow(choose) {
  const { curve } = shown;
  if (!curve) return;
  element("curve").closest("figure").hidden = false;
  const chosen = state.view === "interior" ? "inside" : wantedDegree();
  showCurve(element("curve"), element("degrees"), curve, shown.advice?.solver, chosen, choose);
  const left = curve.points.length - listedPoints(curve, chosen).length;
  const more = left ? `${left} more degrees are points of the curve.` : "";
  element("curve-note").textContent = [curve.open_question, more].filter(Boolean).join(" ");
}

/** Sentences of the server, a paragraph for each line. */
function paragraphs(box, words) {
  const text = words.split("\n").map((line) => line.trim()).filter(Boolean).join(" ");
  box.textContent = text;
}

/** The vertices that a proof is about: the ends of chords, or the apexes. */
export const decidingVertices = ({ certificate: { chords = [], apexes = [] } }) => [...apexes, ...chords.flat()];

export function showDegree(degree) {
  shown.degree = degree;
  paragraphs(element("degree-words"), degree.words);
  element("show-degree").hidden = decidingVertices(degree).length === 0;
}

export function showLimit(limit) {
  shown.limit = limit;
  paragraphs(element("limit-words"), limit.words);
  element("show-limit").hidden = !limit.vertices.length;
}

export function showSuggestions({ suggestions }, apply) {
  const box = element("suggestions");
  if (!suggestions.length) {
    box.replaceChildren(make("p", "", "No small change of the counts makes it better."));
    return;
  }
  box.replaceChildren(...suggestions.map(({ words, domain }) => {
    const button = make("button", "suggestion", words);
    button.type = "button";
    button.addEventListener("click", () => apply(domain));
    return button;
  }));
}

/** Legends and charts of the meshes on screen. */
export function showCharts(stages, facts, colors) {
  const meshes = stages.map(({ view }) => shown.meshes[view]).filter(Boolean);
  const name = (mesh) => (mesh.view === state.view ? "Your mesh" : NAMES[mesh.view]);
  const degrees = [...new Set(meshes.flatMap(({ degree_bars }) => degree_bars.map(([degree]) => degree)))].sort((a, b) => a - b);
  showDegreeLegend(element("degree-legend"), degrees);
  const ranges = rangesOf(degrees);
  showDegreeChart(element("degree-chart"), ranges, meshes.map((mesh) => ({
    name: name(mesh),
    counts: ranges.map(([, from, to]) => mesh.degree_bars.reduce((sum, [degree, count]) => (degree >= from && degree <= to ? sum + count : sum), 0)),
  })));
  const charted = meshes.filter(({ bars }) => bars);
  const measure = facts.measures.find((measure) => measure.name === charted[0]?.bars.measure);
  const section = element("metric-chart").closest("section");
  section.hidden = !measure;
  if (!measure) return showMetricLegend(element("metric-legend"));
  const all = charted.map(({ bars }) => bars);
  const { range, is_logarithmic: logarithmic } = all[0];
  const goesBeyond = [all.some(({ min }) => min < range[0]), all.some(({ max }) => max > range[1])];
  const drawn = { ...measure, range, logarithmic, goes_beyond: goesBeyond };
  element("chart-metric").textContent = measure.title.toLowerCase();
  element("chart-note").textContent = measure.explanation;
  showMetricLegend(element("metric-legend"), drawn);
  showMetricChart(element("metric-chart"), drawn, charted.map((mesh) => ({ name: name(mesh), counts: mesh.bars.counts })), colors);
}

/** The bars of the degree chart: one for each degree, or for ranges of them where they are many. */
function rangesOf(degrees) {
  if (degrees.length <= 14) return degrees.map((degree) => [String(degree), degree, degree]);
  return DEGREE_COLORS.map(({ from, name }, i) => [name, from, (DEGREE_COLORS[i + 1]?.from ?? Infinity) - 1])
    .filter(([, from, to]) => degrees.some((degree) => degree >= from && degree <= to));
}
