// The choices in the library's tables: a button for each goal, and a field for each key of points inside.
// From the viewer's script: angleText, make.

import { apply, ask } from "./asking.js";
import { judge, numberIn, numberOrNone } from "./fields.js";
import { element, fieldName, several, showCurveNow } from "./show.js";
import { shown, state } from "./state.js";

/** What a field for a goal's value begins with. */
const USUAL = { share: 95, degree: 6 };

let goals = [];
let keys = [];

// ---- what the mesh is for

/** The purposes as they are offered, and the mesh that each asks for. */
const PURPOSES = {
  solver: { title: "A solver", what: "points inside, for large angles", view: "interior" },
  patch: { title: "A patch", what: "keeps its points, and 95% of the angle", view: "wanted", goal: { keep_angle: 0.95 } },
  fewest: { title: "Fewest edges", what: "at a vertex, however thin the triangles", view: "wanted", goal: { optimize: "angle" } },
};

const isSameGoal = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** The purpose that the mesh on screen serves, or undefined. */
const purposeNow = () => Object.keys(PURPOSES).find((name) => {
  const { view, goal } = PURPOSES[name];
  return view === state.view && (!goal || isSameGoal(goal, state.goal));
});

/** Offers the purposes; `onView` is called when another mesh is looked at. */
export function offerPurposes(onView) {
  showViews = onView;
  element("coarser").addEventListener("click", () => {
    state.isTold = true;
    apply({ ...state.domain, interior: { ...state.domain.interior, size_inside: shown.coarser } });
  });
  element("purposes").append(...purposeButtons(choosePurpose));
}

/** A button for each purpose. */
export const purposeButtons = (choose) => Object.entries(PURPOSES).map(([name, { title, what }]) => {
  const button = make("button", "purpose");
  button.type = "button";
  button.dataset.purpose = name;
  button.append(make("b", "", title), make("span", "figures"), make("small", "", what));
  button.addEventListener("click", () => choose(name));
  return button;
});

/** Shows the figures of an advice on the buttons of a box, and which one is pressed. */
export function showPurposes(box, advice, now) {
  for (const button of box.children) {
    const { purpose } = button.dataset;
    const mesh = advice?.[purpose];
    button.setAttribute("aria-pressed", String(purpose === now));
    button.querySelector(".figures").textContent = mesh ? `${angleText(mesh.min_angle)}, degree ${mesh.max_degree}` : advice ? (purpose === "solver" && !advice.no_solver ? "too large to show" : "no mesh") : "";
  }
}

let showViews;

/** Takes the mesh for a purpose. With `isGuess`, the reader has not said so. */
export function choosePurpose(name, isGuess = false) {
  const { view, goal } = PURPOSES[name];
  if (!isGuess) state.isTold = true;
  if (goal) state.goal = goal;
  lookAtView(view);
}

/** Leads to points inside again, for another domain, if the reader has not said what the mesh is for. */
export function guessAgain() {
  if (state.isTold || state.view === "interior") return;
  if (state.beside === "interior") state.beside = state.view;
  state.view = "interior";
  showGoal();
  showViews();
}

/** Looks at a view first; the mesh that was looked at stands beside it. */
function lookAtView(view) {
  if (state.beside === view) state.beside = state.view;
  state.view = view;
  showGoal();
  showViews();
  ask();
}

/** Shows the advice: the figures of the mesh for each purpose, and why. */
export function showAdvice() {
  const { advice } = shown;
  const now = purposeNow();
  showPurposes(element("purposes"), advice, now);
  // Among what decides the angle: under the cards it would push the curve out of the first screen.
  element("on-edges").textContent = advice?.on_edges ?? "";
  const conditioned = now === "solver" ? advice?.conditioned : null;
  const button = element("put-on-edges");
  button.hidden = !conditioned;
  if (conditioned) button.textContent = `Put ${several(advice.points_on_edges, "point")} on edges: ${angleText(conditioned.min_angle)}`;
  element("coarser").hidden = !shown.coarser || state.view !== "interior";
  element("coarser").textContent = `Take edges up to ${shown.coarser} inside`;
  if (!advice) {
    element("advice").textContent = "…";
    return;
  }
  // Where a mesh is missing, the reason is told beside what is chosen.
  const missing = advice.words.filter(([purpose]) => purpose !== now && !advice[purpose]);
  const told = [...advice.words.filter(([purpose]) => purpose === now), ...missing];
  element("advice").textContent = told.map(([, words]) => words).join(" ");
}

// ---- the goal

/** Offers the goals that no other control chooses; `{}` in the words of one is the field of its value. */
export function offerGoals(all) {
  goals = all.filter(({ choice }) => choice).map((goal) => ({ ...goal, ...goalButton(goal) }));
  element("goal").append(...goals.map(({ label }) => label));
}

