// SPDX-License-Identifier: Apache-2.0
// The state of the page in its address: which tab, two shapes and, in the tab of motion, how b moves, in hexadecimal,
// so that a link loses no bit.
//
//   #tab=edge&a=rect,0x0p+0,...&b=ellipse,...
//   #tab=two&a=polygon,0x0p+0,...;0x1p+0,...&b=...
//   #tab=motion&a=...&b=...&motion=0x1p+0,0x0p+0,0x0p+0
import { fields } from '../vesica/vesica.mjs';
import { fromHex, toHex } from './number.mjs';
import { isPath, rings } from './path.mjs';
import { kinds, numbers, withNumbers } from './shape.mjs';

const write = (shape) =>
  isPath(shape)
    ? `${shape.kind},${rings(shape)
        .map((ring) => ring.flat().map(toHex).join(','))
        .join(';')}`
    : [shape.kind, ...numbers(shape).map(toHex)].join(',');

/** Rings are between semicolons. */
function readPath(name, kind, lists) {
  const vertices = [],
    ends = [0];
  for (const list of lists) {
    for (const word of list.split(',')) {
      vertices.push(fromHex(word));
      if (Number.isNaN(vertices.at(-1))) throw new Error(`a corner of ${name} is no hexadecimal number: “${word}”`);
    }
    if (vertices.length % 2 === 1) throw new Error(`a corner of ${name} has one number; it has two`);
    ends.push(vertices.length / 2);
  }
  return { kind, vertices, rings: ends };
}

function readShape(name, text) {
  const [kind, ...words] = text.split(',');
  if (!kinds.includes(kind)) throw new Error(`${name} is of no known kind: “${kind}”`);
  if (isPath({ kind })) return readPath(name, kind, text.slice(kind.length + 1).split(';'));
  const values = words.map(fromHex),
    wanted = fields[kind];
  if (values.length !== wanted.length)
    throw new Error(`${name} has ${values.length} numbers; a ${kind} has ${wanted.length}`);
  const bad = values.findIndex(Number.isNaN);
  if (bad >= 0) throw new Error(`${name}'s ${wanted[bad]} is no hexadecimal number: “${words[bad]}”`);
  return withNumbers(kind, values);
}

function readMotion(text) {
  const values = text.split(',').map(fromHex);
  if (values.length !== 3) throw new Error(`a motion has 3 numbers, not ${values.length}`);
  if (!values.every(Number.isFinite)) throw new Error(`the motion is not of hexadecimal numbers: “${text}”`);
  const [vx, vy, angle] = values;
  if (Math.abs(angle) > 2 ** 20) throw new Error('the motion turns by more than 2^20');
  return { vx, vy, angle };
}

export function toAddress({ tab, a, b, motion, own }) {
  if (!own) return `#tab=${tab}`;
  const shapes = `#tab=${tab}&a=${write(a)}&b=${write(b)}`;
  return tab === 'motion' ? `${shapes}&motion=${[motion.vx, motion.vy, motion.angle].map(toHex).join(',')}` : shapes;
}

/** What an address says: { tab, a, b, motion }, of which what it does not name is undefined. Throws what is wrong with it. */
export function fromAddress(hash, tabs) {
  const state = {};
  for (const part of decodeURIComponent(hash.replace(/^#/, '')).split('&').filter(Boolean)) {
    const [name, value = ''] = part.split('=');
    if (name === 'tab') {
      if (!tabs.includes(value)) throw new Error(`there is no tab “${value}”`);
      state.tab = value;
    } else if (name === 'a' || name === 'b') {
      state[name] = readShape(name, value);
    } else if (name === 'motion') {
      state.motion = readMotion(value);
    } else {
      throw new Error(`“${name}” means nothing here`);
    }
  }
  if ((state.a === undefined) !== (state.b === undefined)) throw new Error('one of the two shapes is missing');
  return state;
}
