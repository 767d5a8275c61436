// The vertex, edge or triangle at a place of a scene, in words and marked.

/** The vertex near a place, or else the triangle around it. */
function pick({ points, triangles }, frame, x, y) {
  const [sx, sy] = frame.scale();
  let vertex = -1;
  let nearest = 9;
  for (let i = 0; i < points.length / 2; i++) {
    const distance = Math.hypot((points[2 * i] - x) * sx, (points[2 * i + 1] - y) * sy);
    if (distance < nearest) [nearest, vertex] = [distance, i];
  }
  if (vertex >= 0) return { vertex };
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

function describe(scene, measure, { vertex, triangle }) {
  const number = (place) => (scene.vertexNumbers ? scene.vertexNumbers[place] : place);
  if (vertex !== undefined) {
    const degree = scene.degrees[vertex];
    const above = degree - (scene.leastDegree ?? Infinity);
    const note = above > 0 ? `, ${above} above the least possible maximum` : "";
    return `Vertex ${number(vertex)}: degree ${degree}${note}`;
  }
  if (triangle === undefined) return "";
  const { triangles, numbers, values } = scene;
  const corners = [...triangles.subarray(3 * triangle, 3 * triangle + 3)].map(number);
  const named = `Triangle ${numbers ? numbers[triangle] : triangle} (${corners.join(", ")})`;
  const known = [];
  const hasAngles = values.min_angle && values.max_angle;
  if (hasAngles) {
    const [least, greatest] = [values.min_angle[triangle], values.max_angle[triangle]];
    known.push(`angles ${[least, 180 - least - greatest, greatest].map(angleText).join(", ")}`);
  }
  if (measure && !(hasAngles && measure.unit === "degrees")) {
    known.push(`${measure.title.toLowerCase()} ${valueText(values[measure.name][triangle], measure)}`);
  }
  return known.length ? `${named}: ${known.join("; ")}` : named;
}

/** Draws a line around what was found. */
function outlineFound(context, frame, { points, triangles }, { vertex, triangle }) {
  context.lineWidth = 2;
  context.beginPath();
  if (vertex !== undefined) {
    const place = frame.toScreen(points[2 * vertex], points[2 * vertex + 1]);
    context.arc(...place, 8, 0, 2 * Math.PI);
  } else if (triangle !== undefined) {
    for (const corner of triangles.subarray(3 * triangle, 3 * triangle + 3)) {
      context.lineTo(...frame.toScreen(points[2 * corner], points[2 * corner + 1]));
    }
    context.closePath();
  }
  context.stroke();
}

/** Draws a cross, open in the middle. */
function drawCross(context, [x, y]) {
  context.lineWidth = 1;
  context.beginPath();
  for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    context.moveTo(x + 4 * dx, y + 4 * dy);
    context.lineTo(x + 11 * dx, y + 11 * dy);
  }
  context.stroke();
}

/** Where to look, and how near, to see a vertex, or a triangle as large as it goes. */
function lookAt({ points, triangles }, frame, { vertex, triangle }) {
  const corners = triangle === undefined ? [vertex] : [...triangles.subarray(3 * triangle, 3 * triangle + 3)];
  const along = (axis) => corners.map((corner) => points[2 * corner + axis]);
  const span = (values) => Math.max(...values) - Math.min(...values);
  const [xs, ys] = [along(0), along(1)];
  const [sx, sy] = frame.scale().map((scale) => scale / frame.view.zoom);
  const shown = Math.max((span(xs) * sx) / frame.width, (span(ys) * sy) / frame.height);
  const zoom = triangle === undefined ? 4 : Math.max(1, Math.min(MAX_ZOOM, 0.8 / shown));
  const middle = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  return { x: middle(xs), y: middle(ys), zoom };
}
