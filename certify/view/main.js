// Brings the views of a page to life, each when it is first seen. Where there is no WebGL the pictures stay.
import { Panel } from './panel.js';
import { Run } from './run.js';
import { canDraw } from './space.js';

function start(figure) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  new Panel(figure, new Run(data));
}

const figures = document.querySelectorAll('figure.view');
if (canDraw()) {
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
