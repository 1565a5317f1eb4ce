// SPDX-License-Identifier: Apache-2.0
// A run as the page has it (view.cpp): its courses step by step, and what is measured on them. Points are [x, y, z].
import { Program } from './program.js';

export const plus = (a, k, b) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
export const minus = (a, b) => plus(a, -1, b);
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const last = (list) => list[list.length - 1];

const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// The courses in the order in which they are drawn.
export const COURSES = ['programmed', 'axes', 'point', 'other'];

// The blocks to step through: those of the program, or each step by itself. `steps`: what comes of it, by number;
// `last`: the step behind which the machine is when the block is done, -1 before the first.
function blocksOf({ program, steps }) {
  if (!program) return steps.map((step, i) => ({ line: step.line, n: step.n, steps: [i], last: i }));
  let last = -1;
  return program.blocks.map((block) => {
    const numbers = (block.events ?? []).map((event) => event.step);
    last = Math.max(last, ...numbers);
    return { ...block, steps: numbers, last };
  });
}

export class Run {
  constructor(data) {
    this.program = data.program && new Program(data.program);
    this.blocks = blocksOf(data);
    this.unit = data.unit;
    this.start = data.start;
    this.steps = data.steps;
    this.more = data.more;
    this.marked = data.marked ?? 0;
    this.compared = data.compared;
    this.clauses = data.clauses;
    this.tools = data.tools;
    this.recorded = data.recorded ?? [];
    this.names = {
      programmed: 'programmed',
      point: 'exact: tool point',
      axes: 'exact: axes, with length offset',
      other: data.controller,
    };
    if (!this.has('point')) this.names.programmed = 'programmed and exact';
    this.shown = COURSES.filter((course) => this.has(course));
    this.tipCourse = this.steps.some((step) => step.point) ? 'point' : 'programmed';
    this.largest = this.largestDeviation();
  }

  // Whether the course is there, and another than what stands for it already.
  has(course) {
    if (!this.steps.some((step) => step[course])) return false;
    const isCopyOf = (other) => this.steps.every((step) => same(step[course], step[other]));
    if (course === 'axes') return !isCopyOf('point') && !isCopyOf('programmed');
    return course !== 'point' || !isCopyOf('programmed');
  }

  // Where a course stands behind a step.
  place(course, index) {
    for (let i = index; i >= 0; --i) if (this.steps[i][course]) return last(this.steps[i][course]);
    return this.start;
  }

  // Where the tool point is behind a step.
  tip(index) {
    return this.place(this.tipCourse, index);
  }

  // The points of a step, from where the course was before; null where it does not move. The controller's are as many
  // times as far off as `factor` says.
  line(course, index, factor = 1) {
    const points = this.drawn(course, index, factor);
    if (!points) return null;
    for (let i = index - 1; i >= 0; --i) {
      const before = this.drawn(course, i, factor);
      if (before) return [last(before), ...points];
    }
    return [this.start, ...points];
  }

  drawn(course, index, factor) {
    const step = this.steps[index];
    const points = step[course];
    if (course !== 'other' || !points || factor === 1) return points;
    const exact = step[this.compared];
    if (!exact || exact.length !== points.length) return points;
    return points.map((p, i) => plus(p, factor - 1, minus(p, exact[i])));
  }

  // Of the controller from what it is compared with, at the end of a step; null where one of them is missing.
  deviation(index) {
    const step = this.steps[index];
    const exact = step[this.compared];
    return step.other && exact ? minus(last(step.other), last(exact)) : null;
  }

  largestDeviation() {
    let largest = 0;
    for (let i = 0; i < this.steps.length; ++i) {
      const deviation = this.deviation(i);
      if (deviation) largest = Math.max(largest, length(deviation));
    }
    for (const [at, exact] of this.recorded) largest = Math.max(largest, length(minus(at, exact)));
    return largest;
  }

  // A recorded place, drawn.
  sample(index, factor) {
    const [at, exact] = this.recorded[index];
    return plus(at, factor - 1, minus(at, exact));
  }

  // [lowest, highest] of everything, as it is.
  box() {
    const points = [this.start];
    for (const step of this.steps) for (const course of COURSES) points.push(...(step[course] ?? []));
    for (const [at] of this.recorded) points.push(at);
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const p of points)
      for (let i = 0; i < 3; ++i) {
        low[i] = Math.min(low[i], p[i]);
        high[i] = Math.max(high[i], p[i]);
      }
    return [low, high];
  }
}
