// SPDX-License-Identifier: Apache-2.0
// B moves, and may turn: does it touch A, when first, and where?
import { point } from '../../vesica/vesica.mjs';
import { copyButton, html, slider, svg } from '../element.mjs';
import { short, toHex } from '../number.mjs';
import { dot, draw, grid, polygon } from '../plane.mjs';
import { isPath, turnedAbout } from '../path.mjs';
import { programIn, shapesIn } from '../program.mjs';
import { exampleOf } from '../scene.mjs';
import { asKind, form, moved } from '../shape.mjs';
import { Stage } from '../stage.mjs';
import { hexSwitch, languageSwitch } from '../view.mjs';
import { callsOf, firstContact, tolerance } from './ask.mjs';

const ghosts = 8;

const arrow = (id) =>
  svg(
    'marker',
    { id, viewBox: '0 0 10 10', refX: 9, refY: 5, markerWidth: 7, markerHeight: 7, orient: 'auto' },
    svg('path', { d: 'M0,0L10,5L0,10Z', class: 'arrowhead' }),
  );

/** B at a time of its way. A box that turns is a rectangle. */
function at(b, { vx, vy, angle }, t) {
  const there = moved(b, t * vx, t * vy);
  if (angle === 0 || b.kind === 'point' || b.kind === 'circle') return there;
  const { x, y } = form(there),
    c = Math.cos(t * angle),
    s = Math.sin(t * angle);
  const turn = ([dx, dy]) => [c * dx - s * dy, s * dx + c * dy];
  if (isPath(b)) return turnedAbout(there, [x, y], t * angle);
  if (b.kind === 'segment' || b.kind === 'capsule') {
    const [dx, dy] = turn([(b.x1 - b.x0) / 2, (b.y1 - b.y0) / 2]);
    return { ...b, x0: x - dx, y0: y - dy, x1: x + dx, y1: y + dy };
  }
  const turned = there.kind === 'aabb' ? asKind(there, 'rect') : there,
    [ux, uy] = turn([turned.ux, turned.uy]);
  return { ...turned, ux, uy };
}

const words = {
  hit: 'B touches A on its way.',
  miss: 'B does not touch A on its way.',
  start: 'They overlap at the start.',
  near: 'B comes near: there is no contact before, and perhaps none later.',
};

const degrees = (angle) => `${Math.round((angle * 180) / Math.PI)}°`;

export class MotionTab {
  #vesica;
  #scene;
  #stage;
  #verdict = html('p', { class: 'verdict', role: 'status' });
  #told = html('ul', { class: 'answers' });
  #turn;
  #code = html('pre');

  constructor(vesica, scene) {
    this.#vesica = vesica;
    this.#scene = scene;
    this.#stage = new Stage(
      'motion',
      'A, B on its way and their first contact',
      () => ({ a: scene.a, b: scene.b, v: this.#goal() }),
      (what) => this.#change(what),
    );
    this.#turn = slider(
      'motion-turn',
      'B turns by',
      { min: -720, max: 720, step: 5, value: Math.round((scene.motion.angle * 180) / Math.PI) },
      (value) => `${value}°`,
      (value) => scene.change({ motion: { ...scene.motion, angle: (value * Math.PI) / 180 } }),
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
          'Drag V, where B’s centre goes, or the shapes. By keyboard: Tab to V, then arrow keys. A and B are chosen in the first tab; what you change is kept in all.',
        ),
        html(
          'div',
          { class: 'row' },
          this.#turn,
          html('button', { type: 'button', id: 'motion-example', click: () => this.#example() }, 'An example'),
          html('button', { type: 'button', click: () => (this.#stage.fit(), this.show()) }, 'Show all'),
          copyButton('Copy the link to this motion', () => (scene.writeAddress(), location.href)),
        ),
      ),
      html('div', { class: 'told' }, languageSwitch('motion', scene), this.#told, this.#code, hexSwitch('motion', scene)),
    );
    this.#told.append(
      ...['answer', 't', 'place', 'normal', 'gap'].map((id) =>
        html(
          'li',
          { id: `motion-${id}` },
          html('span', { class: `swatch ${id}` }),
          html('span', { class: 'question' }),
          html('strong'),
          html('span', { class: 'detail' }),
          html('code', { class: 'exact hex' }),
        ),
      ),
      html(
        'li',
        { id: 'motion-call' },
        html('span', { class: 'swatch overlap' }),
        html('span', { class: 'question' }, 'The call'),
        html('code', { class: 'call' }),
        copyButton('Copy a program that asks this', () => this.#program()),
      ),
    );
    scene.onChange(() => scene.tab === 'motion' && this.show());
    this.#stage.fit();
    this.show();
  }

  shown() {
    this.show();
  }

  /** After the address told another scene. */
  restart() {
    this.#stage.fit();
    this.show();
  }

  #example() {
    this.#scene.change(exampleOf('motion'));
    this.#stage.fit();
    this.show();
  }

  /** Where B's centre goes. */
  #goal() {
    const { b, motion } = this.#scene,
      { x, y } = form(b);
    return point(x + motion.vx, y + motion.vy);
  }

  #change({ v, ...shapes }) {
    if (v === undefined) return this.#scene.change(shapes);
    const { b, motion } = this.#scene,
      { x, y } = form(b);
    return this.#scene.change({ motion: { ...motion, vx: v.x - x, vy: v.y - y } });
  }

  #program() {
    const { a, b, motion, language } = this.#scene;
    return programIn(language, a, b, callsOf(motion));
  }

