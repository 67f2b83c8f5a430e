// SPDX-License-Identifier: Apache-2.0
// The card of one device on the page: its data, its values, and its controls.
import { el, tell } from './dom.js';
import { Dial, makeControl } from './controls.js';
import { attitude, connector, relay } from './drawings.js';
import { Gauge } from './gauges.js';
import { Lamp } from './lamps.js';
import { message, sendFrame } from './server.js';
import { digitsFor, seconds, valueText } from './units.js';

const noNode = 255;
const commands = [['Start', '01', 'start'], ['Pre-op', '80', 'enter pre-operational'], ['Stop', '02', 'stop'],
  ['Reset comm', '82', 'reset communication'], ['Reset node', '81', 'reset node']];

/** Returns buttons that send NMT commands; `node()` returns the node-ID, or 0 for all nodes. */
export function nmtButtons(whose, node) {
  return commands.map(([label, specifier, command]) => el('button', {
    type: 'button', title: `NMT ${command}: 000#${specifier}…`, 'aria-label': `${label}, ${whose}`,
    onclick: async () => {
      const id = node();
      if (id === noNode) return message(`${whose} has no node-ID.`, true);
      const frame = `000#${specifier}${id.toString(16).padStart(2, '0').toUpperCase()}`;
      if (await sendFrame(frame)) message(`${whose}: ${command} sent (${frame}).`);
    },
  }, label));
}

const lentLamps = [{ signal: 'run', label: 'RUN', name: 'Run, added by the panel', colour: 'green' },
  { signal: 'error', label: 'ERR', name: 'Error, added by the panel', colour: 'red' }];

export class Card {
  constructor(device) {
    Object.assign(this, { device, name: device.name, view: device.view });
    this.inputs = new Map(device.inputs.map((input, at) => [input.name, { ...input, at }]));
    this.channels = new Map(device.channels.map((channel, at) => [channel.name, { ...channel, at }]));
    this.listeners = device.channels.map(() => []);
    this.shown = new Set();
    this.element = el('article', { class: 'device', 'aria-labelledby': `title-${device.name}`, 'data-device': device.name },
      this.head(), this.unit(), this.readings(), this.controls());
  }

  head() {
    this.node = el('span', { class: 'chip' });
    this.nmt = el('span', { class: 'chip state' });
    this.emcy = el('p', { class: 'emcy' }, 'No emergency so far');
    const title = this.device.part ? `${this.device.vendor} ${this.device.title}` : 'from an EDS';
    return el('header', {}, el('div', { class: 'name' }, el('h2', { id: `title-${this.name}` }, this.name), el('p', {}, title)),
      el('div', { class: 'chips' }, this.node, this.nmt),
      el('div', { class: 'nmt', role: 'group', 'aria-label': `NMT, ${this.name}` }, ...nmtButtons(this.name, () => this.nodeId ?? noNode)), this.emcy);
  }

  unit() {
    const own = this.view.lamps;
    this.lamps = new Map();
    const list = el('ul', { class: 'lamps', 'aria-label': own ? 'LEDs' : 'LEDs added by the panel' });
    for (const lamp of own ?? lentLamps) {
      if (!this.channels.has(lamp.signal)) continue;
      const one = new Lamp({ ...lamp, note: this.channels.get(lamp.signal).text });
      this.lamps.set(lamp.signal, one);
      this.listen(lamp.signal, (time, value) => one.change(time, value));
      list.append(one.element);
    }
    const connectors = (this.view.connectors ?? []).map((one) => connector(one, (signal) => this.channels.get(signal) ?? this.inputs.get(signal)));
    const contact = this.view.relay ? relay(this.view.relay) : null;
    this.drawings = contact ? [...connectors, contact] : connectors;
    if (contact) {
      this.shown.add(this.view.relay.closed).add(this.view.relay.open);
    }
    this.dials = (this.view.dials ?? []).map(({ signal, label }) => new Dial(this.name, this.inputs.get(signal), label));
    const dials = this.dials.length ? el('div', { class: 'dials', title: this.view.dials_note }, ...this.dials.map((dial) => dial.element), el('p', { class: 'hint' }, this.view.dials_note)) : null;
    const note = own ? null : el('p', { class: 'hint' }, 'The unit has no LEDs: the panel adds two.');
    this.horizon = this.view.attitude ? attitude(this.name, this.view.attitude, Object.fromEntries(this.inputs)) : null;
    return el('section', { class: 'unit', 'aria-label': 'Unit' }, el('p', { class: 'caption' }, this.view.unit ?? 'No view of this device'),
      el('div', { class: 'bench' }, el('div', { class: 'face' }, list, note, dials), ...connectors.map((one) => one.element)),
      el('div', { class: 'beside' }, contact?.element, this.horizon?.element));
  }

