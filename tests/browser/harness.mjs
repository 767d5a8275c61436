// Runs named tests one after the other and counts them.

const tests = [];

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
