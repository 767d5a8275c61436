"use strict";

// The worker of the page: it asks the server, unpacks the meshes and draws them, so that the page itself
// never waits while a corner is dragged.

importScripts("/page/viewer.js");

/** A newer request waits for the meshes of the one before, but no longer than so many milliseconds. */
const PATIENCE = 200;

let headers = {};
let look = null;
let measures = [];
const stages = new Map();

let running = null;
let waiting = null;

/** Sends what was asked last. While meshes of the request before are on their way, they come first. */
function askNext() {
  if (!waiting) return;
  const spent = running ? performance.now() - running.start : Infinity;
  if (running && running.awaited.size && spent < PATIENCE) {
    setTimeout(askNext, PATIENCE - spent);
    return;
  }
  running?.controller.abort();
  const { id, tab, request } = waiting;
  waiting = null;
  const awaited = new Set(request.show.filter((part) => ["wanted", "least", "delaunay"].includes(part)));
  running = { id, awaited, controller: new AbortController(), start: performance.now(), domain: null, color: request.color };
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
  run.awaited.clear();
  askNext();
}

function take(run, line) {
  if (line.kind === "domain") {
    const points = unpack(line.points, Float64Array);
    for (let i = 0; i < points.length; i++) points[i] += line.center[i % 2];
    run.domain = { ...line, points };
    line = run.domain;
  } else if (line.kind === "mesh") {
    show(run, line);
    for (const name of ["interior_points", "triangles", "degrees", "values"]) delete line[name];
    run.awaited.delete(line.view);
  } else if (line.kind === "refused") {
    if (line.part) run.awaited.delete(line.part);
    else run.awaited.clear();
    const stage = stages.get(line.part);
    if (stage) clear(stage);
  }
  postMessage({ kind: "line", id: run.id, line, spent: performance.now() - run.start });
  if (!run.awaited.size) askNext();
}

/** The line round a ring of vertices. */
function closedLine(points, from, to) {
  const line = new Float64Array(2 * (to - from) + 2);
  line.set(points.subarray(2 * from, 2 * to));
  line.set(points.subarray(2 * from, 2 * from + 2), line.length - 2);
  return line;
}

/** Makes a scene of a mesh and draws it. */
function show(run, line) {
  const stage = stages.get(line.view);
  if (!stage) return;
  const { points, rings, center } = run.domain;
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
    outlines: rings.slice(1).map((end, i) => closedLine(points, rings[i], end)),
    isRing: rings.length === 2 && !inside.length,
    fillsOutlines: true,
    leastDegree: line.at_least,
    worst: line.worst_triangle,
    busiest: line.max_degree_vertex,
  };
  const facts = measures.find(({ name }) => name === run.color);
  const measure = facts && line.bars ? { ...facts, range: line.bars.range, logarithmic: line.bars.is_logarithmic } : undefined;
  Object.assign(stage, { scene, measure, painter: new Painter(scene, measure) });
  line.worst = corners(scene, { triangle: line.worst_triangle });
  paint(stage);
}

function clear(stage) {
  Object.assign(stage, { scene: null, painter: null });
  if (stage.frame) stage.frame.start(stage.canvas);
}

/** Draws a stage as all of them look now. */
function paint(stage) {
  const frame = look?.frames[stage.name];
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
    if (!stage.painter || !stage.frame || !place) continue;
    const at = pick(stage.scene, stage.frame, place.x, place.y);
    found[stage.name] = { text: describe(stage.scene, stage.measure, at), corners: corners(stage.scene, at) };
  }
  return found;
}

const requests = {
  begin(message) {
    ({ headers, measures } = message);
  },
  stage({ name, canvas }) {
    stages.set(name, { name, canvas });
  },
  /** A stage shows another mesh from now on. */
  rename({ from, to }) {
    const stage = stages.get(from);
    stages.delete(from);
    stage.name = to;
    stages.set(to, stage);
    clear(stage);
  },
  ask(message) {
    waiting = message;
    askNext();
  },
  look(message) {
    look = message;
    for (const stage of stages.values()) paint(stage);
  },
  point({ place }) {
    postMessage({ kind: "found", place, found: point(place) });
  },
  jump({ name, target }) {
    const stage = stages.get(name);
    if (!stage?.painter || !stage.frame) return;
    const { worst, busiest } = stage.scene;
    const at = lookAt(stage.scene, stage.frame, target === "worst" ? { triangle: worst } : { vertex: busiest });
    postMessage({ kind: "jump", at });
  },
};

onmessage = ({ data }) => requests[data.kind](data);
