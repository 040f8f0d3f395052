// SPDX-License-Identifier: Apache-2.0
// Doubles and floats as what they are: hexadecimal text without rounding, and the numbers next to one.

const view = new DataView(new ArrayBuffer(8));
const signBit = 1n << 63n;

/** A double as a whole number in the order of doubles; both zeros are 0. */
function rank(x) {
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  return bits & signBit ? -(bits ^ signBit) : bits;
}

function fromRank(n) {
  view.setBigUint64(0, n < 0n ? -n | signBit : n);
  return view.getFloat64(0);
}

function rankOfFloat(x) {
  view.setFloat32(0, x);
  const bits = view.getUint32(0);
  return bits >= 2 ** 31 ? 2 ** 31 - bits : bits;
}

function fromRankOfFloat(n) {
  view.setUint32(0, n < 0 ? 2 ** 31 - n : n);
  return view.getFloat32(0);
}

/** The number that is `steps` last-place units on from a double. */
export const beside = (x, steps) => fromRank(rank(x) + BigInt(steps));
/** The same among floats. */
export const besideFloat = (x, steps) => fromRankOfFloat(rankOfFloat(x) + steps);

/** The middle of two doubles in their order: as many lie on either side. */
export const between = (x, y) => fromRank((rank(x) + rank(y)) >> 1n);
export const betweenFloats = (x, y) => fromRankOfFloat(Math.floor((rankOfFloat(x) + rankOfFloat(y)) / 2));

/** As C's %a writes it: 1.5 is 0x1.8p+0. */
export function toHex(x) {
  if (!Number.isFinite(x)) return String(x);
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0),
    sign = bits & signBit ? '-' : '';
  const exponent = Number((bits >> 52n) & 0x7ffn),
    fraction = bits & ((1n << 52n) - 1n);
  if (exponent === 0 && fraction === 0n) return `${sign}0x0p+0`;
  const digits = fraction.toString(16).padStart(13, '0').replace(/0+$/, '');
  const power = exponent === 0 ? -1022 : exponent - 1023;
  return `${sign}0x${exponent === 0 ? 0 : 1}${digits && '.'}${digits}p${power < 0 ? '' : '+'}${power}`;
}

const hexPattern = /^([+-]?)0x([01])(?:\.([0-9a-f]{1,13}))?p([+-]?\d{1,4})$/i;

/** The double that toHex() wrote so; NaN for any other text. */
export function fromHex(text) {
  const [, sign, whole, fraction = '', power] = hexPattern.exec(text) ?? [];
  if (whole === undefined) return NaN;
  const digits = Number.parseInt(whole + fraction, 16),
    exponent = Number(power) - 4 * fraction.length;
  // In two steps, as 2^-1074 cannot be the quotient of a number and a power that is finite.
  const half = Math.trunc(exponent / 2),
    value = digits * 2 ** half * 2 ** (exponent - half);
  return Number.isFinite(value) ? (sign === '-' ? -value : value) : NaN;
}

/** A number that someone typed: decimal or hexadecimal; NaN if it is neither. */
export function fromText(text) {
  const trimmed = text.trim();
  if (/0x/i.test(trimmed)) return fromHex(trimmed);
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(trimmed) ? Number(trimmed) : NaN;
}

/** For people: short, and never without sign of what was cut. */
export function short(x, digits = 6) {
  if (x === 0) return '0';
  const text = Math.abs(x) >= 1e-4 && Math.abs(x) < 1e7 ? String(+x.toPrecision(digits)) : x.toExponential(digits - 3);
  return Number(text) === x ? text : `≈ ${text}`;
}
