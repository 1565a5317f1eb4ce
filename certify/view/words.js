// SPDX-License-Identifier: Apache-2.0
// What is said of a step beside the drawing, as elements: its text is never read as markup.
import { length, minus } from './run.js';

export function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

export const number = (x) => {
  const text = Number(x.toFixed(6)).toString();
  return text === '-0' ? '0' : text;
};

const KNOWN = { mm: ['µm', 1000], inch: ['µin', 1e6] };

// A distance that may be far below a micrometre.
export function small(x, unit) {
  const [name, factor] = KNOWN[unit] ?? [unit, 1];
  return `${Number((x * factor).toPrecision(3))} ${name}`;
}

function place(name, p) {
  return element('tr', {}, element('th', { scope: 'row' }, name), ...p.map((x) => element('td', { class: 'n' }, number(x))));
}

function places(run, index) {
  const step = run.steps[index];
  const rows = element('tbody');
  const add = (name, p) => rows.append(place(name, p));
  if (step.programmed) add('programmed', run.place('programmed', index));
  if (step.point) add('exact point', run.place('point', index));
  if (step.programmed && step.point) add('vector', minus(run.place('point', index), run.place('programmed', index)));
  if (step.axes && run.shown.includes('axes')) add('exact axes', run.place('axes', index));
  if (step.other) add(run.names.other, run.place('other', index));
  const deviation = run.deviation(index);
  if (deviation) add('off by', deviation);
  if (step.tool_axis) add('tool axis', step.tool_axis);
  const head = ['', 'X', 'Y', 'Z'].map((name) => element('th', { scope: 'col', class: 'n' }, name));
  return rows.children.length
    ? element('table', {}, element('thead', {}, element('tr', {}, ...head)), rows)
    : element('span');
}

export function toolWords(run, index) {
  const shape = run.tools[run.steps[index].tool];
  if (!shape) return 'The radius of the tool is not known here. The tool is drawn as a pointer.';
  let text = `Tool of ${shape.name}: radius ${number(shape.radius)}`;
  if (shape.corner) text += `, corner radius ${number(shape.corner)}`;
  return `${text}${shape.length ? `, length ${number(shape.length)}` : ''} ${run.unit}.`;
}

export function describe(run, index) {
  const step = run.steps[index];
  const name = step.n === undefined ? `Line ${step.line}` : `N${step.n}, line ${step.line}`;
  const out = [element('p', {}, element('b', {}, name), `: ${step.what}`)];
  if (step.text) out.push(element('pre', {}, step.text));
  out.push(places(run, index));
  const deviation = run.deviation(index);
  if (deviation && length(deviation) > 0)
    out.push(element('p', {}, `${run.names.other} is ${small(length(deviation), run.unit)} off here.`));
  out.push(element('p', { class: 'soft' }, toolWords(run, index)));
  const clauses = (step.clauses ?? []).map((i) => run.clauses[i]);
  if (clauses.length)
    out.push(
      element('p', {}, 'Clauses, the deciding one last:'),
      element('ul', {}, ...clauses.map(([id, text]) => element('li', {}, element('code', {}, id), ` ${text}`))),
    );
  return out;
}
