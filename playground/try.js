// SPDX-License-Identifier: Apache-2.0
// The page to try toolcomp. In the page this script is the frame around the page of a program (certify/view), which the
// module makes; in a worker, of the same text, it is what runs the module.
import { Engine } from './engine.mjs';

const REST = 350; // milliseconds without a key before a run begins
const MOST_TEXT = 4e6; // characters of what a link holds

function work() {
  let engine;
  self.onmessage = ({ data }) => {
    if (data.module) engine = new Engine(data.module);
    else self.postMessage(engine.run(data.program, data.setup, data.options));
  };
}

// --- links: what stands behind # --------------------------------------------------------------------------------

async function through(bytes, stream, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    size += part.value.length;
    if (size > most) throw new Error('too long');
    parts.push(part.value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

async function packed(state) {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(state)), new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return `z=${btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '')}`;
}

async function unpacked(hash) {
  const bytes = bytesOf(hash.slice(2).replace(/-/g, '+').replace(/_/g, '/'));
  const { program, setup, samples = 0 } = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw'), MOST_TEXT)));
  if (typeof program !== 'string' || typeof setup !== 'string') throw new Error('no texts');
  return { program, setup, samples: Number(samples) || 0 };
}

// --- the page ---------------------------------------------------------------------------------------------------

const $ = (id) => document.getElementById(id);

function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

// The module counts columns in bytes.
const inCharacters = (line, column) => new TextDecoder().decode(new TextEncoder().encode(line).subarray(0, column - 1)).length + 1;

const inAttribute = (text) => text.replace(/[&"<>]/g, (c) => `&#${c.charCodeAt(0)};`);

class Page {
  constructor(examples) {
    this.examples = examples;
    this.code = URL.createObjectURL(new Blob([$('code').textContent], { type: 'text/javascript' }));
    for (const folder of new Set(examples.map(({ group }) => group))) {
      const group = element('optgroup', { label: folder });
      for (const [i, example] of examples.entries())
        if (example.group === folder) group.append(element('option', { value: i }, example.title));
      $('examples').append(group);
    }
    $('examples').addEventListener('change', () => this.show(this.examples[$('examples').value]));
    for (const id of ['program', 'setup', 'samples'])
      $(id).addEventListener('input', () => {
        $('examples').value = '';
        this.soon(REST);
      });
    $('stop').addEventListener('click', () => this.stop('stopped'));
    $('share').addEventListener('click', () => this.share());
    window.addEventListener('hashchange', () => this.open());
  }

  async begin() {
    this.module = await through(bytesOf($('module').textContent.trim()), new DecompressionStream('gzip'));
    await this.open();
  }

  get state() {
    return { program: $('program').value, setup: $('setup').value, samples: Number($('samples').value) || 0 };
  }

  // What the address asks for, or the first example.
  async open() {
    const hash = decodeURIComponent(window.location.hash.slice(1));
    if (hash && hash === this.hash) return;
    const example = this.examples.find(({ name }) => name === hash);
    if (example || !hash.startsWith('z=')) {
      this.show(example ?? this.examples[0]);
      return;
    }
    try {
      this.show(await unpacked(hash));
    } catch {
      this.status('This link holds no program and setup that can be read.');
    }
  }

  show({ program, setup, samples = 0 }) {
    $('program').value = program;
    $('setup').value = setup;
    $('samples').value = samples;
    const known = this.examples.findIndex((example) => example.program === program && example.setup === setup);
    $('examples').value = known < 0 || samples ? '' : known;
    this.kept = null;
    this.fresh = true;
    this.soon(0);
  }

  status(text) {
    $('status').textContent = text;
  }

  soon(rest) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.run(), rest);
  }

  stop(why) {
    if (!this.worker || !this.busy) return;
    this.worker.terminate();
    this.worker = null;
    this.busy = false;
    $('stop').hidden = true;
    if (why) this.status(why);
  }

  // Only the latest texts count: a run that is not done is given up.
  run() {
    this.stop('');
    if (!this.worker) {
      this.worker = new Worker(this.code);
      this.worker.postMessage({ module: this.module });
    }
    const begun = performance.now();
    const { program, setup, samples } = this.state;
    const known = this.examples[$('examples').value];
    const name = known ? known.file : 'program';
    this.busy = true;
    const slow = setTimeout(() => {
      if (!this.busy) return;
      this.status('runs …');
      $('stop').hidden = false;
    }, 400);
    this.worker.onmessage = ({ data }) => {
      clearTimeout(slow);
      this.busy = false;
      $('stop').hidden = true;
      this.take(data, performance.now() - begun);
    };
    this.worker.onerror = (event) => {
      clearTimeout(slow);
      this.stop(`internal error: ${event.message}`);
    };
    this.worker.postMessage({ program, setup, options: { page: true, samples, name } });
    this.remember();
  }

  take(text, milliseconds) {
    const said = [];
    const events = [];
    let page = null;
    for (const line of text.split('\n')) {
      if (!line) continue;
      const json = JSON.parse(line);
      if (json.kind === 'page') page = json.html;
      else if (['said', 'note', 'fault'].includes(json.kind)) said.push(json);
      else events.push(line);
    }
    const fault = said.some(({ kind }) => kind === 'fault');
    $('says').replaceChildren(...said.map((json) => this.saying(json)));
    $('events').textContent = events.join('\n');
    $('events-count').textContent = events.length.toLocaleString('en');
    this.status(fault ? 'cannot be run' : `${events.length.toLocaleString('en')} events in ${Math.round(milliseconds).toLocaleString('en')} ms`);
    $('frame').classList.toggle('old', fault);
    if (page) this.draw(page);
  }

  // The page of the program, at the block and seen from where it was.
  draw(html) {
    const figure = $('frame').contentDocument?.querySelector('figure.view');
    const kept = this.fresh ? null : figure?.state?.();
    this.fresh = false;
    $('frame').srcdoc = kept ? html.replace('<html ', `<html data-kept="${inAttribute(JSON.stringify(kept))}" `) : html;
  }

  // Where it is, what it says, and the clause behind it.
  saying({ kind, what = kind, in: place = 'program', line, column: byte, number, text, more, clause, clause_text: words }) {
    const area = place === 'setup' ? $('setup') : $('program');
    const column = inCharacters(area.value.split('\n')[line - 1] ?? '', byte ?? 1);
    const item = element('li', { class: what });
    const at = [place === 'setup' ? 'setup' : '', line && `line ${line}`, column > 1 && `column ${column}`].filter(Boolean).join(' ');
    if (at) {
      const button = element('button', { type: 'button' }, at);
      button.addEventListener('click', () => this.go(area, line, column));
      item.append(button, ' ');
    }
    item.append(element('b', {}, [what.replace('_', ' '), number].filter(Boolean).join(' ')), ` ${text}${more ? `: ${more}` : ''}`);
    if (clause) item.append(element('details', {}, element('summary', {}, 'clause ', element('code', {}, clause)), element('pre', {}, words)));
    return item;
  }

  // To a line of a text.
  go(area, line, column) {
    const lines = area.value.split('\n');
    const from = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    const length = (lines[line - 1] ?? '').length;
    area.closest('details')?.setAttribute('open', '');
    area.focus();
    area.setSelectionRange(from + Math.min(column - 1, length), from + length);
    area.scrollTop = (line - 4) * (area.scrollHeight / lines.length);
  }

  async link() {
    const example = this.examples[$('examples').value];
    return example ? example.name : packed(this.state);
  }

  async remember() {
    this.hash = await this.link();
    try {
      window.history.replaceState(null, '', `#${this.hash}`);
    } catch {
      // Some browsers do not have that of a file: the button gives the link.
    }
  }

  async share() {
    const address = `${window.location.href.replace(/#.*/, '')}#${await this.link()}`;
    $('link').hidden = false;
    $('link').value = address;
    $('link').focus();
    $('link').select();
    try {
      await navigator.clipboard.writeText(address);
      this.status('The link is copied: it holds the program and the setup.');
    } catch {
      this.status('Copy the link: it holds the program and the setup.');
    }
  }
}

if (typeof document === 'undefined') work();
else new Page(JSON.parse($('all-examples').textContent)).begin();
