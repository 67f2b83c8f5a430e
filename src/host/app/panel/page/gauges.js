// SPDX-License-Identifier: Apache-2.0
// Draws a value on its scale, and its history over half a minute.
import { el, tell } from './dom.js';
import { shownTime } from './clock.js';
import { digitsFor, numberText, unitSign, valueText } from './units.js';

const span = 30000000;
const traces = [];

class Trace {
  constructor(low, high) {
    [this.low, this.high] = [low, high];
    this.points = [];
    this.canvas = el('canvas', { class: 'trace', 'aria-hidden': true });
    traces.push(this);
  }

  change(time, value) { this.points.push([time, value]); }

  draw(now, line, zero) {
    const from = now - span;
    while (this.points.length > 1 && this.points[1][0] < from) this.points.shift();
    const { canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    const pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    const y = (value) => height - 2 - (height - 4) * (value - this.low) / (this.high - this.low);
    if (this.low < 0 && this.high > 0) {
      pen.strokeStyle = zero;
      pen.lineWidth = 1;
      pen.beginPath();
      pen.moveTo(0, y(0));
      pen.lineTo(width, y(0));
      pen.stroke();
    }
    pen.strokeStyle = line;
    pen.lineWidth = 1.5;
    pen.lineJoin = 'round';
    pen.beginPath();
    let last = null;
    for (const [time, value] of this.points) {
      if (time > now) break;
      if (value === null) { last = null; continue; }
      const x = Math.max(0, width * (time - from) / span);
      if (last === null) pen.moveTo(x, y(value));
      else { pen.lineTo(x, last); pen.lineTo(x, y(value)); }
      last = y(value);
    }
    if (last !== null) pen.lineTo(width, last);
    pen.stroke();
  }
}

let due = 0;
function frame(now) {
  if (now >= due) {
    due = now + 66;
    const style = getComputedStyle(document.documentElement);
    for (const trace of traces) trace.draw(shownTime(), style.getPropertyValue('--trace'), style.getPropertyValue('--line'));
  }
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);

export class Gauge {
  constructor(label, { unit, whole }, low, high, withTrace) {
    [this.low, this.high, this.unit] = [low, high, unit];
    this.digits = whole ? 0 : digitsFor(low, high);
    this.text = el('output', { class: 'figure' }, '–');
    this.bar = el('i');
    this.trace = withTrace ? new Trace(low, high) : null;
    const end = (value) => numberText(value, Number.isInteger(value) ? 0 : 1);
    this.element = el('div', { class: 'gauge' },
      el('div', { class: 'head' }, el('span', {}, label), this.text),
      el('div', { class: 'scale', 'aria-hidden': true }, this.bar),
      el('div', { class: 'ends', 'aria-hidden': true }, el('span', {}, end(low)), el('span', {}, `${end(high)} ${unitSign(unit)}`)),
      this.trace?.canvas);
  }

  change(time, value) { this.trace?.change(time, value); }

  show(value) {
    tell(this.text, valueText(value, this.digits, this.unit));
    const share = (x) => Math.min(1, Math.max(0, (x - this.low) / (this.high - this.low)));
    const zero = share(Math.min(Math.max(0, this.low), this.high));
    const at = value === null ? zero : share(value);
    this.bar.style.left = `${100 * Math.min(zero, at)}%`;
    this.bar.style.width = `${100 * Math.abs(at - zero)}%`;
  }
}
