// SPDX-License-Identifier: Apache-2.0
// The knife's edge: one number of B at contact and its 130 neighbours, asked exactly and as in textbooks.
import { choice, html, svg } from '../element.mjs';
import { short, toHex } from '../number.mjs';
import { board, draw, grid, View } from '../plane.mjs';
import { exampleOf } from '../scene.mjs';
import { fieldsOf, nameOf, withNumber, wordsOf } from '../shape.mjs';
import { hexSwitch } from '../view.mjs';
import { contact, neighbours } from './contact.mjs';
import { double, float, overlap, recipe } from './textbook.mjs';

const cellWidth = 10,
  cellHeight = 40;

const mark = (x, name) => svg('rect', { x, width: cellWidth - 1, height: cellHeight, class: `cell ${name}` });

/** 131 cells: filled where the answer is yes; a wrong one is short and dark, so that it shows without colour too. */
function strip(id, title, note, answers, exact) {
  const wrong = answers.filter((answer, i) => answer !== exact[i]).length;
  const cells = answers.flatMap((answer, i) => {
    const cell = mark(i * cellWidth, answer ? 'yes' : 'no');
    cell.dataset.answer = answer === null ? '' : Number(answer);
    return answer === exact[i]
      ? [cell]
      : [cell, svg('rect', { x: i * cellWidth, y: 14, width: cellWidth - 1, height: 12, class: 'cell wrong' })];
  });
  const label = `${title}: ${answers.filter(Boolean).length} of ${answers.length} yes, ${wrong} wrong`;
  return html(
    'section',
    { class: 'strip', id },
    html('h2', {}, title, html('span', {}, `${note}${id === 'exact' ? '' : ` — ${wrong} of ${answers.length} wrong`}`)),
    svg(
      'svg',
      {
        viewBox: `0 0 ${answers.length * cellWidth} ${cellHeight}`,
        preserveAspectRatio: 'none',
        role: 'img',
        'aria-label': label,
      },
      ...cells,
    ),
  );
}

const sign = (name, words) =>
  html(
    'span',
    {},
    svg(
      'svg',
      { viewBox: '0 0 10 10', 'aria-hidden': 'true' },
      svg('rect', { width: 10, height: 10, class: `cell ${name}` }),
    ),
    ` ${words}`,
  );

export class EdgeTab {
  #vesica;
  #scene;
  #type = 'double';
  #field = null;
  #controls = html('div', { class: 'controls' });
  #board = board('A and B at contact');
  #result = html('div', { class: 'result' });

  constructor(vesica, scene) {
    this.#vesica = vesica;
    this.#scene = scene;
    this.element = html(
      'div',
      {},
      html(
        'div',
        { class: 'edge-head' },
        html('div', { class: 'picture' }, this.#board),
        html(
          'div',
          {},
          html(
            'p',
            { class: 'lead' },
            'Where shapes just touch, formulas that are right on paper give wrong answers in floating point. Below is one cell for each neighbouring number of B, 65 on each side of contact.',
          ),
          this.#controls,
          html(
            'div',
            { class: 'row' },
            html(
              'button',
              { type: 'button', id: 'to-contact', click: () => this.#bring() },
              'Bring B to contact, to the last place',
            ),
            html(
              'button',
              { type: 'button', id: 'edge-example', click: () => this.#example() },
              'An example where textbooks fail',
            ),
          ),
          html('p', { class: 'hint' }, 'A and B are chosen in the first tab; what you change is kept in all.'),
        ),
      ),
      this.#result,
      hexSwitch('edge', scene),
    );
    scene.onChange(() => this.show());
    this.show();
  }

  restart() {
    this.show();
  }

  show() {
    const names = fieldsOf(this.#scene.b);
    if (!names.includes(this.#field)) [this.#field] = names;
    this.#controls.replaceChildren(
      choice(
        'edge-field',
        'The number of B that changes',
        names.map((name) => [name, wordsOf(this.#scene.b, name)]),
        this.#field,
        (name) => {
          this.#field = name;
          this.#compare();
        },
      ),
      choice(
        'edge-type',
        'Numbers of type',
        [
          ['double', 'double'],
          ['float', 'float'],
        ],
        this.#type,
        (type) => {
          this.#type = type;
          this.#compare();
        },
      ),
    );
    if (this.#scene.tab === 'edge') this.#compare();
  }

  #example() {
    this.#field = 'cx';
    this.#type = 'double';
    this.#scene.change(exampleOf('edge'));
    this.#bring();
  }

  #bring() {
    const { a, b } = this.#scene,
      found = contact(this.#vesica, a, b, this.#field, this.#type);
    if (found !== null) this.#scene.change({ a: found.a, b: found.b });
  }

  /** Both at contact. */
  #show({ a, b }) {
    const view = new View();
    view.fit([a, b]);
    this.#board.replaceChildren(grid(view), draw(view, a, { class: 'shape a' }), draw(view, b, { class: 'shape b' }));
  }

  #compare() {
    const { a, b } = this.#scene,
      field = this.#field,
      name = wordsOf(b, field),
      found = contact(this.#vesica, a, b, field, this.#type);
    if (found === null) {
      this.#result.replaceChildren(
        html(
          'p',
          { role: 'status' },
          `No value of ${name} parts these two, or brings them together. Choose another number, or other shapes.`,
        ),
      );
      return;
    }
    this.#show(found);
    const exact = found.cells.map((cell) => cell.exact);
    const textbook = (arithmetic) =>
      found.cells.map(({ value }) => overlap(arithmetic, found.a, withNumber(found.b, field, value)));
    const first = toHex(found.cells[0].value),
      last = toHex(found.cells.at(-1).value);
    this.#result.replaceChildren(
      html(
        'p',
        { role: 'status' },
        `At ${name} ${short(found.value)} `,
        html('code', { id: 'edge-value', class: 'hex' }, `${toHex(found.value)} `),
        `the ${nameOf[found.a.kind]} and the ${nameOf[found.b.kind]} still touch; at the next number of type ${this.#type} they do not.`,
      ),
      html(
        'div',
        { class: 'strips', 'data-type': this.#type, 'data-field': field, 'data-first': first, 'data-last': last },
        strip('exact', 'Vesica', 'exact: every answer right', exact, exact),
        strip('double', 'Textbook, in double', recipe(found.a.kind, found.b.kind), textbook(double), exact),
        strip('float', 'Textbook, in float', recipe(found.a.kind, found.b.kind), textbook(float), exact),
      ),
      html(
        'p',
        { class: 'legend' },
        sign('yes', 'they overlap'),
        sign('no', 'they do not'),
        sign('wrong', 'a wrong answer'),
      ),
      html(
        'p',
        { class: 'hint' },
        `From left to right ${name} grows by one last-place unit a cell, by about ${short(Math.abs(found.cells[1].value - found.cells[0].value), 4).replace('≈ ', '')}: ${2 * neighbours + 1} numbers that a drawing cannot tell apart. `,
        html('code', { class: 'hex' }, `From ${first} to ${last}.`),
      ),
    );
  }
}
