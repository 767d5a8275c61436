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

/** Draws names that are in sight and do not cover one another; a point and a mark have a ring. Returns the names drawn. */
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
    if (kind === "point" || kind === "mark") {
      context.beginPath();
      context.arc(x, place, kind === "mark" ? 11 : 6, 0, 2 * Math.PI);
      context.strokeStyle = kind === "mark" ? looks.mark : looks.accent;
      context.lineWidth = 2.5;
      context.stroke();
    }
    const isAbove = kind === "point" || kind === "mark";
    const away = isAbove ? HEIGHT + (kind === "mark" ? 7 : 2) : 0;
    // Above what it names, but for the top of the picture.
    const y = place - away < HEIGHT * 0.8 ? place + away : place - away;
    const half = context.measureText(name).width / 2 + 4;
    const middle = Math.max(half, Math.min(frame.width - half, x));
    const box = [middle - half, y - HEIGHT * 0.8, middle + half, y + HEIGHT * 0.8];
    if (taken.some(([left, top, right, bottom]) => box[0] < right && box[2] > left && box[1] < bottom && box[3] > top)) continue;
    taken.push(box);
    drawn.push(name);
    context.strokeStyle = looks.card;
    context.lineWidth = 4;
    context.strokeText(name, middle, y);
    context.fillStyle = kind === "line" ? looks.accent : kind === "mark" ? looks.mark : looks.text;
    context.fillText(name, middle, y);
  }
  return drawn;
}
