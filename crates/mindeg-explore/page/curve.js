// The curve: the largest minimum angle over the maximum degree, to click on, and the same as buttons.
// From the viewer's script: angleText.

const NAMESPACE = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [380, 180];
const [LEFT, RIGHT, TOP, BOTTOM] = [46, 16, 30, 38];

function draw(tag, attributes, text) {
  const made = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

/** As the same shares are written everywhere, by `percent` of mindeg-answers. */
export function percent(share) {
  const whole = Math.round(100 * share);
  if (Math.abs(100 * share - whole) < 1e-9 && (whole || !share)) return `${whole}%`;
  if (share < 0.001) return "<0.1%";
  return share > 0.999 && share < 1 ? ">99.9%" : `${(100 * share).toFixed(1)}%`;
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
  const highest = Math.max(curve.delaunay_min_angle, inside?.min_angle ?? 0, ...points.map(({ min_angle }) => min_angle)) || 1;
  const x = (degree) => LEFT + 20 + ((degree - from) / (to - from + 0.35)) * (WIDTH - LEFT - RIGHT - 20);
  const y = (angle) => HEIGHT - BOTTOM - (angle / highest) * (HEIGHT - TOP - BOTTOM);
  const told = points.map(({ max_degree, min_angle }) => `degree ${max_degree}: ${angleText(min_angle)}`).join(", ");
  const svg = draw("svg", { class: "plot small", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `The curve: ${told}` });
  for (const angle of steps(highest, 4)) {
    svg.append(draw("path", { class: "grid", d: `M${LEFT} ${y(angle)}H${WIDTH - RIGHT}` }));
    svg.append(draw("text", { class: "tick", "text-anchor": "end", x: LEFT - 8, y: y(angle) + 4 }, `${angle}°`));
  }
  const every = Math.ceil(degrees.length / 9);
  [...new Set(degrees)].forEach((degree, place) => {
    if (place % every) return;
    svg.append(draw("text", { class: "tick", "text-anchor": "middle", x: x(degree), y: HEIGHT - BOTTOM + 18 }, String(degree)));
  });
  svg.append(draw("path", { class: "axis", d: `M${LEFT} ${HEIGHT - BOTTOM}H${WIDTH - RIGHT}` }));
  svg.append(draw("text", { class: "tick", "text-anchor": "middle", x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 4 }, "maximum degree"));
  const ceiling = y(curve.delaunay_min_angle);
  svg.append(draw("path", { class: "ceiling", d: `M${LEFT} ${ceiling}H${WIDTH - RIGHT}` }));
  const degree = curve.delaunay_max_degree ? `, degree ${curve.delaunay_max_degree}` : "";
  svg.append(draw("text", { class: "tick", x: LEFT + 4, y: ceiling - 15 }, `Delaunay${degree}: ${angleText(curve.delaunay_min_angle)}`));
  const line = points.map((point, i) => (i ? `H${x(point.max_degree)}V` : `M${x(point.max_degree)} `) + y(point.min_angle));
  svg.append(draw("path", { class: "curve", d: `${line.join("")}H${WIDTH - RIGHT}` }));
  const mark = (value, title, { max_degree, min_angle }) => {
    const group = draw("g", { class: "pick" });
    group.append(draw("title", {}, `Show ${title}: ${angleText(min_angle)}`));
    const at = { cx: x(max_degree), cy: y(min_angle) };
    group.append(draw("circle", { class: "target", ...at, r: 16 }));
    if (value === shown) group.append(draw("circle", { class: "advised", ...at, r: 11 }));
    group.append(draw("circle", { class: "point ringed", ...at, r: 6 }));
    group.dataset.degree = value;
    group.addEventListener("click", () => choose(value));
    svg.append(group);
  };
  for (const point of points) mark(point.max_degree, `degree ${point.max_degree}`, point);
  if (inside) {
    mark("inside", "points inside", inside);
    const isLeft = x(inside.max_degree) > WIDTH / 2;
    svg.append(draw("text", { class: "tick", "text-anchor": isLeft ? "end" : "start",
      x: x(inside.max_degree) + (isLeft ? -16 : 16), y: y(inside.min_angle) + 4 }, "points inside"));
  }
  box.replaceChildren(svg);
}

/** One button for points inside and one for each degree, with its angle. */
function showRows(rows, { points }, inside, shown, choose) {
  const all = [...(inside ? [{ value: "inside", ...inside }] : []), ...points.map((point) => ({ value: point.max_degree, ...point }))];
  // Buttons are kept, so that the one with the focus keeps it.
  while (rows.children.length > all.length) rows.lastChild.remove();
  all.forEach(({ value, max_degree, min_angle, share_of_delaunay: share, exact }, place) => {
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
