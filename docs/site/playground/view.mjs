// SPDX-License-Identifier: Apache-2.0
// How answers are shown, in all tabs: in which language the calls are, and whether hexadecimal numbers are there.
import { html } from './element.mjs';
import { languages } from './program.mjs';

/** A choice of language; `id` makes the names of its inputs. */
export function languageSwitch(id, scene) {
  const inputs = Object.keys(languages).map((name) =>
    html('input', {
      type: 'radio',
      name: `${id}-language`,
      id: `${id}-in-${name}`,
      value: name,
      change: () => scene.change({ language: name }),
    }),
  );
  const show = () => inputs.forEach((input) => (input.checked = input.value === scene.language));
  scene.onChange(show);
  show();
  return html(
    'fieldset',
    { class: 'languages' },
    html('legend', {}, 'Calls in'),
    ...inputs.flatMap((input) => [input, html('label', { for: input.id }, languages[input.value].title)]),
  );
}

/** The switch of hexadecimal numbers. */
export function hexSwitch(id, scene) {
  const input = html('input', {
    type: 'checkbox',
    id: `${id}-hex`,
    change: () => scene.change({ hex: input.checked }),
  });
  const show = () => {
    input.checked = scene.hex;
    document.documentElement.classList.toggle('with-hex', scene.hex);
  };
  scene.onChange(show);
  show();
  const label = html('label', { for: input.id }, 'Hexadecimal numbers, to the last bit');
  return html('div', { class: 'control' }, input, label);
}
