// Runs the Khronos glTF validator and writes down what it says.
//
//     node validator.mjs ENVIRONMENT READINGS.jsonl FILE...
//
// One line of JSON a file, in the order given; judging it is left to expectations.py.
// ENVIRONMENT is the folder that gltf-validator was installed in.

import { appendFileSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";

const [environment, readings, ...files] = process.argv.slice(2);
const { validateBytes } = createRequire(join(environment, "package.json"))("gltf-validator");

async function read(file) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 100,
    // A .gltf keeps its numbers in a .bin beside it.
    externalResourceFunction: async (uri) =>
      new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  const { issues, info } = report;
  const of = (severity) =>
    issues.messages
      .filter((issue) => issue.severity === severity)
      .map(({ code, message, pointer }) => `${code} ${pointer ?? ""}: ${message}`);
  return {
    errors: of(0),
    warnings: of(1),
    remarks: [...of(2), ...of(3)],
    // Absent when the file could not be read so far.
    vertices: info?.totalVertexCount ?? 0,
    primitives: info?.drawCallCount ?? 0,
    faces: info?.totalTriangleCount ?? 0,
  };
}

writeFileSync(readings, "");
for (const file of files) {
  let reading;
  try {
    reading = await read(file);
  } catch (problem) {
    reading = { error: String(problem) };
  }
  appendFileSync(readings, JSON.stringify({ file, ...reading }) + "\n");
}
