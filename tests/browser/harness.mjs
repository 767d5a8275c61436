// Runs named tests one after the other and counts them; and asks axe about a page.

import { readFileSync } from "node:fs";

const tests = [];
const axe = readFileSync("node_modules/axe-core/axe.min.js", "utf8");

export function test(name, body) {
  tests.push([name, body]);
}

/** Runs all tests, or those whose names have the text ONLY; the exit code says whether all have passed. */
export async function run() {
  let failed = 0;
  const chosen = tests.filter(([name]) => name.includes(process.env.ONLY ?? ""));
  for (const [name, body] of chosen) {
    try {
      await body();
      console.log(`ok    ${name}`);
    } catch (error) {
      failed += 1;
      console.log(`FAIL  ${name}\n      ${String(error.stack).replaceAll("\n", "\n      ")}`);
    }
  }
  console.log(`${chosen.length - failed} passed, ${failed} failed`);
  process.exitCode = failed ? 1 : 0;
}

/** What axe finds serious on a page, which must let scripts of others in. */
export async function seriousFaults(page) {
  await page.evaluate(axe);
  // To describe all that is right takes longer than to look for what is wrong.
  const { violations } = await page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
  const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
  return serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
}
