// What a reader does with a report, in headless Chromium.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { run, seriousFaults, test } from "./harness.mjs";

const [binary, domains, executablePath] = process.argv.slice(2);
const pages = resolve("pages");
rmSync(pages, { recursive: true, force: true });
mkdirSync(pages);

function mindeg(...args) {
  const { status, stderr, error } = spawnSync(binary, args, { cwd: pages, encoding: "utf8" });
  if (error) throw error;
  return { status, stderr };
}

const bundled = (name) => join(domains, `${name}.json`);
const page = (name) => join(pages, name);

/** A rectangle with equally many intervals on all sides, but for one. */
function rectangle(name, intervals) {
  const sides = [intervals, intervals + 1, intervals, intervals].map((n) => ({ intervals: n }));
  const path = page(`${name}.json`);
  writeFileSync(path, JSON.stringify({ name, rectangle: { width: 4, height: 3 }, sides }));
  return path;
}

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const noise = [];

/** A page in a context of its own. What goes wrong on it is kept in `noise`. */
async function open(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const opened = await context.newPage();
  const address = pathToFileURL(page(name)).href;
  // A driver without a processor for pictures tells how slow it is; that is not the page's.
  const isDriver = (text) => text.includes("GL Driver Message (OpenGL, Performance");
  opened.on("console", (message) => {
    if (!isDriver(message.text())) noise.push(`${name}: ${message.type()}: ${message.text()}`);
  });
  opened.on("pageerror", (error) => noise.push(`${name}: ${error.message}`));
  opened.on("request", (request) => {
    if (request.url() !== address && !request.url().startsWith("data:")) {
      noise.push(`${name} asks for ${request.url()}`);
    }
  });
  await opened.goto(address);
  await settled(opened);
  return opened;
}

/** Opens all that is folded. */
async function unfold(opened) {
  await opened.evaluate(() => document.querySelectorAll("details").forEach((details) => { details.open = true; }));
  await settled(opened);
  return opened;
}

/** Waits for what is drawn at once and for what is drawn after a pause. */
async function settled(opened) {
  await opened.waitForTimeout(200);
  await opened.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The picture of each method, as text that differs when it does. */
const drawn = (opened) =>
  opened.$$eval(".stage canvas:first-child", (all) => all.map((canvas) => canvas.toDataURL()));

const readouts = (opened) => opened.locator(".readout").allTextContents();

/** Where a vertex is on the screen. */
async function screenPlace(opened, stage, vertex) {
  await opened.locator(".stage").nth(stage).scrollIntoViewIfNeeded();
  return opened.evaluate(([stage, vertex]) => {
    const box = document.querySelectorAll(".stage")[stage].getBoundingClientRect();
    const [x, y] = pictures[stage].frame.toScreen(points[2 * vertex], points[2 * vertex + 1]);
    return [box.left + x, box.top + y];
  }, [stage, vertex]);
}

function assertAllDiffer(before, after) {
  assert.ok(before.length > 1);
  before.forEach((picture, place) => assert.notEqual(picture, after[place], `picture ${place}`));
}

mindeg("compare", bundled("wing-panel"), "--interior", "-o", "inside.html");
const written = mindeg("compare", bundled("unequal-hexagon"), "-o", "hexagon.html", "-o", "hexagon.json", "-o", "hexagon.md");
assert.equal(written.status, 0, written.stderr);
const report = JSON.parse(readFileSync(page("hexagon.json"), "utf8"));
/** What a reader sees as the name of a method of the JSON. */
function title(name) {
  if (name === `Exact, degree ${report.trade_off.advised}`) return "Keeps 95% of the angle";
  if (name.startsWith("Exact")) return `${name.replace("Exact, degree", "Degree")}, largest angle`;
  return { "mindeg": "Least degree", "mindeg, points inside": "Points inside" }[name] ?? name;
}

// A mesh appears once: the methods that have the same one share a place, and say so in one title.
const meshes = report.methods.filter((method) => method.same_mesh_as === null);
const names = meshes.map((method) => {
  const others = report.methods.filter((other) => other.same_mesh_as === method.name);
  const more = others.map(({ name }) => title(name).toLowerCase().replace(/^degree \d+, /, ""));
  return [title(method.name), ...more].join(", ");
});
/** The place of a method's mesh among the pictures of the page, which begin with the advised one. */
const placed = async (opened) => {
  const shown = await opened.locator(".mesh h3").allTextContents();
  return names.map((name) => shown.indexOf(name));
};

test("the page begins with what to do, and has every mesh once", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const shown = await opened.locator(".mesh h3").allTextContents();
  assert.deepEqual([...shown].sort(), [...names].sort());
  assert.ok(names.includes("Least degree, largest angle"), names.join(" | "));
  assert.deepEqual(shown.slice(0, 2), ["Points inside", "Keeps 95% of the angle"]);
  const [headline, also] = await opened.locator(".headline").allTextContents();
  assert.ok(report.verdict.startsWith(`${headline} ${also}`) && headline.startsWith("For a solver, put points inside: "));
  // What makes an advised mesh stands with it.
  for (const [place, end] of [[0, "-points-inside.obj"], [1, "-keep-angle-95.obj"]]) {
    const commands = await opened.locator(".mesh").nth(place).locator(".command code").allTextContents();
    assert.ok(commands.length === 1 && commands[0].endsWith(end), commands.join(" | "));
  }
  assert.equal(await opened.locator(".command").count(), 2);
  assert.deepEqual(await opened.locator(".words tbody th").allTextContents(), [
    "Maximum degree", "Minimum angle", "Median minimum angle", "Triangles below 5°", "Triangles below 15°"]);
  for (const picture of await drawn(opened)) assert.ok(picture.length > 5000);
  await opened.context().close();
});

