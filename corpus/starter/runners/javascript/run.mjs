// SPDX-License-Identifier: Apache-2.0
// Runs the starter vectors against your function: node run.mjs [CONTROLLER.mjs] (example.mjs). The file exports `sections`
// and `needs`, which name what it knows, and yourFunction(program, settings), which answers { points, alarm }:
//   program    the lines of the program
//   settings   `settings` of the vector, as in starter.json
//   points     where the axes go at the end of each move: arrays of numbers, in the order of settings.axes
//   alarm      null, or { line, name }: the number of the alarm, or its cause as in starter.json
// Exit status: 0 all agree, 1 one does not, or nothing was compared.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const controller = await import(process.argv[2] ? pathToFileURL(resolve(process.argv[2])) : "./example.mjs");
const { vectors } = JSON.parse(readFileSync(new URL("../../starter.json", import.meta.url), "utf8"));

const shown = (axes, point) =>
  point ? axes.map((axis, index) => axis + Number(Number(point[index]).toPrecision(10))).join(" ") : "nothing";

// The first thing that is not as expected, as text; null where all agrees.
function difference({ settings: { axes }, expect }, { points, alarm }) {
  const wanted = expect.points.map((point) => axes.map((axis) => point[axis]));
  for (let i = 0; i < Math.max(wanted.length, points.length); ++i) {
    const [want, got] = [wanted[i], points[i]];
    // Written so that a NaN, which compares with nothing, does not agree.
    const agrees = want && got && got.length === axes.length && got.every((value, k) => Math.abs(value - want[k]) <= expect.tolerance);
    if (!agrees) {
      const line = want ? `, line ${expect.points[i].line}` : "";
      return `point ${i + 1}${line}: expected ${shown(axes, want)}, got ${shown(axes, got)}`;
    }
  }
  const want = expect.alarm;
  if (!want && !alarm) return null;
  if (want && alarm && alarm.line === want.line && [want.number, want.cause].includes(alarm.name)) return null;
  const name = want ? `line ${want.line}: ${want.number} (${want.cause})` : "none";
  return `alarm: expected ${name}, got ${alarm ? `line ${alarm.line}: ${alarm.name}` : "none"}`;
}

let agreed = 0, failed = 0;
for (const vector of vectors) {
  if (!controller.sections.includes(vector.section) || !vector.needs.every((need) => controller.needs.includes(need))) continue;
  let wrong;
  try {
    wrong = difference(vector, controller.yourFunction(vector.program, vector.settings));
  } catch (why) {
    wrong = `your function threw ${why}`;
  }
  if (wrong) {
    ++failed;
    console.log(`FAILED ${vector.name}: ${vector.shows}\n  mistake: ${vector.catches}\n  ${wrong}\n  see ${vector.picture}`);
  } else {
    ++agreed;
  }
}
console.log(`${agreed} vectors agree, ${failed} do not, ${vectors.length - agreed - failed} skipped: their section or a need is not named`);
process.exitCode = agreed && !failed ? 0 : 1;
