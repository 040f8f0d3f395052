// SPDX-License-Identifier: Apache-2.0
// Elements of the page in one call.

const fill = (node, attributes, children) => {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') node.addEventListener(name, value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== false && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
};

/** html('button', { class: 'copy', click: f }, 'Copy'): attributes that are functions listen to events. */
export const html = (tag, attributes = {}, ...children) => fill(document.createElement(tag), attributes, children);
export const svg = (tag, attributes = {}, ...children) =>
  fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

/** A slider with its label and its value in words; changed(value) at each move. */
export function slider(id, label, { min, max, step = 1, value }, words, changed) {
  const output = html('output', { for: id }, words(value));
  const input = html('input', {
    id,
    type: 'range',
    min,
    max,
    step,
    value,
    input: () => {
      output.textContent = words(+input.value);
      input.setAttribute('aria-valuetext', output.textContent);
      changed(+input.value);
    },
  });
  input.setAttribute('aria-valuetext', words(value));
  return html('div', { class: 'control' }, html('label', { for: id }, label), input, output);
}

/** A choice among some, [value, text] each. */
export function choice(id, label, options, value, changed) {
  const select = html(
    'select',
    { id, change: () => changed(select.value) },
    ...options.map(([name, text]) => html('option', { value: name, selected: name === value }, text)),
  );
  return html('div', { class: 'control' }, html('label', { for: id }, label), select);
}

/** Text to the clipboard; the button says that it was done. */
export function copyButton(label, text) {
  const button = html(
    'button',
    {
      type: 'button',
      class: 'copy',
      'aria-label': label,
      click: async () => {
        try {
          await navigator.clipboard.writeText(text());
          button.textContent = 'copied';
        } catch {
          button.textContent = 'no clipboard here';
        }
        setTimeout(() => (button.textContent = 'copy'), 1500);
      },
    },
    'copy',
  );
  return button;
}
