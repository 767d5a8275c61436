// Corners and sides on the picture: what is near a pointer, and the handles.

import { corners, isPoints } from "./domain.js";

/** A corner is taken by a pointer that is nearer, in pixels; a finger is less exact than a mouse. */
const REACH = { mouse: 12, pen: 16, touch: 26 };
/** Where corners are more crowded, in pixels, their handles are dots. */
const CROWDED = 12;

const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The corner near a place of a stage, or null. */
export function cornerAt(domain, shown, frame, place, pointerType) {
  let nearest = REACH[pointerType] ?? REACH.mouse;
  let found = null;
  for (const { ring, index, x, y } of corners(domain, shown)) {
    const distance = apart(frame.toScreen(x, y), place);
    if (distance < nearest) [nearest, found] = [distance, { ring, index }];
  }
  return found;
}

/** The boundary vertices of a side, its end included. */
export function sideLine(shown, { ring, start, intervals }) {
  const [first, end] = [shown.rings[ring], shown.rings[ring + 1]];
  return Array.from({ length: intervals + 1 }, (_, i) => {
    const vertex = first + ((start - first + i) % (end - first));
    return [shown.points[2 * vertex], shown.points[2 * vertex + 1]];
  });
}

/** All sides with their index in their ring. In a ring of points, each edge is a side. */
export function indexedSides(domain, shown) {
  const counts = new Map();
  return shown.sides.flatMap((side) => {
    const { ring, start, intervals } = side;
    if (isPoints(domain, ring)) {
      return Array.from({ length: intervals }, (_, index) => ({ ring, index, start: start + index, intervals: 1 }));
    }
    const index = counts.get(ring) ?? 0;
    counts.set(ring, index + 1);
    return [{ ...side, index }];
  });
}

/** The side near a place of a stage, or null. */
export function sideAt(domain, shown, frame, place) {
  let nearest = 8;
  let found = null;
  for (const side of indexedSides(domain, shown)) {
    const line = sideLine(shown, side).map((point) => frame.toScreen(...point));
    for (let i = 0; i + 1 < line.length; i++) {
      const [a, b] = [line[i], line[i + 1]];
      const length = apart(a, b) || 1;
      const along = ((place[0] - a[0]) * (b[0] - a[0]) + (place[1] - a[1]) * (b[1] - a[1])) / length;
      const at = Math.min(length, Math.max(0, along)) / length;
      const distance = apart(place, [a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1])]);
      if (distance < nearest) [nearest, found] = [distance, side];
    }
  }
  return found;
}

/** A round step, about a fiftieth of the narrow side of a domain. */
export function gridStep([width, height]) {
  const raw = Math.max(Math.min(width, height) / 50, Math.max(width, height) / 2000) || 1;
  const power = 10 ** Math.floor(Math.log10(raw));
  return Number(([5, 2, 1].find((factor) => factor * power <= raw) * power).toPrecision(3));
}

/** A place on the grid; without one, a place with few digits for the size. */
export function snapped([x, y], step, isOn) {
  const unit = isOn ? step : step / 1000;
  return [x, y].map((value) => Number((Math.round(value / unit) * unit).toPrecision(12)));
}

/** Draws the handles of the corners and the chosen side. */
export function drawHandles(context, frame, style, { domain, shown, chosen, side }) {
  context.setLineDash([]);
  if (side && shown) {
    const line = sideLine(shown, side);
    context.strokeStyle = style.accent;
    context.lineWidth = 4;
    context.beginPath();
    for (const point of line) context.lineTo(...frame.toScreen(...point));
    context.stroke();
  }
  const all = corners(domain, shown);
  const places = all.map(({ x, y }) => frame.toScreen(x, y));
  const isCrowded = all.length > 40 && places.some((place, i) => i > 0 && all[i].ring === all[i - 1].ring && apart(place, places[i - 1]) < CROWDED);
  all.forEach(({ ring, index }, i) => {
    const [x, y] = places[i];
    if (x < -12 || y < -12 || x > frame.width + 12 || y > frame.height + 12) return;
    const isChosen = chosen && chosen.ring === ring && chosen.index === index;
    if (isCrowded && !isChosen) return;
    const radius = isChosen ? 8 : 6.5;
    context.beginPath();
    context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
    context.fillStyle = isChosen ? style.accent : style.card;
    context.fill();
    context.strokeStyle = style.accent;
    context.lineWidth = 2.5;
    context.stroke();
  });
}
