// Moving and zooming a picture by pointer, wheel and keyboard.

/** Where in a stage a pointer is. */
function placeIn(stage, event) {
  const box = stage.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/**
 * Follows the pointers and keys of a stage: `frame` is its frame; `pointAt(x, y)` and `leave()` tell where
 * the pointer is, `pointAtCenter()` that keys have moved; `moveTo(x, y)`, `zoomBy(factor, place)` and `fit()`
 * move the view. `grab(event, place)` may take a pointer that goes down for itself; `handleKey(event)` a key.
 */
function followPointers(stage, { frame, pointAt, leave, pointAtCenter, moveTo, zoomBy, fit, grab, handleKey }) {
  const pointers = new Map();
  const point = (event) => pointAt(...frame.toDomain(...placeIn(stage, event)));
  stage.addEventListener("pointerdown", (event) => {
    if (!pointers.size && grab && grab(event, placeIn(stage, event))) return;
    pointers.set(event.pointerId, placeIn(stage, event));
    if (event.pointerType === "mouse") stage.setPointerCapture(event.pointerId);
    point(event);
  });
  stage.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return point(event);
    const now = placeIn(stage, event);
    const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    pointers.set(event.pointerId, now);
    if (others.length === 1) {
      const apart = (at) => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]);
      const middle = [(now[0] + others[0][0]) / 2, (now[1] + others[0][1]) / 2];
      zoomBy(apart(now) / Math.max(1, apart(before)), middle);
    } else if (others.length === 0) {
      const [sx, sy] = frame.scale();
      moveTo(frame.view.x - (now[0] - before[0]) / sx, frame.view.y + (now[1] - before[1]) / sy);
    }
  });
  const release = (event) => pointers.delete(event.pointerId);
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
  stage.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse" && !pointers.size) leave();
  });
  stage.addEventListener("wheel", (event) => {
    // Otherwise the page scrolls, as it should under a pointer passing by.
    if (!event.ctrlKey && document.activeElement !== stage) return;
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 300), placeIn(stage, event));
  }, { passive: false });
  stage.addEventListener("dblclick", (event) => zoomBy(2, placeIn(stage, event)));
  stage.addEventListener("focus", () => {
    if (stage.matches(":focus-visible")) pointAtCenter();
  });
  stage.addEventListener("keydown", (event) => {
    if (handleKey && handleKey(event)) return event.preventDefault();
    const [sx, sy] = frame.scale();
    const step = [frame.width / 12 / sx, frame.height / 12 / sy];
    const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (moves[event.key]) {
      const [dx, dy] = moves[event.key];
      moveTo(frame.view.x + dx * step[0], frame.view.y + dy * step[1]);
    } else if (event.key === "+" || event.key === "=") zoomBy(1.5);
    else if (event.key === "-") zoomBy(1 / 1.5);
    else if (event.key === "0") fit();
    else return;
    event.preventDefault();
    pointAtCenter();
  });
}
