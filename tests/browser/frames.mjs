// How much work a page's main thread has in a frame, by Chromium's own trace: while a corner is dragged in the page of
// `explore`, and while a torus of a million triangles is turned in that of `view`; and how long a reader waits for a mesh.
//
//   node frames.mjs MINDEG_BINARY CHROMIUM
//
// The 95th percentile of a frame may be 16 ms of the main thread's processor time, with 10,000 triangles in each
// picture and with the torus, and that of the first mesh with points inside, a draft, 100 ms at 400 boundary points;
// half of the frames of the torus may be 34 ms apart. Processor time leaves out what other programs take from the machine; wall time is printed
// beside it. Without a graphics card the processor draws: with one, frames are no slower. Exit code 1 if a bound is missed.

import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { answered, cornerPlaces, explore } from "./explore-server.mjs";

const [binary, executablePath] = process.argv.slice(2);
const FRAMES = 240;
const MOST_WORK = 16;
const MOST_WAIT = 100;
const MOST_BETWEEN = 34;

/** A rectangle with so many boundary points; without holes, two triangles fewer. */
function rectangle(name, points) {
  const [long, short] = [Math.round(points / 3), Math.round(points / 6)];
  const last = points - 2 * long - short;
  const sides = [long, short, long, last].map((intervals) => ({ intervals }));
  const path = resolve(`${name}.json`);
  writeFileSync(path, JSON.stringify({ name, rectangle: { width: 4, height: 2 }, sides }));
  return path;
}

const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];
const told = (values) => [0.5, 0.95, 1].map((share) => (values.length ? quantile(values, share) : NaN).toFixed(1)).join(" / ");

/**
 * Notes when the page asks, and when the worker has drawn a mesh of the answer in the view that is looked at: the first, a draft
 * perhaps, in `waits`, and the last in `lasts`.
 */
function measureAnswers() {
  window.waits = [];
  window.lasts = [];
  const asked = new Map();
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...more) {
    if (message.kind === "begin") {
      this.addEventListener("message", ({ data }) => {
        if (data.line?.kind !== "mesh" || !asked.has(data.id) || data.line.view !== asked.get(data.id).view) return;
        const { time, isDrawn } = asked.get(data.id);
        if (!isDrawn) window.waits.push(performance.now() - time);
        asked.get(data.id).isDrawn = true;
        if (!data.line.is_last) return;
        window.lasts.push(performance.now() - time);
        asked.delete(data.id);
      });
    }
    if (message.kind === "ask") asked.set(message.id, { time: performance.now(), view: message.request.view });
    return postMessage.call(this, message, ...more);
  };
}

/** Drags a place in a circle, a step every 16 ms, and gives the trace. */
async function traced(page, [x, y]) {
  await browser.startTracing(page, { categories: ["devtools.timeline", "disabled-by-default-devtools.timeline", "toplevel", "disabled-by-default-devtools.timeline.frame"] });
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let frame = 0; frame < FRAMES; frame++) {
    const angle = (2 * Math.PI * frame) / 60;
    await page.mouse.move(x - 40 + 30 * Math.cos(angle), y + 20 + 15 * Math.sin(angle));
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
  return (await browser.stopTracing()).toString();
}

/** A torus of 1000 by 500 vertices as a file. */
function torus() {
  const [around, across] = [1000, 500];
  const lines = [];
  for (let i = 0; i < around; i++) {
    for (let k = 0; k < across; k++) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * k) / across];
      const radius = 3 + Math.cos(v);
      lines.push(`v ${radius * Math.cos(u)} ${radius * Math.sin(u)} ${Math.sin(v)}`);
    }
  }
  const at = (i, k) => (i % around) * across + (k % across) + 1;
  for (let i = 0; i < around; i++) {
    for (let k = 0; k < across; k++) {
      lines.push(`f ${at(i, k)} ${at(i + 1, k)} ${at(i, k + 1)}`, `f ${at(i + 1, k)} ${at(i + 1, k + 1)} ${at(i, k + 1)}`);
    }
  }
  writeFileSync("torus.obj", lines.join("\n"));
  return "torus.obj";
}

