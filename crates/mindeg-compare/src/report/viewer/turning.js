// A stage on which a mesh in space is turned by pointer, wheel and keys.

/** The numbers of a color as a style has it, each 0 to 1. */
function channels(color) {
  const hex = color.match(/^#(..)(..)(..)/);
  const numbers = hex ? hex.slice(1).map((digits) => parseInt(digits, 16)) : color.match(/[\d.]+/g).slice(0, 3).map(Number);
  return numbers.map((value) => value / 255);
}

/** Gives a scene in space what is worked out once. */
function preparedSpace(scene) {
  const { positions, triangles, degrees } = scene;
  const used = new Uint8Array(degrees.length);
  for (const vertex of triangles) used[vertex] = 1;
  const vertices = Array.from(degrees.keys()).filter((vertex) => used[vertex]);
  const dotColors = new Uint8Array(positions.length);
  const byStep = DEGREE_COLORS.map(({ color }) => channels(color).map((value) => Math.round(255 * value)));
  degrees.forEach((degree, vertex) => dotColors.set(byStep[degreeStep(degree)], 3 * vertex));
  return {
    ...scene, bounds: boundsOf(positions), meanEdge: meanEdge(positions, triangles), dotColors,
    used: Uint32Array.from(vertices), poles: Uint32Array.from(vertices.filter((vertex) => degrees[vertex] > POLE)),
  };
}

/**
 * A mesh in space on a stage with two canvases. `told(text, isSpoken)` says what is pointed at. `hasWebGl` is false where
 * a picture is drawn without it.
 */
class SpaceStage {
  constructor(stage, scene, { told, hasDots }) {
    this.scene = preparedSpace(scene);
    Object.assign(this, { stage, told, hasDots, measure: undefined, found: {}, isMoving: false, pointers: new Map() });
    this.camera = new Camera(this.scene.bounds);
    const [mesh, overlay] = stage.querySelectorAll("canvas");
    this.overlay = overlay;
    this.mesh = mesh;
    try {
      this.picture = new Lit(mesh, this.scene);
    } catch {
      this.picture = new Raster(mesh, this.scene);
    }
    stage.dataset.drawn = this.picture instanceof Lit ? "webgl" : "software";
    this.follow();
  }

  /** Colors the triangles by a measure; by none if it is undefined. */
  color(measure) {
    this.measure = measure;
    const { scene } = this;
    const count = scene.triangles.length / 3;
    let steps = measure && scene.steps?.[measure.name];
    if (!steps) {
      steps = new Uint8Array(count);
      if (measure) bySteps(scene, measure).forEach((numbers, step) => numbers.forEach((number) => { steps[number] = step; }));
    }
    this.picture.color(steps);
  }

  look(colors) {
    this.looks = {
      ramp: colors.ramp.flatMap(channels), edge: channels(colors.edge), mark: colors.mark,
      dot: 5 * (window.devicePixelRatio || 1),
    };
  }

  resize() {
    const { width, height } = this.stage.getBoundingClientRect();
    const dots = window.devicePixelRatio || 1;
    Object.assign(this.camera, { width, height });
    this.dots = dots;
    for (const canvas of [this.mesh, this.overlay]) {
      canvas.width = Math.max(1, Math.round(width * dots));
      canvas.height = Math.max(1, Math.round(height * dots));
    }
  }

  /** Draws at the next frame; while it moves, a large mesh coarsely. */
  redraw(isMoving = false) {
    this.isMoving = isMoving;
    clearTimeout(this.resting);
    // Under a pointer that is down, it moves on.
    if (isMoving && !this.pointers.size) this.resting = setTimeout(() => this.redraw(), REST);
    if (this.isDrawing) return;
    this.isDrawing = true;
    requestAnimationFrame(() => {
      this.isDrawing = false;
      this.draw();
    });
  }

  draw() {
    if (!this.camera.width || !this.looks) return;
    this.picture.draw(this.camera, { ...this.looks, hasDots: this.hasDots() }, this.isMoving);
    this.mark();
  }

  /** Marks edges, pairs of vertices one after the other, from now on. */
  emphasize(edges) {
    this.emphasized = edges;
    if (this.looks) this.mark();
  }

  /** Marks what is emphasized, and what is pointed at. */
  mark() {
    const context = this.overlay.getContext("2d");
    context.setTransform(this.dots, 0, 0, this.dots, 0, 0);
    context.clearRect(0, 0, this.camera.width, this.camera.height);
    const { vertex, triangle } = this.found;
    context.strokeStyle = this.looks.mark;
    context.lineWidth = 3;
    context.beginPath();
    for (let i = 0; i < (this.emphasized ?? []).length; i += 2) {
      context.moveTo(...this.placeOf(this.emphasized[i]));
      context.lineTo(...this.placeOf(this.emphasized[i + 1]));
    }
    context.stroke();
    context.lineWidth = 2;
    context.beginPath();
    if (vertex !== undefined) context.arc(...this.placeOf(vertex), 8, 0, 2 * Math.PI);
    else if (triangle !== undefined) {
      for (const corner of this.scene.triangles.subarray(3 * triangle, 3 * triangle + 3)) context.lineTo(...this.placeOf(corner));
      context.closePath();
    }
    context.stroke();
  }

  at(vertex) {
    return this.scene.positions.subarray(3 * vertex, 3 * vertex + 3);
  }

  placeOf(vertex) {
    return this.camera.toScreen(this.at(vertex)).slice(0, 2);
  }

  /** The vertex near a place, or else the triangle at it, of what is in front. */
  pick(x, y) {
    const { triangles, positions, used } = this.scene;
    const pixels = projected(positions, this.camera);
    const triangle = triangleAt(triangles, pixels, x, y);
    // Beside the mesh, a vertex of its rim may be near.
    const candidates = triangle < 0 ? used : triangles.subarray(3 * triangle, 3 * triangle + 3);
    let [vertex, nearest] = [-1, 9];
    for (const candidate of candidates) {
      const apart = Math.hypot(pixels[3 * candidate] - x, pixels[3 * candidate + 1] - y);
      if (apart < nearest) [vertex, nearest] = [candidate, apart];
    }
    return vertex >= 0 ? { vertex } : triangle >= 0 ? { triangle } : {};
  }

  find(found, isSpoken = false) {
    this.found = found;
    this.told(describe(this.angled(found), this.measure, found), isSpoken);
    this.mark();
  }

  /** The scene with the angles of a triangle, where no measures are there to read. */
  angled({ triangle }) {
    const { scene } = this;
    if (triangle === undefined || scene.values.min_angle) return scene;
    const corners = [...scene.triangles.subarray(3 * triangle, 3 * triangle + 3)].map((corner) => [...this.at(corner)]);
    const angle = SpaceStage.angle;
    const angles = corners.map((corner, i) => angle(corner, corners[(i + 1) % 3], corners[(i + 2) % 3]));
    const only = (value) => ({ [triangle]: value });
    return { ...scene, values: { min_angle: only(Math.min(...angles)), max_angle: only(Math.max(...angles)) } };
  }

  /** The angle at a corner, in degrees. */
  static angle(at, to, other) {
    const [u, v] = [to, other].map((end) => end.map((value, axis) => value - at[axis]));
    const dot = u.reduce((sum, value, axis) => sum + value * v[axis], 0);
    const cross = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
    return (Math.atan2(Math.hypot(...cross), dot) * 180) / Math.PI;
  }

  /** Turns to a vertex of maximum degree, or to the worst triangle. */
  jump(target) {
    const { scene, camera } = this;
    const { worst, maxDegreeVertex, triangles } = scene;
    const found = target === "worst" ? { triangle: worst } : { vertex: maxDegreeVertex };
    const corners = target === "worst" ? [...triangles.subarray(3 * worst, 3 * worst + 3)] : [maxDegreeVertex];
    const place = [0, 1, 2].map((axis) => corners.reduce((sum, corner) => sum + this.at(corner)[axis], 0) / corners.length);
    const normal = this.normal(corners);
    if (normal) camera.face(normal, Math.abs(normal[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1]);
    const span = Math.max(...corners.map((corner) => Math.hypot(...this.at(corner).map((value, axis) => value - place[axis]))), 2 * scene.meanEdge);
    camera.fit();
    camera.zoom = Math.min(MAX_ZOOM, Math.max(1, (0.3 * scene.bounds.radius) / span));
    const [x, y] = camera.toScreen(place);
    Object.assign(camera, { x: camera.width / 2 - x, y: camera.height / 2 - y });
    this.find(found, true);
    this.redraw();
  }

  /** The direction out of a triangle, or the mean of those at a vertex. */
  normal(corners) {
    const { triangles } = this.scene;
    const sum = [0, 0, 0];
    const add = (triangle) => {
      const [a, b, c] = [...triangles.subarray(3 * triangle, 3 * triangle + 3)].map((corner) => this.at(corner));
      const [u, v] = [b, c].map((end) => [0, 1, 2].map((axis) => end[axis] - a[axis]));
      for (let i = 0; i < 3; i++) sum[i] += u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    };
    if (corners.length === 3) add(this.scene.worst);
    else triangles.forEach((vertex, i) => { if (vertex === corners[0]) add(Math.floor(i / 3)); });
    const length = Math.hypot(...sum);
    return length > 0 ? sum.map((value) => value / length) : null;
  }

  zoomBy(factor, place) {
    const { camera } = this;
    const zoom = Math.min(MAX_ZOOM, Math.max(0.2, camera.zoom * factor));
    const change = zoom / camera.zoom;
    const [x, y] = place ?? [camera.width / 2, camera.height / 2];
    camera.x = (camera.x + camera.width / 2 - x) * change + x - camera.width / 2;
    camera.y = (camera.y + camera.height / 2 - y) * change + y - camera.height / 2;
    camera.zoom = zoom;
    this.redraw(true);
  }

  fit() {
    this.camera.fit();
    this.camera.face([0.55, -0.7, 0.45], [0, 0, 1]);
    this.find({});
    this.redraw();
  }

  follow() {
    const { stage, camera, pointers } = this;
    const place = (event) => placeIn(stage, event);
    stage.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, place(event));
      stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      const now = place(event);
      if (!before) return this.pointAt(now);
      const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      pointers.set(event.pointerId, now);
      const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      if (others.length === 1) {
        const apart = (at) => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]);
        camera.x += dx / 2;
        camera.y += dy / 2;
        this.zoomBy(apart(now) / Math.max(1, apart(before)), [(now[0] + others[0][0]) / 2, (now[1] + others[0][1]) / 2]);
      } else if (event.shiftKey || event.buttons > 1) {
        camera.x += dx;
        camera.y += dy;
        this.redraw(true);
      } else {
        camera.rotate(dx / 150, dy / 150);
        this.redraw(true);
      }
    });
    const release = (event) => {
      if (pointers.delete(event.pointerId) && !pointers.size && this.isMoving) this.redraw(true);
    };
    for (const kind of ["pointerup", "pointercancel"]) stage.addEventListener(kind, release);
    stage.addEventListener("pointerleave", () => { if (!pointers.size) this.find({}); });
    stage.addEventListener("contextmenu", (event) => event.preventDefault());
    stage.addEventListener("wheel", (event) => {
      // Otherwise the page scrolls, as it should under a pointer passing by.
      if (!event.ctrlKey && document.activeElement !== stage) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-event.deltaY / 300), place(event));
    }, { passive: false });
    stage.addEventListener("dblclick", (event) => this.zoomBy(2, place(event)));
    stage.addEventListener("keydown", (event) => this.key(event));
  }

  /** Reads off what is under a pointer that rests: to find it, a large mesh is drawn again. */
  pointAt([x, y]) {
    clearTimeout(this.pointing);
    this.pointing = setTimeout(() => this.find(this.pick(x, y)), this.scene.triangles.length / 3 > MANY ? REST : 0);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { camera } = this;
    const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const move = moves[event.key];
    if (move && event.shiftKey) {
      camera.x -= (move[0] * camera.width) / 12;
      camera.y -= (move[1] * camera.height) / 12;
    } else if (move) camera.rotate(move[0] * Math.PI / 12, move[1] * Math.PI / 12);
    else if (event.key === "+" || event.key === "=") this.zoomBy(1.5);
    else if (event.key === "-") this.zoomBy(1 / 1.5);
    else if (event.key === "0") this.fit();
    else return;
    event.preventDefault();
    this.redraw(true);
    this.find(this.pick(camera.width / 2, camera.height / 2), true);
  }
}
