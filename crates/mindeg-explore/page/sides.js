// The table of the sides: how many intervals, how they are spaced, and whether they are straight.

import { bendSide, changeSide, firstRise, isKnown, isPoints, riseOf, sideOf } from "./domain.js";
import { indexedSides } from "./editor.js";
import { isPositive, judge, numberIn } from "./fields.js";
import { shown, state } from "./state.js";

/** So many sides stand in the table at once. */
const ROWS = 12;

const POSITIVE = { wanted: "Give a number above 0.", isRight: isPositive };

/** The spacing laws: what they are called, the name of their number in JSON, one to begin with, and which are right. */
const LAWS = {
  uniform: { title: "equal" },
  geometric: { title: "geometric", key: "ratio", label: "ratio", first: 1.1, ...POSITIVE },
  bump: { title: "bump", key: "ratio", label: "ratio", first: 0.5, ...POSITIVE },
  beta: { title: "beta", key: "beta", label: "beta", first: 1.1, wanted: "Give a number above 1, or below -1.", isRight: (number) => Math.abs(number) > 1 },
  first_length: { title: "first length", label: "length", ...POSITIVE },
  last_length: { title: "last length", label: "length", ...POSITIVE },
  parameters: { title: "as given" },
};

/** How a side runs from corner to corner. */
const SHAPES = { straight: "straight", arc: "arc", given: "as given" };

function shapeOf({ arc, bezier, polyline, points }) {
  if (bezier || polyline || points) return "given";
  return arc ? "arc" : "straight";
}

/** What ocean models take a side for. */
const KINDS = { "": "no kind", open: "open water", land: "mainland", island: "island" };

/** The law of a side, with its number. */
function lawOf({ spacing }) {
  if (!spacing || spacing === "uniform") return { law: "uniform", value: null };
  const [law] = Object.keys(spacing);
  const value = LAWS[law]?.key ? spacing[law][LAWS[law].key] : spacing[law];
  return { law, value: typeof value === "number" ? value : null };
}

function spacingOf(law, value) {
  if (law === "uniform") return undefined;
  return { [law]: LAWS[law].key ? { [LAWS[law].key]: value } : value };
}

/** A side as the domain has it now: while an answer is on its way, that is newer than the table. */
const now = (side) => sideOf(state.domain, shown.domain, side);

const make = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};

export class SidesTable {
  /** `apply(domain)` takes a changed domain, `choose(side)` a side that is clicked. */
  constructor(box, apply, choose) {
    Object.assign(this, { box, apply, choose, rows: [], first: 0, key: "" });
  }

  /** Shows the sides; `chosen` is one, `{ring, index}`, or null. */
  show(chosen) {
    this.sides = indexedSides(state.domain, shown.domain).filter(({ ring }) => !isPoints(state.domain, ring));
    const at = chosen ? this.sides.findIndex(({ ring, index }) => ring === chosen.ring && index === chosen.index) : -1;
    if (at >= 0 && (at < this.first || at >= this.first + ROWS)) this.first = at - (at % ROWS);
    if (this.first >= this.sides.length) this.first = 0;
    const listed = this.sides.slice(this.first, this.first + ROWS);
    const key = [this.first, this.sides.length, ...listed.map(({ ring, index }) => `${ring}.${index}`)].join(" ");
    if (key !== this.key) this.build(listed);
    this.key = key;
    listed.forEach((side, row) => this.fill(this.rows[row], side, this.first + row === at));
  }

  build(listed) {
    this.rows = listed.map(() => this.row());
    if (!listed.length) {
      this.box.replaceChildren(make("p", { className: "note", textContent:
        "This boundary is a list of points, which come back as they are: it has no counts. Its points can be dragged, added and removed." }));
      return;
    }
    const headings = ["Side", "Intervals", "Shape", "Spacing", "Name and kind"].map((text) => make("th", { scope: "col", textContent: text }));
    const table = make("table", {}, make("thead", {}, make("tr", {}, ...headings)), make("tbody", {}, ...this.rows.map(({ line }) => line)));
    const parts = [make("div", { className: "scroll" }, table)];
    if (this.sides.length > ROWS) {
      const to = Math.min(this.first + ROWS, this.sides.length);
      const turn = (by, label, text) => make("button", { type: "button", ariaLabel: label, textContent: text, onclick: () => {
        this.first = Math.max(0, Math.min(this.sides.length - 1, this.first + by));
        this.show(null);
      } });
      parts.push(make("p", { className: "take" }, turn(-ROWS, "Sides before", "‹"),
        `Sides ${this.first + 1} to ${to} of ${this.sides.length}`, turn(ROWS, "Sides after", "›")));
    }
    this.box.replaceChildren(...parts);
  }

