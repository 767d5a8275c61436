// All pictures together, and the controls of the page.

const meshes = methods.filter((method) => method.triangles.length);
const isInSpace = positions !== null;
const pictures = [...document.querySelectorAll(".stage")].map((stage) => (isInSpace ? new SpacePicture(stage) : new Picture(stage)));

let isDrawing = false;
let isMarking = false;
let drawingTime = 0;
let later;

/** Draws everything at the next frame; if that takes long, after a pause in moving. */
function redraw(hasMovedOnly = false) {
  clearTimeout(later);
  if (hasMovedOnly && drawingTime > SLOW) later = setTimeout(() => redraw(false), 120);
  else later = undefined;
  if (isDrawing) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    const start = performance.now();
    for (const picture of pictures) {
      if (later) picture.shift();
      else picture.draw();
      picture.mark();
    }
    if (!later) drawingTime = performance.now() - start;
  });
}

function setCursor(place) {
  cursor = place;
  if (isMarking) return;
  isMarking = true;
  requestAnimationFrame(() => {
    isMarking = false;
    for (const picture of pictures) picture.mark();
  });
}

function moveTo(x, y) {
  view.x = Math.min(high[0], Math.max(low[0], x));
  view.y = Math.min(high[1], Math.max(low[1], y));
  redraw(true);
}

/** Zooms, keeping the given place of a picture where it is. */
function zoomBy(factor, picture, place) {
  const before = place ? picture.frame.toDomain(...place) : null;
  view.zoom = Math.min(MAX_ZOOM, Math.max(1, view.zoom * factor));
  if (!before) return redraw(true);
  const after = picture.frame.toDomain(...place);
  moveTo(view.x + before[0] - after[0], view.y + before[1] - after[1]);
}

function fit() {
  Object.assign(view, { x: 0, y: 0, zoom: 1 });
  redraw();
}

function resize() {
  for (const meshes of document.querySelectorAll(".meshes")) {
    meshes.classList.toggle("wide", !view.stretch && size[0] > 3 * size[1]);
  }
  element("stretched").hidden = !view.stretch;
  for (const picture of pictures) picture.resize();
  redraw();
}

function restyle() {
  colors = pageColors();
  showMetricLegend(element("metric-legend"), measure);
  showMeasure();
  redraw();
}

/** The chart of the chosen measure; of the first if none is chosen. */
function showMeasure() {
  const shown = measure ?? data.metrics[0];
  const place = data.metrics.indexOf(shown);
  const rows = meshes.map((method) => ({ name: method.name, counts: method.bars[place] }));
  element("chart-metric").textContent = shown.title.toLowerCase();
  element("chart-note").textContent = shown.explanation;
  showMetricChart(element("metric-chart"), shown, rows, colors);
}

function start() {
  const select = element("metric");
  select.append(...data.metrics.map((measure, place) => new Option(measure.title, String(place))));
  select.append(new Option("nothing", "-1"));
  select.addEventListener("change", () => {
    measure = data.metrics[Number(select.value)];
    for (const picture of pictures) picture.painter.color(measure);
    restyle();
  });
  element("dots").addEventListener("change", () => redraw(false));
  element("stretch").checked = view.stretch;
  element("stretch").addEventListener("change", (event) => {
    view.stretch = event.target.checked;
    resize();
  });
  const zoom = (factor) => (isInSpace ? pictures.forEach(({ space }) => space.zoomBy(factor)) : zoomBy(factor));
  element("zoom-in").addEventListener("click", () => zoom(1.5));
  element("zoom-out").addEventListener("click", () => zoom(1 / 1.5));
  element("fit").addEventListener("click", () => (isInSpace ? pictures.forEach(({ space }) => space.fit()) : fit()));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", restyle);
  // Paper shows all, unfolded, on a light background.
  let folded = [];
  const print = (isPrinting) => () => {
    document.documentElement.classList.toggle("printing", isPrinting);
    if (isPrinting) folded = [...document.querySelectorAll("details:not([open])")];
    for (const details of folded) details.open = isPrinting;
    restyle();
    for (const picture of pictures) {
      picture.resize();
      picture.draw();
    }
  };
  window.addEventListener("beforeprint", print(true));
  window.addEventListener("afterprint", print(false));
  showDegreeLegend(element("degree-legend"), methods.flatMap((method) => [...new Set(method.degrees)]));
  showDegreeChart(element("degree-chart"), data.degrees, meshes.map((method) => ({ name: method.name, counts: method.degreeBars })));
  restyle();
  const observer = new ResizeObserver(resize);
  for (const meshes of document.querySelectorAll(".meshes")) observer.observe(meshes);
  offerCopy();
}

start();
