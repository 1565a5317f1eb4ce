// SPDX-License-Identifier: Apache-2.0
// The keys, in a dialog.
import { element } from './words.js';

const KEYS = [
  ['arrows', 'the block before and after'],
  ['Home, End', 'the first and the last block'],
  ['page up, page down', 'one page of the list up and down'],
  [', and .', 'the move before and after, in a block of several moves'],
  ['/', 'search: text, N50 or a line; Enter and Shift+Enter go to the next and the previous hit, Escape ends the search'],
  ['Shift and arrows; dragging', 'turn'],
  ['Shift and dragging; right button', 'move'],
  ['+ −; the wheel', 'zoom'],
  ['[ ]', 'deviations drawn smaller and larger'],
  ['1 2 3', 'from the top, the front, the corner'],
  ['?', 'these keys'],
];

export function helpDialog() {
  const close = element('button', { type: 'button' }, 'Close');
  const rows = KEYS.map(([keys, what]) => element('tr', {}, element('th', { scope: 'row' }, keys), element('td', {}, what)));
  const dialog = element(
    'dialog',
    { class: 'help', 'aria-label': 'Keys' },
    element('h2', {}, 'Keys'),
    element('table', {}, element('tbody', {}, ...rows)),
    element('p', { class: 'soft' }, 'A number without ± is the exact value. “ulp” counts by how many doubles the fast engine differs from the two doubles next to the exact value. When the numbers next to the drawing have the focus, up and down scroll them.'),
    close,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
