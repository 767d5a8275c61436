// The page begins here: it takes what the server says, and its controls work.
// From the viewer's script: make.

import { apply, ask, begin, keep, progress, undo, worker } from "./asking.js";
import { chooseDegree, choosePurpose, guessAgain, offerGoals, offerInterior, offerPurposes, showAdvice, showGoal } from "./choices.js";
import { forgetEdges, grab, handleKey, hint, startEditing, updateEditor } from "./editing.js";
import { fit, fitAnew, isOff, jumpTo, looks, moveTo, readLooks, redraw, resize, setCursor, setFound, stages, zoomBy } from "./pictures.js";
import * as server from "./server.js";
import {
  NAMES, decidingVertices, element, showCharts, showCurveNow, showDegree, showDomain, showLimit, showMesh, showOld, showPartRefused, showRefused,
  showSuggestions, showTrouble, showWaiting,
} from "./show.js";
import { Stage, view } from "./stage.js";
import { origins, selection, shown, state } from "./state.js";
import { beginSolid, beginWhole, endSolid, startSolid } from "./solid.js";
import { hand, offerCopy, offerFiles } from "./take.js";

/** Charts are drawn again after so many milliseconds: they are read, not watched. */
const CHART_PAUSE = 150;
/** Figures of another domain stay so many milliseconds while those of this one are looked for. */
const PATIENCE = 250;

let facts;

// ---- what the server says

/** What is done with each kind of line of an answer. */
const take = {
  domain(domain) {
    setTimeout(forgetOld, PATIENCE);
    forgetEdges(false);
    if (selection.mustFit) for (const stage of stages) stage.worst = null;
    shown.domain = domain;
    shown.coarser = null;
    showTrouble("");
    showOld(false);
    showDomain(domain);
    if (selection.mustFit) fitAnew();
    else if (!selection.drag && isOff(domain)) fit();
    selection.mustFit = false;
    if (!selection.drag) updateEditor();
  },
  mesh(mesh, id) {
    const stage = stages.find(({ view }) => view === mesh.view);
    if (!stage) return;
    shown.meshes[mesh.view] = { ...mesh, id };
    stage.worst = mesh.worst;
    showMesh(stage, mesh);
    if (mesh.view === "wanted" && mesh.is_last) {
      shown.wantedDegree = mesh.max_degree;
      showCurveNow(chooseDegree);
    }
    if (mesh.view === "interior") redraw();
    laterCharts();
  },
  advice(advice, id) {
    shown.advice = advice;
    advised = id;
    showAdvice();
    showCurveNow(chooseDegree);
    // Where points inside bring little, they are not what a reader is led to.
    if (!state.isTold && advice.first !== "solver" && state.view === "interior" && !selection.drag) choosePurpose(advice.first, true);
  },
  curve(curve) {
    shown.curve = curve;
    showCurveNow(chooseDegree);
  },
  degree: showDegree,
  limit: showLimit,
  suggestions: (line) => showSuggestions(line, apply),
  command({ text }) {
    element("command").textContent = text;
  },
  refused({ part, message, path, coarser }) {
    if (!part) {
      forgetEdges(true);
      showRefused(stages, { message, path });
      if (shown.advice || !shown.forgotten.advice) return;
      shown.advice = shown.forgotten.advice;
      showAdvice();
      // One that came while the advice was waited for has no points inside.
      return showCurveNow(chooseDegree);
    }
    showPartRefused(stages, part, message);
    if (part === "interior") {
      shown.coarser = coarser;
      showAdvice();
    }
    laterCharts();
  },
};

const heard = {
  line({ id, line }) {
    take[line.kind]?.(line, id);
    if (line.kind === "done" || (line.kind === "refused" && !line.part)) progress.answered = id;
    redraw();
  },
  found: ({ place, found }) => setFound(place, found),
  jump: ({ at }) => jumpTo(at),
};

let advised = 0;

/** What is not of this domain goes, if it is still there. */
function forgetOld() {
  if (progress.answered >= progress.asked) return;
  for (const stage of stages) {
    const { view, figure } = stage;
    // While a corner is dragged, drafts come in turn: a caption that went between them would flicker.
    if (selection.drag || !(shown.meshes[view]?.id < progress.since)) continue;
    shown.forgotten[view] = shown.meshes[view];
    delete shown.meshes[view];
    stage.worst = null;
    showWaiting(figure, view);
  }
  if (advised >= progress.since || !shown.advice) return;
  shown.forgotten.advice = shown.advice;
  shown.advice = null;
  showAdvice();
}

