// Legends and charts.

function make(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

function showDegreeLegend() {
  const legend = element("degree-legend");
  const last = data.degree_colors.length - 1;
  const steps = new Set();
  for (const method of methods) for (const degree of method.degrees) steps.add(degreeStep(degree));
  const items = [...steps].sort((a, b) => a - b).map((step) => {
    const item = make("span", "degree");
    const dot = make("span", "dot");
    dot.style.background = data.degree_colors[step];
    const degree = step + data.lowest_colored_degree;
    item.append(dot, step === last ? `${degree} or more` : String(degree));
    return item;
  });
  legend.replaceChildren(make("strong", "", "Degree"), ...items);
}

function showMetricLegend() {
  const legend = element("metric-legend");
  const measure = data.metrics[metric];
  if (!measure) return legend.replaceChildren();
  const unit = measure.unit === "degrees" ? "°" : "";
  const [from, to] = measure.range.map((value) => short(value) + unit);
  const [hasLess, hasMore] = measure.goes_beyond;
  const ramp = make("span", measure.higher_is_better ? "ramp" : "ramp rising");
  const direction = measure.higher_is_better ? "higher is better" : "lower is better";
  legend.replaceChildren(
    make("strong", "", measure.title), make("span", "", hasLess ? `${from} or less` : from), ramp,
    make("span", "", hasMore ? `${to} or more` : to), make("span", "", `(${direction})`));
}

function chartRow(name, bars) {
  const row = make("div", "chart-row");
  const box = make("div", "bars");
  box.setAttribute("role", "img");
  box.append(...bars);
  row.append(make("b", "", name), box);
  return row;
}

function showDegreeChart() {
  const most = Math.max(...methods.flatMap((method) => method.degreeBars));
  const height = (count) => (count ? (100 * (1 + Math.log2(count))) / (1 + Math.log2(most)) : 0);
  const rows = methods.filter((method) => method.triangles.length).map((method) => {
    const bars = method.degreeBars.map((count, place) => {
      const bar = make("i", count ? "degree-bar" : "");
      const [name, degree] = data.degrees[place];
      bar.style.height = height(count) + "%";
      bar.style.background = data.degree_colors[degreeStep(degree)];
      bar.title = `degree ${name}: ${count} vertices`;
      return bar;
    });
    return chartRow(method.name, bars);
  });
  const axis = make("div", "axis");
  axis.append(...data.degrees.map(([name]) => make("span", "", name.replace(" to ", "–"))));
  const last = make("div", "chart-row");
  last.append(make("b", "", ""), axis);
  element("degree-chart").replaceChildren(...rows, last);
}

/** Round numbers on the axis of a measure. */
function ticks(measure) {
  const [from, to] = measure.range;
  const steps = measure.logarithmic ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const found = [];
  for (let power = Math.floor(Math.log10(from)); power <= Math.ceil(Math.log10(to)); power++) {
    for (const step of steps) {
      const value = step * 10 ** power;
      if (value >= from && value <= to) found.push(value);
    }
  }
  const apart = Math.ceil(found.length / 7);
  return found.filter((_, place) => place % apart === 0);
}

function showMetricChart() {
  const measure = data.metrics[metric] || data.metrics[0];
  const place = data.metrics.indexOf(measure);
  const [from, to] = measure.range;
  const most = Math.max(...methods.flatMap((method) => method.bars[place]));
  const edge = (share) => short(measure.logarithmic
    ? from * (to / from) ** share
    : from + (to - from) * share);
  const rows = methods.filter((method) => method.triangles.length).map((method) => {
    const counts = method.bars[place];
    const bars = counts.map((count, i) => {
      const bar = make("i");
      const share = (i + 0.5) / counts.length;
      const worse = measure.higher_is_better ? 1 - share : share;
      bar.style.height = (count ? Math.max(2, (100 * count) / most) : 0) + "%";
      bar.style.background = colors.ramp[Math.round(worse * (STEPS - 1))];
      bar.style.boxShadow = count ? "inset 0 0 0 1px " + colors.edge : "none";
      bar.title = `${edge(i / counts.length)} to ${edge((i + 1) / counts.length)}: ${count} triangles`;
      return bar;
    });
    return chartRow(method.name, bars);
  });
  const axis = make("div", "axis ticks");
  for (const value of ticks(measure)) {
    const tick = make("span", "", short(value));
    tick.style.left = 100 * position(measure, value) + "%";
    axis.append(tick);
  }
  const last = make("div", "chart-row");
  last.append(make("b", "", ""), axis);
  element("chart-metric").textContent = measure.title.toLowerCase();
  element("chart-note").textContent = measure.explanation;
  element("metric-chart").replaceChildren(...rows, last);
}
