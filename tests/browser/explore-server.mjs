// A running `mindeg explore`, for tests and benchmarks.

import { spawn } from "node:child_process";
import { once } from "node:events";

/** Starts the page on a domain; `address` is what it prints, with the token. */
export async function explore(binary, ...args) {
  const child = spawn(binary, ["explore", ...args, "--no-open"], { stdio: ["ignore", "pipe", "pipe"] });
  let printed = "";
  const found = new Promise((resolve, reject) => {
    const read = (chunk) => {
      printed += chunk;
      const address = printed.match(/http:\/\/[\d.:]+\/#\w+/);
      if (address) resolve(address[0]);
    };
    child.stdout.on("data", read);
    child.stderr.on("data", read);
    child.once("error", reject);
    child.once("exit", (code) => reject(new Error(`mindeg explore ended with ${code}: ${printed}`)));
    setTimeout(() => reject(new Error(`mindeg explore printed no address: ${printed}`)), 20_000).unref();
  });
  const stop = async (signal = "SIGINT") => {
    if (child.exitCode !== null || child.signalCode !== null) return [child.exitCode, child.signalCode];
    child.kill(signal);
    return once(child, "exit");
  };
  try {
    return { address: await found, stop };
  } catch (error) {
    child.kill("SIGKILL");
    throw error;
  }
}

/** Where corners of the outline are on the screen, in the order of the domain. */
export const cornerPlaces = (page) => page.evaluate(async () => {
  const [{ stages }, { corners }, { state, shown }] = await Promise.all(
    ["pictures", "domain", "state"].map((name) => import(`/page/${name}.js`)));
  const box = stages[0].element.getBoundingClientRect();
  return corners(state.domain, shown.domain).map(({ x, y }) => {
    const [left, top] = stages[0].frame.toScreen(x, y);
    return [box.left + left, box.top + top];
  });
});

/** Waits for the last line of the answer to what was asked last, and for its picture. */
export async function answered(page) {
  await page.evaluate(async () => {
    const { progress } = await import("/page/asking.js");
    const end = performance.now() + 60_000;
    while (progress.answered !== progress.asked) {
      if (performance.now() > end) throw new Error("no whole answer in 60 s");
      await new Promise((done) => setTimeout(done, 20));
    }
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
}
