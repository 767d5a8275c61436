// Drawing a scene.

/** The least height of each triangle: what is thinner than a pixel is drawn in another way. */
function leastHeights({ points, triangles }) {
  const heights = new Float32Array(triangles.length / 3);
  for (let i = 0; i < heights.length; i++) {
    const [a, b, c] = [2 * triangles[3 * i], 2 * triangles[3 * i + 1], 2 * triangles[3 * i + 2]];
    const [ux, uy] = [points[b] - points[a], points[b + 1] - points[a + 1]];
    const [vx, vy] = [points[c] - points[a], points[c + 1] - points[a + 1]];
    const longest = Math.sqrt(Math.max(ux * ux + uy * uy, vx * vx + vy * vy, (ux - vx) ** 2 + (uy - vy) ** 2));
    heights[i] = longest ? Math.abs(ux * vy - uy * vx) / longest : 0;
  }
  return heights;
}

/** For every triangle, which of its edges it draws, as bits: each edge with its highest triangle. */
function edgesByTriangle({ triangles }, heights) {
  const edges = new Uint8Array(heights.length);
  // A table of edges, several times faster than a Set: each has the place in `triangles`, plus one, where what draws it begins it.
  const bits = Math.ceil(Math.log2(2 * triangles.length + 2));
  const table = new Uint32Array(2 ** bits);
  for (let at = 0; at < triangles.length; at++) {
    const number = Math.floor(at / 3);
    const [from, to] = [triangles[at], triangles[3 * number + (at + 1) % 3]];
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    let slot = (Math.imul(low, 0x9e3779b1) + Math.imul(high, 0x85ebca6b)) >>> (32 - bits);
    for (; ; slot = (slot + 1) % table.length) {
      const other = table[slot] - 1;
      const rival = Math.floor(other / 3);
      if (other >= 0) {
        const [a, b] = [triangles[other], triangles[3 * rival + (other + 1) % 3]];
        if (Math.min(a, b) !== low || Math.max(a, b) !== high) continue;
        if (heights[rival] >= heights[number]) break;
        edges[rival] &= ~(1 << other % 3);
      }
      table[slot] = at + 1;
      edges[number] |= 1 << at % 3;
      break;
    }
  }
  return edges;
}

/** What draws one scene, with what it works out once. */
class Painter {
  constructor(scene, measure) {
    this.scene = scene;
    this.heights = scene.values.minimum_height ?? leastHeights(scene);
    this.edges = scene.isRing ? null : edgesByTriangle(scene, this.heights);
    this.dotColors = Array.from(scene.degrees, degreeColor);
    const byDegree = [];
    scene.degrees.forEach((degree, vertex) => (byDegree[degree] ??= []).push(vertex));
    this.order = byDegree.flat();
    this.color(measure);
  }

  /** Colors the triangles by a measure; by none if it is undefined. */
  color(measure) {
    this.steps = bySteps(this.scene, measure);
  }

