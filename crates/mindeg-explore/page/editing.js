// Editing the boundary: by pointer, by keys, and by the fields below the picture.
// From the viewer's script: make.

import { apply, ask } from "./asking.js";
import { showInterior } from "./choices.js";
import { addCorner, addHole, addSize, corners, isKnown, moveCorner, removeCorner, removeHole, sidePlace } from "./domain.js";
import { cornerAt, gridStep, sideAt, snapped } from "./editor.js";
import { isPositive, judge, numberIn, numberOrNone } from "./fields.js";
import { listInside } from "./inside.js";
import { redraw, setCursor, stages } from "./pictures.js";
import * as server from "./server.js";
import { domainTrouble, element, inWords, showTrouble, showUndo } from "./show.js";
import { SidesTable } from "./sides.js";
import { bounds, view } from "./stage.js";
import { origins, remember, selection, shown, state } from "./state.js";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Says what was done. What is found at a place that was pointed at before is not said after it. */
const say = (text) => {
  setCursor(null);
  element("spoken").textContent = text;
};
const grid = () => gridStep(bounds.size);
const snap = (place) => snapped(place, grid(), element("snap").checked);
const isSame = (a, b) => a && b && a.ring === b.ring && a.index === b.index;
const cornerNow = () => corners(state.domain, shown.domain).find((corner) => isSame(corner, selection.corner));
const sidesAreKnown = () => Boolean(shown.domain) && isKnown(state.domain, shown.domain);

let table;
/** What the next click in the picture places: a key of PLACED, or null. */
let placing = null;

/** What is placed by a click: the domain with it, what to say where none fits, and what to say after it. */
const PLACED = {
  hole: {
    button: "add-hole",
    words: "Add a hole",
    made: (domain, place) => addHole(domain, snapped(place, grid(), false), Math.min(...bounds.size) / 8, 3),
    refused: "No hole fits there.",
    done: "A hole is added; its corners are dragged like others.",
  },
  size: {
    button: "add-size",
    words: "Set a size",
    made: (domain, place) => addSize(domain, shown.domain, snap(place)),
    refused: "No size can be set there.",
    done: "A size is set; its field in the list changes it. It counts for points inside.",
  },
};

/** Shows the corners, sides and holes as they are. */
export function updateEditor() {
  if (!shown.domain) return;
  if (sidesAreKnown()) table.show(selection.side);
  element("grid").textContent = String(grid());
  const all = corners(state.domain, shown.domain);
  const place = all.findIndex((corner) => isSame(corner, selection.corner));
  const corner = all[place];
  element("corner").textContent = corner ? `Corner ${place + 1} of ${all.length}` : `${all.length} corners`;
  for (const axis of ["x", "y"]) {
    const input = element(axis);
    input.disabled = !corner;
    if (document.activeElement === input && corner) continue;
    input.value = corner ? String(Number(corner[axis].toPrecision(10))) : "";
    judge(input, "");
  }
  element("remove").disabled = !corner;
  updateHoles();
  listInside(mark);
  showInterior();
}

/** Marks places on the pictures. */
function mark(places) {
  shown.decides = places;
  element("pictures").scrollIntoView({ block: "nearest" });
  redraw();
}

/** A button for each hole. Those that are right already stay, and keep the focus. */
function updateHoles() {
  const box = element("holes");
  const count = state.domain.holes?.length ?? 0;
  while (box.children.length > count) box.lastChild.remove();
  while (box.children.length < count) {
    const ring = box.children.length + 1;
    const button = make("button", "", `Remove hole ${ring}`);
    button.type = "button";
    button.addEventListener("click", () => {
      letGo();
      apply(removeHole(state.domain, ring));
    });
    box.append(button);
  }
}

function letGo() {
  Object.assign(selection, { corner: null, side: null });
}

function choose(corner) {
  Object.assign(selection, { corner, side: null });
  updateEditor();
  redraw();
}

function chooseSide({ ring, index }) {
  Object.assign(selection, { corner: null, side: { ring, index } });
  updateEditor();
  redraw();
}

/** Chooses the next corner, or the one before, and says where it is. */
function chooseNext(by) {
  if (!shown.domain) return;
  const all = corners(state.domain, shown.domain);
  const place = all.findIndex((corner) => isSame(corner, selection.corner));
  const { ring, index } = all[place < 0 ? (by > 0 ? 0 : all.length - 1) : (place + by + all.length) % all.length];
  choose({ ring, index });
  const { x, y } = cornerNow();
  say(`${element("corner").textContent}, at ${x}, ${y}`);
}

