// SPDX-License-Identifier: Apache-2.0
// The two shapes that the tabs share, who wants to know of changes, and the address that follows them.
import { ellipse, rect } from '../vesica/vesica.mjs';
import { fromAddress, toAddress } from './address.mjs';
import { moved } from './shape.mjs';

const defaultScene = () => ({
  a: rect(-0.75, 0, 4, 2.5, 20, { degrees: true }),
  b: ellipse(1.5, 0.75, 2, 1, -35, { degrees: true }),
});

const defaultMotion = () => ({ vx: -3, vy: -5, angle: 0 });

/** What tabs open on: at the knife's edge contact is at a small number, finer than the rounding of the others. */
export function exampleOf(tab) {
  const { a, b } = defaultScene(),
    motion = defaultMotion();
  if (tab === 'edge') return { a: moved(a, -2.57, 0), b: moved(b, -2.57, 0), motion };
  if (tab === 'motion') return { a, b: moved(b, 3.5, 3), motion: { vx: -5, vy: -3.5, angle: 0 } };
  return { a, b, motion };
}

export class Scene {
  #vesica;
  #tabs;
  #listeners = [];
  #timer = 0;

  /** tabs: their names, the first of which is shown by default. */
  constructor(vesica, tabs) {
    this.#vesica = vesica;
    this.#tabs = tabs;
    this.tab = tabs[0];
    // Until shapes are changed or told by a link, each tab shows its example.
    this.own = false;
    Object.assign(this, { language: 'c', hex: false }, exampleOf(this.tab));
  }

  /** listener(scene) is called after each change. */
  onChange(listener) {
    this.#listeners.push(listener);
  }

  /** Changes a, b, motion, tab, language or hex. An invalid shape changes nothing: then the reason is returned. */
  change(what) {
    for (const shape of [what.a, what.b]) {
      const reason = shape && this.#vesica.invalidity(shape);
      if (reason) return reason;
    }
    if (what.a || what.b || what.motion) this.own = true;
    Object.assign(this, this.own || !what.tab ? {} : exampleOf(what.tab), what);
    for (const listener of this.#listeners) listener(this);
    // Browsers refuse an address that changes at every move of a pointer.
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.writeAddress(), 150);
    return null;
  }

  writeAddress() {
    clearTimeout(this.#timer);
    history.replaceState(null, '', toAddress(this));
  }

  /** Takes over what the address says. If it is spoilt: the default scene, and what is wrong is returned. */
  readAddress() {
    let state, reason;
    try {
      state = fromAddress(location.hash, this.#tabs);
      for (const name of ['a', 'b']) {
        const invalid = state[name] && this.#vesica.invalidity(state[name]);
        if (invalid) throw new Error(`shape ${name} is invalid: ${invalid}`);
      }
    } catch (error) {
      reason = error.message;
      state = {};
    }
    this.own = Boolean(state.a || state.motion);
    const tab = state.tab ?? this.#tabs[0];
    Object.assign(this, { tab }, exampleOf(this.own ? null : tab), state);
    for (const listener of this.#listeners) listener(this);
    return reason ?? null;
  }
}