/** Work of each frame in milliseconds, all tasks of the main thread from one frame to the next, and the time between frames. */
function workByFrame(trace) {
  const { traceEvents: events } = JSON.parse(trace);
  const named = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(named.map(({ pid, tid }) => `${pid} ${tid}`));
  const mine = events.filter(({ pid, tid }) => main.has(`${pid} ${tid}`));
  // Of several renderers, the page's is the one that has the most frames.
  const frames = mine.filter(({ name }) => name === "BeginMainThreadFrame");
  const count = new Map();
  for (const { pid } of frames) count.set(pid, (count.get(pid) ?? 0) + 1);
  const [[page] = []] = [...count].sort((a, b) => b[1] - a[1]);
  const starts = frames.filter(({ pid }) => pid === page).map(({ ts }) => ts).sort((a, b) => a - b);
  const tasks = mine.filter(({ pid, name, ph }) => pid === page && ph === "X" && /RunTask$/.test(name)).sort((a, b) => a.ts - b.ts);
  // A task within a task is counted once.
  const outer = [];
  for (const task of tasks) if (!outer.length || task.ts >= outer.at(-1).ts + outer.at(-1).dur) outer.push(task);
  const frameWork = starts.slice(1).map((end, place) => ({ processor: 0, wall: 0, between: (end - starts[place]) / 1000 }));
  let place = 0;
  for (const { ts, dur, tdur } of outer) {
    while (place < frameWork.length && ts >= starts[place + 1]) place++;
    if (place >= frameWork.length || ts < starts[0]) continue;
    frameWork[place].wall += dur / 1000;
    frameWork[place].processor += (tdur ?? dur) / 1000;
  }
  return frameWork;
}

/** Prints the work of the frames of a trace, and notes whether it is too much. */
function judge(what, trace) {
  const frames = workByFrame(trace);
  const [processor, wall, between] = ["processor", "wall", "between"].map((kind) => frames.map((frame) => frame[kind]));
  console.log(`${what}, ${frames.length} frames while dragging; median / 95th percentile / most, in ms`);
  console.log(`  main thread, processor time  ${told(processor)}`);
  console.log(`  main thread, wall time       ${told(wall)}`);
  console.log(`  from a frame to the next     ${told(between)}`);
  if (frames.length < 30 || quantile(processor, 0.95) > MOST_WORK) isMissed = true;
  return between;
}

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--enable-unsafe-swiftshader"] });
let isMissed = false;

for (const [points, what] of [[400, "400 boundary points"], [10_002, "10,000 triangles in each picture"]]) {
  const server = await explore(binary, rectangle(`frames-${points}`, points));
  try {
    const page = await (await browser.newContext({ viewport: { width: 1400, height: 900 } })).newPage();
    await page.addInitScript(measureAnswers);
    await page.goto(server.address);
    await page.waitForFunction(() => document.querySelector("#facts").textContent.includes("vertices"));
    await answered(page);
    await page.evaluate(() => { window.waits = []; window.lasts = []; });
    const [, , corner] = await cornerPlaces(page);
    judge(what, await traced(page, corner));
    const waits = await page.evaluate(() => window.waits);
    console.log(`  from a drag to its mesh      ${told(waits)} (${waits.length} answers)`);
    // Only steps that no newer one ended have it.
    const lasts = await page.evaluate(() => window.lasts);
    console.log(`  to its last mesh             ${told(lasts)} (${lasts.length} answers)`);
    if (points === 400 && (!waits.length || quantile(waits, 0.95) > MOST_WAIT)) isMissed = true;
    await page.context().close();
  } finally {
    await server.stop("SIGKILL");
  }
}

const viewed = spawnSync(binary, ["view", torus(), "-o", "torus.html"]);
if (viewed.status !== 0) throw new Error(viewed.stderr.toString());
const page = await (await browser.newContext({ viewport: { width: 1400, height: 900 } })).newPage();
await page.goto(pathToFileURL(resolve("torus.html")).href);
const stage = page.locator(".stage[data-drawn=webgl]");
const box = await stage.boundingBox({ timeout: 120_000 });
await page.waitForTimeout(2000);
const between = judge("a million triangles in space", await traced(page, [box.x + box.width / 2, box.y + box.height / 2]));
if (quantile(between, 0.5) > MOST_BETWEEN) isMissed = true;

await browser.close();
process.exitCode = isMissed ? 1 : 0;
