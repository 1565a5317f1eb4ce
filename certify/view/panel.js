// The frame around a drawing: buttons, keys, mouse, and the words on the step selected.
import { Space } from './space.js';
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
    this.index = run.marked;
    this.build();
    this.space = new Space(this.canvas, run);
    this.exponent = this.fittingExponent();
    if (this.slider) this.slider.value = this.exponent;
    this.listen();
    this.select(this.index);
  }

  build() {
    const label = this.figure.getAttribute('aria-label');
    this.canvas = element('canvas', { tabindex: 0, role: 'application', 'aria-label': `${label}. ${HELP}` });
    this.count = element('output', {});
    this.words = element('div', { class: 'view-words', 'aria-live': 'polite', tabindex: 0 });
    const button = (name, text, action) => {
      const node = element('button', { type: 'button', 'aria-label': name, title: name }, text);
      node.addEventListener('click', action);
      return node;
    };
    const steps = element(
      'div',
      { class: 'view-bar' },
      button('first block', '|◀', () => this.select(0)),
      button('previous block', '◀', () => this.select(this.index - 1)),
      button('next block', '▶', () => this.select(this.index + 1)),
      button('last block', '▶|', () => this.select(Infinity)),
      this.count,
      ...['top', 'front', 'corner'].map((from) => button(`seen from the ${from}`, from, () => this.look(from))),
    );
    const live = element('div', { class: 'view-live' });
    live.append(element('div', { class: 'view-space' }, this.canvas, steps, this.legend()), this.words);
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
      this.slider = element('input', { type: 'range', min: 0, max: MOST, step: 0.25, 'aria-label': 'deviations, times as large' });
      this.slider.addEventListener('input', () => this.exaggerate(Number(this.slider.value)));
      this.times = element('output', {});
      bar.append(element('label', {}, 'deviations', this.slider, this.times));
    }
    bar.append(element('small', { class: 'soft' }, HELP));
    return bar;
  }

  // So that the largest deviation is seen and does not fill the drawing.
  fittingExponent() {
    if (!(this.run.largest > 0)) return 0;
    return Math.max(0, Math.min(MOST, Math.floor(Math.log10((this.space.size * 0.3) / this.run.largest))));
  }

  get factor() {
    return Number((10 ** this.exponent).toPrecision(2));
  }

  listen() {
    this.figure.addEventListener('keydown', (event) => this.key(event));
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
    document.addEventListener('view-lost', () => this.figure.classList.remove('live'));
  }

  key(event) {
    // The arrows of a slider are its own, and those of the words scroll; keys with Ctrl and Alt are the browser's.
    if (event.target.tagName === 'INPUT' || event.target === this.words || event.ctrlKey || event.altKey || event.metaKey) return;
    const turn = event.shiftKey && { ArrowLeft: [10, 0], ArrowRight: [-10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] }[event.key];
    if (turn) this.space.orbit(...turn);
    const act = turn
      ? () => this.draw()
      : {
          ArrowLeft: () => this.select(this.index - 1),
          ArrowUp: () => this.select(this.index - 1),
          ArrowRight: () => this.select(this.index + 1),
          ArrowDown: () => this.select(this.index + 1),
          Home: () => this.select(0),
          End: () => this.select(Infinity),
          '+': () => this.zoom(1.25),
          '-': () => this.zoom(0.8),
          '[': () => this.exaggerate(this.exponent - 1),
          ']': () => this.exaggerate(this.exponent + 1),
          1: () => this.look('top'),
          2: () => this.look('front'),
          3: () => this.look('corner'),
        }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  select(index) {
    const { steps, more } = this.run;
    if (steps.length) {
      this.index = Math.max(0, Math.min(steps.length - 1, index));
      const rest = more ? ` (${more} more are not shown)` : '';
      this.count.textContent = `${this.index + 1} of ${steps.length}${rest}`;
      this.words.replaceChildren(...describe(this.run, this.index));
      this.figure.dataset.step = this.index;
    }
    this.draw();
  }

  look(from) {
    this.space.lookFrom(from);
    this.draw();
  }

  zoom(factor) {
    this.space.enlarge(factor);
    this.draw();
  }

  exaggerate(exponent) {
    if (!this.slider) return;
    this.exponent = Math.max(0, Math.min(MOST, exponent));
    this.slider.value = this.exponent;
    this.draw();
  }

  draw() {
    if (this.times) this.times.textContent = `× ${this.factor.toLocaleString('en')}`;
    this.space.draw(this.index, this.factor, this.hidden);
  }
}
