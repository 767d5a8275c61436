// Legends and charts.

function make(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

/** What the colors of some degrees mean. */
function showDegreeLegend(legend, degrees) {
  const steps = new Set(degrees.map(degreeStep));
  const items = [...steps].sort((a, b) => a - b).map((step) => {
    const item = make("span", "degree");
    const dot = make("span", "dot");
    dot.style.background = DEGREE_COLORS[step].color;
    item.append(dot, DEGREE_COLORS[step].name);
    return item;
  });
  legend.replaceChildren(make("strong", "", "Degree"), ...items);
}

/** What the colors of a measure mean; nothing for none. */
function showMetricLegend(legend, measure) {
  if (!measure) return legend.replaceChildren();
  // An end that was chosen, such as 60°, has no decimals.
  const isRound = (value) => Number.isInteger(10 * value);
  const unit = measure.unit === "degrees" ? "°" : "";
  const [from, to] = measure.range.map((value) => (isRound(value) ? numberText(value) + unit : valueText(value, measure)));
  const [hasLess, hasMore] = measure.goes_beyond;
  const ramp = make("span", measure.higher_is_better ? "ramp" : "ramp rising");
  const direction = measure.higher_is_better ? "higher is better" : "lower is better";
  legend.replaceChildren(
    make("strong", "", measure.title), make("span", "", hasLess ? `${from} or less` : from), ramp,
    make("span", "", hasMore ? `${to} or more` : to), make("span", "", `(${direction})`));
}

/** The bars of one mesh, with what they count up to and a name for those who cannot see them. */
function chartRow(name, most, bars, description) {
  const row = make("div", "chart-row");
  const box = make("div", "bars");
  box.setAttribute("role", "img");
  box.setAttribute("aria-label", `${name}: ${description}`);
  box.append(...bars);
  const heading = make("b", "", name);
  heading.append(make("small", "", most));
  row.append(heading, box);
  return row;
}

/** Puts rows over their axis into a chart, in which a bar that is pointed at or tapped is read. */
function showChart(chart, rows, axis, title) {
  const last = make("div", "chart-row");
  const below = make("div");
  below.append(axis, make("p", "scale-title", title));
  last.append(make("b"), below);
  const reading = make("p", "chart-read");
  chart.replaceChildren(...rows, last, reading);
  const read = (event) => {
    if (event.target.title) reading.textContent = event.target.title;
  };
  chart.onpointerover = read;
  chart.onclick = read;
}

/** The places of the degree chart, with a gap where degrees are left out. */
function degreePlaces(ranges, place, gap) {
  return ranges.flatMap(([, from], i) => {
    const skips = i > 0 && ranges[i - 1][2] + 1 < from;
    return skips ? [gap(), place(i)] : [place(i)];
  });
}

const counted = (count, what) => `${count} ${count === 1 ? what : what === "vertex" ? "vertices" : what + "s"}`;

/**
 * How many vertices have each degree: `ranges` are the degrees of each bar, as a name, the lowest and the
 * highest; `rows` the name and the counts of each mesh.
 */
function showDegreeChart(chart, ranges, rows) {
  const most = Math.max(...rows.flatMap(({ counts }) => counts));
  const height = (count) => (count ? (100 * (1 + Math.log2(count))) / (1 + Math.log2(most)) : 0);
  const made = rows.map(({ name, counts }) => {
    const named = (i) => `degree ${ranges[i][0]}: ${counted(counts[i], "vertex")}`;
    const bar = (i) => {
      const made = make("i", counts[i] ? "degree-bar" : "");
      made.style.height = height(counts[i]) + "%";
      made.style.background = degreeColor(ranges[i][1]);
      made.title = `${name}, ${named(i)}`;
      return made;
    };
    const occurring = counts.map((count, i) => (count ? named(i) : "")).filter(Boolean);
    return chartRow(name, `tallest bar: ${counted(Math.max(...counts), "vertex")}`,
      degreePlaces(ranges, bar, () => make("i", "gap")), occurring.join(", "));
  });
  const axis = make("div", "scale");
  axis.append(...degreePlaces(ranges,
    (i) => make("span", "", ranges[i][0].replace(" to ", "–")),
    () => make("span", "gap", "")));
  showChart(chart, made, axis, "degree (edges at a vertex)");
}

/** Round numbers on the axis of a measure. */
function ticks(measure) {
  const [from, to] = measure.range;
  const steps = measure.logarithmic ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const found = from === 0 ? [0] : [];
  const least = from > 0 ? from : to / 20;
  for (let power = Math.floor(Math.log10(least)); power <= Math.ceil(Math.log10(to)); power++) {
    for (const step of steps) {
      const value = step * 10 ** power;
      if (value >= least && value <= to) found.push(value);
    }
  }
  if (found.length < 2) return measure.range;
  const apart = Math.ceil(found.length / 7);
  return found.filter((_, place) => place % apart === 0);
}

/** How many triangles have each value of a measure: `rows` are the name and the counts of each mesh. */
function showMetricChart(chart, measure, rows, colors) {
  const [from, to] = measure.range;
  const most = Math.max(...rows.flatMap(({ counts }) => [...counts]));
  const edge = (share) => numberText(measure.logarithmic
    ? from * (to / from) ** share
    : from + (to - from) * share);
  const unit = measure.unit === "1" ? "" : ` ${measure.unit}`;
  const made = rows.map(({ name, counts }) => {
    const bars = counts.map((count, i) => {
      const bar = make("i");
      const share = (i + 0.5) / counts.length;
      const worse = measure.higher_is_better ? 1 - share : share;
      bar.style.height = (count ? Math.max(2, (100 * count) / most) : 0) + "%";
      bar.style.background = colors.ramp[Math.round(worse * (STEPS - 1))];
      bar.style.boxShadow = count ? "inset 0 0 0 1px " + colors.edge : "none";
      bar.title = `${name}, ${edge(i / counts.length)} to ${edge((i + 1) / counts.length)}: ${counted(count, "triangle")}`;
      return bar;
    });
    const filled = counts.map((count, i) => (count ? i : -1)).filter((i) => i >= 0);
    const range = filled.length
      ? `triangles from ${edge(filled[0] / counts.length)} to ${edge((filled.at(-1) + 1) / counts.length)}${unit}`
      : "no triangles";
    const highest = Math.max(...counts);
    return chartRow(name, `tallest bar: ${counted(highest, "triangle")}`, bars,
      `${measure.title.toLowerCase()}, ${range}; the tallest of ${counts.length} bars has ` +
      `${counted(highest, "triangle")}, from ${edge(counts.indexOf(highest) / counts.length)}${unit}`);
  });
  const axis = make("div", "scale ticks");
  for (const value of ticks(measure)) {
    const tick = make("span", "", numberText(value));
    tick.style.left = 100 * position(measure, value) + "%";
    axis.append(tick);
  }
  showChart(chart, made, axis,
    `${measure.title.toLowerCase()} (${unit.trim() || "no unit"})${measure.logarithmic ? ", logarithmic" : ""}`);
}
