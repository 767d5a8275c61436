"use strict";

// What pictures and charts share: the data, the view, the colors.

const data = JSON.parse(document.getElementById("data").textContent);

/** The numbers in a base64 string of little-endian bytes. */
function unpack(text, Kind) {
  return new Kind(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
}

const points = unpack(data.points, Float64Array);
const vertexNumbers = data.vertices ? unpack(data.vertices, Uint32Array) : null;
const methods = data.methods.map((method) => ({
  name: method.name,
  bars: method.bars,
  degreeBars: method.degree_bars,
  worst: method.worst,
  busiest: method.busiest,
  triangles: unpack(method.triangles, Uint32Array),
  numbers: method.numbers ? unpack(method.numbers, Uint32Array) : null,
  degrees: unpack(method.degrees, Uint32Array),
  values: method.values.map((values) => unpack(values, Float32Array)),
}));

const outlines = data.outlines.map((outline) => unpack(outline, Float64Array));
// What has no width or no height, as a plane seen from its edge, is drawn as if it had a little.
const largest = Math.max(...data.size) || 1;
const size = data.size.map((length) => Math.max(length, 1e-9 * largest));
// Coordinates are relative to the center.
const high = size.map((length) => length / 2);
const low = high.map((length) => -length);
const HEIGHT = data.metrics.findIndex((measure) => measure.name === "minimum_height");
const SLENDER = 10;
const MAX_ZOOM = 1e6;
const STEPS = 16;
/** Vertices closer than this, in pixels, go without edges. */
const CROWDED = 1.5;
/** Vertices inside a mesh that are closer than this, in pixels, go without dots, but for poles. */
const DENSE = 4;
/** Vertices with more edges are poles, as for `mindeg inspect`. */
const POLE = 8;
/** Pictures that take longer, in milliseconds, are moved at once and drawn after. */
const SLOW = 30;

const element = (id) => document.getElementById(id);
const short = (value) => (Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "∞");

// What all pictures share: where they look, and what they show.
const view = { x: 0, y: 0, zoom: 1, stretch: Math.max(...size) > SLENDER * Math.min(...size) };
let metric = 0;
let cursor = null;

let colors;

function readColors() {
  const style = getComputedStyle(document.documentElement);
  const get = (name) => style.getPropertyValue("--" + name).trim();
  const stops = ["good", "middling", "bad"].map((name) => {
    const number = parseInt(get(name).slice(1), 16);
    return [number >> 16, (number >> 8) & 255, number & 255];
  });
  const mix = (share) => {
    const at = share * 2 >= 1 ? 1 : 0;
    const part = share * 2 - at;
    const channel = (i) => Math.round(stops[at][i] + (stops[at + 1][i] - stops[at][i]) * part);
    return `rgb(${channel(0)},${channel(1)},${channel(2)})`;
  };
  colors = { ramp: [] };
  for (const name of ["card", "good", "edge", "outline", "ring", "mark"]) colors[name] = get(name);
  for (let step = 0; step < STEPS; step++) colors.ramp.push(mix(step / (STEPS - 1)));
}

/** The place of a degree's color on the scale. */
function degreeStep(degree) {
  const next = data.degree_colors.findIndex((entry) => entry.from > degree);
  return next < 0 ? data.degree_colors.length - 1 : Math.max(0, next - 1);
}

const degreeColor = (degree) => data.degree_colors[degreeStep(degree)].color;

/** Where a value lies on the axis of a measure, 0 to 1. */
function position(measure, value) {
  const [from, to] = measure.range;
  const share = measure.logarithmic
    ? Math.log(value / from) / Math.log(to / from)
    : (value - from) / (to - from);
  return Math.min(1, Math.max(0, share));
}

/** The triangles of a method by color step for the chosen measure. */
function bySteps(method) {
  const steps = Array.from({ length: STEPS }, () => []);
  const measure = data.metrics[metric];
  const count = method.triangles.length / 3;
  for (let i = 0; i < count; i++) {
    let share = measure ? position(measure, method.values[metric][i]) : 0;
    if (measure && measure.higher_is_better) share = 1 - share;
    steps[Math.min(STEPS - 1, Math.floor(share * STEPS))].push(i);
  }
  return steps;
}

