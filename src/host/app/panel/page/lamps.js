// SPDX-License-Identifier: Apache-2.0
// Draws LEDs lit or dark, as the device's outputs are. With reduced motion, a flashing LED is drawn half lit, and the words
// below it name the pattern.
import { calm, el, tell } from './dom.js';
import { shownTime } from './clock.js';

const lamps = [];

export class Lamp {
  constructor({ label, name, colour, note }) {
    this.edges = [];
    this.lit = false;
    this.bulb = el('span', { class: `bulb ${colour}`, 'aria-hidden': true });
    this.words = el('span', { class: 'words' }, 'off');
    this.element = el('li', { class: 'lamp', title: note ?? name },
      this.bulb, el('b', {}, label), el('span', { class: 'visually-hidden' }, ` ${name}: `), this.words);
    lamps.push(this);
  }

  change(time, value) { this.edges.push([time, value !== 0]); }

  describe(words) {
    this.pattern = words;
    tell(this.words, words);
  }

  play(time) {
    while (this.edges.length && this.edges[0][0] <= time) this.lit = this.edges.shift()[1];
    const steady = this.pattern === 'on' || this.pattern === 'off';
    const look = calm.matches && !steady ? 'pattern' : this.lit ? 'lit' : 'dark';
    if (this.bulb.dataset.look !== look) this.bulb.dataset.look = look;
  }
}

function frame() {
  const time = shownTime();
  for (const lamp of lamps) lamp.play(time);
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);
