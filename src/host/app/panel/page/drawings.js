// SPDX-License-Identifier: Apache-2.0
// Drawings of the unit: its connectors, its relay, its attitude.
import { el, svg, tell } from './dom.js';
import { stimulate } from './server.js';
import { digitsFor, valueText } from './units.js';

/** Draws a connector: the pins by row, each with its number, its label and its signal, if it has one. */
export function connector({ name, pins }, describe) {
  const values = [];
  const rows = pins.map((row) => el('ol', { class: `pins of-${row.length}` }, ...row.map(([number, label, signal]) => {
    const value = el('span', { class: 'pin-value' });
    if (signal) values.push({ signal, value, ...describe(signal) });
    return el('li', { class: signal ? 'pin live' : 'pin' }, el('i', {}, number), el('b', {}, label), value);
  })));
  const element = el('figure', { class: 'connector' }, el('figcaption', {}, name), ...rows);
  const show = (valueOf) => {
    for (const { signal, value, unit, min, max } of values) tell(value, valueText(valueOf(signal), Math.min(2, digitsFor(min, max)), unit));
  };
  return { element, show };
}

/** Draws a relay with its common, normally closed and normally open contacts. */
export function relay({ closed, open }) {
  const lever = svg('line', { x1: 26, y1: 40, x2: 92, y2: 18, class: 'lever' });
  const text = el('output', { class: 'figure' });
  const drawing = svg('svg', { viewBox: '0 0 144 80', class: 'relay', 'aria-hidden': 'true' },
    svg('line', { x1: 4, y1: 40, x2: 26, y2: 40 }), svg('circle', { cx: 26, cy: 40, r: 4 }), lever,
    svg('circle', { cx: 96, cy: 18, r: 4 }), svg('line', { x1: 96, y1: 18, x2: 112, y2: 18 }),
    svg('circle', { cx: 96, cy: 62, r: 4 }), svg('line', { x1: 96, y1: 62, x2: 112, y2: 62 }));
  for (const [x, y, word] of [[4, 33, 'C'], [115, 22, 'NC'], [115, 66, 'NO']]) {
    const label = svg('text', { x, y });
    label.textContent = word;
    drawing.append(label);
  }
  const show = (valueOf) => {
    const state = valueOf(closed) ? 'NC' : valueOf(open) ? 'NO' : 'between';
    lever.setAttribute('y2', state === 'NC' ? '18' : state === 'NO' ? '62' : '40');
    tell(text, state === 'between' ? 'C between the contacts' : `C on ${state}`);
  };
  return { element: el('figure', { class: 'relay-box' }, el('figcaption', {}, 'Relay'), drawing, text), show };
}

/** Draws a horizon that the user can drag: vertically for pitch, horizontally for roll. The sliders do the same by keyboard. */
export function attitude(device, { pitch, roll }, signals) {
  const world = svg('g', {}, svg('rect', { x: -200, y: -200, width: 400, height: 200, class: 'sky' }),
    svg('rect', { x: -200, y: 0, width: 400, height: 200, class: 'ground' }), svg('line', { x1: -200, y1: 0, x2: 200, y2: 0, class: 'horizon' }));
  for (const degrees of [-60, -30, 30, 60]) world.append(svg('line', { x1: -12, y1: -degrees, x2: 12, y2: -degrees, class: 'rung' }));
  const clip = svg('clipPath', { id: `clip-${device}` }, svg('circle', { r: 96 }));
  const drawing = svg('svg', { viewBox: '-100 -100 200 200', class: 'attitude', 'aria-hidden': 'true' }, clip,
    svg('g', { 'clip-path': `url(#clip-${device})` }, world), svg('circle', { r: 96, class: 'rim' }),
    svg('path', { d: 'M-46 0H-16M16 0H46M-6 0L0 6L6 0', class: 'wings' }));
  const clamp = (signal, value) => Math.round(Math.min(signal.max, Math.max(signal.min, value)));
  let held = null;
  const now = { [pitch]: 0, [roll]: 0 };
  drawing.addEventListener('pointerdown', (event) => {
    drawing.setPointerCapture(event.pointerId);
    held = { x: event.clientX, y: event.clientY, pitch: now[pitch], roll: now[roll], scale: 200 / drawing.clientWidth };
  });
  drawing.addEventListener('pointermove', (event) => {
    if (!held) return;
    const next = { [pitch]: clamp(signals[pitch], held.pitch + (event.clientY - held.y) * held.scale),
      [roll]: clamp(signals[roll], held.roll + (event.clientX - held.x) * held.scale) };
    for (const [signal, value] of Object.entries(next)) if (now[signal] !== value) stimulate(device, signal, value);
    Object.assign(now, next);
    draw();
  });
  for (const end of ['pointerup', 'pointercancel']) drawing.addEventListener(end, () => { held = null; });
  const draw = () => world.setAttribute('transform', `rotate(${-now[roll]}) translate(0 ${now[pitch]})`);
  const show = (inputOf) => {
    if (held) return;
    now[pitch] = inputOf(pitch);
    now[roll] = inputOf(roll);
    draw();
  };
  return { element: el('figure', { class: 'attitude-box' }, el('figcaption', {}, 'Attitude: drag to tilt'), drawing), show };
}