  paint(context, frame, colors, hasDots) {
    const { scene, heights, edges: drawnEdges } = this;
    const { points, triangles, degrees, isRing } = scene;
    const { width, height } = frame;
    const [sx, sy] = frame.scale();
    const [ox, oy] = [width / 2 - frame.view.x * sx, height / 2 + frame.view.y * sy];
    const screen = new Float64Array(points.length);
    for (let i = 0; i < points.length; i += 2) {
      screen[i] = ox + points[i] * sx;
      screen[i + 1] = oy - points[i + 1] * sy;
    }
    const isSeen = (a, b, c) => {
      const { min, max } = Math;
      return max(screen[a], screen[b], screen[c]) >= 0 && min(screen[a], screen[b], screen[c]) <= width &&
        max(screen[a + 1], screen[b + 1], screen[c + 1]) >= 0 && min(screen[a + 1], screen[b + 1], screen[c + 1]) <= height;
    };
    const outline = () => {
      context.beginPath();
      for (const line of scene.outlines) {
        context.moveTo(ox + line[0] * sx, oy - line[1] * sy);
        for (let i = 2; i < line.length; i += 2) context.lineTo(ox + line[i] * sx, oy - line[i + 1] * sy);
        if (line[0] === line.at(-2) && line[1] === line.at(-1)) context.closePath();
      }
    };
    const room = this.room(screen);
    // The usual color is that of the whole: so it is between triangles that are thinned out, too, and most are not drawn one by one.
    let usual = -1;
    if (scene.fillsOutlines) {
      const half = triangles.length / 6;
      let seen = 0;
      usual = this.steps.findIndex((numbers) => (seen += numbers.length) >= half);
      outline();
      context.fillStyle = colors.ramp[usual];
      context.fill("evenodd");
    }
    // Many small paths are filled much faster than one large one.
    const edges = new Path2D();
    context.lineWidth = 0.6;
    this.steps.forEach((numbers, step) => {
      context.fillStyle = colors.ramp[step];
      context.strokeStyle = colors.ramp[step];
      for (const number of numbers) {
        const a = triangles[3 * number];
        const b = triangles[3 * number + 1];
        const c = triangles[3 * number + 2];
        if (!isSeen(2 * a, 2 * b, 2 * c)) continue;
        const height = heights[number] * Math.min(sx, sy);
        if (step !== usual) {
          context.beginPath();
          context.moveTo(screen[2 * a], screen[2 * a + 1]);
          context.lineTo(screen[2 * b], screen[2 * b + 1]);
          context.lineTo(screen[2 * c], screen[2 * c + 1]);
          // A triangle that covers next to nothing of a pixel would leave little but rounding there.
          if (height < 0.3) context.stroke();
          else context.fill();
        }
        // Of the triangles at an edge one draws it, and none where edges would run into one another.
        if (drawnEdges && height < CROWDED) continue;
        for (let place = 0; place < 3; place++) {
          const from = triangles[3 * number + place];
          const to = triangles[3 * number + (place + 1) % 3];
          // Around a ring, both triangles have an interior edge, in opposite directions.
          if (drawnEdges ? !(drawnEdges[number] >> place & 1) : from > to) continue;
          if (!drawnEdges && Math.min(room[from], room[to]) < CROWDED) continue;
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

    if (!hasDots) return;
    // Around a ring, dots have the outside for room; inside a mesh they would hide triangles.
    const share = isRing ? 0.4 : 0.25;
    const radius = (vertex) => Math.min(5.5, Math.max(1.2, room[vertex] * share));
    const isHiding = (vertex) => !isRing && room[vertex] < DENSE && degrees[vertex] <= POLE;
    const isSmall = (vertex) => radius(vertex) < 3;
    context.strokeStyle = colors.ring;
    context.lineWidth = 1.25;
    // Small ones first and plainly: where dots run into one another, the large count.
    for (const areSmall of [true, false]) {
      for (const vertex of this.order) {
        const [x, y, r] = [screen[2 * vertex], screen[2 * vertex + 1], radius(vertex)];
        if (isSmall(vertex) !== areSmall || isHiding(vertex)) continue;
        if (x < -9 || y < -9 || x > width + 9 || y > height + 9) continue;
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
    const room = new Float64Array(screen.length / 2).fill(Infinity);
    const join = (a, b, least) => {
      const apart = Math.hypot(screen[2 * a] - screen[2 * b], screen[2 * a + 1] - screen[2 * b + 1]);
      if (apart < least) return;
      room[a] = Math.min(room[a], apart);
      room[b] = Math.min(room[b], apart);
    };
    if (this.scene.isRing) {
      for (let i = 0; i < room.length; i++) join(i, (i + 1) % room.length, 0);
      return room;
    }
    // Neighbors seen one behind the other share a dot.
    const { triangles } = this.scene;
    for (let i = 0; i < triangles.length; i += 3) {
      join(triangles[i], triangles[i + 1], 1);
      join(triangles[i + 1], triangles[i + 2], 1);
      join(triangles[i + 2], triangles[i], 1);
    }
    return room;
  }
}
