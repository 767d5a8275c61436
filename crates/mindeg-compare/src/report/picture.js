// The picture of one mesh: drawing, pointing, moving.

/** For every triangle, which of its edges it draws, as bits: each edge with its highest triangle. */
function edgesByTriangle({ triangles, values }) {
  const heights = values[HEIGHT];
  const numbers = Array.from(heights.keys()).sort((a, b) => heights[b] - heights[a]);
  const drawn = new Set();
  const edges = new Uint8Array(heights.length);
  for (const number of numbers) {
    for (let place = 0; place < 3; place++) {
      const from = triangles[3 * number + place];
      const to = triangles[3 * number + (place + 1) % 3];
      const edge = Math.min(from, to) * 2 ** 32 + Math.max(from, to);
      if (!drawn.has(edge)) edges[number] |= 1 << place;
      drawn.add(edge);
    }
  }
  return edges;
}

class Picture {
  constructor(stage) {
    this.stage = stage;
    this.method = methods[Number(stage.dataset.method)];
    [this.mesh, this.overlay] = stage.querySelectorAll("canvas");
    this.readout = stage.parentElement.querySelector(".readout");
    const order = Array.from(this.method.degrees.keys());
    this.edges = data.is_ring ? null : edgesByTriangle(this.method);
    this.dotColors = Array.from(this.method.degrees, degreeColor);
    this.order = order.sort((a, b) => this.method.degrees[a] - this.method.degrees[b]);
    this.color();
    this.listen();
  }

  color() {
    this.steps = bySteps(this.method);
  }

  resize() {
    // A wide domain has a low picture, so that several fit on a screen; a minimum leaves it legible.
    const ratio = view.stretch ? 1.6 : Math.max(0.8, size[0] / size[1]);
    this.stage.style.aspectRatio = String(Math.min(9, ratio));
    const box = this.stage.getBoundingClientRect();
    this.dots = window.devicePixelRatio || 1;
    this.width = box.width;
    this.height = box.height;
    for (const canvas of [this.mesh, this.overlay]) {
      canvas.width = Math.round(box.width * this.dots);
      canvas.height = Math.round(box.height * this.dots);
    }
  }

  /** Pixels per unit of length along both axes. */
  scale() {
    const room = [0.94 * this.width - 8, 0.94 * this.height - 8];
    const fit = [room[0] / size[0], room[1] / size[1]];
    const least = Math.min(...fit);
    return (view.stretch ? fit : [least, least]).map((scale) => scale * view.zoom);
  }

  toScreen(x, y) {
    const [sx, sy] = this.scale();
    return [this.width / 2 + (x - view.x) * sx, this.height / 2 - (y - view.y) * sy];
  }

  toDomain(left, top) {
    const [sx, sy] = this.scale();
    return [view.x + (left - this.width / 2) / sx, view.y - (top - this.height / 2) / sy];
  }

