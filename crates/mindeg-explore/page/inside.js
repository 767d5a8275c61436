// Holes, lines, points and regions of a domain, with their names and sizes.
// From the viewer's script: make.

import { apply } from "./asking.js";
import { changeSize, sizesAtPlaces } from "./domain.js";
import { isPositive, numberIn, numberOrNone } from "./fields.js";
import { element } from "./show.js";
import { shown, state } from "./state.js";

/** So many of a kind are listed. */
const MOST = 60;

/** The kinds of things inside, by their keys in the JSON: the fields that each offers. */
const KINDS = {
  lines: { one: "Line", fields: ["name", "size"] },
  points: { one: "Point", fields: ["name", "size"] },
  regions: { one: "Region", fields: ["name", "size", "hole"] },
};

/** Where a thing inside is, to be marked. */
const placesOf = (key, thing) => (thing.at ? [thing.at] : thing.corners ?? thing.points ?? thing.ring ?? []);

const SIZE = "Give a length above 0.";

let built = "";

/** Changes one thing; a value of undefined removes its key. */
function change(key, index, field, value) {
  const domain = structuredClone(state.domain);
  const { [field]: _, ...others } = domain[key][index];
  domain[key][index] = value === undefined ? others : { ...others, [field]: value };
  apply(domain);
}

function remove(key, index) {
  const domain = structuredClone(state.domain);
  domain[key].splice(index, 1);
  if (!domain[key].length) delete domain[key];
  apply(domain);
}

/** A field that changes a key of a thing. */
function field(key, index, name, thing, title) {
  const input = make("input");
  if (name === "hole") Object.assign(input, { type: "checkbox", checked: Boolean(thing.hole) });
  else if (name === "size") Object.assign(input, { type: "number", min: 0, step: "any", value: thing.size ?? "", placeholder: "size", className: "count" });
  else Object.assign(input, { type: "text", value: thing.name ?? "", placeholder: (key === "lines" && shown.domain?.lines[index]?.name) || (key === "regions" && `region ${index + 1}`) || "name" });
  input.setAttribute("aria-label", `${name} of ${title}`);
  input.addEventListener("change", () => {
    const value = name === "hole" ? input.checked || undefined : name === "size" ? numberOrNone(input, SIZE, isPositive) : input.value.trim() || undefined;
    if (value !== null) change(key, index, name, value);
  });
  const label = make("label", "", name === "hole" ? "a hole " : "");
  label.append(input);
  return label;
}

function button(text, label, act) {
  const made = make("button", "", text);
  made.type = "button";
  made.setAttribute("aria-label", label);
  made.addEventListener("click", act);
  return made;
}

/** A row of the table: a head, and controls beside it. */
function rowOf(title, controls) {
  const row = make("tr");
  const head = make("th", "", title);
  head.scope = "row";
  const box = make("span", "law");
  box.append(...controls);
  const cell = make("td");
  cell.append(box);
  row.append(head, cell);
  return row;
}

/** The rows of sizes at places. */
function sizeRows(mark) {
  return sizesAtPlaces(state.domain).slice(0, MOST).map(({ size: [x, y, size], index }, place) => {
    const title = `size ${place + 1}`;
    const input = make("input");
    Object.assign(input, { type: "number", min: 0, step: "any", value: size, className: "count" });
    input.setAttribute("aria-label", `Length of edges at ${title}`);
    input.addEventListener("change", () => {
      const wanted = numberIn(input, SIZE, isPositive);
      if (wanted !== null) apply(changeSize(state.domain, index, wanted));
    });
    const label = make("label", "", `at ${x}, ${y}: edges of `);
    label.append(input);
    return rowOf(`Size ${place + 1}`, [label, button("Show", `Show ${title}`, () => mark([[x, y]])),
      button("Remove", `Remove ${title}`, () => apply(changeSize(state.domain, index, null)))]);
  });
}

/** Lists what is inside; `mark(places)` shows places on the pictures. */
export function listInside(mark) {
  const told = JSON.stringify([...Object.keys(KINDS).map((key) => state.domain[key]), state.domain.interior?.sizes]);
  if (told === built) return;
  built = told;
  const rows = Object.entries(KINDS).flatMap(([key, { one, fields }]) => (state.domain[key] ?? []).slice(0, MOST).map((thing, index) => {
    const title = `${one.toLowerCase()} ${index + 1}`;
    return rowOf(`${one} ${index + 1}`, [...fields.map((name) => field(key, index, name, thing, title)),
      button("Show", `Show ${title}`, () => mark(placesOf(key, thing))), button("Remove", `Remove ${title}`, () => remove(key, index))]);
  })).concat(sizeRows(mark));
  const box = element("inside");
  if (!rows.length) return box.replaceChildren();
  const table = make("table");
  const body = make("tbody");
  body.append(...rows);
  table.append(body);
  const scroll = make("div", "scroll");
  scroll.append(table);
  const left = Object.keys(KINDS).reduce((sum, key) => sum + Math.max(0, (state.domain[key]?.length ?? 0) - MOST), 0);
  box.replaceChildren(make("h3", "", "Inside the boundary"), scroll, ...(left ? [make("p", "note", `${left} more are not listed.`)] : []));
}
