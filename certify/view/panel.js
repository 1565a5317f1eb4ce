// SPDX-License-Identifier: Apache-2.0
// The frame around a drawing: buttons, keys, mouse, and the words on what is selected. A page of a program has its blocks
// beside it.
import { describeBlock, sayBlock } from './details.js';
import { helpDialog } from './help.js';
import { Listing } from './listing.js';
import { Live, sameBlock } from './live.js';
import { Space, canDraw } from './space.js';
import { describe, element } from './words.js';

const MOST = 6; // deviations are drawn up to 10^6 times as large

const HELP =
  'Left and right: blocks; Home, End: first and last. Shift and arrows, or drag: turn. + and −, or the wheel: zoom. ' +
  '[ and ]: deviations smaller and larger. 1 top, 2 front, 3 corner.';

export class Panel {
  constructor(figure, run) {
    this.run = run;
    this.figure = figure;
    this.hidden = new Set();
    this.block = run.marked;
    this.build();
    if (canDraw()) this.space = new Space(this.canvas, run);
    this.exponent = this.fittingExponent();
    if (this.slider) this.slider.value = this.exponent;
    this.listen();
    if (run.program) this.resume();
    this.select(this.block);
  }

  // The step behind which the tool is drawn.
  get index() {
    return this.step ?? this.run.blocks[this.block]?.last ?? -1;
  }

  build() {
    const { program } = this.run;
    const label = this.figure.getAttribute('aria-label');
    this.canvas = element('canvas', { tabindex: 0, role: 'application', 'aria-label': `${label}. ${HELP}` });
    // As wide as its longest text: nothing moves while blocks are stepped through.
    const most = this.run.blocks.length.toLocaleString('en').length;
    this.count = element('output', { class: 'view-count', style: `min-width: ${2 * most + 4}ch` });
    this.words = element('div', { class: 'view-words', tabindex: 0 });
    const button = (name, text, action) => {
      const node = element('button', { type: 'button', 'aria-label': name, title: name }, text);
      node.addEventListener('click', action);
      return node;
    };
    const steps = element(
      'div',
      { class: 'view-bar' },
      button('first block', '|◀', () => this.select(0)),
      button('previous block', '◀', () => this.select(this.block - 1)),
      button('next block', '▶', () => this.select(this.block + 1)),
      button('last block', '▶|', () => this.select(Infinity)),
      this.count,
    );
    if (canDraw())
      steps.append(...['top', 'front', 'corner'].map((from) => button(`seen from the ${from}`, from, () => this.look(from))));
    const live = element('div', { class: 'view-live' });
    const drawing = canDraw() ? this.canvas : this.figure.querySelector('.picture').cloneNode(true);
    const space = element('div', { class: 'view-space' }, drawing, steps);
    if (canDraw()) space.append(this.legend());
    if (program) {
      this.listing = new Listing(this.run, (block) => this.select(block));
      this.said = element('p', { class: 'unseen', 'aria-live': 'polite' });
      this.help = helpDialog();
      steps.append(button('keys', '?', () => this.help.showModal()));
      this.words.setAttribute('role', 'region');
      this.words.setAttribute('aria-label', 'The block selected');
      live.classList.add('bench');
      live.append(this.listing.node, space, this.words, this.said, this.help);
    } else {
      this.words.setAttribute('aria-live', 'polite');
      live.append(space, this.words);
    }
    this.figure.append(live);
    this.figure.classList.add('live');
  }

