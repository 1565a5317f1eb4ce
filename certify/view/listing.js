// SPDX-License-Identifier: Apache-2.0
// The text of the program beside the drawing: the block selected, marks of alarms, a search. Of a long text only the
// lines that are seen are there.
import { element } from './words.js';

const ROW = 22; // pixels, as view.css has it
const MARGIN = 2; // rows kept in view before and behind the block selected

// Comments and sequence numbers are for the eye of less weight.
function coloured(text, klartext) {
  const parts = klartext ? /^(\s*\d+ )?([^;]*)(;.*)?$/ : /^(\s*\/?\s*[Nn]\d+)?([^(]*)(.*)$/;
  const [, number = '', words = '', comment = ''] = parts.exec(text) ?? [, '', text];
  return [element('span', { class: 'soft' }, number), words, element('span', { class: 'soft' }, comment)];
}

export class Listing {
  // `select` is called with the number of a block.
  constructor(run, select) {
    this.run = run;
    this.program = run.program;
    this.select = select;
    this.marks = this.findMarks();
    this.rows = new Map(); // by line
    this.block = 0;
    this.found = [];
    this.space = element('div', { class: 'list-space' });
    this.space.style.height = `${this.program.lines.length * ROW}px`;
    this.list = element('div', { class: 'list', role: 'listbox', tabindex: 0, 'aria-label': 'Blocks of the program' }, this.space);
    this.node = element('section', { class: 'bench-list', 'aria-label': 'Program' }, this.search(), ...this.notes(), this.list);
    this.list.addEventListener('scroll', () => this.schedule(), { passive: true });
    this.list.addEventListener('click', (event) => {
      const row = event.target.closest('.row');
      if (row) this.select(this.program.blockAt(Number(row.dataset.line), this.block));
    });
    new ResizeObserver(() => this.show(this.block)).observe(this.list);
  }

  // Alarms and warnings by line.
  findMarks() {
    const marks = new Map();
    for (const { line, alarm, warning } of this.run.steps)
      if (alarm || (warning && marks.get(line) !== 'alarm')) marks.set(line, alarm ? 'alarm' : 'warning');
    return marks;
  }

  // How many lines are seen at once.
  get page() {
    return Math.max(1, Math.floor(this.list.clientHeight / ROW) - 1);
  }

  // Of alarms and warnings, each a way to its block; and of what the page leaves out.
  notes() {
    const out = [];
    const marked = this.run.blocks.map((block, i) => [block, i]).filter(([block]) => block.steps.some((s) => this.run.steps[s].alarm || this.run.steps[s].warning));
    for (const [block, i] of marked.slice(0, 3)) {
      const step = this.run.steps[block.steps.find((s) => this.run.steps[s].alarm || this.run.steps[s].warning)];
      const button = element('button', { type: 'button', class: `note ${step.alarm ? 'alarm' : 'warning'}` }, `line ${block.line}: ${step.what}`);
      button.addEventListener('click', () => this.select(i));
      out.push(button);
    }
    if (marked.length > 3) out.push(element('p', { class: 'note' }, `and ${marked.length - 3} more blocks with an alarm or a warning, marked in the list`));
    if (this.program.more)
      out.push(
        element('p', { class: 'note' },
          `The program has ${(this.run.blocks.length + this.program.more).toLocaleString('en')} blocks. You can step through the first ${this.run.blocks.length.toLocaleString('en')}; the others are dim. The printed picture shows all of them.`),
      );
    return out;
  }

  search() {
    this.field = element('input', { type: 'search', placeholder: 'Search: text, N50 or a line  ( / )', 'aria-label': 'Search a block by text, sequence number or line', spellcheck: 'false', autocomplete: 'off' });
    this.hits = element('output', { class: 'soft' });
    this.field.addEventListener('input', () => this.look());
    this.field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.next(event.shiftKey ? -1 : 1);
      else if (event.key === 'Escape') this.leave();
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    return element('div', { class: 'search', role: 'search' }, this.field, this.hits);
  }

  // Where the search begins is where it was opened.
  focusSearch() {
    this.from = this.block;
    this.field.focus();
    this.field.select();
  }

  leave() {
    this.field.value = '';
    this.found = [];
    this.hits.textContent = '';
    this.list.focus();
    this.schedule();
  }

  look() {
    this.found = this.program.find(this.field.value);
    const from = this.from ?? this.block;
    const hit = this.found.find((i) => i >= from) ?? this.found[0];
    if (hit !== undefined) this.select(hit);
    this.count();
    this.schedule();
  }

  next(by) {
    const { found } = this;
    if (!found.length) return;
    const behind = found.findIndex((i) => i > this.block);
    const at = by > 0 ? (behind < 0 ? 0 : behind) : found.filter((i) => i < this.block).length - 1;
    this.select(found[(at + found.length) % found.length]);
    this.from = this.block;
    this.count();
  }

  count() {
    const at = this.found.indexOf(this.block);
    const text = at < 0 ? `${this.found.length}` : `${at + 1} of ${this.found.length}`;
    this.hits.textContent = this.field.value.trim() === '' ? '' : this.found.length ? text : 'none';
  }

  schedule() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  // With the block selected in view.
  show(block) {
    this.block = block;
    const { line } = this.program.blocks[block] ?? { line: 1 };
    const top = (line - 1) * ROW;
    const { scrollTop, clientHeight } = this.list;
    const margin = clientHeight > 8 * ROW ? MARGIN * ROW : 0;
    const low = top - margin;
    const high = top + ROW + margin - clientHeight;
    if (scrollTop > low + 4 * ROW || scrollTop < high - 4 * ROW) this.list.scrollTop = top - (clientHeight - ROW) / 2;
    else if (scrollTop > low) this.list.scrollTop = low;
    else if (scrollTop < high) this.list.scrollTop = high;
    this.count();
    this.draw();
  }

  draw() {
    const { lines, blocks } = this.program;
    const block = blocks[this.block];
    const first = Math.max(1, Math.floor(this.list.scrollTop / ROW) - 5);
    const last = Math.min(lines.length, Math.ceil((this.list.scrollTop + this.list.clientHeight) / ROW) + 5);
    const wanted = new Set();
    for (let line = first; line <= last; ++line) wanted.add(line);
    if (block) wanted.add(block.line);
    for (const [line, row] of this.rows)
      if (!wanted.has(line)) {
        row.remove();
        this.rows.delete(line);
      }
    const found = new Set(this.found.map((i) => blocks[i].line));
    const end = block ? this.program.end(this.block) : 0;
    for (const line of wanted) {
      if (!this.rows.has(line)) this.rows.set(line, this.space.appendChild(this.row(line)));
      const row = this.rows.get(line);
      const selected = block && line >= block.line && line < end;
      row.classList.toggle('selected', Boolean(selected));
      row.classList.toggle('found', found.has(line));
      row.setAttribute('aria-selected', Boolean(block && line === block.line));
    }
    if (block) this.list.setAttribute('aria-activedescendant', `line-${block.line}`);
  }

  row(line) {
    const text = this.program.lines[line - 1];
    const mark = this.marks.get(line);
    const file = this.program.files.get(line);
    const row = element(
      'div',
      { class: 'row', role: 'option', id: `line-${line}`, 'data-line': line, 'aria-setsize': this.program.lines.length, 'aria-posinset': line },
      element('i', {}, line),
      element('span', { class: 'text' }, ...coloured(text, this.program.klartext)),
    );
    if (file) row.append(element('small', { class: 'file' }, file));
    if (mark) row.append(element('b', { class: mark, title: mark, role: 'img', 'aria-label': mark }, mark === 'alarm' ? '●' : '▲'));
    if (!this.program.at.has(line)) row.classList.add('idle');
    row.style.transform = `translateY(${(line - 1) * ROW}px)`;
    return row;
  }
}
