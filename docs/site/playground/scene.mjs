// SPDX-License-Identifier: Apache-2.0
// The two shapes that the tabs share, who wants to know of changes, and the address that follows them.
import { ellipse, rect } from '../vesica/vesica.mjs';
import { fromAddress, toAddress } from './address.mjs';

export const defaultScene = () => ({
  a: rect(-0.75, 0, 4, 2.5, 20, { degrees: true }),
  b: ellipse(1.5, 0.75, 2, 1, -35, { degrees: true }),
});

/** How B moves in the tab of motion. */
export const defaultMotion = () => ({ vx: -3, vy: -5, angle: 0 });

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
    Object.assign(this, { motion: defaultMotion() }, defaultScene());
  }

  /** listener(scene) is called after each change. */
  onChange(listener) {
    this.#listeners.push(listener);
  }

  /** Changes a, b, motion or tab. An invalid shape changes nothing: then the reason is returned. */
  change(what) {
    for (const shape of [what.a, what.b]) {
      const reason = shape && this.#vesica.invalidity(shape);
      if (reason) return reason;
    }
    Object.assign(this, what);
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
    Object.assign(this, { tab: this.#tabs[0], motion: defaultMotion() }, defaultScene(), state);
    for (const listener of this.#listeners) listener(this);
    return reason ?? null;
  }
}