  start(canvas) {
    const context = canvas.getContext("2d");
    context.setTransform(this.dots, 0, 0, this.dots, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    return context;
  }

  draw() {
    // In a part of the page that is folded away.
    if (!this.width) return;
    const context = this.start(this.mesh);
    this.mesh.style.transform = "";
    this.drawn = { ...view, scale: this.scale() };
    const [sx, sy] = this.scale();
    const [ox, oy] = [this.width / 2 - view.x * sx, this.height / 2 + view.y * sy];
    const { triangles, degrees } = this.method;
    const screen = new Float64Array(points.length);
    for (let i = 0; i < points.length; i += 2) {
      screen[i] = ox + points[i] * sx;
      screen[i + 1] = oy - points[i + 1] * sy;
    }
    const isSeen = (a, b, c) => {
      const [ax, bx, cx] = [screen[a], screen[b], screen[c]];
      const [ay, by, cy] = [screen[a + 1], screen[b + 1], screen[c + 1]];
      return Math.max(ax, bx, cx) >= 0 && Math.min(ax, bx, cx) <= this.width &&
        Math.max(ay, by, cy) >= 0 && Math.min(ay, by, cy) <= this.height;
    };
    const outline = () => {
      context.beginPath();
      for (const line of outlines) {
        context.moveTo(ox + line[0] * sx, oy - line[1] * sy);
        for (let i = 2; i < line.length; i += 2) context.lineTo(ox + line[i] * sx, oy - line[i + 1] * sy);
        if (line[0] === line.at(-2) && line[1] === line.at(-1)) context.closePath();
      }
    };
    const room = this.room(screen);
    // Where triangles are thinned out, what lies between them takes the usual color.
    if (data.fills_outlines) {
      const half = triangles.length / 6;
      let seen = 0;
      const usual = this.steps.findIndex((numbers) => (seen += numbers.length) >= half);
      outline();
      context.fillStyle = colors.ramp[usual];
      context.fill("evenodd");
    }
    // Many small paths are filled much faster than one large one.
    const edges = new Path2D();
    const heights = this.method.values[HEIGHT];
    context.lineWidth = 0.6;
    this.steps.forEach((numbers, step) => {
      context.fillStyle = colors.ramp[step];
      context.strokeStyle = colors.ramp[step];
      for (const number of numbers) {
        const a = triangles[3 * number];
        const b = triangles[3 * number + 1];
        const c = triangles[3 * number + 2];
        if (!isSeen(2 * a, 2 * b, 2 * c)) continue;
        context.beginPath();
        context.moveTo(screen[2 * a], screen[2 * a + 1]);
        context.lineTo(screen[2 * b], screen[2 * b + 1]);
        context.lineTo(screen[2 * c], screen[2 * c + 1]);
        // What covers next to nothing of a pixel would leave little but rounding there.
        const height = heights[number] * Math.min(sx, sy);
        if (height < 0.3) context.stroke();
        else context.fill();
        // Of the triangles at an edge one draws it, and none where edges would run into one another.
        if (this.edges && height < CROWDED) continue;
        for (const [place, from, to] of [[0, a, b], [1, b, c], [2, c, a]]) {
          // Around a ring, both triangles have an interior edge, in opposite directions.
          if (this.edges ? !(this.edges[number] >> place & 1) : from > to) continue;
          if (!this.edges && Math.min(room[from], room[to]) < CROWDED) continue;
          edges.moveTo(screen[2 * from], screen[2 * from + 1]);
          edges.lineTo(screen[2 * to], screen[2 * to + 1]);
        }
      }
    });
    context.strokeStyle = colors.edge;
    context.lineWidth = 0.8;
    context.stroke(edges);
    outline();
    context.strokeStyle = colors.outline;
    context.lineWidth = 1.5;
    context.lineJoin = "round";
    context.stroke();

    if (!element("dots").checked) return;
    // Around a ring, dots have the outside for room; inside a mesh they would hide triangles.
    const share = data.is_ring ? 0.4 : 0.25;
    const radius = (vertex) => Math.min(5.5, Math.max(1.2, room[vertex] * share));
    const isHiding = (vertex) => !data.is_ring && room[vertex] < DENSE && degrees[vertex] <= POLE;
    const isSmall = (vertex) => radius(vertex) < 3;
    context.strokeStyle = colors.ring;
    context.lineWidth = 1.25;
    // Small ones first and plainly: where dots run into one another, the large count.
    for (const areSmall of [true, false]) {
      for (const vertex of this.order) {
        const [x, y, r] = [screen[2 * vertex], screen[2 * vertex + 1], radius(vertex)];
        if (isSmall(vertex) !== areSmall || isHiding(vertex)) continue;
        if (x < -9 || y < -9 || x > this.width + 9 || y > this.height + 9) continue;
        context.fillStyle = this.dotColors[vertex];
        if (areSmall) {
          context.fillRect(x - r, y - r, 2 * r, 2 * r);
        } else {
          context.beginPath();
          context.arc(x, y, r, 0, 2 * Math.PI);
          context.fill();
          context.stroke();
        }
      }
    }
  }

  /** How much room each vertex has to its neighbors, in pixels. */
  room(screen) {
    const room = new Float64Array(points.length / 2).fill(Infinity);
    const join = (a, b, least) => {
      const apart = Math.hypot(screen[2 * a] - screen[2 * b], screen[2 * a + 1] - screen[2 * b + 1]);
      if (apart < least) return;
      room[a] = Math.min(room[a], apart);
      room[b] = Math.min(room[b], apart);
    };
    if (data.is_ring) {
      for (let i = 0; i < room.length; i++) join(i, (i + 1) % room.length, 0);
      return room;
    }
    // Neighbors seen one behind the other share a dot.
    const { triangles } = this.method;
    for (let i = 0; i < triangles.length; i += 3) {
      join(triangles[i], triangles[i + 1], 1);
      join(triangles[i + 1], triangles[i + 2], 1);
      join(triangles[i + 2], triangles[i], 1);
    }
    return room;
  }

  /** Moves and scales what is drawn to where it belongs now. */
  shift() {
    if (!this.drawn) return;
    const [sx, sy] = this.scale();
    const { x, y, scale } = this.drawn;
    this.mesh.style.transform =
      `translate(${(x - view.x) * sx}px, ${(view.y - y) * sy}px) scale(${sx / scale[0]}, ${sy / scale[1]})`;
  }

  /** The vertex near a place, or else the triangle around it. */
  pick(x, y) {
    const [sx, sy] = this.scale();
    let vertex = -1;
    let nearest = 9;
    for (let i = 0; i < points.length / 2; i++) {
      const distance = Math.hypot((points[2 * i] - x) * sx, (points[2 * i + 1] - y) * sy);
      if (distance < nearest) [nearest, vertex] = [distance, i];
    }
    if (vertex >= 0) return { vertex };
    const { triangles } = this.method;
    const left = (from, to) =>
      (points[2 * to] - points[2 * from]) * (y - points[2 * from + 1]) -
      (points[2 * to + 1] - points[2 * from + 1]) * (x - points[2 * from]);
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = triangles.subarray(i, i + 3);
      const [ab, bc, ca] = [left(a, b), left(b, c), left(c, a)];
      // Some meshes have triangles that are clockwise, seen from behind, or flat.
      const isAround = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
      if (isAround && ab + bc + ca !== 0) return { triangle: i / 3 };
    }
    return {};
  }

