// SPDX-License-Identifier: Apache-2.0
// The tab of two shapes: a picture with handles, the numbers, and every answer with its call.
import { choice, copyButton, html } from '../element.mjs';
import { beside, fromText, short, toHex } from '../number.mjs';
import { isPath } from '../path.mjs';
import { programIn, shapesIn } from '../program.mjs';
import { angleOf, asKind, choiceOf, choices, fieldsOf, numberOf, withAngle, withNumber, wordsOf } from '../shape.mjs';
import { Stage } from '../stage.mjs';
import { hexSwitch, languageSwitch } from '../view.mjs';
import { answersTo, callsOf, found } from './answers.mjs';
import { picture } from './picture.mjs';

export class PairTab {
  #vesica;
  #scene;
  #stage;
  #answers = html('ul', { class: 'answers' });
  #verdict = html('p', { class: 'verdict', role: 'status' });
  #numbers = { a: html('div'), b: html('div') };
  #code = html('pre');
  #error = html('p', { class: 'error', role: 'alert', hidden: true });

  constructor(vesica, scene) {
    this.#vesica = vesica;
    this.#scene = scene;
    this.#stage = new Stage(
      'two',
      'Two shapes and the answers about them',
      () => ({ a: scene.a, b: scene.b }),
      (what) => this.#change(what),
    );
    this.element = html(
      'div',
      { class: 'columns' },
      html(
        'div',
        { class: 'stage' },
        this.#verdict,
        this.#stage.element,
        html(
          'p',
          { class: 'hint' },
          'Drag a shape or a handle. By keyboard: Tab to a handle, then arrow keys; with Shift the number changes by one last-place unit. A double click on a polygon’s edge adds a corner, on a corner takes it away; by keyboard: Insert and Delete.',
        ),
        html(
          'div',
          { class: 'row' },
          html('button', { type: 'button', click: () => this.#fit() }, 'Show all'),
          copyButton('Copy the link to this scene', () => (scene.writeAddress(), location.href)),
          html('span', { class: 'hint' }, 'the link: every bit is in it'),
        ),
        this.#error,
      ),
      html(
        'div',
        { class: 'told' },
        languageSwitch('two', scene),
        this.#answers,
        html('p', { class: 'hint' }, 'with these shapes; “copy” takes a whole program:'),
        this.#code,
        hexSwitch('two', scene),
      ),
      html('div', { class: 'shapes' }, this.#editor('a'), this.#editor('b')),
    );
    scene.onChange(() => this.show());
    this.#fit();
  }

  #fit() {
    this.#stage.fit();
    this.show();
  }

  /** After the address told another scene. */
  restart() {
    this.#fit();
  }

  show() {
    const { a, b } = this.#scene,
      answers = answersTo(this.#vesica, a, b);
    this.#stage.show(picture(this.#stage.view, a, b, answers));
    const relation = found(answers, 'relation') === null ? '' : `: ${answers[1].value}`;
    this.#verdict.textContent = `${found(answers, 'overlap') ? 'They overlap' : 'They do not overlap'}${relation}.`;
    this.#verdict.classList.toggle('hit', found(answers, 'overlap'));
    this.#showAnswers(answers);
    this.#code.textContent = shapesIn(this.#scene.language, a, b);
    this.#showNumbers('a');
    this.#showNumbers('b');
  }

  #change(what) {
    const reason = this.#scene.change(what);
    this.#error.hidden = reason === null;
    this.#error.textContent = reason === null ? '' : `Not taken: ${reason}.`;
    return reason;
  }

  // ---- Numbers ----

  #editor(name) {
    const title = `Shape ${name.toUpperCase()}`;
    const kind = choice(
      `kind-${name}`,
      title,
      Object.entries(choices),
      choiceOf(this.#scene[name]),
      (chosen) => this.#change({ [name]: asKind(this.#scene[name], chosen) }),
    );
    return html('fieldset', { class: `editor ${name}` }, html('legend', {}, title), kind, this.#numbers[name]);
  }

  #showNumbers(name) {
    const shape = this.#scene[name],
      box = this.#numbers[name];
    document
      .getElementById(`kind-${name}`)
      ?.querySelectorAll('option')
      .forEach((option) => (option.selected = option.value === choiceOf(shape)));
    const names = fieldsOf(shape),
      key = [shape.kind, ...names].join();
    if (box.dataset.kind !== key) {
      box.dataset.kind = key;
      box.className = isPath(shape) ? 'corners' : '';
      box.replaceChildren(
        ...names.flatMap((field) => [this.#number(name, field), ...(field === 'uy' ? [this.#angle(name)] : [])]),
      );
    }
    const angle = box.querySelector(`#number-${name}-angle`);
    if (angle !== null && document.activeElement !== angle) angle.value = short(angleOf(shape)).replace('≈ ', '');
    for (const input of box.querySelectorAll('input[data-field]')) {
      const value = numberOf(shape, input.dataset.field);
      if (document.activeElement !== input || fromText(input.value) !== value) input.value = String(value);
      input.nextSibling.textContent = toHex(value);
    }
  }

  /** What was typed, if it is a number. */
  #typed(input, set) {
    const value = fromText(input.value);
    if (!Number.isNaN(value)) return void set(value);
    this.#error.hidden = false;
    this.#error.textContent = `Not taken: “${input.value}” is no number, neither decimal nor as 0x1.8p+1.`;
  }

  /** The axis as an angle in degrees; arrow keys turn by one. */
  #angle(name) {
    const id = `number-${name}-angle`,
      set = (value) => this.#change({ [name]: withAngle(this.#scene[name], value) });
    const input = html('input', {
      id,
      inputmode: 'decimal',
      autocomplete: 'off',
      change: () => this.#typed(input, set),
      keydown: (event) => {
        const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (way === undefined) return;
        event.preventDefault();
        set(angleOf(this.#scene[name]) + way);
        input.value = short(angleOf(this.#scene[name])).replace('≈ ', '');
      },
    });
    return html('div', { class: 'number' }, html('label', { for: id }, 'angle in °'), input);
  }

  #number(name, field) {
    const id = `number-${name}-${field}`;
    const set = (value) => this.#change({ [name]: withNumber(this.#scene[name], field, value) });
    const input = html('input', {
      id,
      'data-field': field,
      inputmode: 'decimal',
      spellcheck: 'false',
      autocomplete: 'off',
      change: () => this.#typed(input, set),
      keydown: (event) => {
        const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (way === undefined) return;
        event.preventDefault();
        const value = numberOf(this.#scene[name], field);
        set(event.shiftKey ? beside(value, way) : value + (way * 4) / this.#stage.view.scale);
        input.value = String(numberOf(this.#scene[name], field));
      },
    });
    const label = html('label', { for: id }, wordsOf(this.#scene[name], field));
    return html('div', { class: 'number' }, label, input, html('code', { class: 'hex' }));
  }

  // ---- Answers ----

  #showAnswers(answers) {
    const { a, b, language } = this.#scene;
    if (this.#answers.childElementCount === 0) {
      this.#answers.append(
        ...answers.map((answer) => {
          const copy = copyButton(`Copy a program that asks: ${answer.question}`, () => this.#program(answer));
          return html(
            'li',
            { id: `answer-${answer.id}` },
            html('span', { class: `swatch ${answer.id}` }),
            html('span', { class: 'question' }, answer.question),
            html('strong'),
            html('span', { class: 'detail' }),
            html('code', { class: 'exact hex' }),
            html('code', { class: 'call' }),
            copy,
          );
        }),
      );
    }
    for (const answer of answers) {
      const row = this.#answers.querySelector(`#answer-${answer.id}`);
      row.querySelector('strong').textContent = answer.value;
      row.querySelector('.detail').textContent = answer.detail ?? '';
      row.querySelector('.exact').textContent = answer.exact ?? '';
      row.querySelector('.call').textContent = callsOf(answer, a, b)[language].call;
      row.querySelector('.copy').dataset.program = this.#program(answer);
    }
  }

  #program(answer) {
    const { a, b, language } = this.#scene;
    return programIn(language, a, b, callsOf(answer, a, b));
  }
}
