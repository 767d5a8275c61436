// A mesh in space: turned, moved, zoomed and read off. WebGL draws it; without WebGL, raster.js does.
//
// A scene in space is a scene with `positions` (x, y, z of each vertex) in place of `points`, and `steps` (for each
// measure by name, the color of each triangle, 0 to STEPS - 1).

/** Larger meshes are drawn coarser while they move. */
const MANY = 150_000;
/** Edges are drawn where they are at least so long on average, in pixels, and dots where they are so long. */
const [EDGE_ROOM, DOT_ROOM] = [5, 16];
/** Milliseconds without a move after which all is drawn. */
const REST = 120;

/** The middle and the radius of positions. */
function boundsOf(positions) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (let i = 0; i < positions.length; i++) {
    const value = positions[i];
    if (value < low[i % 3]) low[i % 3] = value;
    if (value > high[i % 3]) high[i % 3] = value;
  }
  const center = low.map((value, axis) => (value + high[axis]) / 2);
  const radius = Math.hypot(...low.map((value, axis) => high[axis] - value)) / 2;
  return { center, radius: radius || 1 };
}

/** Each edge once, as pairs of vertices. */
function edgesOf(triangles) {
  const keys = new Float64Array(triangles.length);
  for (let i = 0; i < triangles.length; i++) {
    const [from, to] = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]];
    keys[i] = Math.min(from, to) * 2 ** 26 + Math.max(from, to);
  }
  keys.sort();
  const edges = new Uint32Array(2 * keys.length);
  let length = 0;
  for (let i = 0; i < keys.length; i++) {
    if (i && keys[i] === keys[i - 1]) continue;
    const from = Math.floor(keys[i] / 2 ** 26);
    edges[length++] = from;
    edges[length++] = keys[i] - from * 2 ** 26;
  }
  return edges.subarray(0, length);
}

/** The mean length of some of the edges. */
function meanEdge(positions, triangles) {
  const step = 3 * Math.max(1, Math.floor(triangles.length / 3 / 5000));
  let [sum, count] = [0, 0];
  for (let i = 0; i < triangles.length; i += step) {
    const [a, b] = [3 * triangles[i], 3 * triangles[i + 1]];
    sum += Math.hypot(...[0, 1, 2].map((axis) => positions[a + axis] - positions[b + axis]));
    count++;
  }
  return count ? sum / count : 0;
}

/**
 * The mesh with vertices of a grid joined, with about so many triangles, for moving: `source` has the triangle that each
 * comes from.
 */
function coarsened({ positions, triangles }, { center, radius }, most) {
  let cells = Math.ceil(Math.sqrt(most / 4));
  for (;;) {
    const size = (2 * radius) / cells;
    const first = new Map();
    const joined = new Uint32Array(positions.length / 3);
    for (let v = 0; v < joined.length; v++) {
      const [x, y, z] = [0, 1, 2].map((axis) => Math.floor((positions[3 * v + axis] - center[axis] + radius) / size));
      const key = (x * (cells + 1) + y) * (cells + 1) + z;
      if (!first.has(key)) first.set(key, v);
      joined[v] = first.get(key);
    }
    const kept = [];
    const source = [];
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = [joined[triangles[i]], joined[triangles[i + 1]], joined[triangles[i + 2]]];
      if (a === b || b === c || c === a) continue;
      kept.push(a, b, c);
      source.push(i / 3);
    }
    if (source.length <= 1.5 * most || cells < 8) return { positions, triangles: Uint32Array.from(kept), source: Uint32Array.from(source) };
    cells = Math.floor(cells * 0.7);
  }
}

/** The columns of a turn and a move, from positions to pixels of a stage and a depth from -1 to 1. */
class Camera {
  constructor({ center, radius }) {
    Object.assign(this, { center, radius, x: 0, y: 0, zoom: 1, width: 1, height: 1 });
    this.face([0.55, -0.7, 0.45], [0, 0, 1]);
  }

  /** Looks from a direction. */
  face(from, up) {
    const { m4 } = twgl;
    this.turn = m4.inverse(m4.lookAt(from, [0, 0, 0], up));
    this.turn.fill(0, 12, 15);
  }

  /** Turns about the axes of the screen, in radians. */
  rotate(right, down) {
    const { m4 } = twgl;
    this.turn = m4.multiply(m4.multiply(m4.rotationX(down), m4.rotationY(right)), this.turn);
  }

