// How much work the page's main thread has in a frame while a corner is dragged, by Chromium's own trace, and
// how long a reader waits for a mesh.
//
//   node explore-frames.mjs MINDEG_BINARY CHROMIUM
//
// The 95th percentile of a frame may be 16 ms of the main thread's processor time with 10,000 triangles in each
// picture, and that of the first mesh 50 ms at 400 boundary points. Processor time leaves out what other
// programs take from the machine; wall time is printed beside it. Exit code 1 if a bound is missed.

import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { chromium } from "playwright-core";
import { answered, cornerPlaces, explore } from "./explore-server.mjs";

const [binary, executablePath] = process.argv.slice(2);
const FRAMES = 240;
const MOST_WORK = 16;
const MOST_WAIT = 50;

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

/** Notes when the page asks and when the worker has drawn a mesh of the answer. */
function measureAnswers() {
  window.waits = [];
  const asked = new Map();
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...more) {
    if (message.kind === "begin") {
      this.addEventListener("message", ({ data }) => {
        if (data.line?.kind !== "mesh" || !asked.has(data.id) || data.line.view !== asked.get(data.id).view) return;
        window.waits.push(performance.now() - asked.get(data.id).time);
        asked.delete(data.id);
      });
    }
    if (message.kind === "ask") asked.set(message.id, { time: performance.now(), view: message.request.view });
    return postMessage.call(this, message, ...more);
  };
}

/** Moves the pointer once a frame, in a circle about a corner. */
async function dragCorner(page) {
  const [, , corner] = await cornerPlaces(page);
  await page.mouse.move(...corner);
  await page.mouse.down();
  for (let frame = 0; frame < FRAMES; frame++) {
    const angle = (2 * Math.PI * frame) / 60;
    await page.mouse.move(corner[0] - 40 + 30 * Math.cos(angle), corner[1] + 20 + 15 * Math.sin(angle));
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
}

/** Work of each frame in milliseconds: all tasks of the main thread from one frame to the next. */
function workByFrame(trace, pid) {
  const { traceEvents: events } = JSON.parse(trace);
  const named = events.filter(({ name, args, pid: of }) => name === "thread_name" && args.name === "CrRendererMain" && (!pid || of === pid));
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
  const frameWork = starts.slice(1).map(() => ({ processor: 0, wall: 0 }));
  let place = 0;
  for (const { ts, dur, tdur } of outer) {
    while (place < frameWork.length && ts >= starts[place + 1]) place++;
    if (place >= frameWork.length || ts < starts[0]) continue;
    frameWork[place].wall += dur / 1000;
    frameWork[place].processor += (tdur ?? dur) / 1000;
  }
  return frameWork;
}

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
let isMissed = false;

for (const [points, what] of [[400, "400 boundary points"], [10_002, "10,000 triangles in each picture"]]) {
  const server = await explore(binary, rectangle(`frames-${points}`, points));
  try {
    const page = await (await browser.newContext({ viewport: { width: 1400, height: 900 } })).newPage();
    await page.addInitScript(measureAnswers);
    await page.goto(server.address);
    await page.waitForFunction(() => document.querySelector("#facts").textContent.includes("vertices"));
    await answered(page);
    await page.evaluate(() => { window.waits = []; });
    await browser.startTracing(page, { categories: ["devtools.timeline", "disabled-by-default-devtools.timeline", "toplevel", "disabled-by-default-devtools.timeline.frame"] });
    await dragCorner(page);
    const trace = (await browser.stopTracing()).toString();
    if (process.env.KEEP_TRACE) writeFileSync(`trace-${points}.json`, trace);
    const frames = workByFrame(trace);
    const [processor, wall] = ["processor", "wall"].map((kind) => frames.map((frame) => frame[kind]));
    const waits = await page.evaluate(() => window.waits);
    console.log(`${what}, ${frames.length} frames while dragging; median / 95th percentile / most, in ms`);
    console.log(`  main thread, processor time  ${told(processor)}`);
    console.log(`  main thread, wall time       ${told(wall)}`);
    console.log(`  from a drag to its mesh      ${told(waits)} (${waits.length} answers)`);
    if (frames.length < 30 || quantile(processor, 0.95) > MOST_WORK) isMissed = true;
    if (points === 400 && (!waits.length || quantile(waits, 0.95) > MOST_WAIT)) isMissed = true;
    await page.context().close();
  } finally {
    await server.stop("SIGKILL");
  }
}
await browser.close();
process.exitCode = isMissed ? 1 : 0;
