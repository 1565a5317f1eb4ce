// SPDX-License-Identifier: Apache-2.0
// The keys, in a dialog.
import { element } from './words.js';

const KEYS = [
  ['arrows', 'the block before and after'],
  ['Home, End', 'the first and the last block'],
  ['page up, page down', 'as many blocks as the list shows'],
  [', and .', 'before and after, of several moves of one block'],
  ['/', 'search: text, N50 or a line; Enter and Shift Enter go on, Escape ends'],
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
    element('p', { class: 'soft' }, 'A number without ± is the value itself. “ulp”: how many doubles the fast engine is off the two next to the exact value. When the list or the numbers beside the drawing have the focus, up and down scroll the numbers.'),
    close,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