test("the scripts write numbers as the program does", async () => {
  const table = readFileSync("numbers.txt", "utf8").split(/^< /m).slice(1).map((entry) => entry.trim().split("\n"));
  assert.ok(table.length >= 25);
  const opened = await open("hexagon.html");
  const written = await opened.evaluate((inputs) => inputs.map((input) => {
    const value = Number(input);
    return `> ${numberText(value)} | ${angleText(value)} | ${percent(value)}`;
  }), table.map(([input]) => input));
  assert.deepEqual(written, table.map(([, answer]) => answer));
  await opened.context().close();
});

test("the command is copied", async () => {
  const opened = await open("hexagon.html");
  await opened.evaluate(() => {
    navigator.clipboard.writeText = async (text) => { window.copied = text; };
  });
  const commands = await opened.locator(".command code").allTextContents();
  assert.match(commands[0], /^mindeg mesh \S+ --interior -o \S+-points-inside\.obj$/);
  assert.match(commands[1], /^mindeg mesh \S+ --keep-angle 95% -o \S+-keep-angle-95\.obj$/);
  await opened.locator(".copy").nth(1).click();
  assert.equal(await opened.evaluate(() => window.copied), commands[1]);
  await opened.context().close();
});

test("the mesh to take is in the first screen", async () => {
  const folder = ["plate-with-holes", "boundary-layer-channel", "great-britain"].map(bundled);
  assert.equal(mindeg("compare", ...folder, "-o", "first/").status, 0);
  const names = ["hexagon", "first/plate-with-holes", "first/boundary-layer-channel", "first/great-britain"];
  for (const name of names) {
    for (const [width, height] of [[390, 844], [800, 900], [1400, 900]]) {
      const opened = await open(`${name}.html`, { viewport: { width, height } });
      const { top, bottom } = await opened.$eval(".stage", (stage) => stage.getBoundingClientRect().toJSON());
      // A tall domain begins there.
      const seen = Math.min(bottom, height) - top;
      assert.ok(top > 0 && seen >= Math.min(bottom - top, 240), `${name}: from ${top} to ${bottom} of ${height} at ${width} pixels`);
      await opened.context().close();
    }
  }
});

const SCREENS = [390, 800, 1400].flatMap((width) => ["light", "dark"].map((colorScheme) => ({ width, colorScheme })));

test("the page of a trade-off begins with the mesh to take, and has points inside among its figures", async () => {
  for (const [purpose, first] of [["solver", "points-inside"], ["patch", "degree-6"]]) {
    assert.equal(mindeg("tradeoff", bundled("wing-panel"), "--for", purpose, "-o", `${purpose}.html`).status, 0);
    for (const [width, height] of [[390, 844], [800, 900], [1400, 900]]) {
      const opened = await open(`${purpose}.html`, { viewport: { width, height } });
      assert.equal(await opened.locator(".mesh").first().getAttribute("id"), first);
      const { top, bottom } = await opened.$eval(".mesh svg", (picture) => picture.getBoundingClientRect().toJSON());
      const seen = Math.min(bottom, height) - top;
      assert.ok(seen >= Math.min(bottom - top, 150), `${purpose}: from ${top} to ${bottom} of ${height} at ${width} pixels`);
      assert.match(await opened.locator("tbody tr").first().textContent(), /points inside/);
      await opened.context().close();
    }
  }
});

test("axe finds nothing serious, on any screen, light and dark", async () => {
  assert.equal(mindeg("compare", bundled("wing-panel"), bundled("slender-fin"), "-o", "pages/").status, 0);
  assert.equal(mindeg("tradeoff", bundled("wing-panel"), "-o", "curve.html").status, 0);
  for (const name of ["hexagon.html", "inside.html", "pages/index.html", "pages/slender-fin.html", "curve.html"]) {
    for (const { width, colorScheme } of SCREENS) {
      // The page's own policy keeps scripts of others out, and axe is one.
      const opened = await unfold(await open(name, { viewport: { width, height: 900 }, colorScheme, bypassCSP: true }));
      assert.deepEqual(await seriousFaults(opened), [], `${name} at ${width} pixels, ${colorScheme}`);
      await opened.context().close();
    }
  }
});

test("no table is cut off on any screen or on paper", async () => {
  for (const name of ["hexagon.html", "inside.html", "pages/index.html", "curve.html"]) {
    for (const [width, media] of [[390, "screen"], [800, "screen"], [1400, "screen"], [720, "print"]]) {
      const opened = await open(name, { viewport: { width, height: 900 } });
      await opened.emulateMedia({ media });
      await unfold(opened);
      const cut = await opened.$$eval("html, .scroll", (boxes) =>
        boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.innerText.slice(0, 40)));
      assert.deepEqual(cut, [], `${name} at ${width} pixels, ${media}`);
      await opened.context().close();
    }
  }
});

