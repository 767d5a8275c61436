// The curve: the largest minimum angle over the maximum degree, to click on, and the same as buttons.
// From the viewer's script: angleText, percent.

const NAMESPACE = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [380, 180];
const [LEFT, RIGHT, TOP, BOTTOM] = [46, 16, 30, 38];

function draw(tag, attributes, text) {
  const made = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

/** So many degrees are listed at once, and have large points on the curve. */
const LISTED = 12;
/** Numbers on the axis of degrees are so far apart, at least. */
const APART = 34;

/** The points to list: all, or some that are spread over the curve, with the one that is advised and the one that is shown. */
export function listedPoints({ points, advised }, shown) {
  if (points.length <= LISTED) return points;
  const spread = new Set(Array.from({ length: LISTED - 2 }, (_, i) => Math.round((i * (points.length - 1)) / (LISTED - 3))));
  return points.filter(({ max_degree: degree }, place) => spread.has(place) || degree === advised || degree === shown);
}

/** Round steps of an axis up to `highest`. */
function steps(highest, most) {
  const raw = highest / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= raw);
  return Array.from({ length: Math.floor(highest / step + 1e-9) + 1 }, (_, i) => Number((i * step).toPrecision(6)));
}

/**
 * `inside` has the figures of the mesh with points inside, if they are known. `shown` is a degree whose mesh is in the
 * picture, or "inside"; `choose` is called with one of them.
 */
export function showCurve(box, rows, curve, inside, shown, choose) {
  const { points } = curve;
  if (!points.length) {
    box.replaceChildren();
    rows.replaceChildren();
    return;
  }
  showRows(rows, curve, inside, shown, choose);
  if (points.length < 2 && !inside) {
    box.replaceChildren();
    return;
  }
  const degrees = [...points, ...(inside ? [inside] : [])].map(({ max_degree }) => max_degree);
  const [from, to] = [Math.min(...degrees), Math.max(...degrees)];
  const highest = Math.max(curve.angle_limit, inside?.min_angle ?? 0, ...points.map(({ min_angle }) => min_angle)) || 1;
  const x = (degree) => LEFT + 20 + ((degree - from) / (to - from + 0.35)) * (WIDTH - LEFT - RIGHT - 20);
  const y = (angle) => HEIGHT - BOTTOM - (angle / highest) * (HEIGHT - TOP - BOTTOM);
  const listed = listedPoints(curve, shown);
  const told = listed.map(({ max_degree, min_angle }) => `degree ${max_degree}: ${angleText(min_angle)}`).join(", ");
  const svg = draw("svg", { class: "plot small", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `The curve: ${told}` });
  for (const angle of steps(highest, 4)) {
    svg.append(draw("path", { class: "grid", d: `M${LEFT} ${y(angle)}H${WIDTH - RIGHT}` }));
    svg.append(draw("text", { class: "tick", "text-anchor": "end", x: LEFT - 8, y: y(angle) + 4 }, `${angle}°`));
  }
  const numbered = [];
  // Degrees that are proposed have a number in any case.
  const proposed = [inside?.max_degree, curve.advised, points[0].max_degree].filter((degree) => degree !== undefined && degree !== null);
  for (const degree of [...proposed, ...listed.map(({ max_degree: listedDegree }) => listedDegree)]) {
    if (numbered.some((other) => other === degree || Math.abs(x(other) - x(degree)) < APART)) continue;
    numbered.push(degree);
    svg.append(draw("text", { class: "tick", "text-anchor": "middle", x: x(degree), y: HEIGHT - BOTTOM + 18 }, String(degree)));
  }
  svg.append(draw("path", { class: "axis", d: `M${LEFT} ${HEIGHT - BOTTOM}H${WIDTH - RIGHT}` }));
  svg.append(draw("text", { class: "tick", "text-anchor": "middle", x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 4 }, "maximum degree"));
  const ceiling = y(curve.angle_limit);
  svg.append(draw("path", { class: "ceiling", d: `M${LEFT} ${ceiling}H${WIDTH - RIGHT}` }));
  const degree = curve.delaunay_max_degree ? `, degree ${curve.delaunay_max_degree}` : "";
  svg.append(draw("text", { class: "tick", x: LEFT + 4, y: ceiling - 15 }, `Delaunay${degree}: ${angleText(curve.angle_limit)}`));
  const line = points.map((point, i) => (i ? `H${x(point.max_degree)}V` : `M${x(point.max_degree)} `) + y(point.min_angle));
  svg.append(draw("path", { class: "curve", d: `${line.join("")}H${WIDTH - RIGHT}` }));
  const mark = (value, title, { max_degree, min_angle }) => {
    const group = draw("g", { class: "pick" });
    group.append(draw("title", {}, `Show ${title}: ${angleText(min_angle)}`));
    const at = { cx: x(max_degree), cy: y(min_angle) };
    const isSmall = value !== "inside" && !listed.some((point) => point.max_degree === value);
    group.append(draw("circle", { class: "target", ...at, r: isSmall ? 4 : 16 }));
    if (value === shown) group.append(draw("circle", { class: "advised", ...at, r: 11 }));
    group.append(draw("circle", { class: isSmall ? "point" : "point ringed", ...at, r: isSmall ? 2 : 6 }));
    group.dataset.degree = value;
    group.addEventListener("click", () => choose(value));
    svg.append(group);
  };
  // Large targets lie below small ones.
  for (const point of [...listed, ...points.filter((other) => !listed.includes(other))]) mark(point.max_degree, `degree ${point.max_degree}`, point);
  if (inside) {
    mark("inside", "points inside", inside);
    const isLeft = x(inside.max_degree) > WIDTH / 2;
    svg.append(draw("text", { class: "tick", "text-anchor": isLeft ? "end" : "start",
      x: x(inside.max_degree) + (isLeft ? -16 : 16), y: y(inside.min_angle) + 4 }, "points inside"));
  }
  box.replaceChildren(svg);
}

/** One button for points inside and one for each degree that is listed, with its angle. */
function showRows(rows, curve, inside, shown, choose) {
  const points = listedPoints(curve, shown);
  const all = [...(inside ? [{ value: "inside", ...inside }] : []), ...points.map((point) => ({ value: point.max_degree, ...point }))];
  // Buttons are kept, so that the one with the focus keeps it.
  while (rows.children.length > all.length) rows.lastChild.remove();
  all.forEach(({ value, max_degree, min_angle, share_of_limit: share, exact }, place) => {
    const isInside = value === "inside";
    let button = rows.children[place];
    if (!button) {
      button = document.createElement("button");
      button.type = "button";
      button.append(...["b", "span", "small"].map((tag) => document.createElement(tag)));
      button.addEventListener("click", () => choose(Number(button.dataset.degree) || "inside"));
      rows.append(button);
    }
    button.dataset.degree = value;
    button.setAttribute("aria-pressed", String(value === shown));
    const [name, angle, note] = button.children;
    name.textContent = isInside ? "points inside" : `degree ${max_degree}`;
    angle.textContent = angleText(min_angle);
    // No mesh of these points has more than all of it.
    const more = exact || share > 0.999 ? "" : " or more";
    note.textContent = isInside ? `degree ${max_degree}` : `${percent(share)}${more} of Delaunay’s`;
  });
}
