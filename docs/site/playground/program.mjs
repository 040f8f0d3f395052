// SPDX-License-Identifier: Apache-2.0
// Two shapes and a call as a program in each of four languages. A program prints its answer.
import { fields } from '../vesica/vesica.mjs';
import { isPath, rings } from './path.mjs';
import { numbers } from './shape.mjs';

/** A number as all four languages read it back, without a bit lost. */
export function literal(x) {
  const text = Object.is(x, -0) ? '-0.0' : String(x);
  return /^-?\d{10,}$/.test(text) ? `${text}.0` : text;
}
export const list = (values) => values.map(literal).join(', ');

export const camel = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

/** A shape of C or C++; a path's vertices have an array of their own. */
function declared(shape, letter, type, none) {
  if (!isPath(shape)) return [`const ${type} ${letter} = {${list(numbers(shape))}};`];
  const of = rings(shape).length,
    count = shape.vertices.length / 2,
    offsets = of > 1 ? [`const int32_t ${letter}_rings[] = {${shape.rings.join(', ')}};`] : [],
    part = of > 1 ? `${letter}_rings, ${of}` : `${none}, ${count}`;
  return [
    `const double ${letter}_xy[] = {${list(shape.vertices)}};`,
    ...offsets,
    `const ${type} ${letter} = {${letter}_xy, ${letter}_xy + 1, 2 * sizeof(double), ${part}};`,
  ];
}

/** Python makes arrays of shapes; those with an axis of the library's own numbers. */
function inPython(shape) {
  const nested = (points) => `[${points.map((point) => `[${list(point)}]`).join(', ')}]`;
  if (isPath(shape)) return `vesica.${shape.kind}s([[${rings(shape).map(nested).join(', ')}]])[0]`;
  const row = `[[${list(numbers(shape))}]]`;
  if (!('ux' in shape)) return `vesica.${shape.kind}s(${row})[0]`;
  return `vesica.shapes(vesica.Kind.${shape.kind.toUpperCase()}, ${row})[0]`;
}

function inJavaScript(shape) {
  const members = isPath(shape)
    ? [`vertices: [${list(shape.vertices)}]`, `rings: [${shape.rings.join(', ')}]`]
    : fields[shape.kind].map((name) => `${name}: ${literal(shape[name])}`);
  return `{ kind: '${shape.kind}', ${members.join(', ')} }`;
}

const inset = (lines) => lines.map((line) => `  ${line}`);

/** shape(shape, letter) -> lines; program(shapes' lines, { before, type, call, print }) -> lines. */
export const languages = {
  c: {
    title: 'C',
    shape: (shape, letter) => declared(shape, letter, `vesica_${shape.kind}_f64`, 'NULL'),
    program: (shapes, { before = [], type = 'int32_t', call, print }) => [
      '#include <stdio.h>',
      '#include <vesica.h>',
      '',
      'int main(void) {',
      ...inset([...shapes, ...before, `${type} answer = ${call};`]),
      '  if (answer < 0) {',
      `    puts(vesica_strerror(${type === 'int32_t' ? '' : '(int32_t)'}answer));`,
      '    return 1;',
      '  }',
      `  printf(${print});`,
      '  return 0;',
      '}',
    ],
  },
  cpp: {
    title: 'C++',
    shape: (shape, letter) => declared(shape, letter, `vesica::${camel(`_${shape.kind}`)}<double>`, 'nullptr'),
    program: (shapes, { before = [], print }) => [
      '#include <cstdio>',
      '#include <vesica/vesica.hpp>',
      '',
      'int main() {',
      ...inset([...shapes, ...before, `std::printf(${print});`]),
      '}',
    ],
  },
  python: {
    title: 'Python',
    shape: (shape, letter) => [`${letter} = ${inPython(shape)}`],
    program: (shapes, { print }) => ['import vesica', '', ...shapes, `print(${print})`],
  },
  javascript: {
    title: 'JavaScript',
    shape: (shape, letter) => [`const ${letter} = ${inJavaScript(shape)};`],
    program: (shapes, { print }) => [
      "import { load } from 'vesica';",
      '',
      'const vesica = await load();',
      ...shapes,
      `console.log(${print});`,
    ],
  },
};

/** Both shapes, as a language has them. */
export const shapesIn = (language, a, b) =>
  [...languages[language].shape(a, 'a'), ...languages[language].shape(b, 'b')].join('\n');

/** A whole program; `calls` has { call, print, before } for each language. */
export const programIn = (language, a, b, calls) =>
  `${languages[language].program(shapesIn(language, a, b).split('\n'), calls[language]).join('\n')}\n`;