/** Adds a corner in the middle of the chosen side, or of the side after the chosen corner. */
function add() {
  if (!sidesAreKnown()) return;
  const { corner, side } = selection;
  const after = corner && { ring: corner.ring, index: sidePlace(state.domain, shown.domain, corner) };
  const added = addCorner(state.domain, shown.domain, side ?? after ?? { ring: 0, index: 0 });
  if (!added) return say("A side needs two intervals to be divided.");
  Object.assign(selection, { corner: added.corner, side: null });
  apply(added.domain);
  say("A corner is added; arrows move it.");
}

let told = null;

/** Takes back what is said of the edges of another domain, or of one that is refused. */
export function forgetEdges(isRefused) {
  if (told && (isRefused || told !== state.domain)) tellOfEdges("");
}

/** Divides all sides by the length that is given. */
async function divide() {
  const size = numberIn(element("edge-size"), "Give a length above 0.", isPositive);
  if (size === null) return tellOfEdges("");
  const made = async (before) => {
    const origin = origins.get(before);
    const domain = await server.divide(before, size, origin);
    if (origin) origins.set(domain, origin);
    return domain;
  };
  if (await change(made)) tellOfEdges(`All sides get edges of about ${size}, as --size ${size} makes them.`);
}

/** Takes the domain that is made of this one; whether there is one, and the reader has not gone on meanwhile. */
async function change(made) {
  const before = state.domain;
  tellOfEdges("Working …");
  try {
    const domain = await made(before);
    if (state.domain !== before) return tellOfEdges("");
    letGo();
    apply(domain);
    return true;
  } catch (error) {
    tellOfEdges(inWords(error.message));
  }
}

/** Says what became of the edges, with the command that does the same; of another domain that is not said. */
function tellOfEdges(words, command = null) {
  told = state.domain;
  element("condition-words").textContent = words;
  element("condition-command").hidden = !command;
  element("condition-command").firstElementChild.textContent = command ?? "";
}

/** Changes the boundary so that a mesh with points inside can have the angle. */
async function conditionIt() {
  const wanted = [
    numberIn(element("condition-angle"), "Give an angle above 0°.", isPositive),
    numberOrNone(element("edge-size"), "Give a length above 0, or none for the edges as they are.", isPositive),
    numberOrNone(element("condition-within"), "Give a distance of 0 or more, or none for the usual one.", (number) => number >= 0),
  ];
  if (wanted.includes(null)) return tellOfEdges("");
  await conditionFor(...wanted);
}

/** Changes the boundary for an angle, with edges of a size, moved so far at most. */
async function conditionFor(angle, size, within) {
  let told;
  const isDone = await change(async (before) => {
    told = await server.condition(before, angle, size, within);
    return told.domain;
  });
  if (isDone) tellOfEdges(told.words, told.command);
}

function remove() {
  if (!selection.corner || !sidesAreKnown()) return;
  const changed = removeCorner(state.domain, shown.domain, selection.corner);
  if (!changed) return say("A ring keeps three corners.");
  selection.corner = null;
  apply(changed);
  say("The corner is removed.");
}

function setPlacing(kind) {
  placing = kind;
  for (const [key, { button, words }] of Object.entries(PLACED)) {
    element(button).textContent = key === kind ? "Click in the picture where it should be" : words;
    element(button).setAttribute("aria-pressed", String(key === kind));
  }
  stages[0].element.classList.toggle("placing", kind !== null);
}

/** Places what is to be placed, unless it cannot be there: then what is wrong is said, and the domain stays as it is. */
async function placeAt(x, y) {
  const { made, refused: sentence, done } = PLACED[placing];
  setPlacing(null);
  letGo();
  const before = state.domain;
  const domain = made(before, [x, y]);
  try {
    const refused = await server.refusal(domain);
    if (refused) return showTrouble(`${sentence} ${domainTrouble(refused)}`);
    if (state.domain !== before) return;
    apply(domain);
    say(done);
  } catch (error) {
    showTrouble(error.message);
  }
}

/** A pointer goes down on the picture: on a corner, beside a side, or to move the picture. */
export function grab(stage, event, place) {
  if (event.button || !shown.domain) return false;
  // A second finger does nothing while a corner is dragged.
  if (selection.drag) return true;
  if (placing) {
    placeAt(...stage.frame.toDomain(...place));
    return true;
  }
  const corner = cornerAt(state.domain, shown.domain, stage.frame, place, event.pointerType);
  if (!corner) {
    const near = sidesAreKnown() && sideAt(state.domain, shown.domain, stage.frame, place);
    if (near) chooseSide(near);
    return false;
  }
  stage.element.setPointerCapture(event.pointerId);
  hold(true);
  selection.drag = { pointer: event.pointerId, domain: state.domain, shown: shown.domain, to: null, hasMoved: false };
  choose(corner);
  setCursor(null);
  return true;
}

