// SPDX-License-Identifier: Apache-2.0
// The knife's edge: one number of B at contact and its 130 neighbours, asked exactly and as in textbooks.
import { choice, html, svg } from '../element.mjs';
import { toHex } from '../number.mjs';
import { defaultScene } from '../scene.mjs';
import { fieldsOf, moved, nameOf, withNumber } from '../shape.mjs';
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
  #result = html('div', { class: 'result' });

  constructor(vesica, scene) {
    this.#vesica = vesica;
    this.#scene = scene;
    this.element = html(
      'div',
      {},
      html(
        'p',
        { class: 'lead' },
        'Where shapes just touch, formulas that are right on paper give wrong answers in floating point. Bring A and B to contact by one number of B, and see the answers for the 65 neighbouring numbers on each side. A and B are those of the first tab.',
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
      this.#result,
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
        names.map((name) => [name, name]),
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

  /** The default scene, moved so that contact is at a small number: its last place is finer than the others' rounding. */
  #example() {
    const { a, b } = defaultScene();
    this.#field = 'cx';
    this.#type = 'double';
    this.#scene.change({ a: moved(a, -2.57, 0), b: moved(b, -2.57, 0) });
    this.#bring();
  }

  #bring() {
    const { a, b } = this.#scene,
      found = contact(this.#vesica, a, b, this.#field, this.#type);
    if (found !== null) this.#scene.change({ a: found.a, b: found.b });
  }

  #compare() {
    const { a, b } = this.#scene,
      field = this.#field,
      found = contact(this.#vesica, a, b, field, this.#type);
    if (found === null) {
      this.#result.replaceChildren(
        html(
          'p',
          { role: 'status' },
          `No value of ${field} parts these two, or brings them together. Choose another number, or other shapes.`,
        ),
      );
      return;
    }
    const exact = found.cells.map((cell) => cell.exact);
    const textbook = (arithmetic) =>
      found.cells.map(({ value }) => overlap(arithmetic, found.a, withNumber(found.b, field, value)));
    const first = toHex(found.cells[0].value),
      last = toHex(found.cells.at(-1).value);
    this.#result.replaceChildren(
      html(
        'p',
        { role: 'status' },
        `At ${field} = `,
        html('code', { id: 'edge-value' }, toHex(found.value)),
        ` the ${nameOf[found.a.kind]} and the ${nameOf[found.b.kind]} still touch; one last-place unit on, they do not.`,
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
        `From left to right ${field} grows by one last-place unit of ${this.#type} a cell, from ${first} to ${last}: ${2 * neighbours + 1} numbers that a drawing cannot tell apart.`,
      ),
    );
  }
}
