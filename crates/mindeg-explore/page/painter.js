"use strict";

// The worker of the page: it asks the server, unpacks the meshes and draws them, so that the page itself
// never waits while a corner is dragged.

importScripts("/page/viewer.js");

/** A mesh that a better one follows is shown after so many milliseconds, unless the better one is there. */
const HOLD = 20;
/** Last meshes that came within so many milliseconds are waited for while a corner is dragged. */
const QUICK = 45;
/** No request waits longer than so many milliseconds for the one before. */
const PATIENCE = 250;
/** So many milliseconds after the last step of a corner, what takes longer than drafts is asked for. */
const REST = 120;

let headers = {};
let look = null;
let measures = [];
const stages = new Map();

let running = null;
let waiting = null;
let isQuick = true;
let lastStep = -Infinity;
let timer;
let resting;

/**
 * How many more milliseconds the running request may have before the next one ends it: until all its
 * meshes are there where that is quick, else until there is one in each picture.
 */
function timeLeft() {
  if (!running || !running.unfinished.size) return 0;
  const spent = performance.now() - running.start;
  const isEnough = !isQuick && !running.empty.size;
  return isEnough ? 0 : Math.max(0, (isQuick ? QUICK : PATIENCE) - spent);
}

/** Sends what was asked last, as soon as it may. */
function askNext() {
  clearTimeout(timer);
  if (!waiting) return;
  const left = timeLeft();
  if (left > 0) {
    timer = setTimeout(askNext, left);
    return;
  }
  if (running?.unfinished.size) isQuick = false;
  running?.controller.abort();
  const { id, tab, request } = waiting;
  waiting = null;
  const views = request.show.filter((part) => ["wanted", "least", "delaunay", "interior"].includes(part));
  running = {
    id, start: performance.now(), domain: null, color: request.color, isDraft: request.drafts_only, controller: new AbortController(),
    empty: new Set(views), unfinished: new Set(views), held: new Map(),
  };
  answer(running, tab, request);
}

async function answer(run, tab, request) {
  try {
    const response = await fetch(`/api/answer?tab=${tab}`,
      { method: "POST", headers, body: JSON.stringify(request), signal: run.controller.signal });
    if (!response.ok) {
      const { message } = await response.json().catch(() => ({}));
      throw new Error(message ?? `The server refused the request (${response.status}).`);
    }
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let rest = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      const lines = (rest + value).split("\n");
      rest = lines.pop();
      for (const line of lines) if (line && run === running) take(run, JSON.parse(line));
    }
  } catch (error) {
    if (run !== running || error.name === "AbortError") return;
    const isGone = error instanceof TypeError;
    const message = isGone ? "mindeg explore no longer answers: was it ended in its terminal?" : error.message;
    postMessage({ kind: "line", id: run.id, line: { kind: "refused", part: null, message } });
  }
  if (run !== running) return;
  run.unfinished.clear();
  askNext();
}

function take(run, line) {
  if (line.kind === "domain") {
    const points = unpack(line.points, Float64Array);
    for (let i = 0; i < points.length; i++) points[i] += line.center[i % 2];
    const lines = line.lines.map((own) => ({ ...own, segments: unpack(own.segments, Float64Array) }));
    for (const { segments } of lines) for (let i = 0; i < segments.length; i++) segments[i] += line.center[i % 2];
    line = run.domain = { ...line, points, lines };
  } else if (line.kind === "mesh") {
    clearTimeout(run.held.get(line.view));
    // Pictures would flicker if they changed twice for each step of a corner. Where better meshes take longer, they come
    // after the last step alone.
    if (!line.is_last && isQuick) return void run.held.set(line.view, setTimeout(reveal, HOLD, run, line));
    return reveal(run, line);
  } else if (line.kind === "refused") {
    for (const view of line.part ? [line.part] : [...run.unfinished]) finish(run, view);
    const stage = stageOf(line.part);
    if (stage) showBoundary(stage, run.domain);
  }
  tell(run, line);
}

/** Draws a mesh and tells the page of it. */
function reveal(run, line) {
  if (run !== running) return;
  run.empty.delete(line.view);
  // The server works on the next step while this one is drawn.
  if (waiting && !timeLeft()) askNext();
  show(run, line);
  for (const name of ["interior_points", "triangles", "degrees", "values"]) delete line[name];
  if (line.is_last) finish(run, line.view);
  tell(run, line);
}

function finish(run, view) {
  run.empty.delete(view);
  if (!run.unfinished.delete(view) || run.unfinished.size) return;
  const wasQuick = performance.now() - run.start < QUICK;
  // While a corner moves, pictures that have become drafts stay drafts.
  isQuick = wasQuick && (isQuick || performance.now() - lastStep >= REST);
}

function tell(run, line) {
  // After drafts the whole answer comes.
  if (run.isDraft && line.kind === "done") return;
  postMessage({ kind: "line", id: run.id, line });
  if (waiting && !timeLeft()) askNext();
}

/** The line round a ring of vertices. */
function closedLine(points, from, to) {
  const line = new Float64Array(2 * (to - from) + 2);
  line.set(points.subarray(2 * from, 2 * to));
  line.set(points.subarray(2 * from, 2 * from + 2), line.length - 2);
  return line;
}

/** The edges of a line inside, each as a line of its own. */
const edges = (segments) => Array.from({ length: segments.length / 4 }, (_, i) => segments.subarray(4 * i, 4 * i + 4));