test("every figure has a name, and no table two equal headings", async () => {
  for (const name of ["hexagon.html", "pages/index.html", "curve.html"]) {
    const opened = await unfold(await open(name));
    const nameless = await opened.$$eval("figure, svg, .bars, .stage", (figures) =>
      figures.filter((figure) => {
        const by = figure.getAttribute("aria-labelledby");
        return !(figure.getAttribute("aria-label") || (by && document.getElementById(by)?.textContent));
      }).map((figure) => figure.outerHTML.slice(0, 80)));
    assert.deepEqual(nameless, [], name);
    const headings = await opened.$$eval("table", (tables) =>
      tables.map((table) => [...table.querySelectorAll("thead th")].map((cell) => cell.textContent)));
    for (const row of headings) assert.equal(new Set(row).size, row.length, row.join(" | "));
    await opened.context().close();
  }
});

test("the numbers of a column end at the same place", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const columns = await opened.$$eval("table:not(.words table)", (tables) => tables.flatMap((table) => {
    const rows = [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent));
    return rows[0].map((_, column) => rows.map((row) => row[column]));
  }));
  let checked = 0;
  for (const column of columns) {
    const decimals = column.filter((text) => /^\d+\.\d+[°%]?$/.test(text)).map((text) => text.match(/\.(\d+)/)[1].length);
    if (decimals.length > 1) checked += 1;
    assert.ok(new Set(decimals).size <= 1, column.join(" | "));
  }
  assert.ok(checked > 30, `${checked} columns`);
  await opened.context().close();
});

test("two meshes of a wide domain fit on one screen", async () => {
  assert.equal(mindeg("compare", bundled("boundary-layer-channel"), "-o", "channel.html").status, 0);
  const opened = await open("channel.html", { viewport: { width: 1400, height: 900 } });
  const boxes = await opened.$$eval(".mesh", (all) => all.slice(0, 2).map((mesh) => mesh.getBoundingClientRect().toJSON()));
  assert.ok(boxes[1].top >= boxes[0].bottom, "one above the other");
  assert.ok(boxes[1].bottom - boxes[0].top < 700, `${boxes[1].bottom - boxes[0].top} pixels`);
  await opened.context().close();
});

test("a curve is legible on a phone, and a single point makes none", async () => {
  for (const name of ["channel.html", "curve.html"]) {
    const opened = await open(name, { viewport: { width: 390, height: 740 } });
    const sizes = await opened.$$eval(".plot text", (all) => all.filter((text) => text.getClientRects().length).map((text) => {
      const svg = text.closest("svg");
      return (parseFloat(getComputedStyle(text).fontSize) * svg.getBoundingClientRect().width) / svg.viewBox.baseVal.width;
    }));
    assert.ok(sizes.length > 5 && Math.min(...sizes) > 10, `${name}: ${Math.min(...sizes)} pixels`);
    await opened.context().close();
  }
  assert.equal(mindeg("tradeoff", bundled("slender-fin"), "-o", "point.html", "-o", "point.svg").status, 0);
  for (const name of ["point.html", "pages/slender-fin.html"]) {
    const opened = await open(name);
    assert.equal(await opened.locator(".plot").count(), 0, name);
    await opened.context().close();
  }
  assert.ok(!readFileSync(page("point.svg"), "utf8").includes('class="curve"'));
});

test("a bar that is pointed at or tapped is read", async () => {
  const opened = await unfold(await open("hexagon.html"));
  for (const [chart, words] of [["#degree-chart", /, degree 2: \d+ vert/], ["#metric-chart", / to .*: \d+ triangle/]]) {
    await opened.locator(`${chart} .bars i`).first().hover();
    assert.match(await opened.locator(`${chart} .chart-read`).textContent(), words);
  }
  await opened.context().close();
});

test("pointing at a vertex tells its degree in every mesh", async () => {
  const opened = await unfold(await open("hexagon.html"));
  for (const vertex of [0, 5, 30]) {
    await opened.mouse.move(...(await screenPlace(opened, 1, vertex)));
    await settled(opened);
    for (const text of await readouts(opened)) assert.match(text, new RegExp(`^Vertex ${vertex}: degree \\d+`));
  }
  await opened.mouse.move(0, 0);
  await settled(opened);
  assert.deepEqual(await readouts(opened), names.map(() => ""));
  await opened.context().close();
});

test("pointing at a triangle tells its angles", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const delaunay = (await placed(opened))[names.indexOf("Delaunay")];
  const [worst] = report.methods.find(({ name }) => name === "Delaunay").worst_triangles;
  const corners = [];
  for (const vertex of worst.vertices) corners.push(await screenPlace(opened, delaunay, vertex));
  const middle = [0, 1].map((axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / 3);
  await opened.mouse.move(...middle);
  await settled(opened);
  const text = (await readouts(opened))[delaunay];
  const found = text.match(/^Triangle (\d+) \(([\d, ]+)\): angles ([\d.]+)°, ([\d.]+)°, ([\d.]+)°/);
  assert.ok(found, text);
  assert.equal(Number(found[1]), worst.triangle);
  assert.equal(found[2], worst.vertices.join(", "));
  assert.ok(Math.abs(Number(found[3]) - worst.min_angle) < 0.001 * worst.min_angle, text);
  assert.ok(Math.abs(Number(found[5]) - worst.max_angle) < 0.001 * worst.max_angle, text);
  await opened.context().close();
});

