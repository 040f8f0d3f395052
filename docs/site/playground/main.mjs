// SPDX-License-Identifier: Apache-2.0
// The page: loads the library, and shows a tab when it is asked for.
import { load } from '../vesica/vesica.mjs';
import { html } from './element.mjs';
import { PairTab } from './pair/tab.mjs';
import { Scene } from './scene.mjs';

const tabs = {
  two: { title: 'Two shapes', open: (vesica, scene) => new PairTab(vesica, scene) },
  edge: {
    title: 'The knife’s edge',
    open: async (vesica, scene) => new (await import('./edge/tab.mjs')).EdgeTab(vesica, scene),
  },
  motion: {
    title: 'Motion',
    open: async (vesica, scene) => new (await import('./motion/tab.mjs')).MotionTab(vesica, scene),
  },
  crowd: { title: 'A crowd', open: async (vesica) => new (await import('./crowd/tab.mjs')).CrowdTab(vesica) },
  methods: {
    title: 'The named methods',
    open: async (vesica) => (await import('./methods/tab.mjs')).openMethods(vesica),
  },
};

const notice = document.getElementById('notice');
function say(text) {
  notice.hidden = text === null;
  notice.textContent = text ?? '';
}

/** Tabs as WAI-ARIA has them: one in the order of Tab, arrow keys go from one to the next. */
class Tabs {
  #opened = {};
  #buttons = {};
  #panels = {};

  constructor(vesica, scene) {
    const list = document.querySelector('[role=tablist]'),
      names = Object.keys(tabs);
    for (const name of names) {
      this.#buttons[name] = html(
        'button',
        {
          type: 'button',
          role: 'tab',
          id: `tab-${name}`,
          'aria-controls': `panel-${name}`,
          click: () => scene.change({ tab: name }),
          keydown: (event) => {
            const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
            if (step === undefined) return;
            const next = names[(names.indexOf(name) + step + names.length) % names.length];
            scene.change({ tab: next });
            this.#buttons[next].focus();
          },
        },
        tabs[name].title,
      );
      this.#panels[name] = html('div', {
        role: 'tabpanel',
        id: `panel-${name}`,
        'aria-labelledby': `tab-${name}`,
        hidden: true,
      });
    }
    list.append(...Object.values(this.#buttons));
    list.after(...Object.values(this.#panels));
    this.#show(vesica, scene);
    scene.onChange(() => this.#show(vesica, scene));
  }

  async #show(vesica, scene) {
    for (const name of Object.keys(tabs)) {
      const here = name === scene.tab;
      this.#buttons[name].setAttribute('aria-selected', here);
      this.#buttons[name].tabIndex = here ? 0 : -1;
      this.#panels[name].hidden = !here;
      if (here) this.#buttons[name].scrollIntoView({ block: 'nearest', inline: 'nearest' });
    }
    const { tab } = scene;
    if (this.#opened[tab] === undefined) {
      this.#opened[tab] = Promise.resolve(tabs[tab].open(vesica, scene));
      try {
        this.#panels[tab].append((await this.#opened[tab]).element);
      } catch (error) {
        say(`This part could not be loaded: ${error.message}`);
        throw error;
      }
      (await this.#opened[tab]).shown?.();
    }
  }

  /** After the address told another scene. */
  async restart() {
    for (const opened of Object.values(this.#opened)) (await opened).restart?.();
  }
}

async function start() {
  let vesica;
  try {
    vesica = await load();
  } catch (error) {
    say(`The library could not be loaded: ${error.message}`);
    throw error;
  }
  const scene = new Scene(vesica, Object.keys(tabs));
  const read = () => {
    const reason = scene.readAddress();
    say(reason && `This link is spoilt: ${reason}. Here is the default scene.`);
  };
  read();
  const shown = new Tabs(vesica, scene);
  addEventListener('hashchange', () => {
    read();
    shown.restart();
  });
  document.getElementById('module').textContent =
    `Vesica ${vesica.version} by WebAssembly, ${vesica.isa === 'simd128' ? 'with vectors (simd128)' : 'without vectors'}.`;
  document.documentElement.dataset.ready = vesica.isa;
}

start();
