"use strict";

// Zooms the pictures of the meshes, all together, and copies commands. Without a script they are pictures still.

const drawings = [...document.querySelectorAll(".mesh svg")];
/** The middle of what is seen, from the middle of the pictures with y up, in their own pixels. */
const view = { x: 0, y: 0, zoom: 1 };
const whole = drawings[0].viewBox.baseVal;
const size = [whole.width, whole.height];
const MOST_ZOOM = 200;

/** Lines and dots with their widths: in a closer picture they grow less than what is between. */
const strokes = drawings.flatMap((drawing) => [...drawing.querySelectorAll(".edge, .outline, .ring")]
  .map((line) => [line, parseFloat(getComputedStyle(line).strokeWidth)]));
const dots = drawings.flatMap((drawing) => [...drawing.querySelectorAll("circle")].map((dot) => [dot, dot.r.baseVal.value]));

let isDrawing = false;

function redraw() {
  if (isDrawing) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    const [width, height] = size.map((length) => length / view.zoom);
    const corner = [(size[0] - width) / 2 + view.x, (size[1] - height) / 2 - view.y];
    for (const drawing of drawings) drawing.setAttribute("viewBox", `${corner.join(" ")} ${width} ${height}`);
    const growth = view.zoom ** -0.7;
    for (const [line, width] of strokes) line.style.strokeWidth = `${width * growth}px`;
    for (const [dot, radius] of dots) dot.setAttribute("r", radius * growth);
  });
}

function moveTo(x, y) {
  [view.x, view.y] = [x, y].map((value, axis) => {
    const reach = (size[axis] * (1 - 1 / view.zoom)) / 2;
    return Math.min(reach, Math.max(-reach, value));
  });
  redraw();
}

/** Where a picture of the page looks. */
class Look {
  constructor(drawing) {
    Object.assign(this, { drawing, view });
  }

  get width() {
    return this.drawing.clientWidth || this.drawing.getBoundingClientRect().width;
  }

  get height() {
    return (this.width * size[1]) / size[0];
  }

  scale() {
    const scale = (view.zoom * this.width) / size[0];
    return [scale, scale];
  }

  toDomain(left, top) {
    const [scale] = this.scale();
    return [view.x + (left - this.width / 2) / scale, view.y - (top - this.height / 2) / scale];
  }

  /** Zooms, keeping the given place where it is. */
  zoomBy(factor, place) {
    const before = place && this.toDomain(...place);
    view.zoom = Math.min(MOST_ZOOM, Math.max(1, view.zoom * factor));
    const after = place && this.toDomain(...place);
    moveTo(view.x + (place ? before[0] - after[0] : 0), view.y + (place ? before[1] - after[1] : 0));
  }
}

function fit() {
  view.zoom = 1;
  moveTo(0, 0);
}

const looks = drawings.map((drawing) => {
  const frame = new Look(drawing);
  drawing.tabIndex = 0;
  drawing.setAttribute("role", "application");
  drawing.setAttribute("aria-describedby", "keys");
  const nothing = () => {};
  followPointers(drawing, {
    frame, moveTo, fit, pointAt: nothing, leave: nothing, pointAtCenter: nothing, zoomBy: (factor, place) => frame.zoomBy(factor, place),
  });
  return frame;
});
for (const hidden of document.querySelectorAll("#keys, .toolbar")) hidden.hidden = false;
document.getElementById("zoom-in").addEventListener("click", () => looks[0].zoomBy(1.5));
document.getElementById("zoom-out").addEventListener("click", () => looks[0].zoomBy(1 / 1.5));
document.getElementById("fit").addEventListener("click", fit);
offerCopy();
