// What a reader does with `mindeg explore`, in headless Chromium.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createServer, request as httpRequest } from "node:http";
import { mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";
import { answered, cornerPlaces, explore } from "./explore-server.mjs";
import { run, seriousFaults, test } from "./harness.mjs";

const [binary, domains, executablePath] = process.argv.slice(2);
const work = resolve("explored");
rmSync(work, { recursive: true, force: true });
mkdirSync(work);

const bundled = (name) => join(domains, `${name}.json`);
const mindeg = (...args) => spawnSync(binary, args, { cwd: work, encoding: "utf8" });

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const server = await explore(binary, bundled("boundary-layer-channel"));
const origin = new URL(server.address).origin;
const noise = [];
const errors = [];

/** The page in a context of its own. What goes wrong on it is kept in `errors`, foreign requests in `noise`. */
async function openNew(options = {}, address = server.address) {
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, acceptDownloads: true, ...options });
  return openIn(context, address);
}

/** The same, with the mesh that keeps its points beside the one of least degree. */
async function open(options = {}) {
  const page = await openNew(options);
  await page.locator("[data-purpose=patch]").click();
  await page.selectOption("#beside", "least");
  await answered(page);
  return page;
}

async function openIn(context, address = server.address) {
  const page = await context.newPage();
  page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("request", (request) => {
    if (!request.url().startsWith(origin) && !/^(data|blob):/.test(request.url())) noise.push(request.url());
  });
  await page.goto(address);
  await page.waitForFunction(() => document.querySelector("#facts").textContent.includes("vertices"));
  await answered(page);
  return page;
}

const text = (page, selector) => page.locator(selector).textContent();
const facts = (page) => text(page, "#facts");
const pressed = (page) => page.locator("#degrees [aria-pressed=true] b").allTextContents();
const figures = (page) => page.locator(".mesh:visible").evaluateAll((all) => all.map((mesh) => mesh.querySelector("figcaption").textContent));
const angleOf = (caption) => Number(caption.match(/angle ([\d.e-]+)°/)[1]);

/** Chooses an example and waits for its answer. */
async function choose(page, name) {
  await page.selectOption("#presets", name);
  await page.waitForFunction((name) => document.querySelector("#title").textContent === name, name);
  await answered(page);
}

/** What is drawn: meshes are drawn by a worker, so only a picture of the screen shows them. */
const picture = async (page, place = 0) => (await page.locator(".stage").nth(place).screenshot()).toString("base64");

/** The first picture that is none of those before. Drawing takes its time, above all where other suites run. */
async function another(look, before) {
  const end = Date.now() + 20_000;
  for (;;) {
    const drawn = await look();
    if (!before.includes(drawn)) return drawn;
    assert.ok(Date.now() < end, "the picture stays as it was");
  }
}

/** The bytes of the file that a button downloads. */
async function downloaded(page, button) {
  const waiting = page.waitForEvent("download");
  await page.locator(button).click();
  const download = await waiting;
  const path = join(work, download.suggestedFilename());
  await download.saveAs(path);
  return { path, bytes: readFileSync(path) };
}

test("a newcomer leaves with the mesh for a solver, or with the one for a patch", async () => {
  const page = await openNew();
  assert.equal(await text(page, "#title"), "boundary-layer-channel");
  assert.match(await facts(page), /112 boundary vertices/);
  assert.match(await text(page, "#advice"), /^For a solver, put points inside: minimum angle 15\.600°/);
  assert.match(await text(page, "#on-edges"), /^If the boundary may have 14 points more, condition it: minimum angle 40\.\d+°\.$/);
  assert.deepEqual(await pressed(page), ["points inside"]);
  const [solver, patch] = await figures(page);
  assert.match(solver, /^Points inside: degree 7/);
  assert.match(patch, /^Degree 5/);
  assert.ok(angleOf(solver) > 5 * angleOf(patch), `${solver} | ${patch}`);
  const meshes = [];
  for (const [purpose, degree, name] of [["solver", 7, "points-inside"], ["patch", 5, "keep-angle-95"], ["fewest", 4, "fewest-edges"]]) {
    await page.locator(`[data-purpose=${purpose}]`).click();
    await answered(page);
    const { path } = await downloaded(page, "#download");
    assert.ok(path.endsWith(`boundary-layer-channel-${name}.obj`), path);
    assert.match(mindeg("inspect", path).stdout, new RegExp(`maximum degree ${degree}`));
    assert.match(await text(page, "#command"), new RegExp(`-o boundary-layer-channel-${name}\\.obj`));
    meshes.push(path);
  }
  assert.equal(new Set(meshes).size, 3);
  // One button brings what the sentence promises; it has no place beside a mesh of the boundary points alone.
  assert.equal(await page.locator("#put-on-edges").isVisible(), false);
  await page.locator("[data-purpose=solver]").click();
  await answered(page);
  const offer = await text(page, "#put-on-edges");
  assert.match(offer, /^Put 14 points on edges: 40\.\d+°$/);
  await page.locator("#put-on-edges").click();
  await page.waitForFunction(() => /126 boundary vertices/.test(document.getElementById("facts").textContent));
  await answered(page);
  assert.equal(angleOf((await figures(page))[0]), Number(offer.match(/([\d.]+)°/)[1]));
  assert.equal(await page.locator("#put-on-edges").isVisible(), false);
  await page.context().close();
});

test("the mesh, its figures and what it is for are in the first screen, also of a channel on a phone", async () => {
  for (const [width, height] of [[390, 844], [800, 900], [1400, 900]]) {
    const page = await openNew({ viewport: { width, height } });
    for (const name of ["boundary-layer-channel", "plate-with-holes", "slender-fin"]) {
      if (name !== "boundary-layer-channel") await choose(page, name);
      for (const selector of ["#purposes", ".lead", "#name-main", ".stage"]) {
        const box = await page.locator(selector).first().boundingBox();
        assert.ok(box.y + box.height <= height, `${name} at ${width}: ${selector} ends ${box.y + box.height} pixels down`);
      }
      const stage = await page.locator(".stage").first().boundingBox();
      assert.ok(stage.height >= 60, `${name} at ${width}: ${stage.height} pixels high`);
    }
    await page.context().close();
  }
});

test("from any example a newcomer leaves within a minute with the mesh of the advice", async () => {
  const page = await openNew();
  const names = await page.locator("#presets option").evaluateAll((all) => all.map(({ value }) => value).filter(Boolean));
  assert.ok(names.length >= 8, names.join(" "));
  for (const name of names) {
    const start = Date.now();
    await choose(page, name);
    const { path } = await downloaded(page, "#download");
    const seconds = (Date.now() - start) / 1000;
    assert.ok(seconds < 60, `${name}: ${seconds} s`);
    const told = JSON.parse(spawnSync(binary, ["tradeoff", bundled(name), "--json"], { encoding: "utf8" }).stdout).advice;
    const first = told[told.first];
    // The one with many points has no figures beside another answer.
    if (!first) continue;
    const inspected = JSON.parse(spawnSync(binary, ["inspect", path, "--json"], { encoding: "utf8" }).stdout);
    assert.ok(JSON.stringify(inspected).includes(String(first.max_degree)), name);
    const shown = (await figures(page))[0];
    assert.ok(Math.abs(angleOf(shown) - first.min_angle) < 1e-3 * first.min_angle + 1e-3, `${name}: ${shown}, ${first.min_angle}`);
    await page.screenshot({ path: join(work, `newcomer-${name}.png`) });
  }
  await page.context().close();
});

/**
 * Notes what the page claims at each frame: captions with figures of the first picture, as the number of boundary points and
 * of points inside of the mesh that is drawn under it, and the cards of the advice.
 */
const watch = (page) => page.evaluate(async () => {
  const { selection, shown } = await import("/page/state.js");
  window.claims = [];
  const look = () => {
    const [figures, words, name] = [".figures", ".words-of", "h3"].map((part) => document.querySelector(`.mesh ${part}`).textContent);
    window.claims.push({
      title: document.querySelector("#title").textContent, name, figures, words, facts: document.querySelector("#facts").textContent,
      cards: [...document.querySelectorAll("#purposes .figures")].map((it) => it.textContent), advice: document.querySelector("#advice").textContent,
      domain: shown.domain?.name ?? "", drawn: shown.meshes.interior?.words ?? "", isHeld: selection.drag !== null,
    });
    if (window.claims.length < 3000) requestAnimationFrame(look);
  };
  look();
});