const outlinesOf = ({ points, rings, lines }) =>
  [...rings.slice(1).map((end, i) => closedLine(points, rings[i], end)), ...lines.flatMap(({ segments }) => edges(segments))];

/** Draws the boundary alone, where there is no mesh to show. */
function showBoundary(stage, domain) {
  if (!domain) return clear(stage);
  const none = new Uint32Array(0);
  const scene = { points: domain.points, triangles: none, degrees: none, values: {}, outlines: outlinesOf(domain), isRing: false, fillsOutlines: false };
  Object.assign(stage, { scene: null, measure: undefined, painter: new Painter(scene) });
  paint(stage);
}

/** Makes a scene of a mesh and draws it. */
function show(run, line) {
  const stage = stageOf(line.view);
  if (!stage) return;
  const { points, rings, center, lines } = run.domain;
  const inside = unpack(line.interior_points, Float64Array);
  const all = new Float64Array(points.length + inside.length);
  all.set(points);
  for (let i = 0; i < inside.length; i++) all[points.length + i] = inside[i] + center[i % 2];
  const values = run.color ? { [run.color]: unpack(line.values, Float32Array) } : {};
  const scene = {
    points: all,
    triangles: unpack(line.triangles, Uint32Array),
    degrees: unpack(line.degrees, Uint32Array),
    values,
    outlines: outlinesOf(run.domain),
    isRing: rings.length === 2 && !inside.length,
    // Regions of a map may be holes.
    fillsOutlines: !lines.length,
    leastDegree: line.at_least,
    worst: line.worst_triangle,
    maxDegreeVertex: line.max_degree_vertex,
  };
  const facts = measures.find(({ name }) => name === run.color);
  const measure = facts && line.bars ? { ...facts, range: line.bars.range, logarithmic: line.bars.is_logarithmic } : undefined;
  Object.assign(stage, { scene, measure, painter: new Painter(scene, measure) });
  line.worst = corners(scene, { triangle: line.worst_triangle });
  paint(stage);
}

const stageOf = (view) => [...stages.values()].find((stage) => stage.view === view);

function clear(stage) {
  Object.assign(stage, { scene: null, painter: null });
  if (stage.frame) stage.frame.start(stage.canvas);
}

/** Draws a stage as all of them look now. */
function paint(stage) {
  const frame = look?.frames[stage.id];
  if (!frame?.width) return;
  const [width, height] = [frame.width, frame.height].map((length) => Math.round(length * frame.dots));
  if (stage.canvas.width !== width) stage.canvas.width = width;
  if (stage.canvas.height !== height) stage.canvas.height = height;
  stage.frame = Object.assign(new Frame(look.size, look.view), frame);
  const context = stage.frame.start(stage.canvas);
  if (stage.painter) stage.painter.paint(context, stage.frame, look.colors, look.hasDots);
}

/** What to draw a line around: the points of a vertex or of a triangle. */
function corners({ points, triangles }, { vertex, triangle }) {
  const all = vertex !== undefined ? [vertex] : triangle !== undefined ? triangles.subarray(3 * triangle, 3 * triangle + 3) : [];
  return Array.from(all, (corner) => [points[2 * corner], points[2 * corner + 1]]);
}

/** What is at a place in each stage. */
function point(place) {
  const found = {};
  for (const stage of stages.values()) {
    if (!stage.scene || !stage.frame || !place) continue;
    const at = pick(stage.scene, stage.frame, place.x, place.y);
    found[stage.id] = { text: describe(stage.scene, stage.measure, at), corners: corners(stage.scene, at) };
  }
  return found;
}

const requests = {
  begin(message) {
    ({ headers, measures } = message);
  },
  stage({ id, canvas }) {
    stages.set(id, { id, canvas, view: null });
  },
  /** What each stage shows from now on: a mesh that is drawn already goes where it is wanted. */
  views({ views }) {
    const drawn = new Map([...stages.values()].map(({ view, scene, measure, painter }) => [view, { scene, measure, painter }]));
    for (const stage of stages.values()) {
      if (stage.view === views[stage.id]) continue;
      stage.view = views[stage.id];
      const known = drawn.get(stage.view);
      if (known?.scene) {
        Object.assign(stage, known);
        paint(stage);
      } else clear(stage);
    }
  },
  ask(message) {
    // Of another domain the last pictures show nothing.
    if (message.isAnew) for (const stage of stages.values()) clear(stage);
    clearTimeout(resting);
    const now = performance.now();
    const isMoving = now - lastStep < REST;
    lastStep = now;
    waiting = message;
    // What a searched mesh takes from the processor, the picture that follows a corner would miss.
    if (isMoving && !isQuick) {
      waiting = { ...message, request: { ...message.request, drafts_only: true } };
      resting = setTimeout(() => {
        waiting = message;
        askNext();
      }, REST);
    }
    askNext();
  },
  look(message) {
    look = message;
    for (const stage of stages.values()) paint(stage);
  },
  point({ place }) {
    postMessage({ kind: "found", place, found: point(place) });
  },
  jump({ id, target }) {
    const stage = stages.get(id);
    if (!stage?.scene || !stage.frame) return;
    const { worst, maxDegreeVertex } = stage.scene;
    const at = lookAt(stage.scene, stage.frame, target === "worst" ? { triangle: worst } : { vertex: maxDegreeVertex });
    postMessage({ kind: "jump", at });
  },
};

onmessage = ({ data }) => requests[data.kind](data);
