// SPDX-License-Identifier: Apache-2.0
// A controller to be replaced by yours: it knows the length offset of Z.
export const sections = ["fanuc/tool-length-offset"];
export const needs = ["incremental"];

export function yourFunction(program, settings) {
  const at = { X: 0, Y: 0, Z: 0 }, points = [];
  let offset = 0, h = 0, sign = 0, incremental = false;
  for (const line of program) {
    const words = [...line.matchAll(/([A-Z])([-+.0-9]+)/g)].map(([, letter, digits]) => [letter, Number(digits)]);
    let moved = false;
    const before = offset;
    for (const [letter, value] of words) {
      if (letter === "G" && (value === 90 || value === 91)) incremental = value === 91;
      if (letter === "G" && [43, 44, 49].includes(value)) sign = { 43: 1, 44: -1, 49: 0 }[value];
      if (letter === "H") h = value;
      if (letter in at) [at[letter], moved] = [value + (incremental ? at[letter] : 0), true];
    }
    offset = sign * (settings.offsets[`H${h}`] ?? 0);
    if (moved || offset !== before) points.push([at.X, at.Y, at.Z + offset]);
  }
  return { points, alarm: null };
}
