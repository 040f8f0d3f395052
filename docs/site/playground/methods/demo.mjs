// SPDX-License-Identifier: Apache-2.0
// What the demonstrations of named methods have in common: a stage, controls, and a list of what each method says.
import { html } from '../element.mjs';
import { Stage } from '../stage.mjs';

const reference = '../methods.html';

export class Demo {
  #told = html('ul', { class: 'answers' });
  #controls = html('div', { class: 'controls' });

  /**
   * { id, title, seed, idea, shapes, controls(demo), draw(demo), tell(demo) }: draw gives SVG nodes, tell gives lines
   * [who, answer, note].
   */
  constructor(vesica, methods, description) {
    this.vesica = vesica;
    this.methods = methods;
    this.shapes = description.shapes;
    this.description = description;
    const label = `${description.title}: a picture of the method at work`;
    this.stage = new Stage(
      description.id,
      label,
      () => this.shapes,
      (what) => this.change(what),
    );
    this.#controls.append(...(description.controls?.(this) ?? []));
    this.element = html(
      'section',
      { id: `method-${description.id}` },
      html('h2', {}, description.title),
      html('p', {}, description.idea),
      html('p', { class: 'hint' }, `From: ${description.seed} `, html('a', { href: reference }, 'More about it')),
      this.#controls,
      html(
        'div',
        { class: 'method-grid' },
        html('div', {}, this.stage.element, ...(description.below?.(this) ?? [])),
        html('div', { role: 'status' }, this.#told),
      ),
    );
    this.stage.fit();
    this.show();
  }

  change(what) {
    const next = { ...this.shapes, ...what };
    if (Object.values(next).some((shape) => this.vesica.invalidity(shape) !== null)) return;
    this.shapes = next;
    this.show();
  }

  show() {
    this.stage.show(this.description.draw(this));
    this.#told.replaceChildren(
      ...this.description
        .tell(this)
        .map(([who, answer, note = '']) =>
          html(
            'li',
            {},
            html('span', { class: 'swatch overlap' }),
            html('span', { class: 'question' }, who),
            html('strong', {}, answer),
            html('span', { class: 'hint exact' }, note),
          ),
        ),
    );
  }

  /** The exact answer, as the last line of tell(). */
  exact(a, b) {
    return ['Vesica, exact', this.vesica.overlap(a, b) ? 'yes' : 'no', 'vesica_overlap_f64'];
  }
}