  get scale() {
    return (0.47 * Math.min(this.width, this.height) * this.zoom) / this.radius;
  }

  fit() {
    Object.assign(this, { x: 0, y: 0, zoom: 1 });
  }

  /** The matrix from positions to the pixels of the stage, y down, with the depth in z: larger is nearer. */
  get toPixels() {
    const { m4 } = twgl;
    const { scale, turn, center, width, height, x, y } = this;
    const place = m4.translation([width / 2 + x, height / 2 + y, 0]);
    return m4.translate(m4.multiply(m4.scale(place, [scale, -scale, 1 / this.radius]), turn), center.map((value) => -value));
  }

  /** The same to the clip space of WebGL. */
  get toClip() {
    const { m4 } = twgl;
    const { width, height } = this;
    const clip = m4.translation([-1, 1, 0]);
    m4.scale(clip, [2 / width, -2 / height, -1 / 1.01], clip);
    return m4.multiply(clip, this.toPixels);
  }

  toScreen([x, y, z]) {
    return twgl.m4.transformPoint(this.toPixels, [x, y, z]);
  }
}

/** All positions in pixels of the stage, with the depth of [`Camera.toPixels`]. */
function projected(positions, camera) {
  const m = camera.toPixels;
  const pixels = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    pixels[i] = m[0] * x + m[4] * y + m[8] * z + m[12];
    pixels[i + 1] = m[1] * x + m[5] * y + m[9] * z + m[13];
    pixels[i + 2] = m[2] * x + m[6] * y + m[10] * z + m[14];
  }
  return pixels;
}

/** The nearest to the eye of all triangles at a place of the stage, or -1. */
function triangleAt(triangles, pixels, x, y) {
  let [found, nearest] = [-1, -Infinity];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    const [ax, ay, bx, by, cx, cy] = [pixels[a] - x, pixels[a + 1] - y, pixels[b] - x, pixels[b + 1] - y, pixels[c] - x, pixels[c + 1] - y];
    const [u, v, w] = [bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) continue;
    const area = u + v + w;
    if (!area) continue;
    const depth = (u * pixels[a + 2] + v * pixels[b + 2] + w * pixels[c + 2]) / area;
    if (depth > nearest) [found, nearest] = [i / 3, depth];
  }
  return found;
}

/** What draws with WebGL; throws where there is none. */
class Lit {
  constructor(canvas, scene) {
    // Where a processor draws, smooth edges double the work.
    const antialias = scene.triangles.length / 3 <= MANY;
    this.gl = canvas.getContext("webgl2", { antialias, powerPreference: "high-performance" });
    if (!this.gl) throw new Error("no WebGL");
    this.canvas = canvas;
    this.faces = twgl.createProgramInfo(this.gl, [Lit.FACES, Lit.SHADE]);
    this.plain = twgl.createProgramInfo(this.gl, [Lit.PLAIN, Lit.FLAT]);
    this.scene = scene;
    this.whole = this.prepare(scene.positions, scene.triangles, null);
  }

  /** Buffers in which the last corner of each triangle is its alone: it carries the triangle's color. */
  prepare(positions, triangles, source) {
    const count = triangles.length / 3;
    const vertices = positions.length / 3;
    const owner = new Int32Array(vertices + count).fill(-1);
    const copies = new Uint32Array(count);
    const indices = new Uint32Array(triangles.length);
    let next = vertices;
    for (let i = 0; i < count; i++) {
      let last = 0;
      while (last < 3 && owner[triangles[3 * i + last]] >= 0) last++;
      const own = last < 3;
      if (!own) last = 2;
      for (let k = 0; k < 3; k++) indices[3 * i + k] = triangles[3 * i + ((last + 1 + k) % 3)];
      if (!own) {
        copies[next - vertices] = indices[3 * i + 2];
        indices[3 * i + 2] = next++;
      }
      owner[indices[3 * i + 2]] = i;
    }
    const all = new Float32Array(3 * next);
    all.set(positions);
    for (let v = vertices; v < next; v++) for (let axis = 0; axis < 3; axis++) all[3 * v + axis] = positions[3 * copies[v - vertices] + axis];
    const buffers = twgl.createBufferInfoFromArrays(this.gl, {
      position: { numComponents: 3, data: all },
      step: { numComponents: 1, data: new Float32Array(next), drawType: this.gl.DYNAMIC_DRAW },
      indices: { numComponents: 3, data: indices },
    });
    return { buffers, owner: owner.subarray(0, next), source, steps: new Float32Array(next) };
  }