test("the buttons lead to a vertex of maximum degree and the minimum angle", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const places = await placed(opened);
  for (const [number, method] of meshes.entries()) {
    const figure = opened.locator(".mesh").nth(places[number]);
    await figure.locator("[data-jump=max_degree]").click();
    await settled(opened);
    assert.match(await figure.locator(".readout").textContent(), new RegExp(`: degree ${method.max_degree}\\b`));
    await figure.locator("[data-jump=worst]").click();
    await settled(opened);
    const worst = method.worst_triangles[0].triangle;
    assert.match(await figure.locator(".readout").textContent(), new RegExp(`^Triangle ${worst} `));
  }
  await opened.context().close();
});

test("every measure can be chosen, and colors, legend and chart follow", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const seen = new Set();
  const options = await opened.locator("#metric option").allTextContents();
  assert.equal(options.length, 7);
  for (const [place, title] of options.entries()) {
    await opened.selectOption("#metric", { label: title });
    await settled(opened);
    seen.add((await drawn(opened))[1]);
    if (title === "nothing") continue;
    assert.ok((await opened.locator("#metric-legend").textContent()).startsWith(title));
    assert.equal(await opened.locator("#chart-metric").textContent(), title.toLowerCase());
    const bars = await opened.$$eval("#metric-chart .bars", (rows) =>
      rows.map((row) => [...row.children].reduce((sum, bar) => sum + Number(bar.title.match(/: (\d+)/)[1]), 0)));
    const counts = await opened.evaluate(() => meshes.map(({ triangles }) => triangles.length / 3));
    assert.deepEqual(bars, counts, title);
    assert.equal(counts.filter((count) => count === report.domain.triangles).length, names.length - 1);
    assert.equal(await opened.locator("#metric").inputValue(), String(place === 6 ? -1 : place));
  }
  assert.equal(seen.size, 7);
  await opened.context().close();
});

test("zoom and movement are the same in all pictures", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const first = await drawn(opened);
  await opened.locator("#zoom-in").click();
  await settled(opened);
  const nearer = await drawn(opened);
  assertAllDiffer(first, nearer);

  const stage = opened.locator(".stage").first();
  await stage.scrollIntoViewIfNeeded();
  const box = await stage.boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await opened.mouse.move(...middle);
  await opened.mouse.down();
  await opened.mouse.move(middle[0] + 60, middle[1] + 25, { steps: 4 });
  await opened.mouse.up();
  await settled(opened);
  const moved = await drawn(opened);
  assertAllDiffer(nearer, moved);

  // What was under the pointer stays under it. Pointers are at whole pixels.
  const pointer = [Math.round(box.x) + 100, Math.round(box.y) + 80];
  const under = () => opened.evaluate(([x, y]) => {
    const box = document.querySelectorAll(".stage")[0].getBoundingClientRect();
    return pictures[0].frame.toDomain(x - box.left, y - box.top);
  }, pointer);
  await opened.mouse.move(...pointer);
  const before = await under();
  await opened.mouse.wheel(0, -400);
  await settled(opened);
  assertAllDiffer(moved, await drawn(opened));
  const after = await under();
  before.forEach((value, axis) => assert.ok(Math.abs(value - after[axis]) < 1e-9));

  await opened.locator("#fit").click();
  await settled(opened);
  await opened.mouse.move(0, 0);
  await settled(opened);
  assert.deepEqual(await drawn(opened), first);
  await opened.context().close();
});

test("a wheel over a picture that is not chosen scrolls the page", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const before = await drawn(opened);
  await opened.mouse.move(...(await screenPlace(opened, 0, 0)));
  const top = await opened.evaluate(() => scrollY);
  await opened.mouse.wheel(0, 200);
  await opened.waitForTimeout(400);
  assert.ok((await opened.evaluate(() => scrollY)) > top);
  assert.deepEqual(await drawn(opened), before);
  await opened.context().close();
});

test("everything can be reached and done from the keyboard", async () => {
  const opened = await unfold(await open("hexagon.html"));
  const reached = [];
  for (let step = 0; step < 60; step++) {
    await opened.keyboard.press("Tab");
    const at = await opened.evaluate(() => {
      const { activeElement: at } = document;
      if (at === document.body) return null;
      return at.id || at.dataset.jump || (at.matches(".stage") ? "stage" : at.className);
    });
    if (at === null) break;
    reached.push(at);
  }
  for (const id of ["copy", "metric", "dots", "stretch", "zoom-out", "zoom-in", "fit"]) {
    assert.ok(reached.includes(id), `${id} is not reached`);
  }
  for (const kind of ["stage", "max_degree", "worst"]) {
    assert.equal(reached.filter((at) => at === kind).length, names.length, kind);
  }

  // Folded, as a page opens, it takes few steps to get through.
  const folded = await open("hexagon.html");
  let stops = 0;
  for (; stops < 60; stops++) {
    await folded.keyboard.press("Tab");
    if (await folded.evaluate(() => document.activeElement === document.body)) break;
  }
  assert.ok(stops <= 30, `${stops} stops`);
  await folded.context().close();

  await opened.locator("#fit").focus();
  while (!(await opened.evaluate(() => document.activeElement.matches(".stage")))) await opened.keyboard.press("Tab");
  await settled(opened);
  assert.notEqual(await opened.locator("#spoken").textContent(), "");
  const first = await drawn(opened);
  let last = first;
  for (const key of ["+", "ArrowLeft", "ArrowUp", "-", "ArrowRight"]) {
    await opened.keyboard.press(key);
    await settled(opened);
    const now = await drawn(opened);
    assertAllDiffer(last, now);
    last = now;
  }
  await opened.keyboard.press("0");
  await settled(opened);
  assert.deepEqual(await drawn(opened), first);
  await opened.context().close();
});