  readings() {
    this.gauges = [];
    const grid = el('div', { class: 'gauges' });
    for (const { channel: name, label, range, trace } of this.view.gauges ?? []) {
      const channel = this.channels.get(name);
      if (!channel) continue;
      const scale = this.inputs.get(range) ?? channel;
      const gauge = new Gauge(label, channel, scale.min, scale.max, trace);
      this.gauges.push([name, gauge]);
      this.shown.add(name);
      this.listen(name, (time, value) => gauge.change(time, value));
      grid.append(gauge.element);
    }
    const rest = [...this.channels.values()].filter((one) => !one.led && one.kind !== 'setting' && !this.shown.has(one.name));
    this.rest = rest.map((channel) => ({ channel, digits: channel.whole ? 0 : Math.min(3, digitsFor(channel.min ?? 0, channel.max ?? 0)), text: el('dd') }));
    const table = el('dl', { class: 'rest' }, ...this.rest.map(({ channel, text }) => el('div', { title: channel.text }, el('dt', {}, channel.name.replace(/_/g, ' ')), text)));
    return el('section', { class: 'readings', 'aria-label': 'Readings' }, grid,
      rest.length ? el('details', {}, el('summary', {}, `${rest.length} more values`), table) : null);
  }

  controls() {
    this.inputControls = [];
    const make = (input) => {
      const control = makeControl(this.name, input, this.view, this.device.enumerations);
      this.inputControls.push(control);
      return control.element;
    };
    const dials = new Set((this.view.dials ?? []).map((dial) => dial.signal));
    const main = (this.view.inputs ?? []).map((name) => this.inputs.get(name)).filter(Boolean);
    const more = [...this.inputs.values()].filter((input) => !dials.has(input.name) && !main.includes(input));
    return el('section', { class: 'inputs', 'aria-label': 'Inputs' }, ...main.map(make),
      more.length ? el('details', {}, el('summary', {}, `${more.length} more inputs`), el('div', { class: 'more' }, ...more.map(make))) : null);
  }

  listen(name, listener) { this.listeners[this.channels.get(name).at].push(listener); }

  /** Reports a changed value and the time of the change to the parts of the card that show it; `at` is the number of the channel in this device. */
  change(at, time, value) { for (const listener of this.listeners[at]) listener(time, value); }

  show(state) {
    this.nodeId = state.node;
    tell(this.node, state.node === noNode ? 'no node-ID' : `node ${state.node} · ${state.bit_rate / 1000} kbit/s`);
    tell(this.nmt, state.state);
    this.nmt.dataset.state = state.state;
    this.showEmergency(state);
    const channel = (name) => state.values[this.channels.get(name)?.at];
    const input = (name) => state.inputs[this.inputs.get(name)?.at];
    for (const [name, lamp] of this.lamps) lamp.describe(state.lamps?.[name] ?? 'off');
    for (const [name, gauge] of this.gauges) gauge.show(channel(name));
    for (const drawing of this.drawings) drawing.show((name) => (this.channels.has(name) ? channel(name) : input(name)));
    this.horizon?.show(input);
    for (const control of [...this.inputControls, ...this.dials]) {
      control.show(input(control.input.name));
      control.showMarks?.(channel);
    }
    for (const { channel: one, digits, text } of this.rest) {
      const value = state.values[one.at];
      tell(text, one.truth ? (value ? 'yes' : 'no') : valueText(value, digits, one.unit));
    }
  }

  showEmergency({ emcy, error_register: register }) {
    this.element.classList.toggle('faulty', register !== 0);
    if (!emcy) return;
    tell(this.emcy, `EMCY ${seconds(emcy.t)} s: ${emcy.text}`);
    this.emcy.classList.toggle('error', emcy.error);
    if (emcy.t !== this.toldEmergency) {
      this.toldEmergency = emcy.t;
      message(`${this.name}: ${emcy.text}`, emcy.error);
    }
  }
}
