// SPDX-License-Identifier: Apache-2.0
// A served page: comes again when its server says that the program has changed, at the block where it was.

const KEY = 'toolcomp view';

export class Live {
  constructor(state) {
    this.state = state; // gives what is to be kept, or nothing
    const { live } = document.documentElement.dataset;
    if (!live) return;
    const badge = document.createElement('p');
    badge.className = 'gone';
    badge.setAttribute('role', 'status');
    badge.hidden = true;
    badge.textContent = 'The server has ended. This is the last page that it served.';
    document.body.append(badge);
    const source = new EventSource('/events');
    source.onmessage = ({ data }) => {
      badge.hidden = true;
      if (data === live) return;
      source.close();
      this.keep();
      window.location.reload();
    };
    source.onerror = () => {
      badge.hidden = false;
    };
    window.addEventListener('pagehide', () => this.keep());
  }

  keep() {
    const state = this.state();
    if (state) sessionStorage.setItem(KEY, JSON.stringify(state));
  }

  // What was kept by the page before this one, or what the page around this one (playground/) has kept of it.
  static kept() {
    const { live, kept } = document.documentElement.dataset;
    if (!live && !kept) return null;
    try {
      return JSON.parse(kept ?? sessionStorage.getItem(KEY));
    } catch {
      return null;
    }
  }
}

// The block of the new program that is the old one: the same text, the nearest line of those; else the same sequence
// number; else the line.
export function sameBlock(run, { block, line, n, text }) {
  const { program } = run;
  const nearest = (list) => list.reduce((best, i) => (distance(i) < distance(best) ? i : best), list[0]);
  const distance = (i) => Math.abs(run.blocks[i].line - line) + Math.abs(i - block) / 1e6;
  const all = run.blocks.map((_, i) => i);
  const sameText = all.filter((i) => program.text(i) === text);
  if (sameText.length) return nearest(sameText);
  const sameNumber = n === undefined ? [] : all.filter((i) => run.blocks[i].n === n);
  return sameNumber.length ? nearest(sameNumber) : program.blockAt(line, block);
}