function goalButton({ key, value, choice }) {
  const [before, after = ""] = choice.split("{}");
  const label = make("label");
  const radio = make("input");
  Object.assign(radio, { type: "radio", name: "goal", value: key });
  radio.addEventListener("change", readGoal);
  label.append(radio, ` ${before}`);
  if (!(value in USUAL)) return { label, radio };
  const field = make("input");
  Object.assign(field, { type: "number", id: `goal-${key}`, min: 1, max: value === "share" ? 100 : "", step: 1, value: USUAL[value] });
  field.setAttribute("aria-label", choice.replace("{}", ""));
  field.addEventListener("change", () => {
    radio.checked = true;
    readGoal();
  });
  label.append(field, after);
  return { label, radio, field };
}

/** Shows the goal as it is. */
export function showGoal() {
  const now = typeof state.goal === "string" ? { [state.goal]: null } : state.goal;
  for (const { key, value, radio, field } of goals) {
    radio.checked = state.view === "wanted" && key in now;
    if (field) judge(field, "");
    if (radio.checked && field) field.value = String(value === "share" ? Number((100 * now[key]).toPrecision(6)) : now[key]);
  }
  showCurveNow(chooseDegree);
  showAdvice();
}

/** Takes the mesh of a row: of a degree, or with points inside. */
export function chooseDegree(degree) {
  state.isTold = true;
  if (degree === "inside") return lookAtView("interior");
  state.goal = { max_degree: degree };
  lookAtView("wanted");
}

function readGoal() {
  const { key, value, field } = goals.find(({ radio }) => radio.checked) ?? {};
  if (!key) return;
  if (!field) state.goal = value.word ? { [key]: value.word } : key;
  else {
    const isShare = value === "share";
    const number = isShare
      ? numberIn(field, "Give a percentage above 0, up to 100.", (share) => share > 0 && share <= 100)
      : numberIn(field, "Give a whole number, 1 or more.", (degree) => degree >= 1 && Number.isInteger(degree));
    if (number === null) return;
    state.goal = { [key]: isShare ? number / 100 : number };
  }
  state.isTold = true;
  lookAtView("wanted");
}

// ---- points inside

/** Offers the keys of points inside. An empty field leaves the key out. */
export function offerInterior(all) {
  keys = all.map((key) => ({ ...key, field: keyField(key) }));
  element("interior").append(...keys.map(({ name, text, default: usual, field }) => {
    const row = make("div", "key");
    row.title = text;
    const label = make("label", "", fieldName(name));
    label.htmlFor = field.id;
    // Without a default, what it is for.
    const note = make("small", "", usual || text.split(/[:;,] /)[0].replace(/^The /, "the "));
    note.id = `${field.id}-note`;
    field.setAttribute("aria-describedby", note.id);
    row.append(label, field, note);
    return row;
  }));
}

function keyField(key) {
  const field = make(key.value === "choice" ? "select" : "input");
  field.id = key.name.replaceAll("_", "-");
  if (key.value === "choice") {
    field.append(new Option(key.default, ""), ...key.choices.filter((word) => word !== key.default).map((word) => new Option(word, word)));
  } else {
    Object.assign(field, { type: key.value === "range" ? "text" : "number", size: 8 });
    if (key.value !== "range") Object.assign(field, { min: 0, step: key.value === "number" ? "any" : 1 });
  }
  field.addEventListener("change", () => {
    const isRange = key.value === "range";
    if (isRange && !judge(field, field.value.trim() && !read("range", field) ? "Give two numbers, such as 5 to 7." : "")) return;
    if (field.type === "number" && numberOrNone(field, "Give a number.") === null) return;
    const { interior, ...others } = state.domain;
    const { [key.name]: _, ...kept } = interior ?? {};
    const given = read(key.value, field);
    const wanted = given === null ? kept : { ...kept, [key.name]: given };
    // Who sets how points inside are put wants them, also where the first value allows none.
    state.isTold = true;
    apply(Object.keys(wanted).length ? { ...others, interior: wanted } : others);
  });
  return field;
}

/** The value in a field; null if there is none. */
function read(value, field) {
  if (value === "range") {
    const [, from, to = from] = field.value.match(/^\s*(\d+)(?:\s*(?:to|[-–,\s])\s*(\d+))?\s*$/) ?? [];
    return from ? [Number(from), Number(to)] : null;
  }
  return field.value === "" ? null : value === "choice" ? field.value : field.valueAsNumber;
}

/** Shows the keys of points inside as the domain has them. */
export function showInterior() {
  const wanted = state.domain.interior ?? {};
  for (const { name, value, field } of keys) {
    if (document.activeElement === field) continue;
    field.value = (value === "range" ? wanted[name]?.join(" to ") : wanted[name]) ?? "";
    judge(field, "");
  }
}
