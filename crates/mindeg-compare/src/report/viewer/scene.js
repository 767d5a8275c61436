// The scene, where a picture looks, and the colors. Nothing here or in paint.js and pick.js needs a
// document, so that a worker can draw, too.
//
// A scene is one mesh: `points` (x and y of each vertex), `triangles` (three vertices each), `degrees`,
// `values` (for each measure by name, its value for each triangle), `outlines` (x and y along each line; a
// closed one ends where it starts), `isRing` (the vertices are one boundary, in
// order), `fillsOutlines` (all within the outlines is surface), `leastDegree` (null where unknown), and,
// where not all is drawn, `vertexNumbers` and `numbers`: the index of each vertex and triangle in the mesh.

const SLENDER = 10;
/** A picture that is lower than this, in pixels, shows little. */
const LOW = 60;
const MAX_ZOOM = 1e6;
const STEPS = 16;
/** Vertices closer than this, in pixels, go without edges. */
const CROWDED = 1.5;
/** Vertices inside a mesh that are closer than this, in pixels, go without dots, but for poles. */
const DENSE = 4;
/** Vertices with more edges are poles, as for `mindeg inspect`. */
const POLE = 8;

/** A value of a measure with its unit. */
const valueText = (value, { unit }) => (unit === "degrees" ? angleText(value) : numberText(value));

/** The numbers in a base64 string of little-endian bytes. */
function unpack(text, Kind) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return new Kind(bytes.buffer);
}

/** Width and height to draw: what has none, as a plane seen from its edge, is drawn as if it had a little. */
function drawnSize(size) {
  const largest = Math.max(...size) || 1;
  return size.map((length) => Math.max(length, 1e-9 * largest));
}

const isSlender = (size) => Math.max(...size) > SLENDER * Math.min(...size);

/** Whether a picture of so many pixels in width is stretched to fill its place: to scale there would be little to see. */
const wantsStretch = (size, width) => isSlender(size) || (width > 0 && (width * size[1]) / size[0] < LOW);

/** The shape of a picture: a wide domain has a low one, so that several fit on a screen. */
function aspectRatio(size, isStretched) {
  return Math.min(9, isStretched ? 1.6 : Math.max(0.8, size[0] / size[1]));
}

/** Where a picture of some pixels looks: at `view.x`, `view.y`, of a domain of some size. */
class Frame {
  constructor(size, view) {
    Object.assign(this, { size, view, width: 0, height: 0, dots: 1 });
  }

  /** Pixels per unit of length along both axes. */
  scale() {
    const room = [0.94 * this.width - 8, 0.94 * this.height - 8];
    const fit = [room[0] / this.size[0], room[1] / this.size[1]];
    const least = Math.min(...fit);
    return (this.view.stretch ? fit : [least, least]).map((scale) => scale * this.view.zoom);
  }

  toScreen(x, y) {
    const [sx, sy] = this.scale();
    return [this.width / 2 + (x - this.view.x) * sx, this.height / 2 - (y - this.view.y) * sy];
  }

  toDomain(left, top) {
    const [sx, sy] = this.scale();
    return [this.view.x + (left - this.width / 2) / sx, this.view.y - (top - this.height / 2) / sy];
  }

  /** An empty canvas, to be drawn on in pixels of the page. */
  start(canvas) {
    const context = canvas.getContext("2d");
    context.setTransform(this.dots, 0, 0, this.dots, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    return context;
  }
}

/** The colors of pictures by name, given the value of a style's variable; `ramp` from good to bad. */
function colorsOf(variable) {
  const stops = ["good", "middling", "bad"].map((name) => {
    const number = parseInt(variable(name).slice(1), 16);
    return [number >> 16, (number >> 8) & 255, number & 255];
  });
  const mix = (share) => {
    const at = share * 2 >= 1 ? 1 : 0;
    const part = share * 2 - at;
    const channel = (i) => Math.round(stops[at][i] + (stops[at + 1][i] - stops[at][i]) * part);
    return `rgb(${channel(0)},${channel(1)},${channel(2)})`;
  };
  const colors = { ramp: [] };
  for (const name of ["card", "good", "edge", "outline", "ring", "mark"]) colors[name] = variable(name);
  for (let step = 0; step < STEPS; step++) colors.ramp.push(mix(step / (STEPS - 1)));
  return colors;
}

/** The colors of this page. */
function pageColors() {
  const style = getComputedStyle(document.documentElement);
  return colorsOf((name) => style.getPropertyValue("--" + name).trim());
}

/** The place of a degree's color on the scale. */
function degreeStep(degree) {
  const next = DEGREE_COLORS.findIndex((entry) => entry.from > degree);
  return next < 0 ? DEGREE_COLORS.length - 1 : Math.max(0, next - 1);
}

const degreeColor = (degree) => DEGREE_COLORS[degreeStep(degree)].color;

/** Where a value lies on the axis of a measure, 0 to 1. */
function position(measure, value) {
  const [from, to] = measure.range;
  const share = measure.logarithmic
    ? Math.log(value / from) / Math.log(to / from)
    : (value - from) / (to - from);
  return Math.min(1, Math.max(0, share));
}

/** The triangles of a scene by color step for a measure; all in one for none. */
function bySteps(scene, measure) {
  const steps = Array.from({ length: STEPS }, () => []);
  const count = scene.triangles.length / 3;
  for (let i = 0; i < count; i++) {
    let share = measure ? position(measure, scene.values[measure.name][i]) : 0;
    if (measure && measure.higher_is_better) share = 1 - share;
    steps[Math.min(STEPS - 1, Math.floor(share * STEPS))].push(i);
  }
  return steps;
}