let charting;
function laterCharts() {
  charting ??= setTimeout(() => {
    charting = undefined;
    showCharts(stages, facts, looks.colors);
  }, CHART_PAUSE);
}

// ---- controls

/** The first picture shows the mesh that is taken, the second what is chosen to stand beside it, or it goes. */
function showViews() {
  element("beside").value = state.beside;
  for (const option of element("beside").options) option.hidden = option.value === state.view;
  element("interior").hidden = ![state.view, state.beside].includes("interior");
  const views = [state.view, state.beside === "none" ? null : state.beside];
  const before = Object.fromEntries(stages.map(({ view, worst }) => [view, worst]));
  stages.forEach((stage, place) => {
    stage.figure.hidden = !views[place];
    if (stage.view === views[place]) return;
    stage.view = views[place];
    stage.worst = before[stage.view] ?? null;
    const mesh = shown.meshes[stage.view];
    if (mesh) return showMesh(stage, mesh);
    showWaiting(stage.figure, stage.view);
  });
  for (const meshes of [shown.meshes, shown.forgotten]) for (const view of Object.keys(NAMES)) if (!views.includes(view)) delete meshes[view];
  worker.postMessage({ kind: "views", views: Object.fromEntries(stages.map(({ id, view }) => [id, view])) });
  resize();
}

function startControls() {
  element("trouble-close").addEventListener("click", () => showTrouble(""));
  element("undo").addEventListener("click", () => undo(true));
  element("redo").addEventListener("click", () => undo(false));
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.target.matches("input:not([type=checkbox])")) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    undo(key === "z" && !event.shiftKey);
  });
  element("beside").addEventListener("change", ({ target }) => {
    state.beside = target.value;
    showViews();
    ask();
  });
  element("metric").addEventListener("change", ({ target }) => {
    state.color = target.value || null;
    ask();
  });
  element("dots").addEventListener("change", () => redraw(true));
  element("names").addEventListener("change", () => redraw());
  element("stretch").addEventListener("change", ({ target }) => {
    state.stretch = view.stretch = target.checked;
    resize();
    keep();
  });
  element("zoom-in").addEventListener("click", () => zoomBy(1.5));
  element("zoom-out").addEventListener("click", () => zoomBy(1 / 1.5));
  element("fit").addEventListener("click", fit);
  for (const stage of stages) {
    for (const button of stage.figure.querySelectorAll("[data-jump]")) {
      button.addEventListener("click", () => worker.postMessage({ kind: "jump", id: stage.id, target: button.dataset.jump }));
    }
  }
  const decide = (vertices) => {
    shown.decides = vertices.map((vertex) => [shown.domain.points[2 * vertex], shown.domain.points[2 * vertex + 1]]);
    element("pictures").scrollIntoView({ block: "nearest" });
    redraw();
  };
  element("show-limit").addEventListener("click", () => decide(shown.limit.vertices));
  element("show-degree").addEventListener("click", () => {
    decide(decidingVertices(shown.degree));
  });
}

/** Opens what a reader has chosen or dropped; a file with several polygons offers them by name. */
async function open(file) {
  if (!file) return;
  try {
    if (file.size > facts.max_bytes) {
      throw new Error(`${file.name} has ${Math.ceil(file.size / 2 ** 20)} MB; the page takes ${facts.max_bytes / 2 ** 20}, the command line any number.`);
    }
    const sources = await server.readFile(file);
    if (sources.some(({ is_solid: isSolid }) => isSolid)) {
      showTrouble("");
      return await beginSolid(file);
    }
    endSolid();
    const usable = sources.filter(({ domain, map }) => domain || map);
    const first = usable.find(({ domain }) => domain);
    if (!first) throw new Error(sources[0]?.message ?? `${file.name} has no polygon.`);
    showTrouble("");
    for (const [place, { domain }] of sources.entries()) if (domain) origins.set(domain, [file, place]);
    beginWith(first);
    offerChoices(usable, first.name);
  } catch (error) {
    showTrouble(error.message);
  }
}

/** Offers the whole map and the polygons of a file by name, if there are several; one is chosen. */
function offerChoices(sources, chosen) {
  const box = element("choose");
  box.hidden = sources.length < 2;
  box.replaceChildren(...sources.map((source) => {
    const button = make("button", "", source.name);
    button.type = "button";
    button.setAttribute("aria-pressed", String(source.name === chosen));
    button.addEventListener("click", () => {
      for (const other of box.children) other.setAttribute("aria-pressed", String(other === button));
      if (source.map) beginWhole(source.map);
      else beginWith(source);
    });
    return button;
  }));
}

