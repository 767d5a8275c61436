// What is wrong with a field, said beside it.
// From the viewer's script: make.

let named = 0;
const notes = new WeakMap();

export const isPositive = (number) => number > 0;

/** Says beside a field what is wrong with it; with "", nothing is. Whether nothing is. */
export function judge(field, wrong) {
  let note = notes.get(field);
  if (!note && !wrong) return true;
  if (!note) {
    note = make("small", "wrong");
    note.id = `wrong-${(named += 1)}`;
    note.setAttribute("role", "alert");
    (field.closest("label") ?? field).after(note);
    notes.set(field, note);
  }
  const others = (field.getAttribute("aria-describedby") ?? "").split(" ").filter((id) => id && id !== note.id);
  const described = wrong ? [...others, note.id] : others;
  if (described.length) field.setAttribute("aria-describedby", described.join(" "));
  else field.removeAttribute("aria-describedby");
  if (wrong) field.setAttribute("aria-invalid", "true");
  else field.removeAttribute("aria-invalid");
  note.hidden = !wrong;
  note.textContent = wrong;
  return !wrong;
}

/** The number in a field, if it is one of those that the sentence `wanted` tells; else that is said beside it, and null comes. */
export function numberIn(field, wanted, isRight = () => true) {
  const number = field.valueAsNumber;
  return judge(field, Number.isFinite(number) && isRight(number) ? "" : wanted) ? number : null;
}

/** The same, where an empty field is right, too: then undefined comes. */
export function numberOrNone(field, wanted, isRight) {
  if (field.value !== "" || field.validity.badInput) return numberIn(field, wanted, isRight);
  judge(field, "");
  return undefined;
}