test("light and dark follow the reader's system, also while the page is open", async () => {
  const opened = await unfold(await open("hexagon.html", { colorScheme: "light" }));
  const background = () => opened.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const [light, lightPage] = [await drawn(opened), await background()];
  await opened.emulateMedia({ colorScheme: "dark" });
  await settled(opened);
  assertAllDiffer(light, await drawn(opened));
  assert.notEqual(await background(), lightPage);
  await opened.context().close();
});

test("a dark page prints light, with its pictures", async () => {
  const opened = await unfold(await open("hexagon.html", { colorScheme: "dark" }));
  const dark = await drawn(opened);
  await opened.evaluate(() => {
    window.addEventListener("beforeprint", () => {
      window.printed = [...document.querySelectorAll(".stage canvas:first-child")].map((c) => c.toDataURL());
    });
  });
  assert.ok((await opened.pdf()).length > 20_000);
  assertAllDiffer(dark, await opened.evaluate(() => window.printed));
  await settled(opened);
  assert.deepEqual(await drawn(opened), dark);
  await opened.context().close();
});

test("on a phone nothing is cut off, and a tap reads off", async () => {
  const opened = await open("hexagon.html", { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  assert.equal(await opened.evaluate(() => document.scrollingElement.scrollWidth), 360);
  await opened.touchscreen.tap(...(await screenPlace(opened, 0, 5)));
  await settled(opened);
  assert.match((await readouts(opened))[0], /^Vertex 5: degree/);
  await opened.context().close();
});

test("without the script the figures can still be read", async () => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const opened = await context.newPage();
  await opened.goto(pathToFileURL(page("hexagon.html")).href);
  const text = await opened.locator("main").textContent();
  assert.ok(text.includes(report.verdict.split(". ")[0]));
  // The choice, the overview, degrees, shares and sides; a table for each measure and each mesh.
  assert.equal(await opened.locator("table").count(), 5 + 6 + names.length);
  await context.close();
});

test("a slender domain is stretched, and the page says so", async () => {
  assert.equal(mindeg("compare", bundled("slender-fin"), "-o", "fin.html").status, 0);
  const opened = await open("fin.html");
  assert.ok(await opened.locator("#stretched").isVisible());
  const stretched = await drawn(opened);
  await opened.locator("#stretch").uncheck();
  await settled(opened);
  assert.ok(await opened.locator("#stretched").isHidden());
  assertAllDiffer(stretched, await drawn(opened));
  await opened.context().close();
});

test("20,000 triangles are all drawn, and can be moved and pointed at", async () => {
  const path = rectangle("many", 5000);
  assert.equal(mindeg("compare", path, "-o", "many.html").status, 0);
  const opened = await open("many.html");
  assert.equal(await opened.locator(".thinned").count(), 0);
  assert.equal(await opened.evaluate(() => methods[0].triangles.length / 3), 19_999);
  const whole = await opened.evaluate(() => {
    const start = performance.now();
    for (const picture of pictures) {
      picture.draw();
      picture.mesh.getContext("2d").getImageData(0, 0, 1, 1);
    }
    return performance.now() - start;
  });
  // While moving, pictures already drawn are shifted: that must keep up with the hand.
  const moving = await opened.evaluate(async () => {
    const start = performance.now();
    for (let step = 0; step < 10; step++) {
      zoomBy(1.05);
      await new Promise(requestAnimationFrame);
    }
    return (performance.now() - start) / 10;
  });
  console.log(`      all drawn anew in ${whole.toFixed()} ms, a frame while moving in ${moving.toFixed()} ms`);
  assert.ok(moving < 250, `${moving} ms a frame`);
  await opened.locator("[data-jump=worst]").first().click();
  await settled(opened);
  assert.match((await readouts(opened))[0], /^Triangle \d+ /);
  await opened.context().close();
});

test("more triangles are thinned out, and the page says so", async () => {
  const path = rectangle("more", 10_000);
  const compared = mindeg("compare", path, "-o", "more.html", "-o", "more-report.json");
  assert.equal(compared.status, 0, compared.stderr);
  const opened = await open("more.html");
  const notes = await opened.locator(".thinned").allTextContents();
  assert.match(notes[0], /20.000 of 39.999 triangles/);
  assert.ok((await opened.evaluate(() => methods[0].triangles.length / 3)) <= 20_000);
  const place = (await opened.locator(".mesh h3").allTextContents()).indexOf("Delaunay");
  await opened.locator("[data-jump=max_degree]").nth(place).click();
  await settled(opened);
  const full = JSON.parse(readFileSync(page("more-report.json"), "utf8"));
  const { max_degree } = full.methods.find(({ name }) => name === "Delaunay");
  assert.ok((await readouts(opened))[place].includes(`degree ${max_degree}`));
  await opened.context().close();
});

test("the index of many domains sorts, links, and lists what failed", async () => {
  writeFileSync(page("broken.json"), '{"rectangle": {"width": 4, "height": 3}, "sides": [{"intervals": 0}]}');
  const all = readdirSync(domains).filter((name) => name.endsWith(".json")).map((name) => join(domains, name));
  mindeg("compare", ...all, page("broken.json"), "-o", "out/");
  const opened = await open("out/index.html");
  const rows = opened.locator("tbody tr");
  assert.equal(await rows.count(), all.length);
  assert.match(await opened.locator("main").textContent(), /Not compared: 1[^]*broken/);
  for (const link of await opened.$$eval("tbody a", (links) => links.map((link) => link.getAttribute("href")))) {
    assert.ok(existsSync(join(pages, "out", decodeURIComponent(link))), link);
  }
  const column = (place) => opened.$$eval("tbody tr", (rows, place) => rows.map((row) => row.cells[place].dataset.value), place);
  const headings = opened.locator("thead button");
  for (const place of [1, 4, 5]) {
    for (const [order, sign] of [["ascending", 1], ["descending", -1]]) {
      await headings.nth(place).focus();
      await opened.keyboard.press("Enter");
      assert.equal(await opened.locator("thead th").nth(place).getAttribute("aria-sort"), order);
      // Figures that are missing come last.
      const values = (await column(place)).filter((value) => value !== "").map(Number);
      assert.deepEqual(values, [...values].sort((a, b) => sign * (a - b)));
    }
  }
  await headings.first().click();
  const sorted = await column(0);
  assert.deepEqual(sorted, [...sorted].sort((a, b) => a.localeCompare(b)));
  await opened.locator("tbody a").first().click();
  await settled(opened);
  assert.equal(await opened.locator(".stage").first().isVisible(), true);
  // From page to page, and back to the list; each says what made it.
  assert.match(await opened.locator("footer").textContent(), /from .*\.json with mindeg compare .* -o out\//);
  const first = await opened.locator("h1").textContent();
  const next = opened.locator("nav a[rel=next]");
  const name = (await next.textContent()).replace(" →", "");
  await next.click();
  await settled(opened);
  assert.equal(await opened.locator("h1").textContent(), name);
  assert.ok((await opened.locator("nav a[rel=prev]").textContent()).endsWith(first));
  await opened.locator("nav a").first().click();
  assert.equal(await rows.count(), all.length);
  await opened.context().close();
});

test("points of a trade-off lead to their meshes, by the keyboard and without a script", async () => {
  assert.equal(mindeg("tradeoff", bundled("wing-panel"), "-o", "tradeoff.html").status, 0);
  const context = await browser.newContext({ javaScriptEnabled: false, viewport: { width: 1280, height: 900 } });
  const opened = await context.newPage();
  await opened.goto(pathToFileURL(page("tradeoff.html")).href);
  assert.equal(await opened.locator("figure svg").count(), 5);
  assert.equal(await opened.locator(".mesh h3").first().textContent(), "Points inside");
  assert.equal(await opened.locator("tbody tr").count(), 5);
  for (const degree of [4, 5, 6, 7]) {
    await opened.keyboard.press("Tab");
    // The commands of the meshes come before the curve.
    for (let more = 0; degree === 4 && more < 10 && !(await opened.locator(":focus").getAttribute("href")); more++) await opened.keyboard.press("Tab");
    assert.equal(await opened.locator(":focus").getAttribute("href"), `#degree-${degree}`);
  }
  await opened.keyboard.press("Enter");
  const box = await opened.locator("#degree-7:target").boundingBox();
  assert.ok(box.y >= 0 && box.y < 900, `at ${box.y}`);
  await context.close();
});

test("the meshes of a trade-off are zoomed together, by buttons, wheel, keys and dragging", async () => {
  const opened = await open("tradeoff.html", { viewport: { width: 1280, height: 900 } });
  const boxes = async () => {
    await opened.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const all = await opened.locator(".mesh svg").evaluateAll((all) => all.map((drawing) => drawing.getAttribute("viewBox")));
    assert.equal(new Set(all).size, 1);
    return all[0].split(" ").map(Number);
  };
  const width = () => opened.locator("#degree-5 .edge").evaluate((edges) => parseFloat(getComputedStyle(edges).strokeWidth));
  const [whole, thick] = [await boxes(), await width()];
  await opened.getByRole("button", { name: "Zoom in" }).click();
  const near = await boxes();
  assert.ok(Math.abs(near[2] * 1.5 - whole[2]) < 1e-6 && near[0] > 0 && (await width()) < thick, near.join(" "));
  const drawing = opened.locator("#degree-6 svg");
  await drawing.scrollIntoViewIfNeeded();
  const { x, y, width: wide, height: high } = await drawing.boundingBox();
  await opened.mouse.move(x + 0.75 * wide, y + 0.25 * high);
  await opened.mouse.wheel(0, -300);
  assert.deepEqual(await boxes(), near, "a picture that was not clicked leaves the wheel to the page");
  await drawing.scrollIntoViewIfNeeded();
  const at = await drawing.boundingBox();
  const pointer = [at.x + 0.75 * at.width, at.y + 0.25 * at.height];
  const under = ([left, top, width, height]) => [left + 0.75 * width, top + 0.25 * height];
  await opened.mouse.click(...pointer);
  await opened.mouse.move(...pointer);
  await opened.mouse.wheel(0, -300);
  const nearer = await boxes();
  assert.ok(nearer[2] < 0.5 * near[2], nearer.join(" "));
  under(nearer).forEach((value, axis) => assert.ok(Math.abs(value - under(near)[axis]) < 2, `${under(nearer)} ${under(near)}`));
  await opened.mouse.down();
  await opened.mouse.move(pointer[0] - 40, pointer[1] + 25, { steps: 4 });
  await opened.mouse.up();
  const moved = await boxes();
  assert.ok(moved[0] > nearer[0] + 5 && moved[1] < nearer[1] - 3, moved.join(" "));
  await opened.keyboard.press("ArrowDown");
  assert.ok((await boxes())[1] > moved[1]);
  await opened.keyboard.press("0");
  assert.deepEqual(await boxes(), whole);
  assert.equal(await opened.locator(".copy:visible").count(), 6);
  await opened.context().close();
});

test("a trade-off is dark on a dark screen, light on paper, and fits a phone", async () => {
  const opened = await open("tradeoff.html", { colorScheme: "dark", viewport: { width: 360, height: 740 } });
  const brightness = (selector, property) =>
    opened.$eval(selector, (element, property) => {
      const [red, green, blue] = getComputedStyle(element)[property].match(/\d+/g).map(Number);
      return (red + green + blue) / 3;
    }, property);
  assert.ok((await brightness("h1", "color")) > 200);
  assert.ok((await brightness(".tick", "fill")) > 120);
  assert.ok(await opened.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await opened.emulateMedia({ media: "print" });
  assert.ok((await brightness("h1", "color")) < 80);
  assert.ok((await brightness(".tick", "fill")) < 120);
  await opened.context().close();
});

/** Rings of quads around a hole in an ellipse: a mesh with vertices inside, in space where `height` is not 0. */
function annulus(name, height) {
  const around = 40;
  const rings = 8;
  const vertices = [];
  const faces = [];
  for (let ring = 0; ring <= rings; ring++) {
    for (let place = 0; place < around; place++) {
      const [angle, radius] = [(2 * Math.PI * place) / around, 1 + ring / rings];
      vertices.push(`v ${1.6 * radius * Math.cos(angle)} ${radius * Math.sin(angle)} ${height * ring}`);
      const next = (place + 1) % around;
      const [a, b] = [place, next].map((at) => ring * around + at + 1);
      if (ring < rings) faces.push(`f ${a} ${a + around} ${b + around} ${b}`);
    }
  }
  writeFileSync(page(`${name}.obj`), [...vertices, ...faces, ""].join("\n"));
}

test("a view shows any mesh as a report does, and a domain", async () => {
  annulus("annulus", 0);
  annulus("bowl", 0.1);
  for (const name of ["annulus", "bowl"]) assert.equal(mindeg("view", `${name}.obj`, "-o", `${name}.html`).status, 0);
  assert.equal(mindeg("view", bundled("wing-panel"), "--keep-angle", "95%", "-o", "wing.html").status, 0);
  for (const [name, vertices, triangles] of [["annulus", 360, 640], ["wing", 72, 70]]) {
    const opened = await open(`${name}.html`);
    assert.equal(await opened.locator(".stage").count(), 1, name);
    assert.equal(await opened.locator(".facts").textContent(), `${vertices} vertices · ${triangles} triangles`);
    const [first] = await drawn(opened);
    await opened.mouse.move(...(await screenPlace(opened, 0, 5)));
    await settled(opened);
    assert.match((await readouts(opened))[0], /^Vertex 5: degree \d+$/, name);
    await opened.locator("[data-jump=worst]").click();
    await settled(opened);
    assert.match((await readouts(opened))[0], /^Triangle \d+ /, name);
    assert.notEqual((await drawn(opened))[0], first);
    await opened.locator("#fit").click();
    const seen = new Set();
    for (const title of await opened.locator("#metric option").allTextContents()) {
      await opened.selectOption("#metric", { label: title });
      await settled(opened);
      seen.add((await drawn(opened))[0]);
    }
    assert.equal(seen.size, 7, name);
    const bars = await opened.$$eval("#metric-chart .bars i", (all) =>
      all.reduce((sum, bar) => sum + Number(bar.title.match(/: (\d+)/)[1]), 0));
    assert.equal(bars, triangles);
    await opened.locator(".stage").focus();
    const before = (await drawn(opened))[0];
    await opened.keyboard.press("+");
    await settled(opened);
    assert.notEqual((await drawn(opened))[0], before, "the keyboard zooms");
    await opened.context().close();
  }
});

/** A picture of the stage as a reader sees it. */
const seen = async (opened) => (await opened.locator(".stage").screenshot()).toString("base64");

test("a mesh in space is turned, zoomed and read off, with WebGL and without", async () => {
  annulus("bowl", 0.1);
  assert.equal(mindeg("view", "bowl.obj", "-o", "bowl.html").status, 0);
  for (const [how, launch] of [["webgl", ["--enable-unsafe-swiftshader"]], ["software", ["--disable-3d-apis"]]]) {
    const own = await chromium.launch({ executablePath, args: ["--no-sandbox", ...launch] });
    const opened = await (await own.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
    const faults = [];
    opened.on("pageerror", (error) => faults.push(error.message));
    await opened.goto(pathToFileURL(page("bowl.html")).href);
    await settled(opened);
    const stage = opened.locator(".stage");
    assert.equal(await stage.getAttribute("data-drawn"), how);
    const box = await stage.boundingBox();
    assert.ok(box.y + box.height <= 900, `${how}: the mesh ends ${box.y + box.height} pixels down`);
    const looks = () => opened.evaluate(() => [...pictures[0].space.camera.toPixels].map((value) => value.toFixed(3)).join(" "));
    const firstLook = await looks();
    const first = await seen(opened);
    await opened.mouse.move(box.x + 300, box.y + 200);
    await opened.mouse.down();
    await opened.mouse.move(box.x + 420, box.y + 260, { steps: 6 });
    await opened.mouse.up();
    await opened.waitForTimeout(400);
    const turned = await seen(opened);
    assert.notEqual(turned, first, `${how}: it turns`);
    // From where it is now, the vertex under the pointer is told.
    const [x, y] = await opened.evaluate(() => pictures[0].space.placeOf(5));
    await opened.mouse.move(box.x + x, box.y + y);
    await opened.waitForTimeout(300);
    assert.match(await opened.locator(".readout").textContent(), /^(Vertex|Triangle) \d+/, how);
    for (const [target, words] of [["worst", /^Triangle \d+ .*angles/], ["max_degree", /^Vertex \d+: degree \d+$/]]) {
      await opened.locator(`[data-jump=${target}]`).click();
      await opened.waitForTimeout(300);
      assert.match(await opened.locator(".readout").textContent(), words, how);
    }
    await opened.locator("#fit").click();
    await opened.waitForTimeout(300);
    assert.equal(await looks(), firstLook, `${how}: fit looks as at first`);
    await opened.locator("#zoom-in").click();
    await opened.waitForTimeout(400);
    assert.notEqual(await seen(opened), first, `${how}: it zooms`);
    await opened.locator("#fit").click();
    const colored = new Set();
    for (const title of await opened.locator("#metric option").allTextContents()) {
      await opened.selectOption("#metric", { label: title });
      await opened.waitForTimeout(200);
      colored.add(await seen(opened));
    }
    assert.ok(colored.size >= 6, `${how}: ${colored.size} pictures`);
    await stage.focus();
    await opened.keyboard.press("ArrowLeft");
    await opened.waitForTimeout(300);
    assert.notEqual(await seen(opened), first, `${how}: keys turn`);
    assert.deepEqual(faults, []);
    await own.close();
  }
});

test("what is behind is hidden", async () => {
  // A small triangle before a large one, both square to the first look.
  const opened = await open("bowl.html");
  const order = await opened.evaluate(() => {
    const { space } = pictures[0];
    const { camera, scene } = space;
    // Of all triangles that cover the middle of the picture, the one that is told is the nearest.
    const place = [camera.width * 0.55, camera.height * 0.55];
    const found = space.pick(...place);
    const side = (a, b, [x, y]) => (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    const covering = [];
    for (let i = 0; i < scene.triangles.length; i += 3) {
      const corners = [...scene.triangles.subarray(i, i + 3)].map((vertex) => camera.toScreen(space.at(vertex)));
      const signs = corners.map((corner, k) => Math.sign(side(corner, corners[(k + 1) % 3], place)));
      if (new Set(signs).size === 1) covering.push([i / 3, Math.max(...corners.map((corner) => corner[2]))]);
    }
    covering.sort((a, b) => b[1] - a[1]);
    return { found, nearest: covering[0]?.[0], corners: [...scene.triangles.subarray(3 * covering[0]?.[0], 3 * covering[0]?.[0] + 3)], count: covering.length };
  });
  if (order.count) assert.ok(order.found.triangle === order.nearest || order.corners.includes(order.found.vertex), JSON.stringify(order));
  await opened.context().close();
});

test("a hole is left open", async () => {
  const opened = await open("annulus.html");
  const opacity = await opened.evaluate(() => {
    const [{ mesh, frame: { dots } }] = pictures;
    const { data, width } = mesh.getContext("2d").getImageData(0, 0, mesh.width, mesh.height);
    const at = (x, y) => {
      const [left, top] = pictures[0].frame.toScreen(x, y).map((place) => Math.round(place * dots));
      return data[4 * (top * width + left) + 3];
    };
    return [at(0, 0), at(2.4, 0.02), at(0, -1.52)];
  });
  assert.deepEqual(opacity, [0, 255, 255]);
  await opened.context().close();
});

test("axe finds nothing serious in a view, and nothing is cut off", async () => {
  for (const name of ["bowl.html", "wing.html"]) {
    for (const { width, colorScheme } of SCREENS) {
      const opened = await unfold(await open(name, { viewport: { width, height: 900 }, colorScheme, bypassCSP: true }));
      const cut = await opened.$$eval("html, .scroll", (boxes) =>
        boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.innerText.slice(0, 40)));
      assert.deepEqual(cut, [], `${name} at ${width} pixels`);
      assert.deepEqual(await seriousFaults(opened), [], `${name} at ${width} pixels, ${colorScheme}`);
      await opened.context().close();
    }
  }
});

test("no page has reported an error or asked for anything", () => {
  // The links of the index lead to pages beside it; those were followed on purpose.
  const unexpected = noise.filter((line) => !/^out\/index\.html asks for file:.*\.html$/.test(line));
  assert.deepEqual(unexpected, []);
});

await run();
await browser.close();
