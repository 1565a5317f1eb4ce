// SPDX-License-Identifier: Apache-2.0
// Brings the views of a page to life, each when it is first seen. Where there is no WebGL the pictures stay; a page of a
// program then has its blocks beside them.
import { Live } from './live.js';
import { Panel } from './panel.js';
import { Run } from './run.js';
import { canDraw } from './space.js';

function start(figure) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  new Panel(figure, new Run(data));
}

const program = document.querySelector('figure.view[data-program]');
const figures = document.querySelectorAll('figure.view:not([data-program])');
if (program) start(program);
else if (document.documentElement.dataset.live) new Live(() => null);
if (canDraw() && figures.length) {
  const seen = new IntersectionObserver(
    (entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        seen.unobserve(entry.target);
        start(entry.target);
      }
    },
    { rootMargin: '300px' },
  );
  for (const figure of figures) seen.observe(figure);
}