  /** Gives each triangle its color. */
  color(steps) {
    this.steps = steps;
    for (const part of [this.whole, this.coarse]) if (part) this.colorPart(part);
  }

  colorPart(part) {
    const { gl } = this;
    for (let v = 0; v < part.owner.length; v++) {
      const triangle = part.owner[v];
      if (triangle >= 0) part.steps[v] = this.steps[part.source ? part.source[triangle] : triangle];
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, part.buffers.attribs.step.buffer);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, part.steps);
  }

  draw(camera, look, isMoving) {
    const { gl, canvas, scene } = this;
    const isCoarse = isMoving && scene.triangles.length / 3 > MANY;
    if (isCoarse && !this.coarse) {
      const { positions, triangles, source } = coarsened(scene, scene.bounds, MANY / 3);
      this.coarse = this.prepare(positions, triangles, source);
      this.colorPart(this.coarse);
    }
    const part = isCoarse ? this.coarse : this.whole;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.faces.program);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    twgl.setBuffersAndAttributes(gl, this.faces, part.buffers);
    twgl.setUniforms(this.faces, { toClip: camera.toClip, turn: camera.turn, ramp: look.ramp });
    twgl.drawBufferInfo(gl, part.buffers);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    const room = scene.meanEdge * camera.scale;
    if (isCoarse) return;
    gl.useProgram(this.plain.program);
    if (room >= EDGE_ROOM) {
      this.lines ??= this.listed("color", edgesOf(scene.triangles), new Uint8Array(scene.positions.length));
      twgl.setBuffersAndAttributes(gl, this.plain, this.lines);
      twgl.setUniforms(this.plain, { toClip: camera.toClip, size: 1, nearer: 0.0004, own: [...look.edge, 1] });
      twgl.drawBufferInfo(gl, this.lines, gl.LINES);
    }
    if (!look.hasDots) return;
    if (room >= DOT_ROOM) this.dots(camera, (this.points ??= this.listed("color", scene.used, scene.dotColors)), look);
    else if (scene.poles.length) this.dots(camera, (this.poles ??= this.listed("color", scene.poles, scene.dotColors)), look);
  }

  dots(camera, buffers, look) {
    const { gl } = this;
    twgl.setBuffersAndAttributes(gl, this.plain, buffers);
    twgl.setUniforms(this.plain, { toClip: camera.toClip, size: look.dot, nearer: 0.002, own: [0, 0, 0, 0] });
    twgl.drawBufferInfo(gl, buffers, gl.POINTS);
  }

  listed(name, indices, colors) {
    return twgl.createBufferInfoFromArrays(this.gl, {
      position: { numComponents: 3, data: this.scene.positions },
      [name]: { numComponents: 3, data: colors, normalize: true },
      indices: { numComponents: 1, data: indices },
    });
  }
}

Lit.FACES = `#version 300 es
in vec3 position;
in float step;
uniform mat4 toClip;
uniform mat4 turn;
flat out float own;
out vec3 seen;
void main() {
  gl_Position = toClip * vec4(position, 1.0);
  seen = mat3(turn) * position;
  own = step;
}`;

Lit.SHADE = `#version 300 es
precision highp float;
flat in float own;
in vec3 seen;
uniform vec3 ramp[${STEPS}];
out vec4 color;
void main() {
  vec3 across = cross(dFdx(seen), dFdy(seen));
  float facing = abs(across.z) / max(length(across), 1e-30);
  float light = 0.45 + 0.55 * facing;
  color = vec4(ramp[int(own)] * (gl_FrontFacing ? light : 0.6 * light), 1.0);
}`;

Lit.PLAIN = `#version 300 es
in vec3 position;
in vec3 color;
uniform mat4 toClip;
uniform float size;
uniform float nearer;
uniform vec4 own;
out vec4 shown;
void main() {
  gl_Position = toClip * vec4(position, 1.0);
  gl_Position.z -= nearer;
  gl_PointSize = size;
  shown = own.a > 0.0 ? own : vec4(color, 1.0);
}`;

Lit.FLAT = `#version 300 es
precision mediump float;
in vec4 shown;
out vec4 color;
void main() {
  color = shown;
}`;