  row() {
    const name = make("button", { type: "button", className: "side-name" });
    const intervals = make("input", { type: "number", min: 1, step: 1, className: "count" });
    const fewer = make("button", { type: "button", textContent: "−" });
    const more = make("button", { type: "button", textContent: "+" });
    const law = make("select");
    law.append(...Object.entries(LAWS).map(([value, { title }]) => new Option(title, value)));
    const value = make("input", { type: "number", step: "any", className: "count" });
    const shape = make("select");
    shape.append(...Object.entries(SHAPES).map(([value, text]) => new Option(text, value)));
    const rise = make("input", { type: "number", step: "any", className: "count", title: "how far the arc rises outwards" });
    const title = make("input", { type: "text", placeholder: "name" });
    const kind = make("select");
    kind.append(...Object.entries(KINDS).map(([value, text]) => new Option(text, value)));
    const line = make("tr", {}, make("th", { scope: "row" }, name),
      make("td", {}, make("span", { className: "stepper" }, fewer, intervals, more)),
      make("td", {}, make("span", { className: "law" }, shape, rise)),
      make("td", {}, make("span", { className: "law" }, law, value)),
      make("td", {}, make("span", { className: "law" }, title, kind)));
    const row = { line, name, intervals, fewer, more, shape, rise, law, value, title, kind, side: null };
    title.addEventListener("change", () => this.change(row.side, { name: title.value.trim() || undefined }));
    kind.addEventListener("change", () => this.change(row.side, { kind: kind.value || undefined }));
    name.addEventListener("click", () => this.choose(row.side));
    const count = (wanted) => {
      const change = { intervals: wanted, size: undefined };
      if (lawOf(now(row.side)).law === "parameters") change.spacing = undefined;
      this.change(row.side, change);
    };
    intervals.addEventListener("change", () => {
      const wanted = numberIn(intervals, "Give a whole number, 1 or more.", (number) => number >= 1 && Number.isInteger(number));
      if (wanted !== null) count(wanted);
    });
    const countNow = () => now(row.side).intervals ?? row.side.intervals;
    fewer.addEventListener("click", () => count(Math.max(1, countNow() - 1)));
    more.addEventListener("click", () => count(countNow() + 1));
    law.addEventListener("change", () => {
      const { first } = LAWS[law.value];
      this.change(row.side, { spacing: spacingOf(law.value, first ?? this.meanLength(row.side)) });
    });
    shape.addEventListener("change", () =>
      this.bend(row.side, shape.value === "arc" ? firstRise(shown.domain, row.side) : 0));
    rise.addEventListener("change", () => {
      const wanted = numberIn(rise, "Give a number: above 0 outwards, below 0 inwards, 0 for a straight side.");
      if (wanted !== null) this.bend(row.side, wanted);
    });
    value.addEventListener("change", () => {
      const { wanted, isRight } = LAWS[law.value];
      const number = numberIn(value, wanted, isRight);
      if (number !== null) this.change(row.side, { spacing: spacingOf(law.value, number) });
    });
    return row;
  }

  /** The length of a side's first interval as it is drawn: a law that begins with a length begins with this. */
  meanLength({ start }) {
    const { points } = shown.domain;
    const length = Math.hypot(points[2 * start + 2] - points[2 * start], points[2 * start + 3] - points[2 * start + 1]);
    return Number(length.toPrecision(3));
  }

  change(side, change) {
    if (isKnown(state.domain, shown.domain)) this.apply(changeSide(state.domain, shown.domain, side, change));
  }

  bend(side, rise) {
    if (isKnown(state.domain, shown.domain)) this.apply(bendSide(state.domain, shown.domain, side, rise));
  }

  fill(row, side, isChosen) {
    const told = now(side);
    const { law, value } = lawOf(told);
    const isFixed = Boolean(told.points);
    row.side = side;
    row.line.classList.toggle("chosen", isChosen);
    row.name.textContent = side.name;
    row.name.setAttribute("aria-pressed", String(isChosen));
    const set = (input, wanted) => {
      if (document.activeElement === input) return;
      input.value = wanted;
      judge(input, "");
    };
    set(row.intervals, String(side.intervals));
    set(row.law, law);
    set(row.value, value === null ? "" : String(value));
    const shape = shapeOf(told);
    set(row.shape, shape);
    set(row.rise, shape === "arc" ? String(Number(riseOf(state.domain, shown.domain, side).toPrecision(6))) : "");
    row.shape.options[Object.keys(SHAPES).indexOf("given")].hidden = shape !== "given";
    set(row.title, told.name ?? "");
    set(row.kind, told.kind ?? "");
    row.title.ariaLabel = `Name of ${side.name}`;
    row.kind.ariaLabel = `Kind of ${side.name}`;
    const { label } = LAWS[law] ?? {};
    row.value.hidden = !label;
    row.law.options[Object.keys(LAWS).indexOf("parameters")].hidden = law !== "parameters";
    for (const control of [row.intervals, row.fewer, row.law, row.more, row.value]) control.disabled = isFixed;
    // A full circle has no ends between which it could be straight, and one interval shows no arc.
    const isBound = isFixed || !firstRise(shown.domain, side);
    row.rise.hidden = shape !== "arc" || isBound;
    row.shape.disabled = isBound || (shape === "straight" && side.intervals < 2);
    row.shape.ariaLabel = `Shape of ${side.name}`;
    row.rise.ariaLabel = `Rise of the arc of ${side.name}, outwards`;
    row.fewer.disabled ||= side.intervals < 2;
    row.intervals.ariaLabel = `Intervals of ${side.name}`;
    row.fewer.ariaLabel = `One interval less on ${side.name}`;
    row.more.ariaLabel = `One interval more on ${side.name}`;
    row.law.ariaLabel = `Spacing of ${side.name}`;
    row.value.ariaLabel = `${label ?? "number"} of the spacing of ${side.name}`;
  }
}
