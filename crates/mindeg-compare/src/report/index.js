"use strict";

const body = document.querySelector(".sortable tbody");
const headings = [...document.querySelectorAll(".sortable thead th")];

/** Rows in the order of a column: numbers by size, names by letter, what has neither last. */
function sort(column, isDescending) {
  const key = (row) => row.cells[column].dataset.value;
  const isNumeric = headings[column].dataset.kind === "number";
  const compare = (a, b) => {
    if (key(a) === "" || key(b) === "") return (key(a) === "") - (key(b) === "");
    const order = isNumeric ? key(a) - key(b) : key(a).localeCompare(key(b));
    return isDescending ? -order : order;
  };
  body.append(...[...body.rows].sort(compare));
  headings.forEach((heading, place) => {
    if (place !== column) heading.removeAttribute("aria-sort");
    else heading.setAttribute("aria-sort", isDescending ? "descending" : "ascending");
  });
}

headings.forEach((heading, column) => {
  heading.querySelector("button").addEventListener("click", () => {
    sort(column, heading.getAttribute("aria-sort") === "ascending");
  });
});
