// Changes of a domain's JSON. Each function returns a new domain and leaves the one it is given alone.
//
// `shown` is the domain as the server understood it: `points` (x and y of each boundary vertex), `rings`
// (the first vertex of each, then the number of vertices) and `sides`. A ring whose corners ran the other
// way round is reversed there: its first corner stays, and every side keeps its edge.

/** The ring of corners or points with an index: 0 is the outline, then come the holes. */
const ringOf = (domain, ring) => (ring === 0 ? domain.polygon ?? domain : domain.holes[ring - 1]);
const listOf = (ring) => ring.corners ?? ring.ring;
/** Sides stand beside `polygon`, but within a hole. */
const sidesHolder = (domain, ring) => (ring === 0 ? domain : domain.holes[ring - 1]);

const copy = (domain) => structuredClone(domain);
const point = (shown, vertex) => [shown.points[2 * vertex], shown.points[2 * vertex + 1]];

/** A number without digits that rounding has left, for a domain of some size. */
function tidy(value, size) {
  const unit = 10 ** Math.floor(Math.log10(size) - 11);
  return Number((Math.round(value / unit) * unit).toPrecision(15));
}

const largest = (shown) => Math.max(...shown.size, Number.MIN_VALUE);

/** The sides of a ring as the server has them. */
const shownSides = (shown, ring) => shown.sides.filter((side) => side.ring === ring);

/** The domain with a polygon for an outline, where it was a rectangle. */
function withPolygon(domain, shown) {
  if (!domain.rectangle) return copy(domain);
  const { rectangle: _, ...others } = copy(domain);
  const corners = shownSides(shown, 0).map(({ start }) => {
    const reach = largest(shown) + Math.max(...shown.center.map(Math.abs));
    return point(shown, start).map((value) => tidy(value, reach));
  });
  return { polygon: { corners }, ...others };
}

/** Whether a ring's corners run the other way round than its vertices. */
function isReversed(domain, shown, ring) {
  const list = domain.rectangle && ring === 0 ? null : listOf(ringOf(domain, ring));
  if (!list || list.length < 3) return false;
  const first = shown.rings[ring];
  const sides = shownSides(shown, ring);
  const second = sides.length === list.length ? sides[1].start : first + 1;
  const apart = (corner) => Math.hypot(...point(shown, second).map((value, axis) => value - corner[axis]));
  return apart(list.at(-1)) < apart(list[1]);
}

/**
 * The place in the JSON of a side that the server has as the `index`th of its ring, and the other way round. In a
 * ring of points, each edge is a side.
 */
export function sidePlace(domain, shown, { ring, index }) {
  if (!isReversed(domain, shown, ring)) return index;
  return listOf(ringOf(domain, ring)).length - 1 - index;
}

/** All corners, and all points of rings: `{ring, index, x, y}`, with their index in the JSON. */
export function corners(domain, shown) {
  const found = [];
  const add = (ring, list) => list.forEach(([x, y], index) => found.push({ ring, index, x, y }));
  if (domain.rectangle) add(0, shownSides(shown, 0).map(({ start }) => point(shown, start)));
  else add(0, listOf(ringOf(domain, 0)));
  (domain.holes ?? []).forEach((hole, i) => add(i + 1, listOf(hole)));
  return found;
}

/** Whether a ring is a list of points, which has no counts. */
export const isPoints = (domain, ring) => Boolean((ring === 0 ? domain : domain.holes[ring - 1]).ring);

/**
 * Whether the server has said the sides of a domain: not while the answer to an added or removed corner or
 * hole is on its way, nor where a domain with one is refused.
 */
export function isKnown(domain, shown) {
  if (shown.rings.length !== (domain.holes?.length ?? 0) + 2) return false;
  return shown.rings.slice(1).every((_, ring) => {
    if (isPoints(domain, ring)) return true;
    const count = domain.rectangle && ring === 0 ? 4 : listOf(ringOf(domain, ring)).length;
    return shownSides(shown, ring).length === count;
  });
}

/** The sides of a ring in the JSON, one entry for each. */
function sidesOf(domain, ring) {
  const holder = sidesHolder(domain, ring);
  const count = listOf(ringOf(domain, ring)).length;
  holder.sides = Array.from({ length: count }, (_, i) => holder.sides?.[i] ?? {});
  return holder.sides;
}

