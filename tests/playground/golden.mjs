// SPDX-License-Identifier: Apache-2.0
// golden.mjs MODULE CORPUS [SEED]: golden vectors through the WebAssembly module. A twentieth of them by SEED (1), or all
// with TOOLCOMP_TESTS_WHOLE. The corpus says what is expected: every event, of the fast engine to 1e-9, of the exact model
// to the last of its 15 decimals and with the same clauses. Then faults of input, worked out by hand.
import assert from 'node:assert';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { Engine } from '../../playground/engine.mjs';

const [module, corpus, seed = '1'] = process.argv.slice(2);
if (!existsSync(module)) {
  console.log('the module is not there: `./dev playground` builds it');
  process.exit(77);
}
const engine = new Engine(readFileSync(module));
const whole = process.env.TOOLCOMP_TESTS_WHOLE !== undefined;
const WIDTH = 1e-9;

const files = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? files(join(folder, entry.name)) : entry.name.endsWith('.jsonl') ? [join(folder, entry.name)] : [],
  );
const chosen = (id) => whole || createHash('sha256').update(`${seed} ${id}`).digest()[0] < 256 / 20;
const lines = (text) => text.split('\n').filter(Boolean).map((line) => JSON.parse(line));
const events = (text) => lines(text).filter(({ kind }) => !['note', 'said'].includes(kind));

// What differs, as "[path, expected, actual]"; of a number expected is its decimal `v`.
function difference(expected, actual, width, path = '') {
  if (typeof expected !== 'object' || expected === null) return expected === actual ? null : [path, expected, actual];
  if (typeof actual === 'number' && 'v' in expected) {
    const value = Number(expected.v);
    return Math.abs(actual - value) <= width * Math.max(1, Math.abs(value)) ? null : [path, expected.v, actual];
  }
  if (typeof actual !== 'object' || actual === null) return [path, expected, actual];
  for (const key of new Set([...Object.keys(expected), ...Object.keys(actual)])) {
    // The fast engine names no clauses, and the corpus has no texts of ours.
    if ((key === 'clauses' && !(key in actual)) || key === 'message') continue;
    // Two radii of an arc that differ by less than doubles tell are one to the fast engine, here as elsewhere.
    if (key === 'radius' && !(key in actual) && width && Math.abs(expected[key][0].v - expected[key][1].v) <= width) continue;
    const found = difference(expected[key], actual[key], width, `${path}.${key}`);
    if (found) return found;
  }
  return null;
}

const counts = { vectors: 0, events: 0, alarms: 0 };
const faults = [];
for (const file of files(corpus).sort())
  for (const vector of lines(readFileSync(file, 'utf8'))) {
    if (!chosen(vector.id)) continue;
    ++counts.vectors;
    for (const [name, width] of [['fast', WIDTH], ['model', 0]]) {
      const run = events(engine.run(vector.program, JSON.stringify(vector.setup), { engine: name, samples: vector.samples ?? 0 }));
      const found = difference(vector.expect, run, width);
      if (found) faults.push(`${vector.id} ${name}: ${found.map((part) => JSON.stringify(part)).join(' ')}`);
    }
    counts.events += vector.expect.length;
    counts.alarms += vector.expect.filter(({ kind }) => kind === 'alarm').length;
  }

// A TOML text that is none: `=` without a value, in line 2.
const setup = 'control = "fanuc"\naxes = ["X", "Y", "Z"]\n';
const [fault] = lines(engine.run('N10 G01 X1.', 'control = "fanuc"\naxes =\n'));
assert.deepEqual([fault.kind, fault.in, fault.line], ['fault', 'setup', 2]);
// No control has two axes X; a parameter that is none.
for (const wrong of ['control = "fanuc"\naxes = ["X", "X"]\n', `${setup}[parameters]\n99999 = 1\n`])
  assert.deepEqual(lines(engine.run('N10 G01 X1.', wrong)).map(({ kind, in: place }) => [kind, place]), [['fault', 'setup']]);
// An arc of R 10 over a chord of 40 is none, and its alarm says by which clause.
const said = lines(engine.run('N10 G90 G17 G01 X10. F100\nN20 G03 X50. R10.\n', setup)).filter(({ kind }) => kind === 'said');
assert.deepEqual(said.map(({ what, number, line }) => [what, number, line]), [['alarm', 'PS0020', 2]]);
assert.ok(said[0].clause_text.startsWith(`${said[0].clause}\n`) && said[0].clause_text.includes('source'));
// What may have been meant by a word (tests/command_line/spoiled.cpp has the words of each).
const [comma] = lines(engine.run('N10 G01 X1,5 F100\n', setup)).filter(({ kind }) => kind === 'said');
assert.ok(comma.text.includes(', "X1,5": a comma') && comma.column === 11, JSON.stringify(comma));
// 9,999 calls of three blocks are too many for exact numbers, not for the fast engine: that gives 2 x 9,999 and more.
const calls = 'O0001\nG91 G01 F100\nM98 P2 L9999\nM30\nO0002\nX1.\nX-1.\nM99\n';
assert.ok(lines(engine.run(calls, setup)).some(({ kind, text }) => kind === 'fault' && text.includes('20000')));
assert.equal(events(engine.run(calls, setup, { engine: 'fast' })).filter(({ kind }) => kind === 'move').length, 2 * 9999);

console.log(counts);
assert.deepEqual(faults.slice(0, 20), []);
assert.ok(counts.vectors > 100 && counts.alarms > 5, 'a sample that says something');
