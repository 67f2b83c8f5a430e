// SPDX-License-Identifier: Apache-2.0
// The page: requests the description of the devices, builds a card for each device, then follows the program.
import { tell } from './dom.js';
import { Card, nmtButtons } from './card.js';
import { heard } from './clock.js';
import { FrameLog } from './frame_log.js';
import { get, message, onMessage } from './server.js';
import { seconds } from './units.js';

const period = 100;
const patience = 1000;
const byId = (id) => document.getElementById(id);

onMessage((text, wrong) => {
  const place = byId('message');
  place.classList.toggle('wrong', wrong);
  tell(place, text);
});

function showBus(name, { now, bus }) {
  tell(byId('bus-name'), `${name}, ${bus.bit_rate ? `${bus.bit_rate / 1000} kbit/s` : 'no bit rate'}`);
  tell(byId('bus-load'), `${(100 * bus.load).toFixed(1)} %`);
  byId('bus-load-bar').style.width = `${Math.min(100, 100 * bus.load)}%`;
  tell(byId('bus-frames'), String(bus.frames));
  tell(byId('bus-errors'), String(bus.errors));
  byId('bus-lost-field').hidden = bus.lost + bus.missed === 0;
  tell(byId('bus-lost'), `${bus.lost} to the log, ${bus.missed} to the devices`);
  byId('bus-lag-field').hidden = bus.lag_us === 0;
  tell(byId('bus-lag'), `${(bus.lag_us / 1e6).toFixed(1)} s`);
  tell(byId('bus-latency'), `< ${(bus.latency_us / 1000).toFixed(2)} ms`);
  tell(byId('bus-time'), `${seconds(now).slice(0, -2)} s`);
}

async function start() {
  const { devices, interface: name } = await get('/api/panel');
  const cards = devices.map((device) => new Card(device));
  byId('devices').replaceChildren(...cards.map((card) => card.element));
  byId('nmt-all').replaceChildren(...nmtButtons('all nodes', () => 0));
  const places = cards.flatMap((card) => card.device.channels.map((_, at) => [card, at]));
  const log = new FrameLog();
  let [changes, frames, notices] = [0, 0, 0];

  /** Shows the present value of each channel without a recorded change. Such a value has not changed since before
      the oldest record. */
  function seed(state) {
    const changed = new Set(state.changes.map(([, channel]) => channel));
    const values = state.devices.flatMap((device) => device.values);
    values.forEach((value, channel) => { if (!changed.has(channel)) places[channel][0].change(places[channel][1], 0, value); });
  }

  async function follow() {
    const state = await get(`/api/state?changes=${changes}&frames=${frames}`);
    // the numbers are lower than before, so the program was started again and counts from 0
    if (state.next_change < changes || state.next_frame < frames) return location.reload();
    heard(state.now);
    if (changes === 0) seed(state);
    for (const [time, channel, value] of state.changes) places[channel][0].change(places[channel][1], time, value);
    cards.forEach((card, at) => card.show(state.devices[at]));
    showBus(name, state);
    log.show(state.frames);
    [changes, frames] = [state.next_change, state.next_frame];
    if (state.next_notice !== notices) message(state.notices.at(-1));
    notices = state.next_notice;
  }
  return follow;
}

async function run() {
  let follow = null;
  let lost = false;
  for (;;) {
    try {
      follow ??= await start();
      await follow();
      if (lost) message('Connected again.');
      lost = false;
      document.documentElement.dataset.ready = 'yes';
    } catch (error) {
      if (!(error instanceof TypeError && /fetch|network/i.test(error.message))) console.error(error);
      lost = true;
      message('No connection to canproof: has the program ended? Trying again …', true);
    }
    await new Promise((resolve) => { setTimeout(resolve, lost ? patience : period); });
  }
}

run();
