// SPDX-License-Identifier: Apache-2.0
// The decoded frames of the bus, newest first.
import { el } from './dom.js';
import { message, sendFrame } from './server.js';
import { seconds } from './units.js';

const rowsKept = 250;
const services = ['NMT', 'SYNC', 'EMCY', 'PDO', 'SDO', 'guard', 'LSS', 'other'];

const spaced = (data) => (data === 'R' ? 'remote' : data.replace(/(..)(?=.)/g, '$1 '));

export class FrameLog {
  constructor() {
    this.body = document.getElementById('frames');
    this.table = this.body.parentElement;
    this.held = [];
    const hold = document.getElementById('hold');
    hold.addEventListener('click', () => {
      this.holds = !this.holds;
      hold.setAttribute('aria-pressed', String(this.holds));
      if (!this.holds) this.show(this.held.splice(0));
    });
    document.getElementById('services').append(...services.map((service) => this.filter(service)));
    document.getElementById('send').addEventListener('submit', async (event) => {
      event.preventDefault();
      const frame = event.target.elements.frame.value.trim();
      if (frame && await sendFrame(frame)) message(`Sent ${frame}.`);
    });
  }

  filter(service) {
    const button = el('button', { type: 'button', 'aria-pressed': 'true' }, service);
    button.addEventListener('click', () => {
      const hide = !this.table.classList.contains(`no-${service}`);
      this.table.classList.toggle(`no-${service}`, hide);
      button.setAttribute('aria-pressed', String(!hide));
    });
    return button;
  }

  show(frames) {
    if (this.holds) {
      this.held.push(...frames);
      this.held.splice(0, this.held.length - rowsKept);
      return;
    }
    const rows = frames.slice(-rowsKept).reverse().map((one) => {
      const service = one.service === 'TIME' ? 'other' : one.service;
      return el('tr', { class: `is-${service}`, 'data-from': one.from || 'outside' }, el('td', {}, seconds(one.t)), el('td', {}, one.id), el('td', { class: 'data' }, spaced(one.data)),
        el('td', { class: 'service' }, el('span', {}, one.service)), el('td', { class: 'whose' }, one.node), el('td', { class: 'says' }, one.text));
    });
    this.body.prepend(...rows);
    while (this.body.rows.length > rowsKept) this.body.lastElementChild.remove();
  }
}