  // The courses, each to be switched off and on, and how large deviations are drawn.
  legend() {
    const bar = element('div', { class: 'view-bar' });
    for (const course of this.run.shown) {
      const box = element('input', { type: 'checkbox' });
      box.checked = true;
      box.addEventListener('change', () => {
        if (box.checked) this.hidden.delete(course);
        else this.hidden.add(course);
        this.draw();
      });
      const line = element('span', { class: `view-line view-${course}` });
      bar.append(element('label', {}, box, line, this.run.names[course]));
    }
    if (this.run.recorded.length) bar.append(element('label', {}, element('span', { class: 'view-line view-recorded' }), 'recording'));
    if (this.run.largest > 0) {
      this.slider = element('input', { type: 'range', min: 0, max: MOST, step: 0.25, 'aria-label': 'enlargement of the deviations' });
      this.slider.addEventListener('input', () => this.exaggerate(Number(this.slider.value)));
      this.times = element('output', {});
      bar.append(element('label', {}, 'deviations', this.slider, this.times));
    }
    if (!this.run.program) bar.append(element('small', { class: 'soft' }, HELP));
    return bar;
  }

  // So that the largest deviation is seen and does not fill the drawing.
  fittingExponent() {
    if (!(this.run.largest > 0) || !this.space) return 0;
    return Math.max(0, Math.min(MOST, Math.floor(Math.log10((this.space.size * 0.3) / this.run.largest))));
  }

  get factor() {
    return Number((10 ** this.exponent).toPrecision(2));
  }

