// SPDX-License-Identifier: Apache-2.0
// Physical inputs as controls. They also show values that a stimulus file or another page sets.
import { el, tell } from './dom.js';
import { isWaiting, stimulate } from './server.js';
import { digitsFor, numberText, sliderStep, unitSign, valueText } from './units.js';

const canStates = [[0, 'error active'], [1, 'warning limit'], [2, 'error passive'], [3, 'bus-off']];
const widestSlider = 200001;  // most values of a slider; with more it is too coarse, so the user types a number

let ids = 0;

class Control {
  constructor(device, input, label) {
    [this.device, this.input, this.label] = [device, input, label];
    this.id = `input-${++ids}`;
    this.touched = -Infinity;
  }

  send(value) {
    this.touched = performance.now();
    stimulate(this.device, this.input.name, value);
  }

  /** Shows the value that the program reports, unless the user has just moved the control or its value is still being sent. */
  show(value) {
    if (performance.now() - this.touched > 400 && !isWaiting(this.device, this.input.name)) this.put(value);
  }
}

class Switch extends Control {
  constructor(device, input, label) {
    super(device, input, label);
    this.box = el('input', { type: 'checkbox', role: 'switch', id: this.id, onchange: () => this.send(this.box.checked ? 1 : 0) });
    this.element = el('div', { class: 'control switch', title: input.text, 'data-signal': input.name },
      this.box, el('label', { for: this.id }, label));
  }

  put(value) { this.box.checked = value !== 0; }
}

class Choice extends Control {
  constructor(device, input, label, choices) {
    super(device, input, label);
    this.list = el('select', { id: this.id, onchange: () => this.send(Number(this.list.value)) },
      ...choices.map(([value, word]) => el('option', { value }, word)));
    this.element = el('div', { class: 'control choice', title: input.text, 'data-signal': input.name },
      el('label', { for: this.id }, label), this.list);
  }

  put(value) { this.list.value = String(value); }
}

class NumberBox extends Control {
  constructor(device, input, label) {
    super(device, input, label);
    this.box = numberInput(this, label);
    this.element = el('div', { class: 'control number', title: input.text, 'data-signal': input.name },
      el('label', { for: this.id }, label), el('span', { class: 'entry' }, this.box, el('span', { class: 'unit' }, unitSign(input.unit))));
    this.box.id = this.id;
  }

  put(value) { if (document.activeElement !== this.box) this.box.value = String(Number(value.toPrecision(7))); }
}

function numberInput(control, label) {
  const { input } = control;
  const whole = !input.type?.startsWith('REAL');
  const box = el('input', {
    type: 'number', min: input.min, max: input.max, step: whole ? 1 : 'any', 'aria-label': `${label}, exact value`, inputmode: 'decimal',
    onchange: () => {
      if (box.value === '') return;
      const value = Number(box.value);
      control.put(value);
      control.send(value);
    },
  });
  return box;
}

class Slider extends Control {
  constructor(device, input, label, marks) {
    super(device, input, label);
    this.digits = digitsFor(input.min, input.max);
    const whole = !input.type?.startsWith('REAL');
    const step = sliderStep(input.min, input.max);
    this.range = el('input', {
      type: 'range', id: this.id, min: input.min, max: input.max, step: whole ? Math.max(1, Math.round(step)) : step,
      oninput: () => {
        const value = Number(Number(this.range.value).toPrecision(7));
        this.box.value = String(value);
        this.say(value);
        this.send(value);
      },
    });
    this.box = numberInput(this, label);
    this.marks = marks.map((mark) => ({ ...mark, tick: el('span', { class: `mark ${mark.side ?? ''}`, 'aria-hidden': true }, el('i'), el('em', {}, mark.label)) }));
    this.limits = el('span', { class: 'visually-hidden', id: `${this.id}-limits` });
    if (marks.length) this.range.setAttribute('aria-describedby', this.limits.id);
    this.element = el('div', { class: `control slider${marks.length ? ' marked' : ''}`, title: input.text, 'data-signal': input.name },
      el('label', { for: this.id }, label),
      el('span', { class: 'entry' }, this.box, el('span', { class: 'unit' }, unitSign(input.unit))),
      el('div', { class: 'track' }, this.range, ...this.marks.map((mark) => mark.tick)), this.limits);
  }

  say(value) { this.range.setAttribute('aria-valuetext', valueText(value, this.digits, this.input.unit)); }

  put(value) {
    this.range.value = String(value);
    if (document.activeElement !== this.box) this.box.value = String(Number(value.toPrecision(6)));
    this.say(value);
  }

  /** Marks the device's present limits on the slider. */
  showMarks(valueOf) {
    const told = [];
    for (const mark of this.marks) {
      const value = valueOf(mark.entry);
      const share = (value - this.input.min) / (this.input.max - this.input.min);
      mark.tick.hidden = !(share >= 0 && share <= 1);
      // The thumb is 18 px wide, so its centre moves over the length of the track minus 18 px.
      mark.tick.style.left = `calc(9px + ${share} * (100% - 18px))`;
      mark.tick.title = `${mark.label} ${valueText(value, this.digits, this.input.unit)}`;
      told.push(`${mark.label} limit ${numberText(value, this.digits)}`);
    }
    tell(this.limits, told.join(', '));
  }
}

function choicesOf(input, view, enumerations) {
  const name = input.name;
  if (view.choices?.[name]) return view.choices[name];
  if (name === 'can_state') return canStates;
  const words = enumerations[view.words?.[name]];
  if (!words) return null;
  const zero = view.zero?.[name];
  const named = Object.entries(words).map(([word, value]) => [value, word.toUpperCase()]).sort((a, b) => a[0] - b[0]);
  return zero ? [[0, zero], ...named] : named;
}

export function makeControl(device, input, view, enumerations) {
  const label = view.labels?.[input.name] ?? input.name;
  if (input.type === 'BOOLEAN' || input.name === 'can_overrun') return new Switch(device, input, label);
  const choices = choicesOf(input, view, enumerations);
  if (choices) return new Choice(device, input, label, choices);
  const bounded = typeof input.min === 'number' && typeof input.max === 'number';
  if (!bounded || input.max - input.min >= widestSlider) return new NumberBox(device, input, label);
  return new Slider(device, input, label, view.marks?.[input.name] ?? []);
}

/** A coding switch with sixteen positions. */
export class Dial extends Control {
  constructor(device, input, label) {
    super(device, input, label);
    this.arrow = el('span', { class: 'arrow' });
    const positions = Array.from({ length: input.max + 1 }, (_, n) => el('option', { value: n }, n.toString(16).toUpperCase()));
    this.list = el('select', { id: this.id, onchange: () => { this.put(Number(this.list.value)); this.send(Number(this.list.value)); } }, ...positions);
    this.element = el('div', { class: 'dial', title: input.text, 'data-signal': input.name },
      el('span', { class: 'knob', 'aria-hidden': true }, this.arrow), el('label', { for: this.id }, label), this.list);
  }

  put(value) {
    this.list.value = String(value);
    this.arrow.style.transform = `rotate(${value * 22.5}deg)`;
  }
}
