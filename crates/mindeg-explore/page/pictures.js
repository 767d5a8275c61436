// The pictures on screen: where they look, when they are drawn.
// From the viewer's script: MAX_ZOOM, pageColors.

import { worker } from "./asking.js";
import { drawHandles, indexedSides } from "./editor.js";
import { drawNames } from "./names.js";
import { element } from "./show.js";
import { bounds, isWide, lookAtAll, view, wantsStretchIn } from "./stage.js";
import { selection, shown, state } from "./state.js";

/** The stage of the wanted mesh, and the one beside it. */
export const stages = [];
export const looks = { colors: null, accent: "", card: "", text: "" };

let cursor = null;
let found = {};
let isDrawing = false;
let mustPaint = false;

/** Draws what is marked at the next frame; the meshes, too, if the view has changed. */
export function redraw(hasMoved = false) {
  mustPaint ||= hasMoved;
  if (isDrawing) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    if (mustPaint) {
      const frames = Object.fromEntries(stages.map((stage) => [stage.id, stage.size]));
      const hasDots = element("dots").checked;
      worker.postMessage({ kind: "look", frames, view: { ...view }, size: bounds.size, colors: looks.colors, hasDots });
    }
    mustPaint = false;
    for (const stage of stages) {
      const context = stage.mark(looks.colors, { cursor, found: found[stage.id], decides: shown.decides });
      const marks = (shown.meshes[stage.view]?.marks ?? []).map((mark) => ({ kind: "mark", ...mark }));
      const places = element("names").checked ? shown.places : [];
      if (context && marks.length + places.length) {
        stage.element.dataset.names = drawNames(context, stage.frame, looks, [...marks, ...places]).join(", ");
      } else delete stage.element.dataset.names;
      if (context && stage === stages[0] && shown.domain) {
        const { corner: chosen, drag } = selection;
        drawHandles(context, stage.frame, looks, { domain: state.domain, shown: shown.domain, chosen, side: drag ? null : sideNow() });
      }
    }
  });
}

/** The chosen side as the server has it now. */
export function sideNow() {
  const { side } = selection;
  if (!side) return null;
  return indexedSides(state.domain, shown.domain).find(({ ring, index }) => ring === side.ring && index === side.index) ?? null;
}

export function readLooks() {
  looks.colors = pageColors();
  const computed = getComputedStyle(document.documentElement);
  for (const name of ["accent", "card", "text", "mark"]) looks[name] = computed.getPropertyValue(`--${name}`).trim();
  redraw(true);
}

/** Pictures take the size of their places; they are drawn if that is new, or if they look elsewhere. */
export function resize(hasMoved = true) {
  element("meshes").classList.toggle("wide", isWide());
  element("stretched").hidden = !view.stretch;
  const resized = stages.map((stage) => stage.resize());
  if (hasMoved || resized.includes(true)) redraw(true);
}

/** Whether a domain is partly out of sight, or small, in a picture that nobody has zoomed. */
export function isOff({ center, size }) {
  if (view.zoom > 1) return false;
  return size.some((length, axis) => {
    const whole = bounds.size[axis];
    return Math.abs(center[axis] - bounds.center[axis]) + length / 2 > 0.53 * whole || length < 0.6 * whole;
  });
}

/** Looks at a domain for the first time. */
export function fitAnew() {
  lookAtAll(shown.domain);
  view.stretch = state.stretch ?? wantsStretchIn(element("meshes").clientWidth);
  element("stretch").checked = view.stretch;
  resize();
}

export function fit() {
  if (!shown.domain) return;
  lookAtAll(shown.domain);
  resize();
}

export function moveTo(x, y) {
  [view.x, view.y] = [x, y].map((value, axis) => {
    const [middle, reach] = [bounds.center[axis], bounds.size[axis] / 2];
    return Math.min(middle + reach, Math.max(middle - reach, value));
  });
  redraw(true);
}

/** Zooms, keeping the given place of a stage where it is. */
export function zoomBy(factor, stage, place) {
  const before = place ? stage.frame.toDomain(...place) : null;
  view.zoom = Math.min(MAX_ZOOM, Math.max(1, view.zoom * factor));
  if (!before) return redraw(true);
  const after = stage.frame.toDomain(...place);
  moveTo(view.x + before[0] - after[0], view.y + before[1] - after[1]);
}

/** What is at a place is marked and read off in all pictures; `isSpoken` says it, too. */
export function setCursor(place) {
  cursor = place;
  if (place) worker.postMessage({ kind: "point", place: { x: place.x, y: place.y } });
  else found = {};
  redraw();
}

/** What the worker found at a place. */
export function setFound(place, all) {
  if (place.x !== cursor?.x || place.y !== cursor?.y) return;
  found = all;
  if (cursor.isSpoken) element("spoken").textContent = found[cursor.from.id]?.text || "No mesh here";
  redraw();
}

/** Looks where the worker says, at a vertex or triangle. */
export function jumpTo({ x, y, zoom }) {
  view.zoom = zoom;
  moveTo(x, y);
  setCursor({ x, y, from: stages[0], centered: true, isSpoken: true });
}
