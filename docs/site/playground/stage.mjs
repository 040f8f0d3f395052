// SPDX-License-Identifier: Apache-2.0
// A picture of named shapes that one can take hold of: by mouse, touch and keys.
import { html } from './element.mjs';
import { afterKey, handlesOf } from './pair/handles.mjs';
import { edgeNear, isPath, withCorner } from './path.mjs';
import { board, height, View, width } from './plane.mjs';

const percent = (part, whole) => `${Math.max(0, Math.min(100, (100 * part) / whole))}%`;

export class Stage {
  #board;
  #handles = html('div', { class: 'handles' });
  #shapes;
  #change;

  /** shapes() -> { a, b }; change({ a }) takes over what was moved. `id` makes the handles' ids. */
  constructor(id, label, shapes, change) {
    this.id = id;
    this.view = new View();
    this.#shapes = shapes;
    this.#change = change;
    this.#board = board(label);
    this.#board.addEventListener('pointerdown', (event) => this.#grab(event, event.target.dataset.shape, 'move'));
    this.#board.addEventListener('dblclick', (event) => this.#bend(event, event.target.dataset.shape));
    this.element = html('div', { class: 'picture' }, this.#board, this.#handles);
  }

  fit() {
    this.view.fit(Object.values(this.#shapes()));
  }

  /** Shows these nodes, and handles where the shapes are. */
  show(nodes) {
    this.#board.replaceChildren(...nodes);
    const shapes = this.#shapes();
    const wanted = Object.entries(shapes).flatMap(([name, shape]) =>
      handlesOf(shape).map((handle) => [name, handle]),
    );
    const key = wanted.map(([name, { id }]) => `${name}-${id}`).join();
    if (this.#handles.dataset.key !== key) {
      this.#handles.dataset.key = key;
      this.#handles.replaceChildren(...wanted.map(([name, handle]) => this.#handle(name, handle)));
    }
    wanted.forEach(([name, handle], i) => {
      const [x, y] = this.view.to(handle.at(shapes[name])),
        { style } = this.#handles.children[i];
      style.left = percent(x, width);
      style.top = percent(y, height);
    });
  }

  #handle(name, handle) {
    const label = `${name.toUpperCase()}: ${handle.label}`;
    return html(
      'button',
      {
        type: 'button',
        class: `handle ${name} ${handle.id}${handle.remove ? ' corner' : ''}`,
        id: `${this.id}-${name}-${handle.id}`,
        'aria-label': label,
        title: label,
        pointerdown: (event) => this.#grab(event, name, handle.id),
        dblclick: () => {
          const shape = handle.remove?.(this.#shapes()[name]) ?? null;
          if (shape !== null) this.#change({ [name]: shape });
        },
        keydown: (event) => {
          const shape = afterKey(this.#shapes()[name], handle, event, 100 / this.view.scale);
          if (shape === null) return;
          event.preventDefault();
          this.#change({ [name]: shape });
        },
      },
      handle.id === 'move' ? name.toUpperCase() : '',
    );
  }

  /** A corner more on the edge that is nearest. */
  #bend(event, name) {
    const shape = this.#shapes()[name];
    if (shape === undefined || !isPath(shape)) return;
    const at = this.view.under(event, this.#board);
    this.#change({ [name]: withCorner(shape, edgeNear(shape, at), at) });
  }

  #grab(event, name, id) {
    if (name === undefined || event.button > 0) return;
    const handle = handlesOf(this.#shapes()[name]).find((one) => one.id === id);
    let before = this.view.under(event, this.#board);
    const follow = (move) => {
      const to = this.view.under(move, this.#board);
      this.#change({ [name]: handle.drag(this.#shapes()[name], to, before) });
      before = to;
    };
    const ends = ['pointerup', 'pointercancel'],
      end = () => {
        removeEventListener('pointermove', follow);
        for (const type of ends) removeEventListener(type, end);
      };
    addEventListener('pointermove', follow);
    for (const type of ends) addEventListener(type, end);
    event.preventDefault();
    this.#handles.querySelector(`#${this.id}-${name}-${id}`).focus({ preventScroll: true });
  }
}