  show() {
    const { a, b, motion } = this.#scene;
    let found;
    try {
      found = firstContact(this.#vesica, a, b, motion);
    } catch (error) {
      if (error.code === undefined) throw error;
      found = { outcome: null, why: error.message };
    }
    this.#stage.show(this.#picture(a, b, motion, found));
    this.#verdict.textContent = found.outcome === null ? `No answer: ${found.why}.` : words[found.outcome];
    this.#verdict.classList.toggle('hit', found.outcome !== 'miss');
    this.#tell(found, motion);
    const input = this.#turn.querySelector('input'),
      value = Math.round((motion.angle * 180) / Math.PI);
    if (Number(input.value) !== value) input.value = value;
    this.#turn.querySelector('output').textContent = degrees(motion.angle);
  }

  #picture(a, b, motion, found) {
    const view = this.#stage.view,
      { x, y } = form(b),
      goal = this.#goal();
    const steps = Array.from({ length: ghosts }, (_, i) => (i + 1) / ghosts);
    const contact = found.outcome === 'hit' || found.outcome === 'near';
    const reached = contact || found.outcome === 'start';
    const length = 60 / view.scale;
    return [
      svg('defs', {}, arrow('way-end')),
      grid(view),
      ...steps.map((t) => draw(view, at(b, motion, t), { class: 'trail' })),
      draw(view, a, { class: 'shape a', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
      ...(contact ? [draw(view, at(b, motion, found.t), { class: 'arrived' })] : []),
      polygon(view, [[x, y], [goal.x, goal.y]], { class: 'depth', 'marker-end': 'url(#way-end)' }, false),
      ...(reached
        ? [
            polygon(
              view,
              [
                [found.x, found.y],
                [found.x + length * found.nx, found.y + length * found.ny],
              ],
              { class: 'nearest', 'marker-end': 'url(#way-end)' },
              false,
            ),
            dot(view, [found.x, found.y], { class: 'crossing', r: 5 }),
          ]
        : []),
    ];
  }

  #tell(found, motion) {
    const reached = found.outcome !== null && found.outcome !== 'miss',
      turns = motion.angle !== 0;
    const place = (x, y) => (reached ? `(${short(x, 4)}, ${short(y, 4)})`.replaceAll('≈ ', '') : 'none');
    const hex = (...values) => (reached ? values.map(toHex).join(' ') : '');
    const row = (id, question, value, detail, exact = '') => {
      const li = this.#told.querySelector(`#motion-${id}`);
      li.querySelector('.question').textContent = question;
      li.querySelector('strong').textContent = value;
      li.querySelector('.detail').textContent = detail;
      li.querySelector('.exact').textContent = exact;
    };
    row('answer', 'Contact on the way?', found.outcome ?? 'none', turns ? 'proved, unless near' : 'exact');
    row('t', turns ? 'No contact before t =' : 'First contact at t =', reached ? short(found.t) : 'none', 'B starts at t = 0 and arrives at t = 1', hex(found.t));
    row('place', 'Where?', place(found.x, found.y), '', hex(found.x, found.y));
    const slope = Math.atan2(found.ny, found.nx),
      towards = reached ? `towards ${short((slope * 180) / Math.PI, 4)}°`.replace('≈ ', '') : '';
    row('normal', 'Normal from A to B', place(found.nx, found.ny), towards, hex(found.nx, found.ny));
    const gap = found.outcome === 'start' || !turns ? 0 : found.gap;
    row('gap', 'How far apart then, at most?', reached ? short(gap) : 'none', turns ? `within ${tolerance}, or said` : '');
    const call = this.#told.querySelector('#motion-call');
    const { a, b, language } = this.#scene;
    call.querySelector('.call').textContent = callsOf(motion)[language].call;
    call.querySelector('.copy').dataset.program = this.#program();
    this.#code.textContent = shapesIn(language, a, b);
  }
}
