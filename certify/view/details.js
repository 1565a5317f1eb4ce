// SPDX-License-Identifier: Apache-2.0
// What is said of a block beside the drawing: its text, what comes of it with exact numbers, and what decided.
import { exact, numbersTable } from './numbers.js';
import { element, toolWords } from './words.js';

const SIGNS = { '-1': '< 0', 0: '= 0', 1: '> 0' };

function sourceOf({ kind, source }) {
  const page = source.page && (/^[0-9]/.test(source.page) ? `page ${source.page}` : source.page);
  const place = [source.document, source.edition && `(${source.edition})`, page, source.words && `(${source.words})`];
  return [kind, [source.known, ...place].filter(Boolean).join(' ')].join(' · ');
}

// A clause as `toolcomp spec show` has it.
function clauseWords([id, text, more]) {
  const out = [element('p', {}, element('code', {}, id), ' ', element('span', { class: 'kind' }, sourceOf(more))), element('p', {}, text)];
  if (more.formula) out.push(element('p', { class: 'formula' }, more.formula));
  if (more.notation) out.push(element('ul', { class: 'notation' }, ...more.notation.map((t) => element('li', {}, t))));
  if (more.alternatives)
    out.push(element('details', {}, element('summary', {}, 'other readings'), element('ul', {}, ...more.alternatives.map((t) => element('li', {}, t)))));
  return out;
}

function outcome(more, sign) {
  const { positive, negative, tie, true: yes, false: no } = more.outcome_text ?? {};
  return { 1: positive ?? yes, '-1': negative ?? no, 0: tie }[sign] ?? '';
}

function decisionWords([clause, quantity, sign, double, margin, scale], run) {
  const { digits } = run.program;
  const so = outcome(run.clauses[clause][2], sign);
  const out = [element('p', {}, element('b', {}, `${exact(quantity, digits)} ${SIGNS[sign]}`), so ? `: ${so}` : '')];
  const besides = [`double ${double}`];
  if (margin !== undefined) besides.push(`margin ${exact(margin, digits)} of the scale ${exact(scale, digits)}`);
  out.push(element('p', { class: 'soft' }, besides.join(' · ')));
  return out;
}

// Decisions by their clauses, in their order.
function decisions(run, block) {
  const by = new Map();
  for (const decision of block.decisions ?? []) {
    if (!by.has(decision[0])) by.set(decision[0], []);
    by.get(decision[0]).push(decision);
  }
  const items = [...by].map(([clause, list]) =>
    element('li', {}, ...clauseWords(run.clauses[clause]), ...list.map((d) => element('div', { class: 'decision' }, ...decisionWords(d, run)))),
  );
  const out = items.length ? [element('h3', {}, 'Decisions'), element('ul', { class: 'clauses' }, ...items)] : [];
  if (block.more_decisions)
    out.push(element('p', { class: 'soft' }, `${block.more_decisions} more decisions; toolcomp explain prints them.`));
  return [out, by];
}

function otherClauses(run, block, decided) {
  const numbers = new Set(block.steps.flatMap((i) => run.steps[i].clauses ?? []).filter((i) => !decided.has(i)));
  if (!numbers.size) return [];
  return [
    element('h3', {}, decided.size ? 'Other clauses of this block' : 'Clauses of this block'),
    element('ul', { class: 'clauses' }, ...[...numbers].map((i) => element('li', {}, ...clauseWords(run.clauses[i])))),
  ];
}

function eventWords(run, event, step, shown, select) {
  const { what, alarm, warning } = run.steps[step];
  const out = element('section', { class: `event${shown ? ' shown' : ''}` });
  if (alarm || warning) {
    const box = element('p', { class: alarm ? 'callout alarm' : 'callout warning' }, what);
    if (event.permitted?.length) box.append(` – permitted: ${event.permitted.join(', ')}`);
    out.append(box);
  } else if (select) {
    const button = element('button', { type: 'button', class: 'event-name', 'aria-pressed': shown }, what);
    button.addEventListener('click', select);
    out.append(element('h3', {}, button));
  } else out.append(element('h3', {}, what));
  out.append(...numbersTable(event.numbers, run.program.digits));
  for (const name of ['corner', 'measured'])
    if (event[name]) out.append(element('p', { class: 'soft' }, `${name === 'corner' ? 'Corner: ' : ''}${event[name]}.`));
  return out;
}

// `shown`: the step behind which the tool is drawn; `select` chooses another one of the block.
export function describeBlock(run, index, shown, select) {
  const { program } = run;
  const block = run.blocks[index];
  const place = [`line ${block.line}`, program.pass(index)].filter(Boolean).join(', ');
  const out = [
    element('h2', {}, block.n === undefined ? `Line ${block.line}` : `N${block.n}`, ' ', element('small', {}, block.n === undefined ? program.pass(index) : place)),
    element('pre', {}, program.text(index)),
  ];
  const events = block.events ?? [];
  const several = events.filter(({ step }) => run.steps[step].programmed || run.steps[step].axes).length > 1;
  for (const event of events)
    out.push(eventWords(run, event, event.step, several && event.step === shown, several ? () => select(event.step) : null));
  if (!events.length) out.push(element('p', { class: 'soft' }, 'Nothing moves in this block, and nothing is set.'));
  if (block.samples) out.push(element('p', { class: 'soft' }, `${block.samples} samples inside this block; toolcomp run prints them.`));
  if (run.steps[block.last]) out.push(element('p', { class: 'soft' }, toolWords(run, block.last)));
  const [decided, by] = decisions(run, block);
  out.push(...decided, ...otherClauses(run, block, by));
  return out;
}

// In one line, for those who do not see the page.
export function sayBlock(run, index) {
  const block = run.blocks[index];
  const what = block.steps.map((i) => run.steps[i].what).join('; ');
  return `Line ${block.line}: ${run.program.text(index)}${what ? `. ${what}` : ''}`;
}