/** While a corner is dragged, what stands above the picture keeps its height, so that the picture stays. */
function hold(isHeld) {
  const { style, offsetHeight } = element("verdict");
  style.height = isHeld ? `${offsetHeight}px` : "";
}

/** Shows that a corner can be taken where the pointer is. */
export function hint(stage, x, y) {
  if (!shown.domain || stage !== stages[0]) return;
  const isNear = cornerAt(state.domain, shown.domain, stage.frame, stage.frame.toScreen(x, y), "mouse");
  stage.element.classList.toggle("grabbing", Boolean(isNear));
}

/** A finger on a corner drags it; elsewhere it scrolls the page. */
function keepFinger(event) {
  const [touch, ...others] = event.touches;
  if (others.length || !shown.domain) return;
  const { left, top } = stages[0].element.getBoundingClientRect();
  const place = [touch.clientX - left, touch.clientY - top];
  if (placing || cornerAt(state.domain, shown.domain, stages[0].frame, place, "touch")) event.preventDefault();
}

/** The corner follows the pointer, once a frame. */
function dragTo(stage, event) {
  const { drag } = selection;
  if (event.pointerId !== drag?.pointer) return;
  const { left, top } = stage.element.getBoundingClientRect();
  const isWaiting = drag.to !== null;
  drag.to = snap(stage.frame.toDomain(event.clientX - left, event.clientY - top));
  if (!isWaiting) requestAnimationFrame(() => follow(drag));
}

function follow(drag) {
  const { to } = drag;
  drag.to = null;
  const now = cornerNow();
  if (!to || !now || (now.x === to[0] && now.y === to[1])) return;
  state.domain = moveCorner(drag.domain, drag.shown, selection.corner, to);
  drag.hasMoved = true;
  ask();
  redraw();
}

function drop(event) {
  const { drag } = selection;
  if (event.pointerId !== drag?.pointer) return;
  follow(drag);
  selection.drag = null;
  hold(false);
  if (drag.hasMoved) {
    remember(drag.domain);
    showUndo();
    // With the next answer, what has left the picture is brought back into it.
    ask();
  }
  updateEditor();
  redraw();
}

/** Takes the keys that edit; others move the picture. */
export function handleKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || !shown.domain) return false;
  const place = () => placeAt(view.x, view.y);
  const stop = () => {
    setPlacing(null);
    letGo();
    updateEditor();
    redraw();
  };
  const keys = { n: () => chooseNext(1), p: () => chooseNext(-1), Insert: add, Delete: remove, Backspace: remove, Escape: stop };
  if (placing) keys.Enter = place;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (keys[key]) {
    keys[key]();
    return true;
  }
  const arrow = ARROWS[event.key];
  const corner = arrow && selection.corner ? cornerNow() : null;
  if (!corner) return false;
  const far = grid() * (event.shiftKey ? 10 : 1);
  const to = snap([corner.x + arrow[0] * far, corner.y + arrow[1] * far]);
  apply(moveCorner(state.domain, shown.domain, selection.corner, to));
  say(`${to[0]}, ${to[1]}`);
  updateEditor();
  redraw();
  return true;
}

/** Makes the fields work. */
export function startEditing() {
  table = new SidesTable(element("sides"), apply, chooseSide);
  const { element: picture } = stages[0];
  picture.addEventListener("touchstart", keepFinger, { passive: false });
  picture.addEventListener("pointermove", (event) => dragTo(stages[0], event));
  for (const kind of ["pointerup", "pointercancel"]) picture.addEventListener(kind, drop);
  element("previous").addEventListener("click", () => chooseNext(-1));
  element("next").addEventListener("click", () => chooseNext(1));
  element("add").addEventListener("click", add);
  element("divide").addEventListener("click", divide);
  element("condition").addEventListener("click", conditionIt);
  // As the advice counts them: for the usual angle, whatever the fields have.
  element("put-on-edges").addEventListener("click", () => conditionFor(Number(element("condition-angle").defaultValue)));
  element("remove").addEventListener("click", remove);
  for (const [kind, { button }] of Object.entries(PLACED)) {
    element(button).addEventListener("click", () => {
      setPlacing(placing === kind ? null : kind);
      if (placing) stages[0].element.focus();
    });
  }
  for (const axis of ["x", "y"]) {
    element(axis).addEventListener("change", () => {
      const [x, y] = ["x", "y"].map((id) => numberIn(element(id), "Give a number."));
      if (selection.corner && x !== null && y !== null) {
        apply(moveCorner(state.domain, shown.domain, selection.corner, [x, y]));
      }
    });
  }
}
