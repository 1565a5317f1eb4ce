// SPDX-License-Identifier: Apache-2.0
// Numbers as the page has them (number_words.h), as elements.
import { element } from './words.js';

const FORM = /^(\?|.*?)(?:([=#~?])(.*))?$/;

// [decimals, what is said besides, whether the decimals are the value itself].
export function read(text, digits) {
  const [, value, kind, rest] = FORM.exec(text);
  const half = `± 5e-${digits + 1}`;
  if (text === '?') return ['unknown', 'no digits could be certified', false];
  switch (kind) {
    case '=':
      return [value, `= ${rest}`, false];
    case '#':
      return [value, `${half}; a fraction of ${rest} characters`, false];
    case '~':
      return [value, half, false];
    case '?':
      return [value, 'about: its digits could not be certified', false];
    default:
      return [value, '', true];
  }
}

export const exact = (text, digits) => {
  const [value, more] = read(text, digits);
  return more ? `${value} ${more}` : value;
};

const NAMES = {
  programmed: 'programmed',
  point: 'tool point',
  vector: 'vector, programmed to tool point',
  axes: 'axes, positions that they are sent to',
  machine: 'machine coordinates',
  tool_axis: 'tool axis, tip to holder',
  center: 'centre of the arc',
  sweep: 'sweep, degrees',
  radius: 'radius of the arc',
  end_radius: 'radius at the end of the arc',
  feed: 'feed',
  value: 'value',
  tool_center: 'centre of the tool',
  shift: 'shift of the tip',
  tool_shift: 'shift by the deltas',
  carrier: 'carrier',
  contact: 'contact',
  normal: 'surface normal',
  angle: 'contact angle, degrees',
};

// The letters of a field that are not, number for number, those of another one.
function lettersOf([, letters, texts], like) {
  if (!like) return texts.map((_, i) => i);
  const other = new Map([...like[1]].map((letter, i) => [letter, like[2][i]]));
  const differs = [...letters].map((letter, i) => (other.get(letter) === texts[i] ? -1 : i)).filter((i) => i >= 0);
  // Some alike, some not: all of them, but for axes that the other cannot have.
  return differs.every((i) => !other.has(letters[i])) ? differs : [...letters].map((_, i) => i);
}

const LIKE = {
  point: ['programmed', 'as programmed'],
  axes: ['point', 'as the tool point'],
  machine: ['axes', 'as the axes'],
};

function rowsOf(field, only, digits) {
  const [, letters, texts, doubles, ulps] = field;
  return only.map((i) => {
    const [value, more] = read(texts[i], digits);
    const cell = element('td', {}, value);
    if (more) cell.append(' ', element('small', {}, more));
    const off = ulps ? ulps[i] : 0;
    const double = doubles ? doubles[i] : 0;
    return element(
      'tr',
      {},
      element('th', { scope: 'row' }, letters[i] ?? ''),
      cell,
      element('td', { class: 'double' }, double === 0 ? texts[i] : (double ?? '')),
      element('td', { class: off ? 'ulp off' : 'ulp' }, double === null ? '' : off > 0 ? `+${off}` : `${off ?? '?'}`),
    );
  });
}

// The numbers of an event; those that are as others are only said to be so.
export function numbersTable(fields, digits) {
  if (!fields.length) return [];
  const by = new Map();
  for (const [name, letters, ...rest] of fields)
    by.set(name, [name, letters, ...(typeof rest[0] === 'string' ? by.get(rest[0]).slice(2) : rest)]);
  const table = element(
    'table',
    { class: 'numbers' },
    element('thead', {}, element('tr', {}, ...['', 'exact', 'double', 'ulp'].map((name) => element('th', { scope: 'col' }, name)))),
  );
  for (const field of by.values()) {
    const [like, words] = LIKE[field[0]] ?? [];
    const other = by.get(like);
    const only = lettersOf(field, other);
    const said = other && only.length < field[1].length ? words : '';
    const name = element('th', { colspan: 4, scope: 'rowgroup' }, NAMES[field[0]] ?? field[0]);
    if (said) name.append(element('span', { class: 'soft' }, `: ${[...field[1]].filter((_, i) => !only.includes(i)).join(' ')} ${said}`));
    table.append(element('tbody', {}, element('tr', { class: 'field' }, name), ...rowsOf(field, only, digits)));
  }
  return [table];
}