test("no figures stand under points inside but those of a mesh with points inside, also while a corner is dragged", async () => {
  const page = await openNew();
  await watch(page);
  // Opened: a square of 160 points, whose mesh with points inside has many more.
  const domain = { name: "many", rectangle: { width: 4, height: 4 }, sides: Array.from({ length: 4 }, () => ({ intervals: 40 })) };
  await page.locator("#file").setInputFiles({ name: "many.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(domain)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "many");
  await answered(page);
  const [, , corner] = await cornerPlaces(page);
  await page.mouse.move(...corner);
  await page.mouse.down();
  for (let step = 1; step <= 8; step++) {
    await page.mouse.move(corner[0] - 6 * step, corner[1] + 6 * step);
    await page.waitForTimeout(60);
  }
  await page.mouse.up();
  await answered(page);
  const claims = (await page.evaluate(() => window.claims)).filter(({ title }) => title === "many");
  const told = claims.filter(({ name, figures }) => name.startsWith("Points inside") && /\d°/.test(figures));
  assert.ok(told.length > 5, `${told.length} claims`);
  for (const { words, figures, drawn } of told) {
    // Without points inside there are 160 vertices.
    const isInside = /^160 boundary and \d+ interior vertices/.test(drawn) || Number(drawn.match(/^(\d+) vertices/)?.[1]) > 160;
    assert.ok(isInside && !words.includes("No mesh of these points"), `${figures} ${words}`);
  }
  // Drafts and meshes come in turn under one caption.
  const held = claims.filter(({ isHeld, figures }) => isHeld && /°.*…/.test(figures));
  assert.ok(held.length > 3, `${held.length} claims`);
  assert.deepEqual([...new Set(held.map(({ name, words }) => `${name}|${words}`))], ["Points inside|While you drag, drafts are shown."]);
  assert.match(claims.at(-1).words, /boundary and \d+ interior vertices/);
  await page.context().close();
});

test("of another domain no figures are shown until its own are there", async () => {
  const page = await openNew();
  const old = await page.locator("#purposes .figures").allTextContents();
  const advice = await text(page, "#advice");
  assert.ok(old.every((it) => /°/.test(it)), old.join(" "));
  await watch(page);
  await page.selectOption("#presets", "plate-with-holes");
  await page.waitForFunction(() => document.querySelector("#title").textContent === "plate-with-holes");
  await answered(page);
  const claims = (await page.evaluate(() => window.claims)).filter(({ title }) => title === "plate-with-holes");
  assert.ok(claims.some(({ cards }) => cards.every((it) => it === "")), "no card waits");
  for (const claim of claims) {
    assert.notEqual(claim.advice, advice);
    for (const [place, card] of claim.cards.entries()) assert.notEqual(card, old[place]);
  }
  assert.ok(claims.at(-1).cards.every((it) => /°/.test(it)));
  await page.context().close();
});

test("where no points can be put inside, the reason is told in a sentence", async () => {
  const page = await openNew();
  // The angle is proven to be too large.
  const domain = { name: "steep", polygon: { corners: [[0, 0], [4, 0], [4, 1]] }, size: 0.5, interior: { target_angle: 40 } };
  await page.locator("#file").setInputFiles({ name: "steep.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(domain)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "steep");
  await answered(page);
  assert.equal(await text(page, "[data-purpose=solver] .figures"), "no mesh");
  assert.match(await text(page, "#advice"), /Points inside cannot be put here: .*40/);
  await page.context().close();
});

test("refusals speak of the page's things, and no words of options that it lacks", async () => {
  const page = await openNew();
  const said = await page.evaluate(async () => {
    const { domainTrouble } = await import("/page/show.js");
    const at = (message, path) => domainTrouble({ message, path });
    return [at("holes[3].sides[0]: 0 intervals", "holes[3].sides[0]"), at("a side is too short", "sides[2].spacing"),
      at("interior.sizes[0].from: no side is so called", null), at("it is 3.5 m [2]", null)];
  });
  assert.deepEqual(said, ["side 1 of hole 4: 0 intervals", "a side is too short (at spacing of side 3)", "from of size 1: no side is so called", "it is 3.5 m [2]"]);
  const domain = { name: "coarse", polygon: { corners: [[0, 0], [1, 0], [0, 1]] }, sides: [{ intervals: 1 }, { intervals: 1 }, { intervals: 1 }] };
  await page.locator("#file").setInputFiles({ name: "coarse.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(domain)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "coarse");
  await page.locator("[data-purpose=solver]").click();
  await answered(page);
  const words = (await page.locator(".words-of").allTextContents()).join(" ");
  assert.match(words, /No point fits inside/);
  assert.ok(!words.includes("--"), words);
  await page.context().close();
});

test("a file that is started with or dropped is repaired, named after its stem, or shown as a surface", async () => {
  const page = await openNew();
  const overlap = "POLYGON((0 0, 5.02 0, 5.02 5, 0 5)) POLYGON((5 0, 10 0, 10 5, 5 5))";
  await dropFile(page, "fields.wkt", Buffer.from(overlap));
  await page.waitForFunction(() => document.querySelector("#title").textContent === "fields");
  await answered(page);
  assert.match(await facts(page), / 2 regions /);
  assert.match(await text(page, "#notes"), /they were repaired/);
  const { path } = await downloaded(page, "#download");
  assert.match(path, /fields-points-inside\.obj$/);
  assert.ok(await page.locator("#choose").isVisible());
  await openTube(page);
  assert.ok(await page.locator("#choose").isHidden());
  await page.context().close();
  const model = await explore(binary, join(domains, "../models/bracket.json"));
  try {
    const started = await browser.newPage();
    await started.goto(model.address);
    await started.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 2);
    assert.equal(await text(started, "#title"), "bracket.json");
    assert.match(await text(started, "#solid-words"), /degree/);
    // The mesh with points inside is there unasked, beside that of boundary points alone; either is downloaded.
    assert.deepEqual(await started.locator("#solid-meshes h3").allTextContents(), ["Boundary points alone", "Points inside"]);
    assert.match(await text(started, "#solid-command"), /^mindeg mesh \S*bracket\.json --interior -o bracket-points-inside\.obj$/);
    await started.screenshot({ path: join(work, "model.png") });
    const inside = await downloaded(started, "#solid-download");
    assert.match(inside.path, /bracket-points-inside\.obj$/);
    await started.locator("#solid-nothing").click();
    await started.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 1);
    const alone = await downloaded(started, "#solid-download");
    const [more, few] = [inside, alone].map(({ path }) => JSON.parse(mindeg("inspect", path, "--json").stdout));
    assert.ok(more.vertices > few.vertices && more.min_angle > few.min_angle, `${more.min_angle}° ${few.min_angle}°`);
    // Formats of the plane are for maps; what is refused is told where the surface is.
    const offered = await started.locator("#solid-format option:not([disabled])").evaluateAll((all) => all.map(({ value }) => value));
    assert.ok(offered.includes("obj") && !["geojson", "fort14", "ugrid", "su2"].some((name) => offered.includes(name)), offered.join(" "));
    await started.locator("#solid-remesh").click();
    await started.waitForSelector("#solid-download:visible");
    await started.locator("#solid-format").evaluate((select) => {
      const planar = [...select.options].find(({ value }) => value === "su2");
      planar.disabled = false;
      select.value = "su2";
    });
    await started.locator("#solid-download").click();
    await started.waitForSelector("#trouble:visible");
    assert.match(await text(started, "#trouble-text"), /in the plane, and the z of this one goes from 0 to 50;/);
    await started.close();
  } finally {
    await model.stop();
  }
});

test("parts that share no edge are one map, whose mesh is shown and downloaded beside the parts", async () => {
  const page = await openNew();
  await dropFile(page, "islands.wkt", Buffer.from("POLYGON((0 0, 4 0, 4 3, 0 3)) POLYGON((9 0, 12 0, 12 3, 9 3))"));
  await page.waitForFunction(() => document.querySelectorAll("#choose button").length === 3);
  await answered(page);
  const pressed = () => page.locator("#choose [aria-pressed=true]").allTextContents();
  const names = await page.locator("#choose button").allTextContents();
  assert.equal(names[0], "the whole map");
  assert.deepEqual(await pressed(), [names[1]]);
  await page.locator("#choose button").first().click();
  await page.waitForSelector("#solid-download:visible");
  assert.deepEqual(await pressed(), [names[0]]);
  assert.match(await text(page, "#solid-command"), /^mindeg mesh islands\.wkt .* -o islands-/);
  await page.locator("#whole-purposes button").nth(2).click();
  await page.waitForFunction(() => document.querySelector("#solid-command").textContent.includes("--optimize angle"));
  await page.waitForSelector("#solid-download:visible");
  assert.match(await text(page, "#solid-meshes .figures"), / 4 triangles/);
  const { path, bytes } = await downloaded(page, "#solid-download");
  assert.match(path, /islands-fewest-edges\.obj$/);
  assert.equal(bytes.toString().match(/^f /gm).length, 4);
  await page.locator("#choose button").nth(2).click();
  await answered(page);
  assert.deepEqual(await pressed(), [names[2]]);
  assert.ok(await page.locator("#solid").isHidden());
  await page.context().close();
});

test("all sides of a file are divided as --size divides its curves, until a corner is moved", async () => {
  const page = await openNew();
  const icon = join(domains, "../outlines/icon.svg");
  await dropFile(page, "icon.svg", readFileSync(icon));
  await page.waitForFunction(() => document.querySelector("#title").textContent === "icon");
  await answered(page);
  await page.fill("#edge-size", "4");
  await page.click("#divide");
  await page.waitForFunction(() => document.querySelector("#condition-words").textContent.startsWith("All sides get edges"));
  await answered(page);
  const made = spawnSync(binary, ["mesh", icon, "--size", "4", "--interior", "--json", "-o", join(work, "icon.obj")], { encoding: "utf8" });
  const { min_angle: angle, max_degree: degree } = JSON.parse(made.stdout);
  assert.equal((await page.locator("#purposes .figures").first().textContent()), `${angle.toFixed(3)}°, degree ${degree}`);
  await page.context().close();
});

test("a wrong option is told by the name of its field, and the choice of the mesh stays", async () => {
  const page = await openNew();
  await choose(page, "plate-with-holes");
  const set = async (id, value) => {
    await page.fill(id, value);
    await page.keyboard.press("Tab");
    await answered(page);
  };
  for (const [id, value, message] of [
    ["#max-points", "0.5", "Max points: give a whole number, not 0.5"],
    ["#growth", "-1", "Growth: growth is -1"],
  ]) {
    await set(id, value);
    assert.ok((await text(page, "#trouble-text")).startsWith(message), await text(page, "#trouble-text"));
    await set(id, "");
  }
  await set("#max-points", "10");
  assert.equal(await page.locator("#purposes [aria-pressed=true] b").textContent(), "A solver");
  assert.match(await text(page, ".mesh.taken .words-of"), /more than 10 points/);
  await page.context().close();
});

test("a wrong number is told beside its field until it is right", async () => {
  const page = await openNew();
  await choose(page, "plate-with-holes");
  const field = (name) => (name.startsWith("#") ? page.locator(name) : page.getByLabel(name, { exact: true }));
  /** What a field is said to have wrong, as readers of the screen hear it. */
  const wrong = async (name) => {
    const ids = (await field(name).getAttribute("aria-describedby") ?? "").split(" ");
    const notes = await Promise.all(ids.filter((id) => id.startsWith("wrong-")).map((id) => page.locator(`#${id}`).textContent()));
    assert.equal(await field(name).getAttribute("aria-invalid"), notes.length ? "true" : null, name);
    return notes.join(" ");
  };
  const set = async (name, value) => {
    if (Number.isNaN(Number(value)) && await field(name).getAttribute("type") === "number") {
      // What is no number cannot be filled in, only typed.
      await field(name).fill("");
      await field(name).pressSequentially("-");
    } else await field(name).fill(value);
    await page.keyboard.press("Enter");
    await answered(page);
  };
  const first = await page.locator("#sides tbody th button").first().textContent();
  await page.getByLabel(`Spacing of ${first}`, { exact: true }).selectOption("geometric");
  await answered(page);
  await page.locator("#add-size").click();
  await page.locator(".stage").first().click({ position: { x: 60, y: 60 } });
  await page.waitForFunction(() => document.querySelector("#inside table"));
  await answered(page);
  await page.locator("#next").click();
  const before = await facts(page);
  for (const [name, values, message, right] of [
    [`Intervals of ${first}`, ["0", "2.5", "", "-3", "many"], /whole number, 1 or more/, null],
    [`ratio of the spacing of ${first}`, ["0", "-1", "", "many"], /number above 0/, null],
    ["#x", ["", "many"], /a number/, null],
    ["#goal-keep_angle", ["0", "101", "-5", "", "many"], /percentage above 0, up to 100/, "95"],
    ["Length of edges at size 1", ["0", "-1", ""], /length above 0/, null],
    ["#interior-degree", ["few", "5.5", "5 to"], /two numbers/, "5 to 8"],
  ]) {
    const usual = right ?? await field(name).inputValue();
    for (const value of values) {
      await set(name, value);
      assert.match(await wrong(name), message, `${name} = ${value}`);
      assert.equal(await facts(page), before, `${name} = ${value}`);
    }
    await set(name, usual);
    assert.equal(await wrong(name), "", name);
  }
  for (const [name, value, button, message, right] of [
    ["#edge-size", "0", "#divide", /length above 0/, "1"],
    ["#condition-within", "-1", "#condition", /0 or more/, ""],
    ["#condition-angle", "", "#condition", /angle above 0/, "20"],
  ]) {
    await field(name).fill(value);
    await page.click(button);
    assert.match(await wrong(name), message);
    await field(name).fill(right);
    await page.click(button);
    await page.waitForFunction(() => !/Working/.test(document.querySelector("#condition-words").textContent));
    assert.equal(await wrong(name), "", name);
  }
  await field("#condition-angle").fill("");
  await page.click("#condition");
  assert.deepEqual(await seriousFaults(page), []);
  await page.context().close();
});

test("what is inside is listed on a phone with whole names and its buttons in one line", async () => {
  const file = join(work, "inside.json");
  writeFileSync(file, JSON.stringify({
    name: "inside", rectangle: { width: 4, height: 3 }, size: 0.25,
    lines: [{ corners: [[2, 0], [2, 2]], name: "the interface", size: 0.5 }, { corners: [[0.3, 0.3], [1, 0.3], [1, 1]], name: "a fault" }],
    points: [{ at: [1.3, 1.7], name: "gauge" }], interior: { sizes: [[0.7, 1.512345, 0.1]] },
  }));
  const server = await explore(binary, file);
  const page = await browser.newPage({ viewport: { width: 390, height: 844 } });
  try {
    await page.goto(server.address);
    await page.waitForFunction(() => document.querySelectorAll("#inside tr").length === 4);
    const rows = await page.locator("#inside tr").evaluateAll((all) => all.map((row) => {
      const box = (it) => it.getBoundingClientRect();
      const [show, remove] = [...row.querySelectorAll("button")].map(box);
      const name = row.querySelector("input[type=text]");
      const head = row.querySelector("th");
      return {
        isOneLine: Math.abs(show.top - remove.top) < 1,
        isWhole: !name || name.scrollWidth <= name.clientWidth,
        isBelow: box(head).bottom <= show.top + 1,
        right: remove.right,
      };
    }));
    for (const { isOneLine, isWhole, isBelow, right } of rows) assert.deepEqual([isOneLine, isWhole, isBelow, right <= 390], [true, true, true, true], JSON.stringify(rows));
  } finally {
    await page.close();
    await server.stop();
  }
});

test("the curve is in the first screen beside the picture", async () => {
  const page = await openNew();
  for (const name of ["boundary-layer-channel", "wing-panel"]) {
    if (name !== "boundary-layer-channel") await choose(page, name);
    const box = await page.locator("#curve svg").boundingBox();
    assert.ok(box.y + box.height <= 900, `${name}: it ends ${box.y + box.height} pixels down`);
  }
  await page.context().close();
});

test("of no example are corners, words or figures cut, and the download is beside or below its picture", async () => {
  for (const [width, height] of [[390, 844], [800, 900], [1400, 900]]) {
    const page = await openNew({ viewport: { width, height } });
    const names = await page.locator("#presets option").evaluateAll((all) => all.map(({ value }) => value).filter(Boolean));
    for (const name of names) {
      if (name !== "boundary-layer-channel") await choose(page, name);
      const here = `${name} at ${width}`;
      const stage = await page.locator(".stage").first().boundingBox();
      const card = await page.locator(".mesh").first().boundingBox();
      assert.ok(stage.x >= card.x && stage.x + stage.width <= card.x + card.width, `${here}: the picture is wider than its card`);
      for (const [x, y] of await cornerPlaces(page)) {
        const edge = Math.min(x - stage.x, stage.x + stage.width - x, y - stage.y, stage.y + stage.height - y);
        assert.ok(edge >= 7, `${here}: a corner is ${edge} pixels from the edge`);
      }
      const cut = await page.evaluate(() => {
        const context = document.createElement("canvas").getContext("2d");
        const isBroken = (name) => {
          context.font = getComputedStyle(name).font;
          return name.textContent.split(/[ -]/).some((word) => context.measureText(word).width > name.clientWidth);
        };
        const rows = [...document.querySelectorAll("#degrees b, #interior label, #interior small, .mesh .figures")].filter((it) => it.scrollWidth > it.clientWidth);
        return [...rows, ...[...document.querySelectorAll(".side-name")].filter(isBroken)].map((it) => it.textContent);
      });
      assert.deepEqual(cut, [], here);
      const [button, below] = await Promise.all(["#download-main", "#download"].map((selector) => page.locator(selector).boundingBox()));
      assert.equal(button === null, width === 1400, here);
      const top = (button ?? below).y;
      assert.ok(top < height || top < stage.y + stage.height + 120, `${here}: ${top} pixels down`);
    }
    if (width === 390) {
      const [one, other] = [await downloaded(page, "#download-main"), await downloaded(page, "#download")];
      assert.deepEqual(one.bytes, other.bytes);
    }
    await page.context().close();
  }
});

test("points inside have options, and places that decide are marked", async () => {
  const page = await openNew();
  await choose(page, "l-bracket");
  assert.match(await page.locator(".stage").first().getAttribute("data-names"), /limit \d+\.\d+°/);
  const [before] = await figures(page);
  await page.locator("#size-inside").fill("0.4");
  await page.keyboard.press("Enter");
  await answered(page);
  assert.notEqual((await page.locator(".words-of").first().textContent()), before);
  assert.match(await text(page, "#command"), /"size_inside":0\.4/);
  const { path } = await downloaded(page, "#download");
  assert.match(mindeg("inspect", path).stdout, /nothing wrong found/);
  await page.context().close();
});

test("a label at the edge of the picture is within it", async () => {
  const page = await openNew();
  const places = await page.evaluate(async () => {
    const { drawNames } = await import("/page/names.js");
    const places = [];
    const known = { measureText: () => ({ width: 40 }), fillText: (_, x, y) => places.push([x, y]) };
    const context = new Proxy(known, { get: (all, key) => all[key] ?? (() => {}), set: () => true });
    const frame = { width: 200, height: 100, toScreen: (x, y) => [x, y] };
    for (const at of [[100, 2], [3, 50], [198, 97]]) drawNames(context, frame, {}, [{ kind: "mark", name: "limit 45°", at }]);
    return places;
  });
  assert.equal(places.length, 3);
  for (const [x, y] of places) assert.ok(x >= 20 && x <= 180 && y >= 7 && y <= 93, `${x}, ${y}`);
  await page.context().close();
});

test("sides get names and kinds, and a map's regions names and sizes", async () => {
  const page = await openNew();
  await choose(page, "figure-1");
  await page.getByLabel("Name of bottom", { exact: true }).fill("inflow");
  await page.keyboard.press("Enter");
  await answered(page);
  await page.getByLabel("Kind of inflow", { exact: true }).selectOption("open");
  await answered(page);
  const { bytes } = await downloaded(page, "#save");
  const [side] = JSON.parse(bytes).sides;
  assert.deepEqual([side.name, side.kind], ["inflow", "open"]);
  const map = { name: "two", rectangle: { width: 4, height: 2 }, size: 0.5,
    lines: [{ corners: [[2, 0], [2, 2]] }], regions: [{ at: [1, 1], name: "left" }, { at: [3, 1], name: "right" }] };
  await page.locator("#file").setInputFiles({ name: "two.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(map)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "two");
  await answered(page);
  await page.getByLabel("name of region 2", { exact: true }).fill("steel");
  await page.keyboard.press("Enter");
  await answered(page);
  assert.match(await page.locator(".stage").first().getAttribute("data-names"), /steel/);
  await page.getByLabel("Remove region 2", { exact: true }).click();
  await answered(page);
  assert.equal(await page.getByLabel("Remove region 2", { exact: true }).count(), 0);
  await page.context().close();
});

test("a hole of a surface is filled with points inside, and the file has them", async () => {
  const page = await openNew();
  // A pyramid over a square of 24 points, without its floor.
  const rim = [0, 1, 2, 3].flatMap((side) => [0, 1, 2, 3, 4, 5].map((at) => [[at, 0], [6, at], [6 - at, 6], [0, 6 - at]][side]));
  const pyramid = ["v 3 3 3", ...rim.map(([x, y]) => `v ${x} ${y} 0`), ...rim.map((_, at) => `f 1 ${at + 2} ${((at + 1) % 24) + 2}`), ""].join("\n");
  await page.locator("#file").setInputFiles({ name: "pyramid.obj", mimeType: "text/plain", buffer: Buffer.from(pyramid) });
  await page.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 1);
  await page.getByLabel("with points inside").check();
  await page.locator("#solid-fill").click();
  await page.waitForFunction(() => document.querySelectorAll("#solid-meshes h3")[1]?.textContent === "Filled");
  const triangles = Number((await page.locator("#solid-meshes .figures").nth(1).textContent()).match(/(\d+) triangles/)[1]);
  assert.ok(triangles > 70, `${triangles} triangles`);
  // What is chosen afterwards does not change what is downloaded.
  await page.getByLabel("with points inside").uncheck();
  // Another measure is another picture, and the first one is the same again.
  const filled = page.locator("#solid-meshes .stage").nth(1);
  const pictures = [];
  for (const measure of ["min_angle", "max_angle", "", "min_angle"]) {
    await page.selectOption("#solid-metric", measure);
    pictures.push((await filled.screenshot()).toString("base64"));
  }
  assert.equal(new Set(pictures).size, 3);
  assert.equal(pictures[3], pictures[0]);
  const { path } = await downloaded(page, "#solid-download");
  assert.equal(JSON.parse(mindeg("inspect", path, "--json").stdout).faces, triangles);
  await page.screenshot({ path: join(work, "solid-inside.png") });
  await page.context().close();
});

test("two ends far apart are bridged with points between them", async () => {
  const page = await openNew();
  const turn = (at) => (2 * Math.PI * at) / 16;
  const rings = [0, 0.4, 4, 4.4].flatMap((z) => Array.from({ length: 16 }, (_, at) => `v ${Math.cos(turn(at))} ${Math.sin(turn(at))} ${z}`));
  const faces = [1, 33].flatMap((first) => Array.from({ length: 16 }, (_, at) => [first + at, first + ((at + 1) % 16)])
    .flatMap(([a, b]) => [`f ${a} ${b} ${b + 16}`, `f ${a} ${b + 16} ${a + 16}`]));
  const ends = [...rings, ...faces, ""].join("\n");
  await page.locator("#file").setInputFiles({ name: "ends.obj", mimeType: "text/plain", buffer: Buffer.from(ends) });
  await page.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 1);
  for (const loop of [1, 2]) await page.locator("#solid-loops input").nth(loop).check();
  await page.getByLabel("with points inside").check();
  await page.locator("#solid-bridge").click();
  await page.waitForFunction(() => document.querySelectorAll("#solid-meshes h3")[1]?.textContent === "Bridged");
  assert.match(await page.locator("#solid-words").textContent(), /points inside/);
  await page.context().close();
});

/** Opens a cube without its lid and floor. */
async function openTube(page) {
  const tube = ["v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "v 0 0 1", "v 1 0 1", "v 1 1 1", "v 0 1 1",
    "f 1 2 6", "f 1 6 5", "f 2 3 7", "f 2 7 6", "f 3 4 8", "f 3 8 7", "f 4 1 5", "f 4 5 8", ""].join("\n");
  await page.locator("#file").setInputFiles({ name: "tube.obj", mimeType: "text/plain", buffer: Buffer.from(tube) });
  await page.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 1);
}

test("a surface is turned, meshed anew and filled, and the file is downloaded", async () => {
  const page = await openNew();
  await openTube(page);
  assert.equal(await page.locator("#solid-loops input").count(), 2);
  const stage = page.locator("#solid-meshes .stage").first();
  const look = async () => (await stage.screenshot()).toString("base64");
  await page.waitForTimeout(300);
  const first = await look();
  const box = await stage.boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 180, box.y + 120, { steps: 4 });
  await page.mouse.up();
  await another(look, [first]);
  // Ticked loops and new triangles are marked: four edges of a loop, and the rims of two lids.
  const marked = (place) => page.locator("#solid-meshes .stage").nth(place).getAttribute("data-marked");
  const unmarked = await look();
  await page.locator("#solid-loops input").first().check();
  assert.equal(await marked(0), "4");
  await another(look, [unmarked]);
  await page.locator("#solid-loops input").first().uncheck();
  assert.equal(await marked(0), "0");
  for (const [button, title, wanted] of [["#solid-fill", "Filled", /12 triangles/], ["#solid-remesh", "Meshed anew", /minimum angle [2-6]\d/]]) {
    await page.locator(button).click();
    await page.waitForFunction((title) => document.querySelectorAll("#solid-meshes h3")[1]?.textContent === title, title);
    assert.match(await page.locator("#solid-meshes .figures").nth(1).textContent(), wanted);
    assert.equal(await marked(1), title === "Filled" ? "8" : "0");
    const { path } = await downloaded(page, "#solid-download");
    assert.match(mindeg("inspect", path).stdout, /maximum degree/);
  }
  await page.screenshot({ path: join(work, "solid.png") });
  await choose(page, "figure-1");
  assert.ok(await page.locator(".stage").first().isVisible());
  await page.context().close();
});

test("a surface is in the first screen of a phone", async () => {
  const page = await openNew({ viewport: { width: 390, height: 844 } });
  await openTube(page);
  const box = await page.locator("#solid-meshes .stage").first().boundingBox();
  assert.ok(box.y + box.height <= 844, `it ends ${box.y + box.height} pixels down`);
  await page.context().close();
});

test("a corner is dragged, and the meshes follow; undo brings them back", async () => {
  const page = await open();
  const before = await figures(page);
  const [, , corner] = await cornerPlaces(page);
  await page.mouse.move(...corner);
  await page.mouse.down();
  // The mesh follows while the pointer is down.
  const pictures = [await picture(page)];
  for (let step = 1; step <= 6; step++) {
    await page.mouse.move(corner[0] - 20 * step, corner[1] + 5 * step);
    pictures.push(await another(() => picture(page), pictures));
  }
  await page.mouse.up();
  await answered(page);
  assert.match(await text(page, "#corner"), /^Corner 3 of 4$/);
  const x = Number(await page.locator("#x").inputValue());
  assert.ok(x < 0.4 && x > 0.2, `x is ${x}`);
  const after = await figures(page);
  assert.notDeepEqual(after, before);
  // The server has the same of the changed domain as the command line.
  const { path } = await downloaded(page, "#save");
  const { stderr } = mindeg("mesh", path, "--keep-angle", "95%", "-o", "dragged.obj");
  assert.ok(stderr.includes(`angles ${angleOf(after[0]).toFixed(3)}°`), `${stderr} ${after[0]}`);
  await page.keyboard.press("Control+z");
  await answered(page);
  assert.deepEqual(await figures(page), before);
  await page.locator("#redo").click();
  await answered(page);
  assert.deepEqual(await figures(page), after);
  await page.context().close();
});

test("corners snap to a grid, or not", async () => {
  const page = await open();
  await choose(page, "figure-1");
  const grid = Number(await text(page, "#grid"));
  const dragTo = async (dx, dy) => {
    await page.locator(".stage").first().scrollIntoViewIfNeeded();
    const [[left, top]] = await cornerPlaces(page);
    await page.mouse.move(left, top);
    await page.mouse.down();
    await page.mouse.move(left + dx, top + dy, { steps: 3 });
    await page.mouse.up();
    await answered(page);
    return [Number(await page.locator("#x").inputValue()), Number(await page.locator("#y").inputValue())];
  };
  const isOnGrid = (value) => Math.abs(value / grid - Math.round(value / grid)) < 1e-6;
  assert.ok((await dragTo(37, -23)).every(isOnGrid));
  await page.locator("#snap").uncheck();
  assert.ok(!(await dragTo(11.3, -7.7)).every(isOnGrid));
  await page.context().close();
});

test("everything can be edited from the keyboard", async () => {
  const page = await open();
  await choose(page, "unequal-hexagon");
  // With the focus, the picture asks what is in its middle. Here the key comes before the answer.
  await page.evaluate(() => {
    const stage = document.querySelector(".stage");
    stage.focus();
    stage.dispatchEvent(new KeyboardEvent("keydown", { key: "n", bubbles: true }));
  });
  await page.waitForFunction(() => document.querySelector("#spoken").textContent.startsWith("Corner 1 of 6, at 0, 0"));
  await page.waitForTimeout(300);
  assert.match(await text(page, "#spoken"), /^Corner 1 of 6, at 0, 0$/);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowDown");
  await answered(page);
  const grid = Number(await text(page, "#grid"));
  assert.equal(Number(await page.locator("#x").inputValue()), -grid);
  assert.equal(Number(await page.locator("#y").inputValue()), -10 * grid);
  await page.keyboard.press("Insert");
  await answered(page);
  assert.match(await text(page, "#corner"), /of 7$/);
  await page.keyboard.press("Delete");
  await answered(page);
  assert.match(await text(page, "#corner"), /^6 corners$/);
  assert.match(await facts(page), /38 boundary vertices/);
  for (let step = 0; step < 4; step++) await page.keyboard.press("Control+z");
  await answered(page);
  assert.match(await facts(page), /38 boundary vertices/);
  // Without a chosen corner, the arrows and + move the picture.
  await page.keyboard.press("Escape");
  const first = await picture(page);
  await page.keyboard.press("+");
  await another(() => picture(page), [first]);
  // All controls are reached by the Tab key, and none keeps it.
  await page.locator("#presets").focus();
  const reached = new Set();
  for (let step = 0; step < 200; step++) {
    await page.keyboard.press("Tab");
    const id = await page.evaluate(() => document.activeElement === document.body ? null : document.activeElement.id || document.activeElement.className);
    if (id === null) break;
    reached.add(id);
  }
  for (const id of ["open", "format", "download", "copy", "beside", "metric", "fit", "stage", "next", "add", "snap", "add-hole", "add-size"]) {
    assert.ok(reached.has(id), `${id} is not reached: ${[...reached].join(" ")}`);
  }
  await page.context().close();
});

test("a count and a spacing law are changed", async () => {
  const page = await open();
  const before = await figures(page);
  await page.getByLabel("One interval more on wall").click();
  await answered(page);
  assert.match(await facts(page), /113 boundary vertices/);
  assert.equal(await page.getByLabel("Intervals of wall", { exact: true }).inputValue(), "41");
  await page.getByLabel("Intervals of wall", { exact: true }).fill("40");
  await page.keyboard.press("Enter");
  await answered(page);
  assert.deepEqual(await figures(page), before);
  await page.getByLabel("Spacing of outlet", { exact: true }).selectOption("uniform");
  await page.getByLabel("Spacing of inlet", { exact: true }).selectOption("uniform");
  await answered(page);
  assert.notDeepEqual(await figures(page), before);
  await page.getByLabel("Spacing of outlet", { exact: true }).selectOption("geometric");
  await page.getByLabel("ratio of the spacing of outlet", { exact: true }).fill("1.25");
  await page.keyboard.press("Enter");
  await page.getByLabel("Spacing of inlet", { exact: true }).selectOption("geometric");
  await page.getByLabel("ratio of the spacing of inlet", { exact: true }).fill("0.8");
  await page.keyboard.press("Enter");
  await answered(page);
  assert.deepEqual(await figures(page), before);
  await page.context().close();
});

test("a straight side becomes an arc and straight again, with undo", async () => {
  const page = await openNew();
  const side = async (place) => JSON.parse((await downloaded(page, "#save")).bytes).sides?.[place] ?? {};
  for (const [preset, name, place] of [["figure-1", "bottom", 0], ["figure-1", "left", 3]]) {
    await choose(page, preset);
    const straight = await figures(page);
    const shape = page.getByLabel(`Shape of ${name}`, { exact: true });
    const rise = page.getByLabel(`Rise of the arc of ${name}, outwards`, { exact: true });
    assert.equal(await shape.inputValue(), "straight");
    assert.equal(await rise.isVisible(), false);
    await shape.selectOption("arc");
    await answered(page);
    const first = Number(await rise.inputValue());
    assert.ok(first > 0, `${first}`);
    await rise.fill("-0.3");
    await page.keyboard.press("Enter");
    await answered(page);
    // Into the domain: up from the bottom, right from the left side.
    const through = (await side(place)).arc.through;
    assert.deepEqual([through.length, through[name === "bottom" ? 1 : 0]], [2, 0.3]);
    assert.equal(await text(page, "#trouble-text"), "");
    // The mesh follows, and goes back.
    assert.notDeepEqual(await figures(page), straight);
    await page.keyboard.press("Control+z");
    await answered(page);
    assert.equal(Number(await rise.inputValue()), first);
    await shape.selectOption("straight");
    await answered(page);
    assert.equal((await side(place)).arc, undefined);
    for (let step = 0; step < 2; step++) await page.keyboard.press("Control+z");
    await answered(page);
    assert.equal(await shape.inputValue(), "straight");
    assert.deepEqual(await figures(page), straight);
  }
  // An arc about a center, and one of more than half a circle, are told by their rise.
  for (const [center, rise] of [[0, 1], [0.75, 2], [-0.75, 0.5]]) {
    const name = `disk ${center}`;
    const disk = { name, polygon: { corners: [[1, 0], [-1, 0]] },
      sides: [{ intervals: 7, name: "dome", arc: { center: [0, center] } }, { intervals: 4, name: "floor" }] };
    await page.locator("#file").setInputFiles({ name: "disk.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(disk)) });
    await page.waitForFunction((name) => document.querySelector("#title").textContent === name, name);
    await answered(page);
    assert.equal(await page.getByLabel("Rise of the arc of dome, outwards", { exact: true }).inputValue(), String(rise));
  }
  await page.context().close();
});

test("changes that come faster than the answers are all made", async () => {
  const page = await open();
  const before = await facts(page);
  // In one task of the page: no answer can come between.
  await page.evaluate(() => {
    const control = (label) => document.querySelector(`#sides [aria-label="${label}"]`);
    const set = (label, value) => {
      control(label).value = value;
      control(label).dispatchEvent(new Event("change"));
    };
    for (let step = 0; step < 3; step++) control("One interval more on wall").click();
    set("ratio of the spacing of outlet", 1.5);
    set("ratio of the spacing of inlet", 0.5);
  });
  await answered(page);
  assert.equal(await page.getByLabel("Intervals of wall", { exact: true }).inputValue(), "43");
  assert.match(await facts(page), /115 boundary vertices/);
  assert.equal(await page.getByLabel("ratio of the spacing of outlet", { exact: true }).inputValue(), "1.5");
  assert.equal(await page.getByLabel("ratio of the spacing of inlet", { exact: true }).inputValue(), "0.5");
  for (let step = 0; step < 5; step++) await page.keyboard.press("Control+z");
  await answered(page);
  assert.equal(await facts(page), before);
  // Until the sides about a new corner are known, nothing is changed by where they were.
  await page.evaluate(() => {
    document.querySelector("#add").click();
    document.querySelector("#add").click();
    document.querySelector("#remove").click();
    document.querySelector(`#sides [aria-label="One interval more on inlet"]`).click();
  });
  await answered(page);
  assert.match(await text(page, "#corner"), /^Corner 2 of 5$/);
  assert.equal(await facts(page), before);
  await page.context().close();
});

test("a hole that fits nowhere is refused there and then, and nothing waits for it", async () => {
  const page = await open();
  const before = [await facts(page), ...await figures(page)];
  // Beyond the outline; each click once added a hole that nobody saw and nothing but Undo removed.
  for (let click = 0; click < 2; click++) {
    await page.locator("#add-hole").click();
    const box = await page.locator(".stage").first().boundingBox();
    await page.mouse.click(box.x + 4, box.y + 4);
    await page.waitForFunction(() => document.querySelector("#trouble-text").textContent.startsWith("No hole fits there."));
    await answered(page);
    assert.doesNotMatch(await text(page, "#trouble-text"), /line \d+, column/);
  }
  assert.equal(await page.getByRole("button", { name: /^Remove hole/ }).count(), 0);
  // What is wrong does not lie over what is taken.
  const [message, button] = await Promise.all(["#trouble", "#download"].map((id) => page.locator(id).boundingBox()));
  assert.ok(message.x >= button.x + button.width || message.y >= button.y + button.height || message.y + message.height <= button.y);
  assert.deepEqual([await facts(page), ...await figures(page)], before);
  await page.selectOption("#beside", "interior");
  await answered(page);
  assert.match((await figures(page))[1], /minimum angle/);
  assert.match(mindeg("inspect", (await downloaded(page, "#download")).path).stdout, /nothing wrong found/);
  // A corner across the outline is a fault that is seen: it can be dragged back. No picture waits for its mesh.
  await page.selectOption("#beside", "none");
  await choose(page, "figure-1");
  await page.locator("#next").click();
  for (const [axis, value] of [["x", 5], ["y", 1.5]]) {
    await page.locator(`#${axis}`).fill(String(value));
    await page.keyboard.press("Enter");
    await answered(page);
  }
  assert.ok(await page.locator("#trouble").isVisible());
  await page.selectOption("#beside", "interior");
  await answered(page);
  assert.doesNotMatch((await figures(page))[1], /Working/);
  await page.locator("#download").click();
  await page.waitForFunction(() => document.querySelector("#download").disabled === false);
  assert.doesNotMatch(await text(page, "#trouble-text"), /line \d+, column/);
  await page.context().close();
});

test("the last meshes, their figures and the advice stay beside a fault, however long it takes to be found", async () => {
  const page = await open();
  await choose(page, "figure-1");
  const rows = () => page.locator("#purposes .figures").allTextContents();
  const [advised, curve] = [await rows(), await page.locator("#degrees button").count()];
  assert.ok(advised.every((row) => /°/.test(row)) && curve > 1, advised.join(" | "));
  await page.route("**/api/answer?*", async (route) => {
    await new Promise((done) => setTimeout(done, 700));
    await route.continue();
  });
  // The fault comes while a sound domain is worked on, and is told after its figures were waited for.
  await page.evaluate(async () => {
    const [{ apply }, { moveCorner }, { shown, state }] = await Promise.all(["asking", "domain", "state"].map((name) => import(`/page/${name}.js`)));
    const before = shown.domain;
    apply({ ...state.domain });
    while (shown.domain === before) await new Promise((done) => setTimeout(done, 5));
    apply(moveCorner(state.domain, shown.domain, { ring: 0, index: 0 }, [5, 1.5]));
  });
  await page.waitForFunction(() => [...document.querySelectorAll(".mesh:not([hidden]) .figures")].every((it) => it.textContent === "Working …"));
  // The curve of the sound domain can come now, too.
  await page.evaluate(async () => (await import("/page/show.js")).showCurveNow(() => {}));
  await answered(page);
  assert.match(await text(page, "#trouble-text"), /cross|touch/);
  assert.deepEqual(await rows(), advised);
  assert.equal(await page.locator("#degrees button").count(), curve);
  for (const caption of await figures(page)) assert.match(caption, /minimum angle [\d.]+°/);
  assert.ok(await page.locator("#download").isVisible());
  // Without its message they are the same, and still of another domain.
  await page.locator("#trouble-close").click();
  assert.match(await page.locator("#meshes").getAttribute("class"), /old/);
  await page.locator("#undo").click();
  await answered(page);
  assert.doesNotMatch(await page.locator("#meshes").getAttribute("class"), /old/);
  await page.context().close();
});

test("sides are divided by a length, and a boundary is conditioned, with the command for it", async () => {
  const strait = "0,0\n10,0\n10,0.5\n0,0.5\n";
  writeFileSync(join(work, "strait.csv"), strait);
  const server = await explore(binary, join(work, "strait.csv"));
  const page = await browser.newPage();
  try {
    await page.goto(server.address);
    await answered(page);
    // A slow page has asked for nothing yet.
    await page.waitForFunction(() => /^\d+ boundary/.test(document.querySelector("#facts").textContent));
    const count = async () => Number((await page.locator("#facts").textContent()).match(/^(\d+) boundary/)[1]);
    assert.equal(await count(), 4);
    // The numbers of the file are whole: the page writes them otherwise, and its command names the file all the same.
    assert.match(await page.locator("#command").textContent(), /^mindeg mesh \S*strait\.csv --\S+ .*-o strait-\S+\.obj$/);
    await page.locator("#condition").click();
    await page.waitForFunction(() => /boundary points become/.test(document.querySelector("#condition-words").textContent));
    await answered(page);
    assert.ok((await count()) > 20, String(await count()));
    assert.match(await page.locator("#condition-command").textContent(), /^mindeg condition \S*strait\.csv --limit 25 -o strait-conditioned\.json$/);
    // Lists of points are divided, too, as --size divides them.
    await page.locator("#edge-size").fill("0.1");
    await page.locator("#divide").click();
    await page.waitForFunction(() => /^All sides get edges/.test(document.querySelector("#condition-words").textContent));
    await answered(page);
    assert.ok((await count()) > 200, String(await count()));
    await page.locator("#presets").selectOption("plate-with-holes");
    await answered(page);
    // What nothing moves keeps its arcs, its sizes and its names.
    await page.locator("#edge-size").fill("");
    await page.locator("#condition-within").fill("0");
    await page.locator("#condition").click();
    await page.waitForFunction(() => /boundary points become/.test(document.querySelector("#condition-words").textContent));
    await answered(page);
    assert.match(await page.locator("#condition-command").textContent(), /^mindeg condition .* --limit 25 --within 0 -o plate/);
    const bores = await page.evaluate(async () => (await import("/page/state.js")).state.domain.holes[0].sides);
    assert.ok(bores[0].arc && bores[0].name === "left bore", JSON.stringify(bores));
    const before = await count();
    await page.locator("#edge-size").fill("0.2");
    await page.locator("#divide").click();
    // The sides are divided by the server: until it answers the page is that of before.
    await page.waitForFunction(() => /^All sides get edges/.test(document.querySelector("#condition-words").textContent));
    await answered(page);
    assert.ok((await count()) > 1.5 * before / 2 && (await count()) !== before, `${before} and ${await count()}`);
  } finally {
    await page.close();
    await server.stop();
  }
});

test("a surface that the page starts with is there again after a reload, until the reader goes back", async () => {
  const server = await explore(binary, join(domains, "../models/bracket.obj"));
  const page = await browser.newPage();
  const isSolid = () => page.evaluate(() => document.body.classList.contains("solid"));
  const drawn = () => page.waitForFunction(() => document.querySelectorAll("#solid-meshes .stage[data-drawn]").length === 1);
  const isKept = () => page.waitForFunction(() => location.hash.includes("/"));
  try {
    await page.goto(server.address);
    await drawn();
    await isKept();
    await page.waitForTimeout(600);
    await page.reload();
    await drawn();
    assert.ok(await isSolid());
    await page.locator("#solid-end").click();
    await answered(page);
    assert.ok(!(await isSolid()));
    assert.match(await page.locator("#facts").textContent(), /boundary vertices/);
    await page.waitForTimeout(600);
    await page.reload();
    await answered(page);
    assert.ok(!(await isSolid()));
  } finally {
    await page.close();
    await server.stop();
  }
});

test("a boundary too large for the search has a curve and advice", async () => {
  const page = await open();
  const sides = [1500, 1000, 1500, 1000].map((intervals) => ({ intervals }));
  const large = { name: "large", rectangle: { width: 4, height: 3 }, sides };
  await page.locator("#file").setInputFiles({ name: "large.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(large)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "large");
  await answered(page);
  assert.match(await text(page, "#advice"), /^For a patch that must keep its points, take degree \d+: minimum angle .* For a solver, put points inside\.$/);
  assert.match(await text(page, "#curve-note"), /^Not all of these are proven: /);
  // No button promises a mesh that the page has not: the command stands in its place, and the picture has the boundary.
  await page.locator("[data-purpose=solver]").click();
  await answered(page);
  await page.screenshot({ path: join(work, "coarser.png") });
  for (const button of ["#download", "#download-main"]) assert.ok(!await page.locator(button).isVisible(), button);
  assert.ok(await page.locator("#command").isVisible());
  assert.match(await text(page, "#command"), / --interior /);
  assert.match((await page.locator(".mesh .words-of").first().textContent()), /more than the page shows\. The command on this page/);
  const picture = (await page.locator(".mesh .stage").first().screenshot()).toString("base64");
  // The lines of the boundary are gray, the marks of corners are not.
  const drawn = await page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height }).getContext("2d");
    context.drawImage(image, 0, 0);
    const { data: dots } = context.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 0; i < dots.length; i += 4) if (dots[i] < 140 && Math.abs(dots[i] - dots[i + 2]) < 30) count += 1;
    return count;
  }, picture);
  assert.ok(drawn > 400, `${drawn} dots`);
  await page.locator("[data-purpose=patch]").click();
  await answered(page);
  assert.ok(await page.locator("#download").isVisible());
  // Windows give its curve.
  assert.ok(await page.locator("#curve").isVisible());
  assert.equal(await page.locator("#coarser").isVisible(), false);
  // One click takes longer edges inside, with which the page has the mesh.
  await page.locator("[data-purpose=solver]").click();
  await answered(page);
  assert.equal(await text(page, "#coarser"), "Take edges up to 0.3 inside");
  await page.locator("#coarser").click();
  await answered(page);
  assert.match(await page.locator("#name-main").textContent(), /points inside/i);
  assert.match(await text(page, "#command"), /"size_inside":\s*0\.3/);
  const { bytes } = await downloaded(page, "#download");
  assert.ok(bytes.toString().match(/^v /gm).length > 10_000);
  assert.equal(await page.locator("#coarser").isVisible(), false);
  await page.screenshot({ path: join(work, "coarser-taken.png") });
  await page.context().close();
});

test("no name in a menu is cut", async () => {
  const page = await open();
  const cut = await page.evaluate(() => [...document.querySelectorAll("#format, #presets")].flatMap((select) => {
    const style = getComputedStyle(select);
    const context = document.createElement("canvas").getContext("2d");
    context.font = style.font;
    const room = select.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
    return [...select.options].map(({ text }) => text).filter((text) => context.measureText(text).width > room);
  }));
  assert.deepEqual(cut, []);
  await page.selectOption("#format", "gltf");
  assert.match(await text(page, "#format-note"), /glTF.*2 files that belong together, \.gltf, \.bin/);
  await page.context().close();
});

test("what is advised is what is shown", async () => {
  const page = await open();
  const ring = (count, x, y, radius) => Array.from({ length: count }, (_, i) => {
    const rough = radius * (1 + 0.03 * Math.sin(7 * i * i));
    return [x + rough * Math.cos(2 * Math.PI * i / count), y + rough * Math.sin(2 * Math.PI * i / count)];
  });
  const rough = { name: "rough", ring: ring(60, 0, 0, 10), holes: [{ ring: ring(20, 2, 1, 3) }] };
  await page.locator("#file").setInputFiles({ name: "rough.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(rough)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "rough");
  await answered(page);
  const mostly = [...Array(await page.locator("#degrees button").count()).keys()];
  for (const button of [null, ...mostly]) {
    if (button !== null) await page.locator("#degrees button").nth(button).click();
    await answered(page);
    const [degree, angle] = await page.locator("#degrees [aria-pressed=true]").evaluate((chosen) => [chosen.children[0].textContent, chosen.children[1].textContent]);
    const [wanted] = await figures(page);
    assert.ok(wanted.toLowerCase().startsWith(degree) && wanted.includes(angle), `${degree} ${angle}: ${wanted}`);
  }
  await page.context().close();
});

test("a point of the curve is picked, and a degree by its button", async () => {
  const page = await open();
  assert.equal(await page.locator("#curve .pick").count(), await page.locator("#degrees button").count());
  await page.locator("#curve .pick").first().click();
  await answered(page);
  assert.deepEqual(await pressed(page), ["degree 4"]);
  assert.match((await figures(page))[0], /^Degree 4/);
  assert.match(await text(page, "#command"), /--max-degree 4/);
  await page.locator("#degrees button").nth(3).click();
  await answered(page);
  assert.match((await figures(page))[0], /^Degree 6/);
  await page.locator("#degrees button").first().click();
  await answered(page);
  assert.match((await figures(page))[0], /^Points inside: degree 7/);
  assert.match(await text(page, "#command"), /--interior/);
  await page.getByLabel("the least degree", { exact: true }).check();
  await answered(page);
  assert.match((await figures(page))[0], /^Degree 4/);
  await page.locator("#goal-keep_angle").fill("96");
  await page.keyboard.press("Enter");
  await answered(page);
  assert.match((await figures(page))[0], /^Degree 5/);
  await page.context().close();
});

test("Delaunay and points inside stand beside the mesh, or nothing does", async () => {
  const page = await open();
  await choose(page, "plate-with-holes");
  const seen = [];
  for (const [beside, caption] of [["delaunay", /Delaunay/], ["interior", /points inside/i], ["least", /^Least degree: /]]) {
    await page.selectOption("#beside", beside);
    await answered(page);
    assert.match((await figures(page))[1], caption);
    seen.push(await another(() => picture(page, 1), seen));
    assert.equal(await page.locator("#interior").isVisible(), beside === "interior");
  }
  await page.selectOption("#beside", "interior");
  await answered(page);
  const { path } = await downloaded(page, "#download-beside");
  assert.match(mindeg("inspect", path).stdout, /nothing wrong found/);
  await page.selectOption("#beside", "none");
  await answered(page);
  assert.equal((await figures(page)).length, 1);
  await page.context().close();
});

test("every measure colors the triangles, and has a chart of all of them", async () => {
  const page = await open();
  const seen = new Set();
  const options = await page.locator("#metric option").evaluateAll((all) => all.map(({ value }) => value));
  assert.ok(options.length >= 7, options.join(" "));
  for (const value of options) {
    await page.selectOption("#metric", value);
    await answered(page);
    await page.waitForTimeout(400);
    seen.add(await picture(page, 1));
    if (!value) continue;
    const bars = await page.$$eval("#metric-chart .bars", (rows) =>
      rows.map((row) => [...row.children].reduce((sum, bar) => sum + Number(bar.title.match(/: (\d+)/)[1]), 0)));
    assert.deepEqual(bars, [110, 110], value);
  }
  assert.ok(seen.size >= options.length - 2, `${seen.size} pictures of ${options.length} measures`);
  const vertices = await page.$$eval("#degree-chart .bars", (rows) =>
    rows.map((row) => [...row.children].reduce((sum, bar) => sum + Number(bar.title.match(/: (\d+)/)?.[1] ?? 0), 0)));
  assert.deepEqual(vertices, [112, 112]);
  await page.context().close();
});

test("the degree and the limit of the angle are told in words, with the vertex that decides", async () => {
  const page = await open();
  const degree = mindeg("degree", bundled("unequal-hexagon")).stdout;
  await choose(page, "unequal-hexagon");
  const words = (await text(page, "#degree-words")).replace(/\s+/g, " ");
  assert.ok(degree.replace(/\s+/g, " ").includes(words.slice(0, 40)), `${words} | ${degree}`);
  assert.match(await text(page, "#limit-words"), /angle of at most [\d.]+°/);
  const before = await picture(page);
  await page.locator("#show-limit").click();
  await another(() => picture(page), [before]);
  await page.context().close();
});

test("a suggestion is applied by its button", async () => {
  const page = await open();
  await choose(page, "unequal-hexagon");
  const [least] = await page.locator("#degrees b").allTextContents();
  const before = await facts(page);
  await page.locator(".suggestion").first().click();
  await answered(page);
  assert.notEqual(await facts(page), before);
  await page.keyboard.press("Control+z");
  await answered(page);
  assert.equal(await facts(page), before);
  assert.equal((await page.locator("#degrees b").allTextContents())[0], least);
  await page.context().close();
});

test("a hole is added where the reader clicks, and removed", async () => {
  const page = await open();
  await choose(page, "figure-1");
  await page.locator("#add-hole").click();
  const box = await page.locator(".stage").first().boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  // The page first asks whether the hole fits; what is on screen is asked for after that.
  await page.getByRole("button", { name: "Remove hole 1" }).waitFor();
  await answered(page);
  assert.match(await facts(page), /1 hole/);
  await page.locator(".stage").first().focus();
  await page.keyboard.press("p");
  assert.match(await text(page, "#corner"), /^Corner 8 of 8$/);
  await page.keyboard.press("ArrowUp");
  await answered(page);
  assert.ok(await page.locator("#trouble").isHidden());
  await page.getByRole("button", { name: "Remove hole 1" }).click();
  await answered(page);
  assert.ok(!(await facts(page)).includes("hole"));
  await page.context().close();
});

test("a size is set where the reader clicks or by keys, changed and taken back", async () => {
  const page = await openNew();
  await choose(page, "figure-1");
  const points = async () => Number((await page.locator("[data-stage=main] .words-of").textContent()).match(/and (\d+) interior/)[1]);
  const before = await points();
  await page.locator("#add-size").click();
  const box = await page.locator(".stage").first().boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  const size = page.getByLabel("Length of edges at size 1", { exact: true });
  await size.waitFor();
  await size.fill("0.05");
  await page.keyboard.press("Enter");
  await answered(page);
  const finer = await points();
  assert.ok(finer > before + 20, `${before} and ${finer} points inside`);
  const { bytes } = await downloaded(page, "#save");
  const [[x, y, wanted]] = JSON.parse(bytes).interior.sizes;
  assert.equal(wanted, 0.05);
  assert.ok(Number.isFinite(x + y));
  assert.match(await text(page, "#command"), /--interior/);
  await page.locator("#undo").click();
  await page.locator("#undo").click();
  await answered(page);
  assert.equal(await points(), before);
  assert.equal(await size.count(), 0);
  await page.locator("#add-size").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await size.waitFor();
  await page.getByLabel("Remove size 1", { exact: true }).click();
  await answered(page);
  assert.equal(await points(), before);
  await page.context().close();
});

test("what is no domain is refused in a sentence, and the last mesh stays", async () => {
  const page = await open();
  await choose(page, "figure-1");
  const [[left, top], , [right, high]] = await cornerPlaces(page);
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(right + 10, high + (top - high) / 2, { steps: 5 });
  await page.mouse.up();
  await answered(page);
  assert.ok(await page.locator("#trouble").isVisible());
  assert.ok((await text(page, "#trouble-text")).length > 20);
  await page.keyboard.press("Control+z");
  await answered(page);
  assert.ok(await page.locator("#trouble").isHidden());
  await page.context().close();
});

/** Drops a file on the page, as a hand does. */
async function dropFile(page, name, bytes) {
  const transfer = await page.evaluateHandle(([name, base64]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    return transfer;
  }, [name, Buffer.from(bytes).toString("base64")]);
  for (const kind of ["dragenter", "dragover", "drop"]) await page.dispatchEvent("body", kind, { dataTransfer: transfer });
}

test("a Gmsh file is dropped and meshed", async () => {
  assert.equal(mindeg("mesh", bundled("wing-panel"), "--ascii", "-o", "wing.msh").status, 0);
  const page = await open();
  await dropFile(page, "wing.msh", readFileSync(join(work, "wing.msh")));
  await page.waitForFunction(() => document.querySelector("#facts").textContent.startsWith("72 boundary vertices"));
  await answered(page);
  assert.equal(await page.locator("#presets").inputValue(), "");
  await dropFile(page, "notes.txt", Buffer.from("no domain at all"));
  await page.waitForFunction(() => !document.querySelector("#trouble").hidden);
  assert.match(await facts(page), /^72 boundary vertices/);
  await page.context().close();
});

test("a file of several polygons offers each", async () => {
  const square = (x) => [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1], [x, 0]];
  const feature = (name, x) => ({ type: "Feature", properties: { name }, geometry: { type: "Polygon", coordinates: [square(x)] } });
  const json = { type: "FeatureCollection", features: [feature("one", 0), feature("two", 3)] };
  const page = await open();
  await dropFile(page, "two.geojson", Buffer.from(JSON.stringify(json)));
  await page.waitForFunction(() => document.querySelectorAll("#choose button").length === 3);
  await answered(page);
  await page.locator("#choose button").nth(2).click();
  await answered(page);
  assert.equal(await text(page, "#title"), await page.locator("#choose button").nth(2).textContent());
  await page.context().close();
});

const MAP = {
  name: "a map", rectangle: { width: 4, height: 2 }, size: 0.5,
  lines: [{ corners: [[2, 0], [2, 2]], name: "interface", size: 0.5 }, { points: [[2.5, 0.5], [3, 0.75], [3.5, 0.5]], name: "fault" }],
  points: [{ at: [3, 1.5], name: "gauge" }],
  regions: [{ at: [0.75, 1], name: "clay" }, { at: [3.25, 1.2], name: "sand" }],
};

async function openMap(page) {
  await page.locator("#file").setInputFiles({ name: "map.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(MAP)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "a map");
  await answered(page);
}

test("lines, points and regions of a map are drawn with their names", async () => {
  const page = await open();
  const names = () => page.locator(".stage").evaluateAll((all) => all.map((stage) => stage.dataset.names));
  const choice = page.locator("#names-choice");
  assert.deepEqual(await names(), [undefined, undefined]);
  assert.ok(await choice.isHidden());
  await openMap(page);
  assert.match(await facts(page), /^31 vertices/);
  assert.ok((await facts(page)).includes(" · 2 lines · 2 regions · "));
  const nameless = { ...MAP, name: "a map of two", lines: MAP.lines.map(({ name: _, ...line }) => line) };
  await page.locator("#file").setInputFiles({ name: "two.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(nameless)) });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "a map of two");
  await answered(page);
  const drawn = await page.evaluate(async () => (await import("/page/state.js")).shown.domain.lines.map(({ name }) => name));
  for (const [place, name] of drawn.entries()) assert.equal(await page.getByLabel(`name of line ${place + 1}`, { exact: true }).getAttribute("placeholder"), name);
  await openMap(page);
  const all = "gauge, clay, sand, interface, fault";
  assert.deepEqual(await names(), [all, all]);
  const named = await picture(page);
  await page.uncheck("#names");
  await page.waitForFunction(() => !document.querySelector(".stage").dataset.names);
  const plain = await another(() => picture(page), [named]);
  // Zoomed in on the left half, what is out of sight has no name.
  await page.check("#names");
  await page.evaluate(async () => {
    const { moveTo, zoomBy } = await import("/page/pictures.js");
    zoomBy(4);
    moveTo(0.75, 1);
  });
  await page.waitForFunction(() => document.querySelector(".stage").dataset.names === "clay");
  await page.context().close();
});

test("every format is downloaded, and GLB is read back", async () => {
  const page = await open();
  const formats = await page.locator("#format option").evaluateAll((all) => all.map(({ value }) => value));
  assert.ok(formats.length >= 8, formats.join(" "));
  for (const format of formats) {
    await page.selectOption("#format", format);
    const { bytes } = await downloaded(page, "#download");
    assert.ok(bytes.length > 100, `${format}: ${bytes.length} bytes`);
    await page.waitForTimeout(100);
  }
  await page.selectOption("#format", "glb");
  const { path, bytes } = await downloaded(page, "#download");
  assert.equal(bytes.subarray(0, 4).toString(), "glTF");
  const { stdout } = mindeg("inspect", path);
  assert.match(stdout, /nothing wrong found; maximum degree 5/);
  await page.context().close();
});

test("the copied command makes the same mesh in a shell", async () => {
  const page = await open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.selectOption("#format", "obj");
  for (const change of ["none", "drag"]) {
    if (change === "drag") {
      const [, corner] = await cornerPlaces(page);
      await page.mouse.move(...corner);
      await page.mouse.down();
      await page.mouse.move(corner[0] - 60, corner[1] - 10, { steps: 4 });
      await page.mouse.up();
      await answered(page);
    }
    await page.locator("#copy").click();
    const command = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(command, await text(page, "#command"));
    const { bytes } = await downloaded(page, "#download");
    // A command for an example names it as it lies in the repository.
    const shell = join(work, `shell-${change}`);
    mkdirSync(shell);
    symlinkSync(resolve(domains, ".."), join(shell, "assets"));
    const path = `${resolve(binary, "..")}:${process.env.PATH}`;
    const ran = spawnSync("sh", ["-c", command], { cwd: shell, encoding: "utf8", env: { ...process.env, PATH: path } });
    assert.equal(ran.status, 0, `${command}\n${ran.stderr}`);
    const same = readFileSync(join(shell, command.match(/-o (\S+)/)[1])).equals(bytes);
    assert.ok(same, command);
  }
  await page.context().close();
});

test("the address brings the domain and the choices back", async () => {
  const page = await open();
  await choose(page, "wing-panel");
  await page.selectOption("#beside", "delaunay");
  await page.locator("#degrees button").nth(1).click();
  await page.getByLabel("One interval more on root-rib").click();
  await answered(page);
  await page.waitForFunction(() => location.hash.includes("/"));
  await page.evaluate(async () => {
    const [{ state }, { getJson }] = await Promise.all(["state", "server"].map((name) => import(`/page/${name}.js`)));
    const kept = () => getJson(`/api/state/${location.hash.split("/")[1]}`).catch(() => null);
    const end = performance.now() + 20_000;
    while (JSON.stringify(await kept()) !== JSON.stringify(state)) {
      if (performance.now() > end) throw new Error("what is on the page is not kept");
      await new Promise((done) => setTimeout(done, 50));
    }
  });
  const [before, caption] = [await facts(page), await figures(page)];
  const other = await openIn(page.context(), page.url());
  for (const restored of [other, page]) {
    if (restored === page) {
      await page.reload();
      await page.waitForFunction(() => document.querySelector("#facts").textContent.includes("vertices"));
      await answered(page);
    }
    assert.equal(await facts(restored), before);
    assert.deepEqual(await figures(restored), caption);
    assert.equal(await restored.locator("#beside").inputValue(), "delaunay");
  }
  await page.context().close();
});

test("two tabs do not disturb each other", async () => {
  const one = await open();
  const two = await openIn(one.context());
  await Promise.all([choose(one, "wing-panel"), choose(two, "great-britain")]);
  assert.equal(await text(one, "#title"), "wing-panel");
  assert.equal(await text(two, "#title"), "great-britain");
  for (const page of [one, two]) assert.equal((await figures(page)).length, 2);
  await one.context().close();
});

/** The status of a request that no page of ours would send. */
const status = (path, { method = "GET", headers = {}, body } = {}) => new Promise((done, failed) => {
  const { hostname, port } = new URL(origin);
  const sent = httpRequest({ hostname, port, path, method, headers, agent: false }, (response) => {
    response.resume();
    done(response.statusCode);
  });
  sent.on("socket", (socket) => socket.on("error", () => {}));
  sent.on("error", (error) => (["ECONNRESET", "EPIPE"].includes(error.code) ? done("closed") : failed(error)));
  if (body) sent.write(body);
  sent.end();
});

test("hostile requests are refused", async () => {
  const token = new URL(server.address).hash.slice(1).split("/")[0];
  const good = { "X-Mindeg-Token": token };
  assert.equal(await status("/api/start", { headers: good }), 200);
  assert.equal(await status("/api/start"), 403);
  assert.equal(await status("/api/start", { headers: { "X-Mindeg-Token": token.replace(/./g, "0") } }), 403);
  assert.equal(await status("/api/start", { headers: { ...good, Host: "evil.example" } }), 403);
  assert.equal(await status("/", { headers: { Host: "evil.example" } }), 403);
  assert.equal(await status("/api/start", { headers: { ...good, Origin: "http://evil.example" } }), 403);
  assert.equal(await status("/api/start", { headers: { ...good, "Sec-Fetch-Site": "cross-site" } }), 403);
  const huge = await status("/api/answer?tab=x", { method: "POST", headers: good, body: Buffer.alloc(20_000_000, 32) });
  assert.ok(huge === 413 || huge === "closed", String(huge));

  // A page of another origin, even with the token, can neither read nor embed.
  const foreign = createServer((_, response) => response.end("<!doctype html><title>evil</title>"));
  await new Promise((done) => foreign.listen(0, "127.0.0.1", done));
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`http://127.0.0.1:${foreign.address().port}/`);
  const outcome = await page.evaluate(async ([origin, token]) => {
    const read = await fetch(`${origin}/api/start`, { headers: { "X-Mindeg-Token": token } }).then(() => "read", () => "refused");
    const frame = document.createElement("iframe");
    frame.src = `${origin}/#${token}`;
    document.body.append(frame);
    await new Promise((done) => { frame.onload = done; setTimeout(done, 2000); });
    let inside = "hidden";
    try { inside = frame.contentDocument ? "blank" : "hidden"; } catch { inside = "hidden"; }
    return { read, inside };
  }, [origin, token]);
  assert.equal(outcome.read, "refused");
  assert.ok(!page.frames().some((frame) => frame !== page.mainFrame() && frame.url().startsWith(origin)), "it is not framed");
  await context.close();
  await new Promise((done) => foreign.close(done));
});

const SCREENS = [390, 800, 1400].flatMap((width) => ["light", "dark"].map((colorScheme) => ({ width, colorScheme })));

test("axe finds nothing serious and nothing is cut off, on any screen, light and dark", async () => {
  for (const { width, colorScheme } of SCREENS) {
    // The page's own policy keeps scripts of others out, and axe is one.
    const page = await open({ viewport: { width, height: 900 }, colorScheme, bypassCSP: true });
    const shown = [["boundary-layer-channel", () => {}],
      ...["plate-with-holes", "great-britain"].map((name) => [name, () => choose(page, name)]),
      ["a map", () => openMap(page)], ["a size", async () => {
        await page.locator("#add-size").focus();
        for (let press = 0; press < 2; press++) await page.keyboard.press("Enter");
        await page.getByLabel("Length of edges at size 1", { exact: true }).waitFor();
      }], ["a surface", async () => {
        await openTube(page);
        await page.locator("#solid-fill").click();
        await page.waitForFunction(() => document.querySelectorAll("#solid-meshes h3").length === 2);
      }]];
    for (const [name, show] of shown) {
      await show();
      await page.waitForTimeout(300);
      assert.equal(await page.evaluate(() => document.scrollingElement.scrollWidth), width, `${name} at ${width} pixels`);
      assert.deepEqual(await seriousFaults(page), [], `${name} at ${width} pixels, ${colorScheme}`);
    }
    await page.screenshot({ path: join(work, `${width}-${colorScheme}.png`), fullPage: true });
    await page.context().close();
  }
});

test("on a phone a corner is dragged by a finger", async () => {
  const page = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await choose(page, "figure-1");
  await page.locator(".stage").first().scrollIntoViewIfNeeded();
  const [, corner] = await cornerPlaces(page);
  const client = await page.context().newCDPSession(page);
  const touch = (type, points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await touch("touchStart", [corner]);
  for (let step = 1; step <= 4; step++) await touch("touchMove", [[corner[0] - 8 * step, corner[1] - 6 * step]]);
  await touch("touchEnd", []);
  await answered(page);
  assert.match(await text(page, "#corner"), /^Corner 2 of 4$/);
  assert.ok(Number(await page.locator("#x").inputValue()) < 3);
  await page.context().close();
});

test("light and dark follow the reader's system, also while the page is open", async () => {
  const page = await open({ colorScheme: "light" });
  const light = await picture(page);
  await page.emulateMedia({ colorScheme: "dark" });
  await another(() => picture(page), [light]);
  await page.context().close();
});

test("a picture for the README", async () => {
  // As a newcomer meets it.
  const page = await openNew({ viewport: { width: 1400, height: 876 } });
  await page.mouse.move(0, 0);
  await page.waitForTimeout(500);
  await page.screenshot({ path: resolve("explore.png") });
  await page.context().close();
});

test("no page has reported an error or asked anybody else for anything", () => {
  assert.deepEqual(noise, []);
  // A file that is no domain is refused with a status, which Chromium lists.
  assert.deepEqual(errors.filter((message) => !/status of 4\d\d/.test(message)), []);
});

test("the process ends with Ctrl-C, and the page says so", async () => {
  const page = await open();
  const [code, signal] = await server.stop();
  // A shell tells of an end by SIGINT as 130.
  assert.ok(code === 0 || code === 130 || signal === "SIGINT", `code ${code}, signal ${signal}`);
  await page.getByLabel("One interval more on wall").click();
  await page.waitForFunction(() => document.querySelector("#trouble-text").textContent.includes("no longer answers"));
  await page.context().close();
});

try {
  await run();
} finally {
  await server.stop("SIGKILL");
  await browser.close();
}