  describe({ vertex, triangle }) {
    const number = (place) => (vertexNumbers ? vertexNumbers[place] : place);
    if (vertex !== undefined) {
      const degree = this.method.degrees[vertex];
      const above = degree - (data.optimal_max_degree ?? Infinity);
      const note = above > 0 ? `, ${above} above the least possible maximum` : "";
      return `Vertex ${number(vertex)}: degree ${degree}${note}`;
    }
    if (triangle === undefined) return "";
    const { triangles, numbers, values } = this.method;
    const corners = [...triangles.subarray(3 * triangle, 3 * triangle + 3)].map(number);
    const value = (name) => values[data.metrics.findIndex((m) => m.name === name)][triangle];
    const [least, greatest] = [value("min_angle"), value("max_angle")];
    const angles = [least, 180 - least - greatest, greatest].map((angle) => short(angle) + "°");
    const measure = data.metrics[metric];
    const isAngle = !measure || measure.unit === "degrees";
    const chosen = isAngle ? "" : `; ${measure.title.toLowerCase()} ${short(values[metric][triangle])}`;
    return `Triangle ${numbers ? numbers[triangle] : triangle} (${corners.join(", ")}): ` +
      `angles ${angles.join(", ")}${chosen}`;
  }

  /** What is at the cursor: marked in the picture and put into words. */
  mark() {
    if (!this.width) return;
    const context = this.start(this.overlay);
    const found = cursor ? this.pick(cursor.x, cursor.y) : {};
    this.readout.textContent = this.describe(found);
    if (!cursor) return;
    context.strokeStyle = colors.mark;
    context.lineWidth = 2;
    context.beginPath();
    if (found.vertex !== undefined) {
      const place = this.toScreen(points[2 * found.vertex], points[2 * found.vertex + 1]);
      context.arc(...place, 8, 0, 2 * Math.PI);
    } else if (found.triangle !== undefined) {
      for (const vertex of this.method.triangles.subarray(3 * found.triangle, 3 * found.triangle + 3)) {
        context.lineTo(...this.toScreen(points[2 * vertex], points[2 * vertex + 1]));
      }
      context.closePath();
    }
    context.stroke();
    if (cursor.from === this && !cursor.centered) return;
    const [x, y] = this.toScreen(cursor.x, cursor.y);
    context.lineWidth = 1;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + 4 * dx, y + 4 * dy);
      context.lineTo(x + 11 * dx, y + 11 * dy);
    }
    context.stroke();
  }

  /** Where in the picture a pointer is. */
  place(event) {
    const box = this.stage.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  listen() {
    const pointers = new Map();
    const stage = this.stage;
    const pointAt = (event) => {
      const [x, y] = this.toDomain(...this.place(event));
      setCursor({ x, y, from: this });
    };
    stage.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, this.place(event));
      if (event.pointerType === "mouse") stage.setPointerCapture(event.pointerId);
      pointAt(event);
    });
    stage.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return pointAt(event);
      const now = this.place(event);
      const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      pointers.set(event.pointerId, now);
      if (others.length === 1) {
        const apart = (at) => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]);
        const middle = [(now[0] + others[0][0]) / 2, (now[1] + others[0][1]) / 2];
        zoomBy(apart(now) / Math.max(1, apart(before)), this, middle);
      } else if (others.length === 0) {
        const [sx, sy] = this.scale();
        moveTo(view.x - (now[0] - before[0]) / sx, view.y + (now[1] - before[1]) / sy);
      }
    });
    const release = (event) => pointers.delete(event.pointerId);
    stage.addEventListener("pointerup", release);
    stage.addEventListener("pointercancel", release);
    stage.addEventListener("pointerleave", (event) => {
      if (event.pointerType === "mouse" && !pointers.size) setCursor(null);
    });
    stage.addEventListener("wheel", (event) => {
      // Otherwise the page scrolls, as it should under a pointer passing by.
      if (!event.ctrlKey && document.activeElement !== stage) return;
      event.preventDefault();
      zoomBy(Math.exp(-event.deltaY / 300), this, this.place(event));
    }, { passive: false });
    stage.addEventListener("dblclick", (event) => zoomBy(2, this, this.place(event)));
    stage.addEventListener("focus", () => {
      if (stage.matches(":focus-visible")) this.pointAtCenter();
    });
    stage.addEventListener("keydown", (event) => {
      const [sx, sy] = this.scale();
      const step = [this.width / 12 / sx, this.height / 12 / sy];
      const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (moves[event.key]) {
        const [dx, dy] = moves[event.key];
        moveTo(view.x + dx * step[0], view.y + dy * step[1]);
      } else if (event.key === "+" || event.key === "=") zoomBy(1.5);
      else if (event.key === "-") zoomBy(1 / 1.5);
      else if (event.key === "0") fit();
      else return;
      event.preventDefault();
      this.pointAtCenter();
    });
    for (const button of this.stage.parentElement.querySelectorAll("[data-jump]")) {
      button.addEventListener("click", () => this.jump(button.dataset.jump));
    }
  }

  /** For those without a pointer, the middle of the picture is what is pointed at. */
  pointAtCenter() {
    setCursor({ x: view.x, y: view.y, from: this, centered: true });
    element("spoken").textContent = this.describe(this.pick(view.x, view.y));
  }

  /** Shows the busiest vertex, or the worst triangle as large as it goes. */
  jump(target) {
    const { triangles, worst, busiest } = this.method;
    const vertices = target === "worst" ? [...triangles.subarray(3 * worst, 3 * worst + 3)] : [busiest];
    const along = (axis) => vertices.map((vertex) => points[2 * vertex + axis]);
    const [xs, ys] = [along(0), along(1)];
    const span = (values) => Math.max(...values) - Math.min(...values);
    view.zoom = 1;
    const [sx, sy] = this.scale();
    const shown = Math.max((span(xs) * sx) / this.width, (span(ys) * sy) / this.height);
    view.zoom = target === "worst" ? Math.max(1, Math.min(MAX_ZOOM, 0.8 / shown)) : 4;
    const middle = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
    const at = { x: middle(xs), y: middle(ys) };
    moveTo(at.x, at.y);
    setCursor({ ...at, from: this, centered: true });
    element("spoken").textContent = this.describe(this.pick(at.x, at.y));
  }
}
