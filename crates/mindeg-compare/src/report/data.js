// The data of a report, as scenes.

const data = JSON.parse(document.getElementById("data").textContent);
const DEGREE_COLORS = data.degree_colors;

const points = unpack(data.points, Float64Array);
const positions = data.positions ? unpack(data.positions, Float32Array) : null;
const outlines = data.outlines.map((outline) => unpack(outline, Float64Array));
const vertexNumbers = data.vertices ? unpack(data.vertices, Uint32Array) : null;
const least = Math.min(...data.methods.map(({ vertices }) => vertices).filter(Boolean));
const methods = data.methods.map((method) => ({
  name: method.name,
  bars: method.bars,
  degreeBars: method.degree_bars,
  worst: method.worst,
  maxDegreeVertex: method.max_degree_vertex,
  triangles: unpack(method.triangles, Uint32Array),
  numbers: method.numbers ? unpack(method.numbers, Uint32Array) : null,
  degrees: unpack(method.degrees, Uint32Array),
  values: Object.fromEntries(method.values.map((values, i) => [data.metrics[i].name, unpack(values, Float32Array)])),
  steps: Object.fromEntries(method.steps.map((steps, i) => [data.metrics[i].name, unpack(steps, Uint8Array)])),
  positions,
  points: points.subarray(0, 2 * method.vertices),
  outlines,
  vertexNumbers,
  // Points inside come after those of the one boundary that others join.
  isRing: data.is_ring && method.vertices === least,
  fillsOutlines: data.fills_outlines,
  leastDegree: data.at_least,
}));

const size = drawnSize(data.size);
// Coordinates are relative to the center.
const high = size.map((length) => length / 2);
const low = high.map((length) => -length);
/** Pictures that take longer, in milliseconds, are moved at once and drawn after. */
const SLOW = 30;

const element = (id) => document.getElementById(id);

// The state that all pictures share: where they look, and what they show.
const view = { x: 0, y: 0, zoom: 1, stretch: wantsStretch(size, document.querySelector(".meshes")?.clientWidth ?? 0) };
let measure = data.metrics[0];
let cursor = null;
let colors;