/** A side through a point instead of about a center, which holds when its corners move. */
function throughPoint(domain, shown, ring, place) {
  const side = sidesHolder(domain, ring).sides?.[place];
  if (!side?.arc?.center || !isKnown(domain, shown)) return;
  const index = sidePlace(domain, shown, { ring, index: place });
  const { start, intervals } = shownSides(shown, ring)[index];
  if (intervals > 1) side.arc = { through: point(shown, start + Math.floor(intervals / 2)) };
  else delete side.arc;
}

export function moveCorner(domain, shown, { ring, index }, to) {
  const moved = withPolygon(domain, shown);
  const list = listOf(ringOf(moved, ring));
  if (!isPoints(moved, ring)) {
    const before = (index + list.length - 1) % list.length;
    for (const place of [before, index]) throughPoint(moved, shown, ring, place);
  }
  list[index] = [...to];
  return moved;
}

/** Divides a side at its boundary vertex nearest to the middle, or a ring of points after one of them. */
export function addCorner(domain, shown, { ring, index }) {
  const changed = withPolygon(domain, shown);
  const list = listOf(ringOf(changed, ring));
  const place = sidePlace(changed, shown, { ring, index });
  if (isPoints(changed, ring)) {
    const [a, b] = [list[place], list[(place + 1) % list.length]];
    list.splice(place + 1, 0, [0, 1].map((axis) => tidy((a[axis] + b[axis]) / 2, largest(shown))));
    return { domain: changed, corner: { ring, index: place + 1 } };
  }
  const { start, intervals } = shownSides(shown, ring)[index];
  if (intervals < 2) return null;
  const half = Math.floor(intervals / 2);
  const isTurned = isReversed(changed, shown, ring);
  // Vertices of a ring wrap round at its end, but a vertex within a side never does.
  const at = (vertices) => point(shown, start + vertices);
  const sides = sidesOf(changed, ring);
  const { spacing, arc, points: _, polyline: __, bezier: ___, size: ____, ...kept } = sides[place];
  const counts = isTurned ? [intervals - half, half] : [half, intervals - half];
  const parts = counts.map((count) => ({ ...kept, intervals: count }));
  // Halves of a geometric law have the same ratio; halves of others have laws of their own.
  if (spacing?.geometric) for (const part of parts) part.spacing = spacing;
  if (arc) {
    const quarters = [Math.floor(half / 2), half + Math.floor((intervals - half) / 2)];
    if (isTurned) quarters.reverse();
    parts.forEach((part, i) => { if (counts[i] > 1) part.arc = { through: at(quarters[i]) }; });
  }
  if (kept.name) parts[1].name = `${kept.name} 2`;
  sides.splice(place, 1, ...parts);
  list.splice(place + 1, 0, at(half).map((value) => tidy(value, largest(shown) + Math.max(...shown.center.map(Math.abs)))));
  return { domain: changed, corner: { ring, index: place + 1 } };
}

/** Joins the two sides at a corner; null if too few would be left. */
export function removeCorner(domain, shown, { ring, index }) {
  const changed = withPolygon(domain, shown);
  const list = listOf(ringOf(changed, ring));
  if (list.length < 4) return null;
  if (isPoints(changed, ring)) {
    list.splice(index, 1);
    return changed;
  }
  const sides = sidesOf(changed, ring);
  const before = (index + list.length - 1) % list.length;
  const count = (place) => shownSides(shown, ring)[sidePlace(changed, shown, { ring, index: place })].intervals;
  const { name } = sides[before];
  const joined = { intervals: count(before) + count(index) };
  if (name) joined.name = name;
  sides[before] = joined;
  sides.splice(index, 1);
  list.splice(index, 1);
  return changed;
}

/** Changes one side, `{ring, index}` as the server counts them. What is undefined in `change` goes. */
export function changeSide(domain, shown, side, change) {
  const changed = copy(domain);
  const place = sidePlace(changed, shown, side);
  const holder = sidesHolder(changed, side.ring);
  const count = shownSides(shown, side.ring).length;
  holder.sides = Array.from({ length: count }, (_, i) => holder.sides?.[i] ?? {});
  const merged = { ...holder.sides[place], ...change };
  holder.sides[place] = Object.fromEntries(Object.entries(merged).filter(([, value]) => value !== undefined));
  return changed;
}

