// The choices in the library's tables: a button for each goal, and a field for each key of points inside.
// From the viewer's script: make.

import { apply, ask } from "./asking.js";
import { element, showCurveNow } from "./show.js";
import { state } from "./state.js";

/** What a field for a goal's value begins with. */
const USUAL = { share: 95, degree: 6 };

let goals = [];
let keys = [];

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
    radio.checked = key in now;
    if (radio.checked && field) field.value = String(value === "share" ? Number((100 * now[key]).toPrecision(6)) : now[key]);
  }
  showCurveNow(chooseDegree);
}

export function chooseDegree(degree) {
  state.goal = { max_degree: degree };
  showGoal();
  ask();
}

function readGoal() {
  const { key, value, field } = goals.find(({ radio }) => radio.checked) ?? {};
  if (!key) return;
  const number = field?.valueAsNumber;
  if (!field) state.goal = value.word ? { [key]: value.word } : key;
  else if (number > 0 && number <= Number(field.max || Infinity)) state.goal = { [key]: value === "share" ? number / 100 : number };
  ask();
}

// ---- points inside

/** Offers the keys of points inside. An empty field leaves the key out. */
export function offerInterior(all) {
  keys = all.map((key) => ({ ...key, field: keyField(key) }));
  element("interior").append(...keys.map(({ name, text, field }) => {
    const label = make("label", "", `${name[0].toUpperCase()}${name.slice(1).replaceAll("_", " ")} `);
    label.title = text;
    label.append(field);
    return label;
  }));
}

function keyField(key) {
  const field = make(key.value === "choice" ? "select" : "input");
  field.id = key.name.replaceAll("_", "-");
  if (key.value === "choice") {
    field.append(new Option(key.default, ""), ...key.choices.filter((word) => word !== key.default).map((word) => new Option(word, word)));
  } else {
    Object.assign(field, { type: key.value === "range" ? "text" : "number", placeholder: key.default, size: 8 });
    if (key.value !== "range") Object.assign(field, { min: 0, step: key.value === "number" ? "any" : 1 });
  }
  field.addEventListener("change", () => {
    const { interior, ...others } = state.domain;
    const { [key.name]: _, ...kept } = interior ?? {};
    const given = read(key.value, field);
    const wanted = given === null ? kept : { ...kept, [key.name]: given };
    apply(Object.keys(wanted).length ? { ...others, interior: wanted } : others);
  });
  return field;
}

/** The value in a field; null if there is none. */
function read(value, field) {
  if (value === "range") return field.value.match(/\d+/g)?.slice(0, 2).map(Number) ?? null;
  return field.value === "" ? null : value === "choice" ? field.value : field.valueAsNumber;
}

/** Shows the keys of points inside as the domain has them. */
export function showInterior() {
  const wanted = state.domain.interior ?? {};
  for (const { name, value, field } of keys) {
    if (document.activeElement === field) continue;
    field.value = (value === "range" ? wanted[name]?.join(" to ") : wanted[name]) ?? "";
  }
}
