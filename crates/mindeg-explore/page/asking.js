// Asking the server, by the worker, for what is on screen.

import * as server from "./server.js";
import { showNothing, showTrouble, showUndo } from "./show.js";
import { remember, selection, shown, state, step } from "./state.js";

export const worker = new Worker("/page/painter.js");

/** The numbers of the last request, of the last one whose answer is complete, and of the first one about this domain. */
export const progress = { asked: 0, answered: 0, since: 0 };

const tab = server.newName();
let ownState = null;
let keeping;
let domainAsked = null;

/** What is asked for: what is on screen, and nothing else. */
export function request() {
  const { domain, goal, color, view, beside, format } = state;
  const show = [view, ...(beside === "none" ? [] : [beside]), "advice", "degree", "limit", "curve", "suggestions", "command"];
  return { domain, goal, show, color, format, view };
}

export function ask() {
  progress.asked += 1;
  if (state.domain !== domainAsked) progress.since = progress.asked;
  domainAsked = state.domain;
  worker.postMessage({ kind: "ask", id: progress.asked, tab, request: request(), isAnew: selection.mustFit });
  showUndo();
  keep();
}

/** Keeps the state on the server a moment after the last change. */
export function keep() {
  clearTimeout(keeping);
  keeping = setTimeout(() => {
    ownState ??= server.newName();
    server.keepState(ownState, state).catch((error) => showTrouble(error.message));
  }, 400);
}

/** Takes a changed domain; the one before can be brought back. */
export function apply(domain) {
  remember(state.domain);
  state.domain = domain;
  ask();
}

/** Takes another domain altogether. */
export function begin(domain, notes = []) {
  if (state.domain) remember(state.domain);
  state.domain = domain;
  startAnew();
  shown.sourceNotes = notes;
  ask();
}

/** Nothing is chosen or known, and the whole domain will be in sight. */
export function startAnew() {
  Object.assign(selection, { corner: null, side: null, mustFit: true });
  shown.decides = [];
  showNothing();
}

/** Takes one step back, or forth. */
export function undo(isBack) {
  const before = state.domain?.name;
  if (!step(isBack)) return;
  if (state.domain.name !== before) startAnew();
  Object.assign(selection, { corner: null, side: null });
  ask();
}