/** The ends of a side, and half the way between them with a step out of the ring: of length 1, or none for a full circle. */
function chordOf(shown, { ring, start, intervals }) {
  const [first, end] = [shown.rings[ring], shown.rings[ring + 1]];
  const at = (vertex) => point(shown, first + ((vertex - first) % (end - first)));
  let area = 0;
  for (let vertex = first; vertex < end; vertex++) {
    const [[x, y], [nextX, nextY]] = [at(vertex), at(vertex + 1)];
    area += x * nextY - y * nextX;
  }
  const [a, b] = [at(start), at(start + intervals)];
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const turn = Math.sign(area) / (length || 1);
  return { a, b, length, out: [(b[1] - a[1]) * turn, (a[0] - b[0]) * turn], middle: at(start + Math.floor(intervals / 2)) };
}

/** How far the middle of an arc is from the line between its ends: above 0 out of its ring, below 0 into it. */
export function riseOf(domain, shown, side) {
  const { a, b, length, out, middle } = chordOf(shown, side);
  const [x, y] = sideOf(domain, shown, side).arc?.through ?? middle;
  const [toA, toB] = [a, b].map(([endX, endY]) => [endX - x, endY - y]);
  // The angle in which the arc sees its ends is the same from everywhere on it.
  const angle = Math.abs(Math.atan2(toA[0] * toB[1] - toA[1] * toB[0], toA[0] * toB[0] + toA[1] * toB[1]));
  const isOut = (x - a[0]) * out[0] + (y - a[1]) * out[1] > 0;
  return tidy(((isOut ? 1 : -1) * length * Math.tan((Math.PI - angle) / 2)) / 2, largest(shown));
}

/** What a first arc rises: enough to be seen; 0 where there is no line that it could rise from. */
export const firstRise = (shown, side) => Number((chordOf(shown, side).length / 8).toPrecision(3));

/** Makes an arc of a side; a straight side where nothing rises. */
export function bendSide(domain, shown, side, rise) {
  const { a, b, out } = chordOf(shown, side);
  const reach = largest(shown) + Math.max(...shown.center.map(Math.abs));
  const through = [0, 1].map((axis) => tidy((a[axis] + b[axis]) / 2 + rise * out[axis], reach));
  const arc = rise ? { through } : undefined;
  return changeSide(withPolygon(domain, shown), shown, side, { arc, bezier: undefined, polyline: undefined });
}

/** The description of a side in the JSON. */
export function sideOf(domain, shown, side) {
  return sidesHolder(domain, side.ring).sides?.[sidePlace(domain, shown, side)] ?? {};
}

/** A square hole about a place, with some intervals on each side. */
export function addHole(domain, [x, y], radius, intervals) {
  const changed = copy(domain);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([dx, dy]) =>
    [tidy(x + dx * radius, radius), tidy(y + dy * radius, radius)]);
  const hole = { corners, sides: corners.map(() => ({ intervals })) };
  changed.holes = [...(changed.holes ?? []), hole];
  return changed;
}

/** A size at a place: half the mean edge of the boundary, until a reader says another. */
export function addSize(domain, shown, [x, y]) {
  const changed = copy(domain);
  let length = 0;
  for (let ring = 0; ring + 1 < shown.rings.length; ring++) {
    const [first, end] = [shown.rings[ring], shown.rings[ring + 1]];
    for (let vertex = first; vertex < end; vertex++) {
      const [a, b] = [point(shown, vertex), point(shown, vertex + 1 < end ? vertex + 1 : first)];
      length += Math.hypot(b[0] - a[0], b[1] - a[1]);
    }
  }
  const size = Number((length / shown.rings.at(-1) / 2).toPrecision(2));
  changed.interior = { ...changed.interior, sizes: [...(changed.interior?.sizes ?? []), [x, y, size]] };
  return changed;
}

/** The sizes at places, each with its index among all sizes: others come from sides, grids or files. */
export const sizesAtPlaces = (domain) => (domain.interior?.sizes ?? []).flatMap((size, index) => (Array.isArray(size) ? [{ size, index }] : []));

/** Changes a size at a place; without one, it goes. */
export function changeSize(domain, index, size) {
  const changed = copy(domain);
  if (size > 0) changed.interior.sizes[index][2] = size;
  else changed.interior.sizes.splice(index, 1);
  if (!changed.interior.sizes.length) delete changed.interior.sizes;
  if (!Object.keys(changed.interior).length) delete changed.interior;
  return changed;
}

export function removeHole(domain, ring) {
  const changed = copy(domain);
  changed.holes.splice(ring - 1, 1);
  if (!changed.holes.length) delete changed.holes;
  return changed;
}
