// The reader's choices, the steps that can be undone, and the last answer of the server.

/**
 * The beginning of a page: the mesh that a reader should probably take, with points inside, beside the one of the goal.
 * `view` is what is looked at first and taken: `interior`, or `wanted` for the goal; `isTold` whether the reader
 * has said what the mesh is for.
 */
export const state = {
  domain: null,
  view: "interior",
  isTold: false,
  goal: { keep_angle: 0.95 },
  beside: "wanted",
  color: "min_angle",
  format: "obj",
  /** Whether pictures are stretched to fill their places; null for what suits the domain. */
  stretch: null,
  /** The name of the file of the surface that is shown in place of a domain, or null. */
  solid: null,
};

/**
 * `corner` or `side` is chosen, as `{ring, index}`: a corner as the JSON counts, a side as the server does.
 * `drag` is a corner on its way; with `mustFit`, the next domain is brought into sight.
 */
export const selection = { corner: null, side: null, drag: null, mustFit: true };

/**
 * The last answers; `decides` are places that were asked for, `sourceNotes` tell what a file lost; `places` have names.
 * `coarser` is a size inside where points inside are too many. `forgotten` are meshes and an advice of a domain before that are no longer told, while those of this one are looked for.
 */
export const shown = { domain: null, meshes: {}, forgotten: {}, advice: null, curve: null, degree: null, limit: null, coarser: null, wantedDegree: null, decides: [], sourceNotes: [], places: [] };

/** Where domains that are as a file has them are from: `[file, place]`, the file null for that of the start, and the place in it. */
export const origins = new WeakMap();

const past = [];
const future = [];
const MOST = 200;

/** Remembers a domain that another one replaces. */
export function remember(domain) {
  past.push(domain);
  if (past.length > MOST) past.shift();
  future.length = 0;
}

/** Takes a step back, or forth; false if there is none. */
export function step(isBack) {
  const [from, to] = isBack ? [past, future] : [future, past];
  if (!from.length) return false;
  to.push(state.domain);
  state.domain = from.pop();
  return true;
}

export const canUndo = () => past.length > 0;
export const canRedo = () => future.length > 0;
