// The names of what is inside a domain, on the picture: of regions, lines and points.

/** Names are so high, in pixels. */
const HEIGHT = 13;

/** The middle edge of a line, as the middle of its ends. */
function middle({ segments }) {
  const i = 4 * Math.floor(segments.length / 8);
  return [(segments[i] + segments[i + 2]) / 2, (segments[i + 1] + segments[i + 3]) / 2];
}

/** What has a name and where, the most important first: what does not fit is left out. */
export function namedPlaces({ named_points: points, lines, regions }) {
  return [
    ...points.map(({ name, at }) => ({ kind: "point", name, at })),
    ...regions.map(({ name, at }) => ({ kind: "region", name, at })),
    ...lines.filter(({ name, segments }) => name && segments.length).map((line) => ({ kind: "line", name: line.name, at: middle(line) })),
  ];
}

/** Draws names that are in sight and do not cover one another; a point has a ring. Returns the names drawn. */
export function drawNames(context, frame, looks, places) {
  const taken = [];
  const drawn = [];
  context.font = `600 ${HEIGHT}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  context.textAlign = "center";
  context.lineJoin = "round";
  context.setLineDash([]);
  for (const { kind, name, at } of places) {
    const [x, place] = frame.toScreen(...at);
    if (x < 0 || place < 0 || x > frame.width || place > frame.height) continue;
    if (kind === "point") {
      context.beginPath();
      context.arc(x, place, 6, 0, 2 * Math.PI);
      context.strokeStyle = looks.accent;
      context.lineWidth = 2.5;
      context.stroke();
    }
    const y = kind === "point" ? place - HEIGHT - 2 : place;
    const half = context.measureText(name).width / 2 + 4;
    const box = [x - half, y - HEIGHT * 0.8, x + half, y + HEIGHT * 0.8];
    if (taken.some(([left, top, right, bottom]) => box[0] < right && box[2] > left && box[1] < bottom && box[3] > top)) continue;
    taken.push(box);
    drawn.push(name);
    context.strokeStyle = looks.card;
    context.lineWidth = 4;
    context.strokeText(name, x, y);
    context.fillStyle = kind === "line" ? looks.accent : looks.text;
    context.fillText(name, x, y);
  }
  return drawn;
}