  listen() {
    (this.run.program ? document : this.figure).addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('wheel', (event) => {
      // A page that is scrolled past it scrolls on.
      if (document.activeElement !== this.canvas) return;
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15);
    }, { passive: false });
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.focus();
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!event.buttons) return;
      const { space } = this;
      if (event.buttons === 1 && !event.shiftKey) space.orbit(-event.movementX / 2, event.movementY / 2);
      else space.shift = [space.shift[0] + event.movementX, space.shift[1] + event.movementY];
      this.draw();
    });
    this.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    document.addEventListener('view-lost', () => this.lose());
  }

  // The browser has taken its context away: the picture is there.
  lose() {
    if (!this.run.program) this.figure.classList.remove('live');
    else if (this.space) this.canvas.replaceWith(this.figure.querySelector('.picture').cloneNode(true));
    this.space = undefined;
  }

  // Where an address or the page before says so: "#120" is a line, "#N50" a sequence number.
  resume() {
    const { program, blocks } = this.run;
    const live = new Live(() => this.state());
    this.figure.state = () => this.state(); // for the page around this one
    const kept = Live.kept();
    if (kept) this.restore(kept);
    else if (/^#N?\d+$/.test(window.location.hash)) {
      const wanted = window.location.hash.slice(1);
      const found = wanted[0] === 'N' ? program.find(wanted) : [program.blockAt(Number(wanted), 0)];
      if (found.length) [this.block] = found;
    }
    this.live = live;
    if (!blocks.length) this.block = 0;
  }

  // What a page that comes again is to keep.
  state() {
    const { program, blocks } = this.run;
    const block = blocks[this.block];
    if (!block) return null;
    const { around, above, zoom, shift } = this.space ?? {};
    return { block: this.block, line: block.line, n: block.n, text: program.text(this.block), seen: { around, above, zoom, shift }, hidden: [...this.hidden] };
  }

  restore(kept) {
    if (this.run.blocks.length) this.block = sameBlock(this.run, kept);
    if (!this.space || kept.seen.around === undefined) return;
    Object.assign(this.space, kept.seen);
    this.space.fit();
  }

  key(event) {
    // The arrows of a slider are its own, and those of the words scroll; keys with Ctrl and Alt are the browser's.
    if (event.target.tagName === 'INPUT' || event.ctrlKey || event.altKey || event.metaKey) return;
    if (this.help?.open) {
      if (/^(Escape|\?)$/.test(event.key)) this.help.close();
      return;
    }
    if (event.target === this.words && !(this.run.program && /^(Arrow(Left|Right)|.)$/.test(event.key))) return;
    const act = this.turning(event) ?? this.action(event.key);
    if (!act) return;
    event.preventDefault();
    act();
  }

  turning({ key, shiftKey }) {
    const turn = shiftKey && { ArrowLeft: [10, 0], ArrowRight: [-10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] }[key];
    if (!turn) return null;
    return () => {
      this.space?.orbit(...turn);
      this.draw();
    };
  }

  action(key) {
    const here = {
      ArrowLeft: () => this.select(this.block - 1),
      ArrowUp: () => this.select(this.block - 1),
      ArrowRight: () => this.select(this.block + 1),
      ArrowDown: () => this.select(this.block + 1),
      Home: () => this.select(0),
      End: () => this.select(Infinity),
      '+': () => this.zoom(1.25),
      '-': () => this.zoom(0.8),
      '[': () => this.exaggerate(this.exponent - 1),
      ']': () => this.exaggerate(this.exponent + 1),
      1: () => this.look('top'),
      2: () => this.look('front'),
      3: () => this.look('corner'),
    }[key];
    if (here || !this.run.program) return here;
    return {
      PageUp: () => this.select(this.block - this.listing.page),
      PageDown: () => this.select(this.block + this.listing.page),
      ',': () => this.selectStep(-1),
      '.': () => this.selectStep(1),
      '/': () => this.listing.focusSearch(),
      '?': () => this.help.showModal(),
    }[key];
  }

  select(block) {
    const { blocks } = this.run;
    this.step = undefined;
    if (blocks.length) this.block = Math.max(0, Math.min(blocks.length - 1, block));
    this.figure.dataset.block = this.block;
    this.figure.dataset.step = this.index;
    this.draw();
  }

  // Of several moves of the block the one before or after.
  selectStep(by) {
    const { blocks, steps } = this.run;
    const moves = (blocks[this.block]?.steps ?? []).filter((i) => steps[i].programmed || steps[i].axes);
    const at = moves.indexOf(this.index) + by;
    if (at >= 0 && at < moves.length) this.showStep(moves[at]);
  }

  showStep(step) {
    this.step = step;
    this.figure.dataset.step = step;
    this.draw();
  }

  look(from) {
    this.space?.lookFrom(from);
    this.draw();
  }

  zoom(factor) {
    this.space?.enlarge(factor);
    this.draw();
  }

  exaggerate(exponent) {
    if (!this.slider) return;
    this.exponent = Math.max(0, Math.min(MOST, exponent));
    this.slider.value = this.exponent;
    this.draw();
  }

  // In the next frame: of keys that come faster all count, and the last is drawn.
  draw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.tell();
      if (this.times) this.times.textContent = `× ${this.factor.toLocaleString('en')}`;
      const selected = this.step === undefined ? (this.run.blocks[this.block]?.steps ?? []) : [this.step];
      this.space?.draw({ index: this.index, selected, factor: this.factor, hidden: this.hidden });
    });
  }

  // The words, where they are of another block or step than those that are there.
  tell() {
    const { run, block } = this;
    const told = `${block} ${this.step}`;
    if (this.told === told || !run.blocks.length) return;
    this.told = told;
    const rest = run.more && !run.program ? ` (${run.more} more are not shown)` : '';
    this.count.textContent = `${(block + 1).toLocaleString('en')} of ${run.blocks.length.toLocaleString('en')}${rest}`;
    if (!run.program) {
      this.words.replaceChildren(...describe(run, this.index));
      return;
    }
    const focused = this.words.contains(document.activeElement) && document.activeElement !== this.words;
    this.words.replaceChildren(...describeBlock(run, block, this.index, (step) => this.showStep(step)));
    if (focused) (this.words.querySelector('[aria-pressed=true]') ?? this.words).focus();
    if (this.step === undefined) this.words.scrollTop = 0;
    this.listing.show(block);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.settle(), 300);
  }

  // What may wait until the keys rest: what is said aloud, and the address.
  settle() {
    this.said.textContent = sayBlock(this.run, this.block);
    try {
      window.history.replaceState(null, '', `#${this.run.blocks[this.block].line}`);
    } catch {
      // Some browsers do not have that of a file.
    }
  }
}
