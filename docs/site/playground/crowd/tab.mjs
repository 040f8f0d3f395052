// SPDX-License-Identifier: Apache-2.0
// The crowd: shapes that move, all pairs that meet in every frame, and what that costs.
import { html, slider } from '../element.mjs';
import { flatCanvas } from './draw_canvas.mjs';
import { webgl } from './draw_webgl.mjs';
import { box, Crowd } from './motion.mjs';

const counts = [100, 300, 1000, 3000, 10000, 30000, 100000];
const still = matchMedia('(prefers-reduced-motion: reduce)');
const dark = matchMedia('(prefers-color-scheme: dark)');

/** A colour of the page as three numbers from 0 to 1. */
function colour(name) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return [1, 3, 5].map((i) => Number.parseInt(text.slice(i, i + 2), 16) / 255);
}

const median = (list) => [...list].sort((x, y) => x - y)[list.length >> 1] ?? 0;

export class CrowdTab {
  #vesica;
  #crowd = null;
  #draw;
  #colours;
  #running = !still.matches;
  #frame = 0;
  #last = 0;
  #steps = 0;
  #queries = [];
  #canvas = html('canvas', {
    width: 1280,
    height: 1280 * (box.height / box.width),
    role: 'img',
    'aria-label': 'Moving shapes; those that touch another are red',
  });
  #values = {};
  #toggle = html('button', { type: 'button', id: 'crowd-run', click: () => this.#run(!this.#running) });

  constructor(vesica) {
    this.#vesica = vesica;
    this.#draw = webgl(this.#canvas) ?? flatCanvas(this.#canvas);
    const value = (name, label) =>
      html('div', {}, html('dt', {}, label), (this.#values[name] = html('dd', { id: `crowd-${name}` }, '–')));
    this.element = html(
      'div',
      {},
      html(
        'div',
        { class: 'controls' },
        slider(
          'crowd-count',
          'How many',
          { min: 0, max: counts.length - 1, value: counts.indexOf(10000) },
          (i) => `${counts[i].toLocaleString('en')} shapes`,
          (i) => this.#start(counts[i]),
        ),
        this.#toggle,
      ),
      html(
        'dl',
        { class: 'figures' },
        value('query', 'query, ms'),
        value('pairs', 'pairs that touch'),
        value('tests', 'pairs tested exactly'),
        value('exact', 'exact tests a second of query time'),
      ),
      html('div', { class: 'picture' }, this.#canvas),
      html(
        'p',
        { class: 'hint' },
        'Points, segments, circles, boxes, rectangles, ellipses, capsules, rounded rectangles and polygons, all moving. Each frame builds an index of all of them and asks for every pair that meets, exactly; red shapes touch another. Pairs whose bounding boxes meet are tested. The query is the build of the index and the join, in the median of the last 60; moving and drawing are not in it.',
      ),
    );
    this.#takeColours();
    dark.addEventListener('change', () => this.#takeColours());
    addEventListener('resize', () => this.shown());
    still.addEventListener('change', () => this.#run(!still.matches));
    this.#start(10000);
    this.#run(this.#running);
  }

  /** When the canvas has its place on the page: as many pixels as are seen. */
  shown() {
    const width = Math.round(Math.min(2560, this.#canvas.clientWidth * devicePixelRatio));
    if (width === 0) return;
    this.#canvas.width = width;
    this.#canvas.height = Math.round(width * (box.height / box.width));
    this.#paint();
  }

  /** The last frames' query times in ms: for tests. */
  get queries() {
    return this.#queries;
  }

  #start(count) {
    this.#crowd?.free();
    this.#crowd = new Crowd(this.#vesica, count);
    this.#queries = [];
    this.#steps = 0;
    this.step(0);
    this.#settle(this.#crowd, performance.now() + 2000);
  }

  /** Repeats the query for a while where nothing moves, as engines compile better what has run often. */
  #settle(crowd, end) {
    if (this.#running || crowd !== this.#crowd || performance.now() > end) return;
    this.#tell(this.#query());
    setTimeout(() => this.#settle(crowd, end));
  }

  #run(running) {
    this.#running = running;
    this.#toggle.textContent = running ? 'Pause' : 'Play';
    cancelAnimationFrame(this.#frame);
    this.#last = 0;
    if (running) this.#frame = requestAnimationFrame((now) => this.#next(now));
  }

  #next(now) {
    this.#frame = requestAnimationFrame((then) => this.#next(then));
    if (this.element.offsetParent === null) return void (this.#last = 0); // another tab is shown
    this.step(this.#last > 0 ? Math.min(0.05, (now - this.#last) / 1000) : 0);
    this.#last = now;
  }

  /** One frame, so many seconds after the last. */
  step(seconds) {
    this.#crowd.move(seconds);
    const pairs = this.#query();
    this.#paint();
    if (!this.#running || this.#steps % 15 === 0) this.#tell(pairs);
    this.#steps += 1;
    this.element.dataset.frames = this.#steps;
  }

  /** How many pairs touch; the time it takes is kept. */
  #query() {
    const start = performance.now(),
      pairs = this.#crowd.collide();
    this.#queries.push(performance.now() - start);
    return pairs;
  }

  #takeColours() {
    this.#colours = { paper: colour('--panel'), calm: colour('--a'), hit: colour('--hit') };
    if (this.#crowd !== null) this.#paint();
  }

  #paint() {
    this.#crowd.paint();
    this.#draw(this.#crowd.instances, this.#crowd.count, this.#colours);
  }

  #tell(pairs) {
    this.#queries.splice(0, this.#queries.length - 60);
    const tests = this.#crowd.candidates(),
      // A browser's clock may have steps of 0.1 ms: less than one is shown as one.
      query = Math.max(0.1, median(this.#queries));
    this.#values.query.textContent = query.toFixed(2);
    this.#values.pairs.textContent = pairs.toLocaleString('en');
    this.#values.tests.textContent = tests.toLocaleString('en');
    this.#values.exact.textContent = Math.round((1000 * tests) / query).toLocaleString('en', { notation: 'compact' });
  }
}