function beginWith({ domain, notes }) {
  endSolid();
  element("presets").value = "";
  guessAgain();
  begin(domain, notes);
}

function startFiles() {
  element("open").addEventListener("click", () => element("file").click());
  element("file").addEventListener("change", ({ target }) => {
    open(target.files[0]);
    target.value = "";
  });
  const dropping = element("dropping");
  const hasFile = (event) => event.dataTransfer?.types.includes("Files");
  window.addEventListener("dragover", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    dropping.hidden = false;
  });
  window.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) dropping.hidden = true;
  });
  window.addEventListener("drop", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    dropping.hidden = true;
    open(event.dataTransfer.files[0]);
  });
}

/** What a stage does with its pointers and keys. */
const hooks = (stage) => ({
  pointAt: (x, y) => {
    if (selection.drag) return;
    setCursor({ x, y, from: stage });
    hint(stage, x, y);
  },
  leave: () => setCursor(null),
  pointAtCenter: () => { if (!selection.corner) setCursor({ x: view.x, y: view.y, from: stage, centered: true, isSpoken: true }); },
  moveTo,
  zoomBy: (factor, place) => zoomBy(factor, stage, place),
  fit,
  ...(stage.id === "main" && { grab: (event, place) => grab(stage, event, place), handleKey }),
});

async function start() {
  worker.onmessage = ({ data }) => heard[data.kind]?.(data);
  let kept = null;
  let presets;
  let source;
  let polygons;
  try {
    [facts, presets, source, polygons] = await Promise.all(["facts", "presets", "start", "start/choices"].map((name) => server.getJson(`/api/${name}`)));
    if (server.firstState) kept = await server.getJson(`/api/state/${server.firstState}`).catch(() => null);
  } catch (error) {
    element("facts").textContent = "";
    return showTrouble(error.message);
  }
  worker.postMessage({ kind: "begin", headers: server.headers, measures: facts.measures });
  for (const figure of document.querySelectorAll(".mesh")) {
    const stage = new Stage(figure, hooks);
    const canvas = stage.mesh.transferControlToOffscreen();
    worker.postMessage({ kind: "stage", id: stage.id, canvas }, [canvas]);
    stages.push(stage);
  }
  const { domain: _, solid: __, ...choices } = kept ?? {};
  Object.assign(state, choices);
  offerPurposes(showViews);

  element("metric").append(...facts.measures.map(({ name, title }) => new Option(title, name)), new Option("nothing", ""));
  element("metric").value = state.color ?? "";
  element("presets").append(new Option("choose …", ""), ...presets.map(({ name }) => new Option(name, name)));
  element("presets").value = presets.some(({ name }) => name === source.name) ? source.name : "";
  element("presets").addEventListener("change", ({ target }) => {
    const preset = presets.find(({ name }) => name === target.value);
    if (!preset) return;
    endSolid();
    offerChoices([]);
    guessAgain();
    begin(preset.domain, preset.notes);
  });
  offerGoals(facts.goals);
  offerInterior(facts.interior);
  startEditing();
  startControls();
  startFiles();
  startSolid(hand, () => {
    // Of a map, a part is chosen anew.
    for (const button of element("choose").children) button.setAttribute("aria-pressed", "false");
    begin(state.domain, shown.sourceNotes);
  });
  offerCopy();
  offerFiles(facts.formats);
  readLooks();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    readLooks();
    laterCharts();
  });
  new ResizeObserver(() => resize(false)).observe(element("meshes"));
  showGoal();
  showViews();
  const isSolid = source.is_solid && (!kept || kept.solid === source.name);
  const first = source.domain ? source : presets[0];
  for (const [place, { domain }] of polygons.entries()) if (domain) origins.set(domain, [null, place]);
  // The list has another copy of the domain that the page begins with.
  if (source.domain && !presets.some(({ name }) => name === source.name)) origins.set(source.domain, [null, Math.max(0, polygons.findIndex(({ domain }) => domain))]);
  begin(kept?.domain ?? first.domain, kept ? [] : first.notes);
  offerChoices(polygons, kept ? null : first.name);
  if (facts.purpose && !kept) choosePurpose(facts.purpose);
  if (!isSolid) return;
  try {
    await beginSolid(await server.startFile(source.name));
  } catch (error) {
    showTrouble(error.message);
  }
}

start();
